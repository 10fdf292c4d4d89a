/// Markdown as GitHub shows it, made into HTML for the book. What cannot be shown right is a problem, with its file and line.
import GithubSlugger from "github-slugger";
import katex from "katex";
import MarkdownIt from "markdown-it";
import mathSyntax from "@vscode/markdown-it-katex";
import { linkCases } from "./cases.js";
import { challengeLinks, rowFigures, settingSentences, smallPictures, wallOfClips } from "./marks.js";
import { escaped, highlighted } from "./sources.js";

const math = ["math_inline", "math_inline_block", "math_inline_bare_block", "math_block"];

/// The page being read comes as the environment of markdown-it. It is given `headings` and `sections`, and says
/// `page.problem(line, text)`, `page.target(address, line)`, `page.picture(address, alt, line)`, `page.quoted(code)`.
export function markdown() {
  const md = new MarkdownIt({ html: true, typographer: true });
  md.use(mathSyntax.default ?? mathSyntax);
  md.core.ruler.disable("replacements"); // quotation marks are made typographic, nothing else is
  md.core.ruler.push("page", readPage);
  for (const kind of math) md.renderer.rules[kind] = (tokens, i) => tokens[i].meta.html;
  md.renderer.rules.fence = md.renderer.rules.code_block = (tokens, i) => codeBlock(tokens[i]);
  md.renderer.rules.table_open = (tokens, i, options, env, self) =>
    `<div class="table"><table${self.renderAttrs(tokens[i])}>\n`;
  md.renderer.rules.table_close = () => "</table></div>\n";
  return md;
}

function readPage({ tokens, env: page }) {
  const slugger = new GithubSlugger();
  page.headings = [];
  page.sections = [{ id: "", title: "", text: "" }];
  if (page.chapter) readSignposts(tokens, page);
  let line = 1;
  tokens.forEach((token, i) => {
    if (token.map) line = token.map[0] + 1;
    if (token.type === "fence" && token.info.trim() === "math") token.type = "math_block";
    if (token.type === "html_block") token.content = withLinks(readKeywords(token.content, page), page, line);
    else if (token.type === "fence") readCode(token, page);
    else if (math.includes(token.type)) token.meta = formula(token.content, true, page, line);
    else if (token.type === "inline") {
      readInline(token, page, line);
      const text = plain(token.children);
      if (tokens[i - 1].type === "heading_open") readHeading(tokens[i - 1], text, page, slugger);
      else if (tokens[i - 1].type !== "td_open" || /[a-z]/i.test(text)) page.sections.at(-1).text += `${text} `;
    }
  });
  figures(tokens, page);
  tables(tokens);
  linkCases(tokens, page);
  smallPictures(tokens, page);
  wallOfClips(tokens, page);
  rowFigures(tokens, page);
  settingSentences(tokens, page);
  challengeLinks(tokens, page);
  for (const token of tokens) if (token.type === "inline") keepTogether(token.children);
}

const unit = "(?:[kcmµn]?m|[mµn]?s|k?g|k?Hz|k?N|k?J|rad|[kMG]?B|[°%])(?![\\w])";
const beforeUnit = new RegExp(`(\\d|\\b(?:N|kg)) (?=${unit})`, "g");
const afterFormula = new RegExp(`^(?:\\s${unit})?[,.;:!?)\\]”’]*`);

/// A unit stays on the line of its number.
export const withUnits = (text) => text.replace(beforeUnit, "$1\u00a0");

/// Within a page: units, and brackets and punctuation marks stay on the line of a formula, and a short formula on one line, where a
/// browser may part them.
function keepTogether(children) {
  children.forEach((child, i) => {
    const [before, after] = [children[i - 1]?.content ?? "", children[i + 1]?.content ?? ""];
    if (child.type === "softbreak" && `${before.slice(-2)} ${after.slice(0, 6)}`.search(beforeUnit) >= 0)
      Object.assign(child, { type: "text", content: "\u00a0" });
    if (child.type === "text") child.content = withUnits(child.content);
    if (child.type !== "math_inline") return;
    const next = children
      .slice(i + 1)
      .find(({ nesting, content }) => nesting !== -1 && !["", "</a>"].includes(content));
    const tail = next?.type === "text" ? afterFormula.exec(next.content)[0] : "";
    const head = children[i - 1]?.type === "text" ? /[([“‘]*$/.exec(before)[0] : "";
    const short = child.meta.text.length <= 10 && child.meta.html.split('class="base"').length > 2;
    if (!head && !tail && !short) return;
    if (tail) next.content = next.content.slice(tail.length);
    if (head) children[i - 1].content = before.slice(0, -head.length);
    const parts = /(?<=<\/span>)(?=<span class="base">)/g;
    const html = short ? child.meta.html : child.meta.html.replace(parts, '<wbr style="white-space: normal">');
    const whole = head + html + tail.replace(" ", "\u00a0");
    child.meta = { ...child.meta, html: `<span style="white-space: nowrap">${whole}</span>` };
  });
}

/// `<!-- search: jitter, flicker -->`: words by which a reader looks for the page, and which it does not need to say.
function readKeywords(html, page) {
  return html.replace(/<!-- search: (.*?) -->/s, (all, words) => ((page.sections[0].keywords = words), ""));
}

function readHeading(token, text, page, slugger) {
  const id = slugger.slug(text.replace(/[“”‘’]/g, ""));
  const level = Number(token.tag[1]);
  token.attrSet("id", id);
  page.headings.push({ level, id, text });
  if (level === 1) page.sections[0].title = text;
  else page.sections.push({ id, title: text, text: "" });
}

/// Takes two lines out of a chapter's page, which the layout shows in its own way: the one below the title, which says where the page
/// stands, and the last one, which names its neighbours. `page.place`, `page.foot`: their links, {text, href}.
function readSignposts(tokens, page) {
  page.foot = linksAlone(tokens.at(-2), page);
  if (page.foot.length) tokens.splice(-3);
  const head = linksAlone(tokens[4], page);
  if (head.length !== 1) return;
  [page.place] = head;
  tokens.splice(3, 3);
}

/// The links of a paragraph that holds links and no other words; none of any other paragraph.
function linksAlone(paragraph, page) {
  const all = paragraph?.children ?? [];
  const besides = all.filter((child, i) => child.type === "text" && all[i - 1]?.type !== "link_open");
  if (/\w/.test(besides.map((child) => child.content).join(""))) return [];
  const links = all.flatMap((child, i) =>
    child.type === "link_open" ? [{ open: child, text: all[i + 1].content }] : [],
  );
  return links.map(({ open, text }) => ({ text, href: page.target(open.attrGet("href"), paragraph.map[0] + 1) }));
}

function readInline(token, page, line) {
  for (const child of token.children) {
    if (child.type === "softbreak" || child.type === "hardbreak") ++line;
    if (child.type === "text" && child.content.includes("$"))
      page.problem(line, `a dollar sign that belongs to no formula: ${child.content.trim().slice(0, 60)}`);
    if (child.type === "code_inline" && child.content.length <= 24) child.attrSet("class", "short");
    if (child.type === "link_open") lead(child, page.target(child.attrGet("href"), line));
    if (child.type === "html_inline") child.content = withLinks(child.content, page, line);
    if (child.type === "image") readImage(child, page, line);
    if (math.includes(child.type)) child.meta = formula(child.content, child.type !== "math_inline", page, line);
    line += (child.content.match(/\n/g) ?? []).length;
  }
}

function readImage(token, page, line) {
  const alt = token.content.replace(/\s+/g, " ").trim();
  if (!alt) page.problem(line, `the picture ${token.attrGet("src")} has no alternative text`);
  const picture = page.picture(token.attrGet("src"), alt, line);
  const { src, width, height } = picture;
  token.meta = picture;
  token.attrSet("src", src);
  for (const [name, value] of Object.entries({ width, height, loading: "lazy", decoding: "async" }))
    if (value) token.attrSet(name, value);
}

/// What only the repository has is named, and linked if the address of the repository is known.
function lead(link, href) {
  if (href) link.attrSet("href", href);
  else link.attrs = [["title", link.attrGet("href").replace(/^(\.\.\/)+/, "")]];
}

function withLinks(html, page, line) {
  const lineAt = (at) => line + (html.slice(0, at).match(/\n/g) ?? []).length;
  return html.replace(/(?<=<a\s[^>]*)href="([^"]*)"/g, (all, address, at) => {
    const href = page.target(address, lineAt(at));
    return href ? `href="${href}"` : `title="${address}"`;
  });
}

const rendered = new Map();

/// {html, text}: the text is for the search.
function formula(tex, displayMode, page, line) {
  const key = displayMode + tex;
  if (rendered.has(key)) return rendered.get(key);
  try {
    const strict = (code) => (code === "unicodeTextInMathMode" ? "ignore" : "error");
    const html = katex
      .renderToString(tex.trim(), { displayMode, strict })
      .replace(' xmlns="http://www.w3.org/1998/Math/MathML"', "") // which HTML knows
      .replace(/<annotation.*<\/annotation>/s, ""); // the source of the formula, which no browser shows
    const [, spoken] = /<semantics>(.*)<\/semantics>/s.exec(html);
    const made = {
      html: displayMode ? `<div class="formula">${html}</div>` : html,
      text: spoken.replace(/<[^>]*>/g, ""),
    };
    rendered.set(key, made);
    return made;
  } catch (error) {
    page.problem(line, `the formula $${tex.trim()}$ is none: ${error.message.replace(/^KaTeX parse error: /, "")}`);
    return { html: "", text: "" };
  }
}

function readCode(token, page) {
  const [language] = token.info.trim().split(/\s+/);
  token.meta = { language, places: language === "cpp" ? page.quoted(token.content) : [] };
}

function codeBlock({ content, meta }) {
  const { language = "", places = [] } = meta ?? {};
  const from = places.map(
    ({ href, file, line }) =>
      `<a${href ? ` href="${href}"` : ""} title="${file}, line ${line}">${file.replace(/.*\//, "")}</a>`,
  );
  const caption = from.length ? `<figcaption>${from.join(", ")}</figcaption>` : "";
  const code = highlighted(content.replace(/\n$/, ""), language);
  return `<figure class="code ${language}">${caption}<pre><code>${code}</code></pre></figure>\n`;
}

/// A paragraph that is one picture becomes a figure, and a paragraph in italics below it the caption.
function figures(tokens, page) {
  let { live } = page; // in the place of the first sheet; on a page that is no chapter's, of the first picture
  for (let i = 0; i + 2 < tokens.length; ++i) {
    const image = tokens[i].type === "paragraph_open" && onlyImage(tokens[i + 1]);
    if (!image) continue;
    const { kind } = image.meta;
    tokens[i].tag = tokens[i + 2].tag = "figure";
    tokens[i].hidden = tokens[i + 2].hidden = false;
    tokens[i].attrSet("class", kind);
    const toy = live && page.file === "README.md"; // plays by itself, so the film stays away
    if (kind === "film") film(tokens[i + 1], image, toy);
    else if (tokens[i + 1].children.length === 1) linked(tokens[i + 1], image);
    if (live && (kind === "sheet" || !page.chapter)) {
      tokens[i].attrSet("class", `live ${toy ? "toy" : kind}`);
      for (const [name, value] of Object.entries(page.figureData(image.meta.file)))
        tokens[i].attrSet(`data-${name}`, value);
      live = false;
    }
    if (tokens[i + 3]?.type === "paragraph_open" && inItalics(tokens[i + 4])) {
      tokens[i + 3].tag = tokens[i + 5].tag = "figcaption";
      tokens[i + 4].children = tokens[i + 4].children.slice(1, -1);
      const [end] = tokens.splice(i + 2, 1);
      tokens.splice(i + 5, 0, end);
    }
  }
}

function onlyImage(inline) {
  const children = inline.children.filter((child) => child.type !== "softbreak");
  if (children.length === 1 && children[0].type === "image") return children[0];
  const isLinked = children.length === 3 && children[0].type === "link_open" && children[1].type === "image";
  return isLinked ? children[1] : null;
}

function inItalics({ children }) {
  const marks = children.filter((child) => child.type === "em_open");
  return marks.length === 1 && children[0] === marks[0] && children.at(-1).type === "em_close";
}

/// A picture that leads nowhere leads to itself, where a reader can enlarge it.
function linked(inline, image) {
  const open = new inline.constructor("link_open", "a", 1);
  open.attrSet("href", image.meta.src);
  inline.children = [open, image, new inline.constructor("link_close", "a", -1)];
}

/// A film stands still until somebody asks for it. Of a toy's film there is only the still, from the start.
function film(inline, image, toy) {
  image.attrSet("src", image.meta.still);
  if (toy) {
    image.attrSet("loading", "eager");
    image.meta.onlyStill = true;
    inline.children = [image];
    return;
  }
  const button = new inline.constructor("html_inline", "", 0);
  const size = (image.meta.bytes / 1e6).toFixed(1);
  button.content =
    `<button type="button" class="play" data-film="${escaped(image.meta.src)}" hidden>` +
    `<span aria-hidden="true">▶</span> <span class="label">Play the film</span> <small>${size} MB</small></button>`;
  inline.children = [image, button];
}

/// Tables of pictures, tables without a head, and cells that pass or fail.
function tables(tokens) {
  let open = null;
  for (let i = 0; i < tokens.length; ++i) {
    const token = tokens[i];
    if (token.type === "table_open") open = token;
    if (token.type === "thead_open") {
      const end = tokens.findIndex((other, at) => at > i && other.type === "thead_close");
      const head = tokens.slice(i, end);
      if (head.every((other) => other.type !== "inline" || !other.content.trim())) {
        tokens.splice(i, end - i + 1);
        --i;
      }
    }
    if (token.type !== "inline" || tokens[i - 1]?.type !== "td_open") continue;
    const [, mark] = /^(?:★ )?([✓✗])/.exec(token.content) ?? [];
    if (mark) tokens[i - 1].attrJoin("class", mark === "✓" ? "pass" : "fail");
    else markVariant(token);
    if (token.children.some((child) => child.type === "image")) open.attrJoin("class", "pictures");
  }
}

/// The shape before the name of a variant has the colour that it has on the sheet and in the plot.
function markVariant(cell) {
  const [first] = cell.children;
  const which = "●■▲◆▼★✚".indexOf(first?.content[0] || " ");
  if (which < 0 || first.type !== "text") return;
  const mark = new cell.constructor("html_inline", "", 0);
  mark.content = `<span class="mark-${which}">${first.content[0]}</span>`;
  first.content = first.content.slice(1).trimStart();
  cell.children.unshift(mark);
}

/// The text that one reads, without marks.
function plain(children) {
  return children
    .map((child) => {
      if (child.type === "softbreak" || child.type === "hardbreak") return " ";
      if (child.type === "html_inline") return "";
      return math.includes(child.type) ? child.meta.text : child.content;
    })
    .join("");
}
