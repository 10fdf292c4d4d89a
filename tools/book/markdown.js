/// Markdown as GitHub shows it, made into HTML for the book. What cannot be shown right is a problem, with its file and line.
import GithubSlugger from "github-slugger";
import katex from "katex";
import MarkdownIt from "markdown-it";
import mathSyntax from "@vscode/markdown-it-katex";
import { linkCases } from "./cases.js";
import { linkChallenges } from "./challenges.js";
import { idle } from "./idle.js";
import { settingSentences } from "./set.js";
import { smallPictures } from "./small.js";
import { escaped, highlightedDifference, highlightedLines } from "./sources.js";

const math = ["math_inline", "math_inline_block", "math_inline_bare_block", "math_block"];

/// The page being read comes as the environment of markdown-it. It is given `headings`, `sections` and `pictures`, and says
/// `page.problem(line, text)`, `page.target(address, line)`, `page.picture(address, alt, line)`, `page.quoted(code, line)`.
export function markdown() {
  const md = new MarkdownIt({ html: true, typographer: true });
  md.use(mathSyntax.default ?? mathSyntax);
  md.core.ruler.disable("replacements"); // quotation marks are made typographic, nothing else is
  md.core.ruler.push("page", readPage);
  for (const kind of math) md.renderer.rules[kind] = (tokens, i) => tokens[i].meta;
  md.renderer.rules.fence = (tokens, i) => codeBlock(tokens[i]);
  md.renderer.rules.code_block = (tokens, i) => codeBlock(tokens[i]);
  md.renderer.rules.table_open = (tokens, i, options, env, self) =>
    `<div class="table"><table${self.renderAttrs(tokens[i])}>\n`;
  md.renderer.rules.table_close = () => "</table></div>\n";
  return md;
}

function readPage({ tokens, env: page }) {
  const slugger = new GithubSlugger();
  page.headings = [];
  page.sections = [{ id: "", title: "", text: "" }];
  let line = 1;
  let inHeading = null;
  tokens.forEach((token, i) => {
    if (token.map) line = token.map[0] + 1;
    if (
      token.type === "ordered_list_open" &&
      tokens[i - 3]?.map?.[1] === token.map[0] &&
      tokens[i - 1].type === "paragraph_close"
    )
      page.problem(line, "this line begins with a number and a dot, so a list begins here, within a paragraph");
    if (token.type === "fence" && token.info.trim() === "math") token.type = "math_block";
    if (token.type === "heading_open") inHeading = token;
    else if (token.type === "heading_close") inHeading = null;
    else if (token.type === "html_block") token.content = withLinks(token.content, page, line);
    else if (token.type === "fence" || token.type === "code_block") readCode(token, page, line);
    else if (math.includes(token.type)) token.meta = formula(token.content, true, page, line);
    else if (token.type === "inline") {
      readInline(token, page, line);
      const text = plain(token.children);
      if (inHeading) {
        const id = slugger.slug(text.replace(/[“”‘’]/g, ""));
        inHeading.attrSet("id", id);
        const level = Number(inHeading.tag[1]);
        page.headings.push({ level, id, text });
        if (level === 1) page.sections[0].title = text;
        else page.sections.push({ id, title: text, text: "" });
      } else {
        page.sections.at(-1).text += text + " ";
      }
    }
  });
  if (page.chapter && endsWithNeighbours(tokens)) tokens.splice(-3);
  alerts(tokens);
  figures(tokens, page);
  tables(tokens);
  linkCases(tokens, page);
  smallPictures(tokens, page);
  settingSentences(tokens, page);
  linkChallenges(tokens, page);
}

/// Whether the last line of a page names its neighbours and nothing else: the book has links of its own there.
function endsWithNeighbours(tokens) {
  const last = tokens.at(-2)?.children ?? [];
  const besides = last.filter((child, i) => child.type === "text" && last[i - 1]?.type !== "link_open");
  return last[0]?.type === "link_open" && !/\w/.test(besides.map((child) => child.content).join(""));
}

function readInline(token, page, line) {
  for (const child of token.children) {
    if (child.type === "softbreak" || child.type === "hardbreak") ++line;
    if (child.type === "text" && child.content.includes("$"))
      page.problem(line, `a dollar sign that belongs to no formula: ${child.content.trim().slice(0, 60)}`);
    if (child.type === "text" && /\[\^[^\]]+\]/.test(child.content))
      page.problem(line, "the book has no footnotes: a note that matters gets a sentence");
    if (child.type === "code_inline" && child.content.length <= 24) child.attrSet("class", "short");
    if (child.type === "link_open") child.attrSet("href", page.target(child.attrGet("href"), line));
    if (child.type === "html_inline") child.content = withLinks(child.content, page, line);
    if (child.type === "image") readImage(child, page, line);
    if (math.includes(child.type)) child.meta = formula(child.content, child.type !== "math_inline", page, line);
    line += (child.content.match(/\n/g) ?? []).length;
  }
}

function readImage(token, page, line) {
  const alt = token.content.replace(/\s+/g, " ").trim();
  if (!alt) page.problem(line, `the picture ${token.attrGet("src")} has no alternative text`);
  const picture = page.picture(token.attrGet("src"), alt, page.headings.at(-1), line);
  token.meta = picture;
  token.attrSet("src", picture.src);
  if (picture.width) {
    token.attrSet("width", picture.width);
    token.attrSet("height", picture.height);
  }
  token.attrSet("loading", "lazy");
  token.attrSet("decoding", "async");
}

function withLinks(html, page, line) {
  const lineAt = (at) => line + (html.slice(0, at).match(/\n/g) ?? []).length;
  return html.replace(
    /(<a\s[^>]*href=")([^"]*)"/g,
    (all, before, address, at) => `${before}${page.target(address, lineAt(at))}"`,
  );
}

const rendered = new Map();

function formula(tex, display, page, line) {
  const key = display + tex;
  if (rendered.has(key)) return rendered.get(key);
  try {
    const strict = (code) => (code === "unicodeTextInMathMode" ? "ignore" : "error");
    const html = katex.renderToString(tex.trim(), {
      displayMode: display,
      throwOnError: true,
      strict,
      output: "htmlAndMathml",
    });
    const own = html.replace(' xmlns="http://www.w3.org/1998/Math/MathML"', ""); // which HTML knows
    rendered.set(key, display ? `<div class="formula">${own}</div>` : own);
    return rendered.get(key);
  } catch (error) {
    page.problem(line, `the formula $${tex.trim()}$ is none: ${error.message.replace(/^KaTeX parse error: /, "")}`);
    return "";
  }
}

function readCode(token, page, line) {
  token.meta = { language: token.info.trim().split(/\s+/)[0] };
  if (token.meta.language === "cpp") token.meta.places = page.quoted(token.content, line);
}

function codeBlock(token) {
  const { language, places = [] } = token.meta;
  const code = token.content.replace(/\n$/, "");
  const lines =
    language === "diff" ? highlightedDifference(code) : highlightedLines(code, language === "sh" ? "bash" : language);
  const from = places
    .map(({ href, name, line, file }) => `<a href="${href}" title="${file}, line ${line}">${name}</a>`)
    .join(", ");
  const caption = from ? `<figcaption>${from}</figcaption>` : "";
  return `<figure class="code ${language}">${caption}<pre><code>${lines.join(language === "diff" ? "" : "\n")}</code></pre></figure>\n`;
}

/// GitHub's alerts: a quotation that begins with [!NOTE] or another of its five words.
function alerts(tokens) {
  tokens.forEach((token, i) => {
    const words = token.type === "blockquote_open" && tokens[i + 2]?.children;
    const [, kind] = /^\[!(NOTE|TIP|IMPORTANT|WARNING|CAUTION)\]$/.exec(words?.[0]?.content ?? "") ?? [];
    if (!kind) return;
    token.attrSet("class", `alert ${kind.toLowerCase()}`);
    words[0].type = "html_inline";
    words[0].content = `<strong>${kind[0]}${kind.slice(1).toLowerCase()}</strong>`;
    if (words[1]) words[1].type = "hardbreak";
  });
}

/// A paragraph that is one picture becomes a figure, and a paragraph in italics below it the caption.
function figures(tokens, page) {
  let live = page.live; // in the place of the first sheet; on a page that is no chapter's, of the first picture
  for (let i = 0; i + 2 < tokens.length; ++i) {
    const image = tokens[i].type === "paragraph_open" && onlyImage(tokens[i + 1]);
    if (!image) continue;
    const kind = image.meta.kind;
    tokens[i].tag = tokens[i + 2].tag = "figure";
    tokens[i].hidden = tokens[i + 2].hidden = false;
    tokens[i].attrSet("class", kind);
    if (kind === "film") film(tokens[i + 1], image);
    else if (tokens[i + 1].children.length === 1) linked(tokens[i + 1], image);
    if (live && (kind === "sheet" || !page.chapter)) {
      tokens[i].attrSet("class", `live ${kind}`);
      tokens[i].attrSet("data-chapter", live);
      tokens[i].attrSet("data-root", page.root);
      tokens[i].attrSet("data-idle", JSON.stringify(idle[live] ?? {}));
      const challenges = page.challenged?.get(live)?.map(({ best, ...rest }) => rest);
      if (page.chapter && challenges) tokens[i].attrSet("data-challenges", JSON.stringify(challenges));
      live = false;
    }
    const caption = tokens[i + 3]?.type === "paragraph_open" && inItalics(tokens[i + 4]);
    if (caption) {
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
  const linked = children.length === 3 && children[0].type === "link_open" && children[1].type === "image";
  return linked ? children[1] : null;
}

function inItalics(inline) {
  const children = inline.children;
  const ends = children.filter((child) => child.type === "em_open").length === 1;
  return ends && children[0].type === "em_open" && children.at(-1).type === "em_close";
}

/// A picture that leads nowhere leads to itself, where a reader can enlarge it.
function linked(inline, image) {
  const open = new inline.constructor("link_open", "a", 1);
  open.attrSet("href", image.meta.src);
  open.attrSet("class", "enlarge");
  inline.children = [open, image, new inline.constructor("link_close", "a", -1)];
}

/// A film stands still until somebody asks for it.
function film(inline, image) {
  image.attrSet("src", image.meta.still);
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
      if (tokens.slice(i, end).every((other) => other.type !== "inline" || !other.content.trim()))
        tokens.splice(i--, end - i);
    }
    if (token.type !== "inline" || tokens[i - 1]?.type !== "td_open") continue;
    const [, verdictMark] = /^(?:★ )?([✓✗])/.exec(token.content) ?? [];
    const verdict = { "✓": "pass", "✗": "fail" }[verdictMark];
    if (!verdict) markVariant(token);
    else tokens[i - 1].attrJoin("class", verdict);
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
      return math.includes(child.type) ? spoken(child.content) : child.content;
    })
    .join("");
}

const greek = {
  alpha: "α",
  beta: "β",
  gamma: "γ",
  delta: "δ",
  epsilon: "ε",
  varepsilon: "ε",
  eta: "η",
  theta: "θ",
  kappa: "κ",
  lambda: "λ",
  mu: "μ",
  pi: "π",
  rho: "ρ",
  sigma: "σ",
  tau: "τ",
  varphi: "φ",
  omega: "ω",
  Delta: "Δ",
  Sigma: "Σ",
  Pi: "Π",
  Omega: "Ω",
  zeta: "ζ",
  le: "≤",
  ge: "≥",
  cdot: "·",
  times: "×",
};

/// A formula as a line of text, for the search.
function spoken(tex) {
  return tex
    .replace(/\\([A-Za-z]+)/g, (all, name) => greek[name] ?? " ")
    .replace(/[{}\\^&]/g, "")
    .replace(/_/g, "");
}
