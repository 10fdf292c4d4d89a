/// The experiments that are compiled, run in node: what a page would be told of them.
import fs from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { fileURLToPath } from "node:url";

const home = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../..");

/// Of NAME.js, which em++ has made beside NAME.wasm.
export async function engineOf(file) {
  // What a loader looks for in node, and a page's script in its window.
  Object.assign(globalThis, { self: globalThis, require: createRequire(import.meta.url), __dirname: home });
  await import(path.join(home, "tools/book/live/engine.js"));
  const create = new Function(`${fs.readFileSync(file, "utf8")}; return createPushbackLive;`)();
  const module = new WebAssembly.Module(fs.readFileSync(file.replace(/\.js$/, ".wasm")));
  return globalThis.PushbackLive.Engine.of({ create, module });
}
