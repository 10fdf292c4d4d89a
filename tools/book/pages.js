/// What the layout is told of each page: where it stands in the course, its contents, what belongs to it.
import path from "node:path";
import { withUnits } from "./markdown.js";
import { relative, toRoot } from "./outline.js";
import { escaped, sourceHtml } from "./sources.js";

/// All pages of the book with their neighbours, the gallery, sources and folders of sources.
export function pagesOf(book, root) {
  const pages = book.pages.map((page) => described(page, book));
  pages.push(gallery(book));
  const read = pages.filter((page) => !page.parent);
  const course = [...new Set(read.map(({ part }) => part))].map((name) => ({
    name,
    pages: read.filter(({ part }) => part === name),
  }));
  for (const page of pages) {
    const at = read.indexOf(page);
    page.course = course;
    page.above = pages.find((other) => other.file === page.parent);
    page.children = pages.filter((other) => other.parent === page.file);
    page.related = pages.filter((other) => other.parent === (page.parent ?? page.file));
    page.before = at > 0 && read[at - 1];
    page.after = at >= 0 && read[at + 1];
  }
  return [...pages, { ...missing, course }, ...sourcePages(book, root, pages)];
}

/// What a host shows for an address that is none. It stands in for any folder, so its links begin at a base that it finds itself.
const missing = {
  file: "404.html",
  address: "404.html",
  title: "There is no such page",
  sort: "missing",
  root: ".",
  html: `<p>It may have moved. Search for it above, or begin at the <a href="index.html">front page</a>, in the
<a href="gallery.html">gallery</a>, or with <a href="docs/symptoms.html">what you see</a>.</p>`,
};

function described(page, { pictures }) {
  const { file, part, chapter, live, parent, address, root, headings, sections, place } = page;
  const title = withUnits(page.title);
  const html = page.html.replace(/(<h1[^>]*>)(\d\d[a-z]?) /, '$1<span class="number">$2</span> ');
  const [, number, name = title] = /^(\d\d[a-z]?) (.*)$/.exec(title) ?? [];
  const task = /^Exercise \d\d(?:, transfer)?: (.*)$/.exec(title)?.[1];
  const sheet = pictures.find((one) => one.page.file === file && one.kind === "sheet");
  const film = pictures.find(({ kind }) => kind === "film");
  return {
    live: live || html.includes('class="small-live'),
    ...{ file, part, parent, address, root, title, html, number, place, foot: page.foot ?? [] },
    onward: onwardOf(page),
    name: file === "README.md" ? "Front page" : task ? `Exercise: ${task}` : name,
    label: task ? "Exercise" : parent ? "Table" : "",
    sort: chapter ? "chapter" : file === "README.md" ? "front" : "",
    hasTitle: headings.some(({ level }) => level === 1),
    hasFormulas: html.includes('class="katex"'),
    contents: headings.filter(({ level }) => level === 2),
    description: beginning(sections.find(({ text }) => text.trim())?.text ?? title),
    picture: sheet?.file ?? film?.file.replace(/\.webp$/, "_still.webp"), // of a link to the page
  };
}

/// The link of a chapter's foot that leads on along the trunk: "Next on the trunk → 11 Substeps", "The trunk and its branches".
function onwardOf({ foot = [], address }) {
  const link = foot.find(({ text }) => /trunk/.test(text));
  if (!link) return undefined;
  const { text, href } = link;
  const [label, title] = text.includes(" → ") ? text.split(" → ") : ["Overview", text];
  return { label, title, href, address: path.posix.join(path.posix.dirname(address), href) };
}

/// Whole sentences, some 200 characters of them: what is said where a page is linked.
function beginning(text) {
  const plain = text.replace(/\s+/g, " ").trim();
  if (plain.length <= 200) return plain;
  const whole = plain.slice(0, 200).replace(/^(.*[.?!]) .*$/, "$1");
  return whole.length < 200 ? whole : plain.slice(0, 200).replace(/ \S*$/, " …");
}

function gallery({ pictures }) {
  const shown = pictures.filter(({ kind, page }) => page.part !== "Start" || kind === "drawing");
  const once = shown.filter(({ file }, i) => shown.findIndex((one) => one.file === file) === i);
  const card = ({ page, heading, file, width, height, alt }) => {
    const to = `${page.address}${heading?.level > 1 ? `#${heading.id}` : ""}`;
    return (
      `<li><a href="${to}"><img src="${file}" width="${width}" height="${height}" alt="${escaped(alt)}" ` +
      `loading="lazy" decoding="async"><span>${escaped(page.title)}</span></a></li>`
    );
  };
  const parts = [
    { id: "sheets", text: "Sheets", kind: "sheet" },
    { id: "plots", text: "Plots", kind: "plot" },
    { id: "drawings", text: "Figures", kind: "drawing" },
  ];
  const html = parts.map(({ id, text, kind }) => {
    const cards = once.filter((one) => one.kind === kind).map(card);
    return `<h2 id="${id}">${text}</h2>\n<ul class="gallery ${id}">\n${cards.join("\n")}\n</ul>`;
  });
  return {
    ...{
      file: "gallery.html",
      address: "gallery.html",
      part: "Understand",
      title: "Gallery",
      name: "Gallery",
      root: ".",
    },
    contents: parts,
    html: `<p>Every sheet, plot and figure of the book. Each leads to the place where it is explained.</p>\n${html.join("\n")}`,
  };
}

/// Beside a source are the pages in which it is read, and the front page, not the whole course: there are five hundred sources.
function sourcePages(book, root, pages) {
  const front = pages.find(({ file }) => file === "README.md");
  const shown = new Map(book.sources.map((source) => [source.file, source]));
  const common = ({ file, address, readIn = [] }) => {
    const beside = pages.filter((page) => readIn.some((one) => one.file === page.file));
    return {
      ...{ file, address, sort: "source", root: toRoot(address), title: path.posix.basename(file) },
      folder: file.includes("/") ? `${path.posix.dirname(file)}/` : "",
      readIn: beside,
      course: [...(beside.length ? [{ name: "Read in", pages: beside }] : []), { name: "The book", pages: [front] }],
    };
  };
  const files = book.sources.map((source) => {
    const link = (included) => shown.has(included) && relative(source.address, shown.get(included).address);
    return { ...common(source), html: sourceHtml(root, source.file, link, source.lines) };
  });
  const folders = book.folders.map((folder) => {
    const items = folder.names.map((name) => `<li><a href="${name}.html">${name}</a></li>`);
    return { ...common(folder), html: `<ul class="files">\n${items.join("\n")}\n</ul>` };
  });
  return [...files, ...folders];
}
