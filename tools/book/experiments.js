/// The experiments that em++ has compiled: run in node, for what a page is told of them, and as files of the book. All of these are
/// scripts, which also load where a page is opened from a folder.
import fs from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { difference } from "./difference.js";

export const home = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../..");
export const programs = path.join(home, "build/wasm/programs");
const own = path.join(home, "tools/book/live");

/// Which parameters change nothing that is seen in which scene: idle.js makes the list.
export const idle = JSON.parse(fs.readFileSync(path.join(home, "tools/book/idle.json"), "utf8"));

/// The experiments in a folder of programs, by their names. Of each there are NAME.js, which loads NAME.wasm.
export function experimentsIn(folder) {
  if (!fs.existsSync(folder)) return [];
  const names = fs.readdirSync(folder).filter((name) => name.endsWith(".wasm"));
  return names.map((name) => name.slice(0, -5)).sort();
}

/// The engine of NAME.js, in node.
export async function engineOf(file) {
  // What a loader looks for in node, and a page's script in its window.
  Object.assign(globalThis, { self: globalThis, require: createRequire(import.meta.url), __dirname: home });
  await import(path.join(own, "engine.js"));
  const create = new Function(`${fs.readFileSync(file, "utf8")}; return createPushbackLive;`)();
  const module = new WebAssembly.Module(fs.readFileSync(file.replace(/\.js$/, ".wasm")));
  return globalThis.PushbackLive.Engine.of({ create, module });
}

/// {name, text} of each file of the book's folder live/, with the experiments of a folder of programs.
export function liveFiles(folder) {
  const uPlot = (name) => fs.readFileSync(path.join(home, "node_modules/uplot/dist", name), "utf8");
  const all = (ending) => {
    const names = fs.readdirSync(own).filter((name) => name.endsWith(ending));
    const order = (name) => ["page.js", "engine.js"].indexOf(name); // what others are made of comes first
    names.sort((a, b) => order(b) - order(a) || a.localeCompare(b));
    return names.map((name) => fs.readFileSync(path.join(own, name), "utf8"));
  };
  return [
    { name: "live.js", text: [uPlot("uPlot.iife.min.js"), ...all(".js")].join("\n") },
    { name: "live.css", text: [uPlot("uPlot.min.css"), ...all(".css")].join("\n") },
    ...packed(folder),
  ];
}

const large = 200e3; // bytes, compressed

/// The first experiment as a whole, and of each what differs from it, compressed: together a tenth of their size. A chapter that
/// differs from the first by much is what the chapters after it start from; a page that is no chapter's does not load that one, too.
function packed(folder) {
  const names = experimentsIn(folder);
  if (!names.length) return [];
  const read = (name, ending) => fs.readFileSync(path.join(folder, `${name}.${ending}`));
  const whole = (name) => Buffer.concat([read(name, "js"), read(name, "wasm")]);
  const compressed = (bytes) => gzipSync(bytes, { level: 9 }).toString("base64");
  const script = (name, program) => ({
    name: `programs/${name}.js`,
    text: `(self.PUSHBACK_PROGRAMS = self.PUSHBACK_PROGRAMS || {})["${name}"] = ${JSON.stringify(program)};\n`,
  });
  const common = ["common", whole(names[0])];
  let latest = common;
  const scripts = [script("common", { packed: compressed(common[1]) })];
  for (const name of names) {
    const [from, start] = /^\d\d_/.test(name) ? latest : common;
    const loader = read(name, "js").length;
    const program = { from, loader, packed: compressed(difference(start, whole(name))) };
    scripts.push(script(name, program));
    if (latest === common && program.packed.length > large * (4 / 3)) latest = [name, whole(name)];
  }
  return scripts;
}
