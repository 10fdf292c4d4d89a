/// Sources: highlighted, with an anchor for each line; and where the code stands that a page quotes.
import fs from "node:fs";
import path from "node:path";
import hljs from "highlight.js/lib/common";
import cmake from "highlight.js/lib/languages/cmake";

hljs.registerLanguage("cmake", cmake);

export const escaped = (text) =>
  text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/>/g, "&gt;").replace(/"/g, "&quot;");

/// As HTML. The class of an element is the first letter of what the highlighter calls it: the book has a hundred thousand of them.
export function highlighted(code, language) {
  if (!hljs.getLanguage(language)) return escaped(code);
  const { value } = hljs.highlight(code, { language });
  return value.replace(/<span class="hljs-(.)[^"]*">/g, "<i class=$1>").replaceAll("</span>", "</i>");
}

function languageOf(file) {
  if (path.basename(file) === "CMakeLists.txt") return "cmake";
  const ending = path.extname(file).slice(1);
  return ending === "h" ? "cpp" : ending === "mjs" ? "js" : ending || "bash";
}

/// A whole source as HTML; `link(file)` is where an included file is shown, if it is; `anchored`: the lines that pages lead to.
export function sourceHtml(root, file, link, anchored = new Set()) {
  const html = highlighted(fs.readFileSync(path.join(root, file), "utf8").trimEnd(), languageOf(file));
  const lines = html.split("\n").map((line, i) => {
    const linked = line.replace(
      /(include.*&quot;)((?:pushback\/)?([^&]+))(?=&quot;)/,
      (all, before, name, included) => {
        const target = link(included);
        return target ? `${before}<a href="${target}">${name}</a>` : all;
      },
    );
    return `<b${anchored.has(i + 1) ? ` id=L${i + 1}` : ""}></b>${linked}`;
  });
  return `<pre class="numbered"><code>${lines.join("\n")}</code></pre>`;
}

const packed = (text) => text.replace(/\s+/g, "");

/// All sources in which a page may quote: {file, source, text}, the text without blanks.
export function quotable(root) {
  const folders = ["chapters", "common", "docs", "engine", "tests", "tools"].filter((name) =>
    fs.existsSync(path.join(root, name)),
  );
  return folders.flatMap((folder) =>
    fs
      .readdirSync(path.join(root, folder), { recursive: true })
      .filter((name) => /\.(h|cpp)$/.test(name))
      .map((name) => {
        const file = path.posix.join(folder, name);
        const source = fs.readFileSync(path.join(root, file), "utf8");
        return { file, source, text: packed(source) };
      }),
  );
}

/// [{file, line}] of the parts of some code, which are apart by an empty line; the page's own folder comes first.
export function placesOf(code, page, sources) {
  const folder = `${path.posix.dirname(page)}/`;
  const places = new Map();
  for (const part of code
    .split(/\n\s*\n/)
    .map(packed)
    .filter(Boolean)) {
    const having = sources.filter(({ text }) => text.includes(part));
    if (!having.length || having.some(({ file }) => places.has(file))) continue;
    const best = having.find(({ file }) => file.startsWith(folder)) ?? having[0];
    places.set(best.file, lineOf(best, part));
  }
  return [...places].map(([file, line]) => ({ file, line }));
}

function lineOf({ source, text }, part) {
  let before = text.indexOf(part);
  let line = 1;
  for (const character of source) {
    if (character === "\n") ++line;
    else if (!/\s/.test(character) && (before -= character.length) < 0) break;
  }
  return line;
}
