/// Builds the book: node tools/book/build.js [--root FOLDER] [--out FOLDER] [--still] [--address URL] [--repository URL]. A page whose
/// experiment is compiled for the browser can run it, unless the book is to be still. `--address`: where it will be published, for the
/// picture of a link that somebody shares. `--repository`: what every page links to; by default where this repository was cloned
/// from, where that is an address for browsers.
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { parseArgs } from "node:util";
import nunjucks from "nunjucks";
import { Problems, readBook, stillOf } from "./book.js";
import { engineOf, experimentsIn, home, idle, liveFiles, programs } from "./experiments.js";
import { pagesOf } from "./pages.js";

const { values } = parseArgs({
  options: {
    root: { type: "string", default: home },
    out: { type: "string" },
    still: { type: "boolean" },
    address: { type: "string" },
    repository: { type: "string" },
  },
});
const site = {
  address: webAddress("address", values.address),
  repository: webAddress("repository", values.repository ?? clonedFrom()),
};
const root = path.resolve(values.root);
const out = path.resolve(values.out ?? path.join(root, "build/book"));
const packages = path.join(home, "node_modules");

const live = new Map();
for (const name of values.still ? [] : experimentsIn(programs))
  live.set(name, await engineOf(path.join(programs, `${name}.js`)));
let book;
try {
  book = readBook(root, live, idle, site.repository);
} catch (error) {
  console.error(error instanceof Problems ? error.message : error);
  process.exit(1);
}
const pages = pagesOf(book, root);
fs.rmSync(out, { recursive: true, force: true });
const layouts = nunjucks.configure(path.join(home, "tools/book/layouts"));
for (const entry of pages) write(entry.address, layouts.render("page.njk", { entry, site }));
for (const file of book.files) copy(path.join(root, file), file);
for (const { kind, file } of book.pictures)
  if (kind === "film") write(file.replace(/\.webp$/, "_still.webp"), stillOf(fs.readFileSync(path.join(root, file))));
writeAssets();
if (live.size) for (const { name, text } of liveFiles(programs)) write(`live/${name}`, text);
console.log(`${pages.filter(({ sort }) => sort !== "source").length} pages, ${book.sources.length} sources`);

/// Without a slash at its end. One that is no address ends the program.
function webAddress(option, value) {
  if (value && !/^https?:\/\/[^\s"'<>]+$/.test(value)) {
    console.error(`--${option}: '${value}' is not allowed: an address that begins with https:// or http:// is`);
    process.exit(2);
  }
  return value?.replace(/\/+$/, "");
}

function clonedFrom() {
  const { stdout } = spawnSync("git", ["config", "--get", "remote.origin.url"], { cwd: home, encoding: "utf8" });
  const [, host, name] =
    /^(?:https:\/\/|(?:ssh:\/\/)?git@)([\w.-]+)[/:]([\w./-]+?)(?:\.git)?\s*$/.exec(stdout ?? "") ?? [];
  return name && `https://${host}/${name}`;
}

function write(file, content) {
  fs.mkdirSync(path.dirname(path.join(out, file)), { recursive: true });
  fs.writeFileSync(path.join(out, file), content);
}

function copy(from, to) {
  fs.cpSync(from, path.join(out, to), { recursive: true });
}

/// Styles, scripts, fonts, and the words for the search.
function writeAssets() {
  for (const folder of ["style", "scripts"]) copy(path.join(home, "tools/book", folder), "assets");
  copy(path.join(packages, "minisearch/dist/umd/index.js"), "assets/minisearch.js");
  const words = book.pages.flatMap(({ title: page, address, sections }) =>
    sections.map(({ id, title, text, keywords }) => ({
      keywords,
      address: id ? `${address}#${encodeURIComponent(id)}` : address,
      title: title || page,
      page,
      text: text.replace(/\s+/g, " ").trim(),
    })),
  );
  const index = JSON.stringify(words.map((word, id) => ({ id, ...word })));
  write("assets/search_index.js", `window.PUSHBACK_SEARCH = ${index};\n`);

  const katex = path.join(packages, "katex/dist");
  const rare = {
    Caligraphic: "mathcal",
    Fraktur: "mathfrak",
    SansSerif: "mathsf",
    Script: "mathscr",
    Typewriter: "mathtt",
  };
  const unused = Object.keys(rare).filter((font) => !book.pages.some(({ html }) => html.includes(` ${rare[font]}"`)));
  const without = new RegExp(`@font-face\\{[^}]*KaTeX_(${unused.join("|")})[;-][^}]*\\}`, "g");
  const style = fs.readFileSync(path.join(katex, "katex.min.css"), "utf8").replace(without, "");
  write("assets/katex.css", style.replace(/,url\([^)]*\.(woff|ttf)\) format\("[^"]*"\)/g, ""));
  for (const [, name] of style.matchAll(/url\(fonts\/([^)]*\.woff2)\)/g))
    copy(path.join(katex, "fonts", name), `assets/fonts/${name}`);
  // Of the text faces those alphabets that the pages use.
  const faces = ["source-serif-4", "source-sans-3", "source-code-pro"].flatMap((font) => {
    const folder = path.join(packages, "@fontsource-variable", font);
    const all = ["wght.css", "wght-italic.css"]
      .map((name) => fs.readFileSync(path.join(folder, name), "utf8"))
      .join("");
    return all.match(/@font-face {[^}]*-(latin|greek)-wght[^}]*}/g).map((face) => {
      const [, name] = /files\/([^)]*woff2)/.exec(face);
      copy(path.join(folder, "files", name), `assets/fonts/${name}`);
      return face.replace("./files/", "fonts/");
    });
  });
  write("assets/fonts.css", faces.join("\n"));
}
