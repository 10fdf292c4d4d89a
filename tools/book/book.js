/// Reads all pages, and with them everything that they name: pages, headings, sources, pictures. Throws with all problems at once.
import fs from "node:fs";
import path from "node:path";
import { imageSize } from "image-size";
import { challengesOf } from "./challenges.js";
import { markdown } from "./markdown.js";
import { addressOf, outline, relative, toRoot } from "./outline.js";
import { includedBy, Sources } from "./sources.js";

const copied = /\.(png|svg|webp|csv)$/;

/// {pages, sources, folders, files, pictures}: `sources` are shown as pages of their own, `files` are copied as they are.
/// `live`: the experiments that are there to be run, each an engine by its name.
export function readBook(root, live = new Map()) {
  const reader = new Reader(root, live);
  for (const page of reader.pages) reader.read(page);
  reader.checkAnchors();
  if (reader.problems.length) throw new Problems(reader.problems);
  return reader.book();
}

export class Problems extends Error {
  constructor(problems) {
    super(["the book was not built:", ...problems].join("\n  "));
  }
}

class Reader {
  problems = [];
  files = new Set();
  pictures = [];
  #anchors = [];
  #shown = new Map(); // each source that is shown, and the pages that name it
  #folders = new Set();
  #names;

  constructor(root, live) {
    this.root = root;
    this.code = new Sources(root);
    this.md = markdown();
    this.pages = outline(root).map((page) => ({
      ...page,
      address: addressOf(page.file),
      live: live.has(page.experiment) ? page.experiment : undefined,
      engine: live.get(page.experiment),
      description: page.chapter && live.get(page.experiment)?.description,
    }));
    this.challenged = challengesOf(root, live, (line, text) =>
      this.problems.push(`docs/challenges.md:${line}: ${text}`),
    );
    this.#names = new Map(this.pages.map((page) => [page.file, page]));
  }

  read(page) {
    page.text = fs.readFileSync(path.join(this.root, page.file), "utf8");
    page.title ??= /^# (.*)$/m.exec(page.text)?.[1] ?? page.file;
    page.root = toRoot(page.address);
    page.challenged = this.challenged;
    page.played = this.pages.find((one) => one.live === "hard_cases");
    page.problem = (line, text) => this.problems.push(`${page.file}:${line}: ${text}`);
    page.target = (address, line) => this.#target(page, address, line);
    page.picture = (address, alt, heading, line) => this.#picture(page, address, alt, heading, line);
    page.quoted = (code, line) => this.#quoted(page, code, line);
    page.html = this.md.render(page.text, page);
  }

  checkAnchors() {
    for (const { page, line, file, anchor } of this.#anchors) {
      const headings = this.#names.get(file).headings;
      if (!headings.some(({ id }) => id === anchor))
        page.problem(line, `the link to ${file}#${anchor}: there is no such heading`);
    }
  }

  book() {
    const sources = [...this.#shown.keys()];
    for (const file of sources) {
      // grows while it is gone through
      if (!/\.(h|cpp)$/.test(file)) continue;
      for (const included of includedBy(this.root, file)) {
        if (this.#shown.has(included)) continue;
        this.#shown.set(included, new Set());
        sources.push(included);
      }
    }
    return {
      pages: this.pages,
      sources: sources.sort().map((file) => ({ file, address: `${file}.html`, readIn: [...this.#shown.get(file)] })),
      folders: [...this.#folders].map((file) => ({
        file,
        address: `${file}/index.html`,
        names: this.#sourcesIn(file),
      })),
      files: [...this.files],
      pictures: this.pictures,
    };
  }

  #target(page, address, line) {
    if (/^[a-z]+:/i.test(address)) {
      if (!/^(https?:\/\/[\w-]+(\.[\w-]+)+(\/\S*)?|mailto:\S+@\S+)$/.test(address))
        page.problem(line, `no address has the form ${address}`);
      return address;
    }
    const [name, anchor] = decodeURI(address).split("#");
    const file = name
      ? path.posix.normalize(path.posix.join(path.posix.dirname(page.file), name)).replace(/\/$/, "")
      : page.file;
    const there = file.startsWith("..") ? null : fs.statSync(path.join(this.root, file), { throwIfNoEntry: false });
    if (!there) {
      page.problem(line, `the link to ${address}: there is no such file`);
      return address;
    }
    if (file.endsWith(".md")) {
      if (!this.#names.has(file))
        page.problem(line, `the link to ${address}: the book has no such page (tools/book/outline.js)`);
      else if (anchor) this.#anchors.push({ page, line, file, anchor });
      const to = name ? relative(page.address, addressOf(file)) : "";
      return to + (anchor ? `#${encodeURIComponent(anchor)}` : "");
    }
    if (anchor) page.problem(line, `the link to ${address}: an anchor in what is no page`);
    if (there.isDirectory()) {
      this.#folders.add(file);
      for (const source of this.#sourcesIn(file)) this.#show(source, page);
      return relative(page.address, `${file}/index.html`);
    }
    if (copied.test(file)) {
      this.files.add(file);
      return relative(page.address, file);
    }
    this.#show(file, page);
    return relative(page.address, `${file}.html`);
  }

  #show(file, page) {
    if (!this.#shown.has(file)) this.#shown.set(file, new Set());
    this.#shown.get(file).add(page);
  }

  #sourcesIn(folder) {
    return fs
      .readdirSync(path.join(this.root, folder))
      .filter((name) => /\.(h|cpp)$/.test(name))
      .sort()
      .map((name) => `${folder}/${name}`);
  }

  #picture(page, address, alt, heading, line) {
    const src = this.#target(page, address, line);
    const file = path.posix.join(path.posix.dirname(page.address), src);
    const picture = { src, file, alt, page, heading, kind: kindOf(file) };
    if (!this.files.has(file)) return picture; // the problem has been said
    const bytes = fs.readFileSync(path.join(this.root, file));
    Object.assign(picture, imageSize(bytes), { bytes: bytes.length });
    if (picture.kind === "film") picture.still = src.replace(/\.webp$/, "_still.webp");
    this.pictures.push(picture);
    return picture;
  }

  #quoted(page, code, line) {
    const { places, missing } = this.code.where(code, page.file);
    if (missing) page.problem(line, `this code stands in no source: ${missing}`);
    return places.map(({ file, line: at }) => {
      this.#show(file, page);
      return {
        file,
        line: at,
        name: path.posix.basename(file),
        href: `${relative(page.address, `${file}.html`)}#L${at}`,
      };
    });
  }
}

function kindOf(file) {
  const name = path.posix.basename(file);
  if (name.startsWith("sheet")) return "sheet";
  if (name.startsWith("guess")) return "guess";
  if (name.endsWith(".svg")) return "drawing";
  if (name.endsWith(".webp")) return "film";
  return name.startsWith("thumbnail") ? "thumbnail" : "plot";
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
