/// Reads all pages, and with them everything that they name: pages, headings, sources, pictures. Throws with all problems at once.
import fs from "node:fs";
import path from "node:path";
import { imageSize } from "image-size";
import { challengeOf, challengesIn } from "./marks.js";
import { markdown } from "./markdown.js";
import { addressOf, outline, relative, toRoot } from "./outline.js";
import { placesOf, quotable } from "./sources.js";
import { withSymbols } from "./symbols.js";

const copied = /\.(png|svg|webp)$/;
const elsewhere = /^(tests|tools)(\/|$)|\.csv$/; // sources and data that are read in the repository, not in the book
const challenges = "docs/challenges.md";

export class Problems extends Error {
  constructor(problems) {
    super(["the book was not built:", ...problems].join("\n  "));
  }
}

/// {pages, sources, folders, files, pictures}: `sources` are shown as pages of their own, `files` are copied as they are.
/// `live`: the experiments that are there to be run, each an engine by its name; `idle`: sliders that change nothing in a
/// scene; `repository`: its web address, where it is known.
export function readBook(root, live = new Map(), idle = {}, repository) {
  const problems = [];
  const files = new Set();
  const pictures = [];
  const anchors = [];
  const folders = new Map();
  const shown = new Map(); // each source that is shown: {readIn, lines}, the pages that name it, and the lines they lead to
  const quotes = quotable(root);
  const md = markdown();
  const pages = outline(root);
  const byFile = new Map(pages.map((page) => [page.file, page]));

  const show = (file, page, line) => {
    if (!shown.has(file)) shown.set(file, { readIn: new Set(), lines: new Set() });
    shown.get(file).readIn.add(page);
    shown.get(file).lines.add(line);
  };
  const inRepository = (file, kind = "blob") => repository && `${repository}/${kind}/HEAD/${file}`;

  function target(page, address, line) {
    const wrong = (text) => (page.problem(line, text), address);
    if (/^[a-z]+:/i.test(address)) {
      if (/^(https?:\/\/[\w-]+(\.[\w-]+)+(\/\S*)?|mailto:\S+@\S+)$/.test(address)) return address;
      return wrong(`no address has the form ${address}`);
    }
    const [name, anchor] = decodeURI(address).split("#");
    const file = name ? path.posix.join(path.posix.dirname(page.file), name).replace(/\/$/, "") : page.file;
    const there = file.startsWith("..") ? null : fs.statSync(path.join(root, file), { throwIfNoEntry: false });
    if (!there) return wrong(`the link to ${address}: there is no such file`);
    if (file.endsWith(".md")) {
      if (!byFile.has(file)) return wrong(`the link to ${address}: the book has no such page (tools/book/outline.js)`);
      if (anchor) anchors.push({ page, line, file, anchor });
      return (name ? relative(page.address, addressOf(file)) : "") + (anchor ? `#${encodeURIComponent(anchor)}` : "");
    }
    if (anchor) return wrong(`the link to ${address}: an anchor in what is no page`);
    if (elsewhere.test(file) && !copied.test(file)) return inRepository(file, there.isDirectory() ? "tree" : "blob");
    if (there.isDirectory()) {
      const within = fs.readdirSync(path.join(root, file)).filter((one) => /\.(h|cpp)$/.test(one));
      folders.set(file, within);
      for (const source of within) show(`${file}/${source}`, page);
      return relative(page.address, `${file}/index.html`);
    }
    if (copied.test(file)) files.add(file);
    else show(file, page);
    return relative(page.address, copied.test(file) ? file : `${file}.html`);
  }

  function picture(page, address, alt, line) {
    const src = target(page, address, line);
    const file = path.posix.join(path.posix.dirname(page.address), src);
    const made = { src, file, alt, page, heading: page.headings.at(-1), kind: kindOf(file) };
    if (!files.has(file)) return made; // the problem has been said
    const bytes = fs.readFileSync(path.join(root, file));
    Object.assign(made, imageSize(bytes), { bytes: bytes.length });
    if (made.kind === "film") made.still = src.replace(/\.webp$/, "_still.webp");
    pictures.push(made);
    return made;
  }

  function quoted(page, code) {
    return placesOf(code, page.file, quotes).map(({ file, line }) => {
      if (elsewhere.test(file)) return { file, line, href: repository && `${inRepository(file)}#L${line}` };
      show(file, page, line);
      return { file, line, href: `${relative(page.address, `${file}.html`)}#L${line}` };
    });
  }

  const challenged = challengesOf(root, live, problems);
  for (const page of pages) {
    page.address = addressOf(page.file);
    page.root = toRoot(page.address);
    page.engines = live;
    page.engine = live.get(page.experiment);
    page.live = page.engine && page.experiment;
  }
  for (const page of pages) {
    page.text = inBook(fs.readFileSync(path.join(root, page.file), "utf8"));
    page.title ??= /^# (.*)$/m.exec(page.text)?.[1] ?? page.file;
    page.challenged = challenged;
    page.played = pages.find((one) => one.live === "hard_cases");
    page.problem = (line, text) => problems.push(`${page.file}:${line}: ${text}`);
    page.target = (address, line) => target(page, address, line);
    page.picture = (address, alt, line) => picture(page, address, alt, line);
    page.quoted = (code) => quoted(page, code);
    page.figureData = (file) => ({
      chapter: page.live,
      sheet: sceneOf(file, page.engine),
      root: page.root,
      idle: JSON.stringify(idle[page.live] ?? {}),
      challenges: JSON.stringify((page.chapter && challenged.get(page.live)) || []),
    });
    page.html = md.render(page.text, page);
    if (/^chapters\/0[1-7]_\w+\/README/.test(page.file)) page.html = withSymbols(page.html);
  }
  for (const { page, line, file, anchor } of anchors)
    if (!byFile.get(file).headings.some(({ id }) => id === anchor))
      page.problem(line, `the link to ${file}#${anchor}: there is no such heading`);
  if (problems.length) throw new Problems(problems);

  return {
    pages,
    sources: [...shown].map(([file, { readIn, lines }]) => ({
      ...{ file, lines },
      address: `${file}.html`,
      readIn: [...readIn],
    })),
    folders: [...folders].map(([file, names]) => ({ file, address: `${file}/index.html`, names })),
    files: [...files].filter((file) => !pictures.some((one) => one.onlyStill && one.file === file)),
    pictures,
  };
}

/// Leaves out what a page says on GitHub only, between <!-- github --> and <!-- /github -->, and shows what it says in the book
/// only, <!-- book: in a comment -->. The lines keep their numbers.
const inBook = (text) =>
  text
    .replace(/<!-- github -->(.*?)<!-- \/github -->([^\n]*)/gs, (all, part, rest) => rest + part.replace(/./g, ""))
    .replace(/<!-- book: (.*?) -->/gs, "$1");

/// Of each chapter its challenges.
function challengesOf(root, live, problems) {
  const found = new Map();
  const text = fs.existsSync(path.join(root, challenges)) ? fs.readFileSync(path.join(root, challenges), "utf8") : "";
  for (const one of challengesIn(text)) {
    const { chapter } = one.asked;
    const engine = live.get(chapter);
    if (!engine) continue;
    try {
      found.set(chapter, [...(found.get(chapter) ?? []), challengeOf(one, engine)]);
    } catch (refused) {
      problems.push(`${challenges}:${one.line}: the challenge: ${refused.message}`);
    }
    engine.set("");
  }
  return found;
}

/// The key of the scene that a sheet of its own shows, renders/CHAPTER/sheet_KEY.png; "" for the sheet of the first scene.
function sceneOf(file, engine) {
  const [, key] = /\/sheet_([^/]*)\.png$/.exec(file) ?? [];
  return engine.description.scenes.some((scene) => scene.key === key) ? key : "";
}

function kindOf(file) {
  const name = path.posix.basename(file);
  if (name.startsWith("sheet")) return "sheet";
  if (name.endsWith(".svg")) return "drawing";
  if (name.endsWith(".webp")) return "film";
  return /^(guess|start|thumbnail)/.exec(name)?.[0] ?? "plot";
}

/// The first picture of an animated WebP as a file of its own: its chunk of pixels, which has to fill the whole canvas.
export function stillOf(film) {
  for (let at = 12; at < film.length;) {
    const length = film.readUInt32LE(at + 4);
    if (film.toString("latin1", at, at + 4) === "ANMF") {
      const pixels = film.subarray(at + 8 + 16, at + 8 + length);
      const head = Buffer.from("RIFF....WEBP", "latin1");
      head.writeUInt32LE(4 + pixels.length, 4);
      return Buffer.concat([head, pixels]);
    }
    at += 8 + length + (length & 1);
  }
  throw new Error("this is no film: there is no frame in it");
}
