/// What pages load to play experiments, made of tools/book/live/ and of what em++ has compiled. All of it are scripts, which also load
/// where a page is opened from a folder.
import fs from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { difference } from "./difference.js";

const home = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../..");
const own = path.join(home, "tools/book/live");
const plots = path.join(home, "node_modules/uplot/dist");

/// The experiments in a folder of programs, by their names. Of each there are NAME.js, which loads NAME.wasm.
export function experimentsIn(folder) {
  if (!fs.existsSync(folder)) return [];
  const names = fs.readdirSync(folder).filter((name) => name.endsWith(".wasm"));
  return names.map((name) => name.slice(0, -5)).sort();
}

const first = ["engine.js", "small.js"]; // what plays, and small pictures: all that a page needs at first

/// {name, text} of each file of the book's folder live/, with the experiments of a folder of programs.
export function liveFiles(folder) {
  const read = (name) => fs.readFileSync(path.join(own, name), "utf8");
  const all = (ending) =>
    fs
      .readdirSync(own)
      .filter((name) => name.endsWith(ending) && name !== "live.js" && !first.includes(name))
      .sort()
      .map(read);
  const uPlot = (name) => fs.readFileSync(path.join(plots, name), "utf8");
  // The first line counts for all that follow.
  const together = (texts) => ['"use strict";', ...texts].join("\n");
  return [
    { name: "live.js", text: read("live.js") },
    { name: "engine.js", text: together(first.map(read)) },
    { name: "pieces.js", text: together([uPlot("uPlot.iife.min.js"), ...all(".js")]) },
    { name: "live.css", text: [uPlot("uPlot.min.css"), ...all(".css")].join("\n") },
    ...programs(folder),
  ];
}

const large = 200e3; // bytes, compressed

/// The first experiment as a whole, and of each what differs from it, compressed: together a tenth of their size. An experiment that
/// differs from the first by much is what those after it start from.
function programs(folder) {
  const names = experimentsIn(folder);
  if (!names.length) return [];
  const read = (name, ending) => fs.readFileSync(path.join(folder, `${name}.${ending}`));
  const whole = (name) => Buffer.concat([read(name, "js"), read(name, "wasm")]);
  const packed = (bytes) => gzipSync(bytes, { level: 9 }).toString("base64");
  const script = (name, program) => ({
    name: `programs/${name}.js`,
    text: `(self.PUSHBACK_PROGRAMS = self.PUSHBACK_PROGRAMS || {})["${name}"] = ${JSON.stringify(program)};\n`,
  });
  let [from, start] = ["common", whole(names[0])];
  const scripts = [script(from, { packed: packed(start) })];
  for (const name of names) {
    const program = { from, loader: read(name, "js").length, packed: packed(difference(start, whole(name))) };
    scripts.push(script(name, program));
    if (from === "common" && program.packed.length > large * (4 / 3)) [from, start] = [name, whole(name)];
  }
  return scripts;
}
