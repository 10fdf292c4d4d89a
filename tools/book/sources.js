/// Sources: highlighted, their includes as links; and where the code stands that a page quotes.
import fs from "node:fs";
import path from "node:path";
import hljs from "highlight.js/lib/core";
import bash from "highlight.js/lib/languages/bash";
import cmake from "highlight.js/lib/languages/cmake";
import cpp from "highlight.js/lib/languages/cpp";
import dockerfile from "highlight.js/lib/languages/dockerfile";
import javascript from "highlight.js/lib/languages/javascript";
import json from "highlight.js/lib/languages/json";

for (const [name, grammar] of Object.entries({ bash, cmake, cpp, dockerfile, javascript, json }))
  hljs.registerLanguage(name, grammar);

const languages = {
  ".h": "cpp",
  ".cpp": "cpp",
  ".sh": "bash",
  ".js": "javascript",
  ".json": "json",
  ".cmake": "cmake",
  Containerfile: "dockerfile",
};
const include = /^#include "(?:pushback\/)?([^"]+)"/gm;

export const escaped = (text) =>
  text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/>/g, "&gt;").replace(/"/g, "&quot;");

/// What the highlighter tells apart, by the letter of its colour (book.css): a hundred thousand of them are in the book.
const colours = {
  c: ["comment", "quote"],
  k: ["keyword", "literal"],
  f: ["title", "title function_", "built_in", "attr"],
  t: ["type", "title class_", "title class_ inherited__"],
  s: ["string", "regexp"],
  n: ["number", "symbol", "variable", "variable language_"],
  m: ["meta"],
  d: ["doctag"],
};
const letters = new Map(
  Object.entries(colours).flatMap(([letter, kinds]) => kinds.map((kind) => [`hljs-${kind}`, letter])),
);

/// The lines of the code, as HTML of their own: what a highlighter opens over an end of line is closed there and opened again.
/// What has no colour of its own has no element. The elements are `i`: no other is shorter.
export function highlightedLines(code, language) {
  const html = hljs.getLanguage(language) ? hljs.highlight(code, { language }).value : escaped(code);
  const open = [];
  const coloured = (tag, kind) => {
    if (tag === "</span>") return open.pop() && "</i>";
    open.push(letters.has(kind) ? `<i class="${letters.get(kind)}">` : "");
    return open.at(-1);
  };
  return html.split("\n").map((line) => {
    const before = open.join("");
    const inside = line.replace(/<span class="([^"]*)">|<\/span>/g, coloured);
    return before + inside + "</i>".repeat(open.filter(Boolean).length);
  });
}

/// A difference of two sources: each line with its mark, the code behind the mark highlighted as what it is.
export function highlightedDifference(code) {
  const kinds = { "+": "added", "-": "removed", "@": "place" };
  return code.split("\n").map((line) => {
    const kind = kinds[line[0]] ?? "same";
    if (kind === "place") return `<span class="place">${escaped(line.replace(/^@@ | @@$/g, ""))}</span>`;
    const [rest] = highlightedLines(line.slice(1), "cpp");
    const mark = { added: "+", removed: "−", same: " " }[kind];
    return `<span class="${kind}"><span class="mark">${mark}</span>${rest}</span>`;
  });
}

export function languageOf(file) {
  return (
    languages[path.extname(file)] ??
    languages[path.basename(file)] ??
    (file.endsWith("CMakeLists.txt") ? "cmake" : "text")
  );
}

/// The files that a source includes and that are the project's own.
export function includedBy(root, file) {
  const text = fs.readFileSync(path.join(root, file), "utf8");
  return [...text.matchAll(include)].map(([, name]) => name).filter((name) => fs.existsSync(path.join(root, name)));
}

/// The lines of a source as HTML; `link(file)` is where an included file is shown, or nothing.
export function sourceLines(root, file, link) {
  const lines = highlightedLines(fs.readFileSync(path.join(root, file), "utf8").trimEnd(), languageOf(file));
  return lines.map((line) =>
    line.replace(/(<i class="s">&quot;)((?:pushback\/)?([^&]+))(&quot;<\/i>)/, (all, open, name, included, close) => {
      const target = line.includes("include") && link(included);
      return target ? `${open}<a href="${target}">${name}</a>${close}` : all;
    }),
  );
}

/// All sources of the project, ready to be searched for quoted code: without blanks, and for each character its line.
export class Sources {
  #files = [];

  constructor(root) {
    const walk = (folder) => {
      if (!fs.existsSync(path.join(root, folder))) return;
      for (const entry of fs.readdirSync(path.join(root, folder), { withFileTypes: true })) {
        const file = `${folder}/${entry.name}`;
        if (entry.isDirectory()) walk(file);
        else if (/\.(h|cpp)$/.test(file))
          this.#files.push(new Packed(file, fs.readFileSync(path.join(root, file), "utf8")));
      }
    };
    for (const folder of ["chapters", "common", "docs", "tests", "tools"]) walk(folder);
  }

  /// {places: [{file, line}], missing: the first line of a part that stands nowhere}. Parts are apart by an empty line.
  /// Of several files with the same code the page's own folder comes first, then the file that most parts are in.
  where(code, page) {
    const parts = code.split(/\n\s*\n/).filter((part) => part.trim());
    const wanted = parts.map(packed);
    const folder = path.posix.dirname(page) + "/";
    const found = wanted.map((part) => this.#files.filter((file) => file.text.includes(part)));
    const missing = parts.find((part, i) => found[i].length === 0);
    if (missing) return { places: [], missing: missing.trim().split("\n")[0] };
    const worth = (file) =>
      found.filter((files) => files.includes(file)).length + (file.name.startsWith(folder) ? 100 : 0);
    const places = new Map();
    found.forEach((files, i) => {
      const best = files.reduce((a, b) => (worth(b) > worth(a) ? b : a));
      if (!places.has(best.name)) places.set(best.name, best.lineOf(wanted[i]));
    });
    return { places: [...places].map(([file, line]) => ({ file, line })) };
  }
}

const packed = (text) => text.replace(/\s+/g, "");

class Packed {
  constructor(name, source) {
    this.name = name;
    this.source = source;
    this.text = packed(source);
  }

  lineOf(part) {
    let before = this.text.indexOf(part);
    let line = 1;
    for (const character of this.source) {
      if (character === "\n") ++line;
      else if (!/\s/.test(character) && (before -= character.length) < 0) break;
    }
    return line;
  }
}
