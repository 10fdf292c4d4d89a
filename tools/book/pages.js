/// What the layouts are told of each page: where it stands in the course, its contents, what belongs to it.
import path from "node:path";
import { relative, toRoot } from "./outline.js";
import { escaped, sourceLines } from "./sources.js";

/// All pages of the book with their neighbours, the gallery behind the first two parts, sources and folders of sources.
export function pagesOf(book, root) {
  const pages = book.pages.map((page) => ({ ...described(page), picture: seenOf(page, book) }));
  pages.splice(
    pages.findLastIndex((page) => page.part === "Chapters" || page.part === "Exercises") + 1,
    0,
    gallery(book),
  );
  const read = pages.filter((page) => !page.parent);
  for (const page of pages) {
    const at = read.indexOf(page);
    page.above = short(pages.find((other) => other.file === page.parent));
    page.children = pages.filter((other) => other.parent === page.file).map(short);
    page.related = pages.filter((other) => other.parent === (page.parent ?? page.file)).map(short);
    page.before = short(at > 0 && read[at - 1]);
    page.after = short(at >= 0 && read[at + 1]);
  }
  return [...pages, missing, ...sourcePages(book, root)];
}

/// What a host shows for an address that is none. It stands in for any folder, so its links begin at a base that it finds itself.
const missing = {
  file: "404.html",
  address: "404.html",
  layout: "page.njk",
  title: "There is no such page",
  name: "There is no such page",
  sort: "missing",
  root: ".",
  contents: [],
  html: `<p>It may have moved. Search for it above, or begin at the <a href="index.html">front page</a>, in the
<a href="gallery.html">gallery</a>, or with <a href="docs/symptoms.html">what you see</a>.</p>`,
};

/// The picture of a link to a page: its sheet, or the front page's film, as it begins.
function seenOf({ file }, { pictures }) {
  const sheet = pictures.find(({ page, kind }) => page.file === file && kind === "sheet");
  return sheet?.file ?? pictures.find(({ kind }) => kind === "film")?.file.replace(/\.webp$/, "_still.webp");
}

/// As much of a page as a link to it shows.
const short = (page) =>
  page && {
    file: page.file,
    address: page.address,
    title: page.title,
    name: page.name,
    label: page.label,
    number: page.number,
  };

/// The parts of the course with the pages that are read one after the other: the contents beside every page.
export function courseOf(pages) {
  return ["Start", "Chapters", "Further"].map((name) => ({
    name,
    pages: pages.filter((page) => page.part === name).map(short),
  }));
}

function described({ file, part, chapter, live, parent, address, root, title, headings, sections, html }) {
  const numbered = html.replace(/(<h1[^>]*>)(\d\d) /, '$1<span class="number">$2</span> ');
  const page = { file, part, chapter, live, parent, address, root, title, html: numbered };
  const [, number, name = title] = /^(\d\d) (.*)$/.exec(page.title) ?? [];
  const task = /^Exercise \d\d(?:, transfer)?: (.*)$/.exec(title)?.[1];
  return {
    ...page,
    layout: "page.njk",
    number,
    name: file === "README.md" ? "Front page" : task ? `Exercise: ${task}` : name,
    label: task ? "Exercise" : parent ? "Table" : "",
    sort: chapter ? "chapter" : file === "README.md" ? "front" : "",
    hasTitle: headings.some(({ level }) => level === 1),
    hasFormulas: html.includes('class="katex"'),
    contents: headings.filter(({ level }) => level === 2),
    description: beginning(sections.find(({ text }) => text.trim())?.text ?? title),
  };
}

/// Whole sentences, some 200 characters of them: what is said where a page is linked.
function beginning(text) {
  const plain = text.replace(/\s+/g, " ").trim();
  if (plain.length <= 200) return plain;
  const whole = plain.slice(0, 200).replace(/^(.*[.?!]) .*$/, "$1");
  return whole.length < 200 ? whole : plain.slice(0, 200).replace(/ \S*$/, " …");
}

const parts = [
  { id: "sheets", title: "Sheets", kind: "sheet" },
  { id: "plots", title: "Plots", kind: "plot" },
  { id: "drawings", title: "Figures", kind: "drawing" },
];

/// A sheet is of one scene: sheet_KEY.png, or sheet.png of the first that has one.
const keyOf = (file) => /sheet_(.*)\.png$/.exec(file)?.[1];

function scenesWithoutSheet(page, pictures) {
  const { scenes } = page.description;
  const shown = pictures
    .filter((picture) => picture.kind === "sheet" && picture.page === page)
    .map(({ file }) => keyOf(file) ?? (scenes.find((scene) => scene.pictures) ?? scenes[0]).key);
  return scenes.filter(({ key }) => !shown.includes(key));
}

function gallery({ pictures, pages }) {
  const address = "gallery.html";
  const once = [
    ...new Map(
      pictures
        .filter(({ page, kind }) => page.part !== "Start" || kind === "drawing")
        .map((picture) => [picture.file, picture]),
    ).values(),
  ];
  const run = ({ kind, file, page }) => {
    if (!page.live || kind !== "sheet") return "";
    const key = keyOf(file);
    return `<a class="run" href="${page.address}#live=${page.live}${key ? `&amp;scene=${key}` : ""}">Run it</a>`;
  };
  const card = (picture) => {
    const to = `${picture.page.address}${picture.heading?.level > 1 ? `#${picture.heading.id}` : ""}`;
    return (
      `<li><a href="${to}"><img src="${picture.file}" width="${picture.width}" height="${picture.height}" alt="${escaped(picture.alt)}" ` +
      `loading="lazy" decoding="async"><span>${escaped(picture.page.title)}</span></a>${run(picture)}</li>`
    );
  };
  const html = parts.map(({ id, title, kind }) => {
    const cards = once
      .filter((picture) => picture.kind === kind)
      .map(card)
      .join("\n");
    return `<h2 id="${id}">${title}</h2>\n<ul class="gallery ${id}">\n${cards}\n</ul>`;
  });
  const contents = parts.map(({ id, title }) => ({ id, text: title }));
  const add = (id, title, words, links) => {
    if (!links.length) return;
    const items = links.map((link) => `<li><a href="${escaped(link.address)}">${escaped(link.title)}</a></li>`);
    html.push(`<h2 id="${id}">${title}</h2>\n<p>${words}</p>\n<ul class="gallery cases">\n${items.join("\n")}\n</ul>`);
    contents.push({ id, text: title });
  };
  const further = pages
    .filter(({ description }) => description)
    .flatMap((page) =>
      scenesWithoutSheet(page, once).map(({ key, name }) => ({
        address: `${page.address}#live=${page.live}&scene=${key}`,
        title: `${page.title}: ${name}`,
      })),
    );
  add("scenes", "Scenes without a sheet", "Each runs on its chapter's page.", further);
  add(
    "problems",
    "One step, iteration by iteration",
    "A step's problem and its matrix, solved by several methods.",
    pages.flatMap((page) =>
      (page.description?.problems ?? []).map((name, i) => ({
        address: `${page.address}#live=${page.live}&problem=${i}`,
        title: `${page.title}: ${name}`,
      })),
    ),
  );
  add(
    "hard-cases",
    "Hard cases",
    "Each is run under chapter 07's solver and under all together.",
    pages.flatMap((page) => page.cases ?? []),
  );
  return {
    file: address,
    address,
    layout: "page.njk",
    part: "Further",
    title: "Gallery",
    name: "Gallery",
    sort: "pictures",
    root: ".",
    contents,
    html: `<p>Every sheet, plot and figure of the book. Each leads to the place where it is explained.</p>\n${html.join("\n")}`,
  };
}

/// Beside a source are the pages in which it is read, and the front page, not the whole course: there are five hundred sources.
const besideSource = (readIn, front) => [
  ...(readIn.length ? [{ name: "Read in", pages: readIn }] : []),
  { name: "The book", pages: [front] },
];

function sourcePages(book, root) {
  const front = short(described(book.pages.find(({ file }) => file === "README.md")));
  const shown = new Map(book.sources.map((source) => [source.file, source]));
  const common = ({ file, address, readIn = [] }) => {
    const folder = path.posix.dirname(file);
    return {
      file,
      address,
      course: besideSource(
        readIn.map((page) => short(described(page))),
        front,
      ),
      readIn: readIn.map(short),
      folder: folder === "." ? "" : `${folder}/`,
      title: path.posix.basename(file),
      layout: "source.njk",
      sort: "source",
      root: toRoot(address),
      contents: [],
    };
  };
  const files = book.sources.map((source) => {
    const link = (included) => shown.has(included) && relative(source.address, shown.get(included).address);
    const lines = sourceLines(root, source.file, link).map((line, i) => `<i id="L${i + 1}">${line}\n</i>`);
    return { ...common(source), html: `<pre class="numbered"><code>${lines.join("")}</code></pre>` };
  });
  const folders = book.folders.map((folder) => {
    const items = folder.names.map(
      (name) => `<li><a href="${path.posix.basename(name)}.html">${path.posix.basename(name)}</a></li>`,
    );
    return { ...common(folder), html: `<ul class="files">\n${items.join("\n")}\n</ul>` };
  });
  return [...files, ...folders];
}
