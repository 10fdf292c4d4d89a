/// Builds the book: node tools/book/build.js [--root FOLDER] [--out FOLDER] [--still] [--address URL] [--repository URL]. Eleventy lays
/// the pages out, writes them, and copies files. A page whose experiment is compiled for the browser can run it, unless the book is to
/// be still. `--address`: where it will be published, for the picture of a link that somebody shares. `--repository`: what every
/// page links to; by default where this repository was cloned from, where that is an address for browsers.
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import Eleventy from "@11ty/eleventy";
import { Problems, readBook, stillOf } from "./book.js";
import { engineOf } from "./experiments.js";
import { experimentsIn, liveFiles } from "./live_files.js";
import { courseOf, pagesOf } from "./pages.js";

const home = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../..");
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
process.chdir(home); // Eleventy reads and copies relative to where it runs
const compiled = "build/wasm/programs";
const live = new Map();
for (const name of values.still ? [] : experimentsIn(compiled))
  live.set(name, await engineOf(`${compiled}/${name}.js`));
const here = (...names) => path.relative(".", path.join(...names));

let book;
try {
  book = readBook(root, live);
} catch (error) {
  console.error(error instanceof Problems ? error.message : error);
  process.exit(1);
}
const pages = pagesOf(book, root);
fs.rmSync(out, { recursive: true, force: true });
const eleventy = new Eleventy("tools/book", here(out), { quietMode: true, config });
await eleventy.write();
writeDerived();
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

function config(eleventy) {
  eleventy.setIncludesDirectory("layouts");
  eleventy.setTemplateFormats("html"); // what is added below
  eleventy.ignores.add("tools/book/live/**");
  eleventy.setUseGitIgnore(false);
  eleventy.addGlobalData("course", courseOf(pages));
  eleventy.addGlobalData("site", site);
  for (const entry of pages) {
    const { html, layout, address: permalink } = entry;
    delete entry.html;
    eleventy.addTemplate(`${permalink.replace(/\W/g, "_")}.html`, bare(html), {
      entry,
      layout,
      permalink,
      templateEngineOverride: "html",
    });
  }
  const copy = (from, to) => fs.existsSync(from) && eleventy.addPassthroughCopy({ [here(from)]: to });
  for (const file of book.files) copy(path.join(root, file), file);
  for (const name of ["style", "scripts"]) copy(`tools/book/${name}`, "assets");
  copy("node_modules/minisearch/dist/umd/index.js", "assets/minisearch.js");
  for (const file of [...textFonts().files, ...katexFonts().map((name) => `node_modules/katex/dist/fonts/${name}`)])
    copy(file, `assets/fonts/${path.basename(file)}`);
}

/// Without the quotes that HTML can do without.
function bare(html) {
  return html.replace(/<[a-z][^<>]*>/g, (tag) => tag.replace(/="([^\s"'=<>`]+)"(?=[\s>])/g, "=$1"));
}

/// The text faces: {style, files} of those alphabets that the pages use.
function textFonts() {
  const faces = ["source-serif-4", "source-sans-3", "source-code-pro"].flatMap((font) =>
    ["wght.css", "wght-italic.css"].flatMap((style) => {
      const folder = `node_modules/@fontsource-variable/${font}`;
      const all = fs.readFileSync(`${folder}/${style}`, "utf8").match(/@font-face {[^}]*}/g);
      return all
        .filter((face) => /-(latin(-ext)?|greek)-wght/.test(face))
        .map((face) => ({ face, file: `${folder}/${/files\/[^)]*woff2/.exec(face)[0]}` }));
    }),
  );
  return {
    style: faces.map(({ face }) => face.replace("./files/", "fonts/")).join("\n"),
    files: faces.map(({ file }) => file),
  };
}

function katexFonts() {
  return fs.readdirSync("node_modules/katex/dist/fonts").filter((name) => name.endsWith(".woff2"));
}

/// What is made of other files: the style of formulas with the fonts that are there, stills of films, experiments, the words for
/// the search.
function writeDerived() {
  const write = (file, text) => {
    fs.mkdirSync(path.dirname(path.join(out, file)), { recursive: true });
    fs.writeFileSync(path.join(out, file), text);
  };
  write("assets/fonts.css", textFonts().style);
  const style = fs.readFileSync("node_modules/katex/dist/katex.min.css", "utf8");
  write("assets/katex.css", style.replace(/,url\([^)]*\.(woff|ttf)\) format\("[^"]*"\)/g, ""));
  for (const { kind, file } of book.pictures) {
    if (kind === "film") write(file.replace(/\.webp$/, "_still.webp"), stillOf(fs.readFileSync(path.join(root, file))));
  }
  if (live.size) for (const { name, text } of liveFiles(compiled)) write(`live/${name}`, text);
  const words = book.pages.flatMap(({ title: page, address, sections }) =>
    sections.map(({ id, title, text }) => ({
      address: id ? `${address}#${encodeURIComponent(id)}` : address,
      title: title || page,
      page,
      text: text.replace(/\s+/g, " ").trim(),
    })),
  );
  write(
    "assets/search_index.js",
    `window.PUSHBACK_SEARCH = ${JSON.stringify(words.map((word, id) => ({ id, ...word })))};\n`,
  );
}
