/// The experiments that are compiled, run in node: what a page would be told of them.
import fs from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { fileURLToPath } from "node:url";

const home = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../..");

/// Of a script that em++ and common/live/pack.js have made: NAME.js.
export async function engineOf(file) {
  // What a loader looks for in node, and a page's script in its window.
  Object.assign(globalThis, { self: globalThis, require: createRequire(import.meta.url), __dirname: home });
  await import(path.join(home, "tools/book/live/engine.js"));
  (0, eval)(fs.readFileSync(file, "utf8"));
  const { create, program } = globalThis.PUSHBACK_LIVE_CHAPTERS[path.parse(file).name];
  return new globalThis.PushbackLive.Engine(await create({ wasmBinary: Buffer.from(program, "base64") }));
}
