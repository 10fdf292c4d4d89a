// What the experiments of the pages cost: node tools/bench/live.mjs. Processor time, in node, without drawing; so it hardly depends on what
// else the machine does.
import fs from "node:fs";
import path from "node:path";
import { gzipSync } from "node:zlib";
import { built, chapters, engineOf } from "../../tests/book/support/live.mjs";

const processor = () => {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1000; // ms
};

console.log("| chapter | script, gzip | until it can be played | the slowest slider |");
console.log("| --- | --- | --- | --- |");
for (const chapter of chapters()) {
  const began = processor();
  const engine = await engineOf(chapter),
    ready = processor() - began;
  let slowest = 0,
    of = "";
  for (const { flag, whole, most } of engine.parameters) {
    const values = [...engine.values[flag]];
    if (!values.length) continue;
    values.push(Math.min(most, whole ? values.pop() + 1 : 1.01 * values.pop()));
    const before = processor();
    engine.set(`${flag}=${values}`);
    const spent = processor() - before;
    if (spent > slowest) [slowest, of] = [spent, flag];
    engine.set("");
  }
  const packed = gzipSync(fs.readFileSync(path.join(built, `${chapter}.js`)), { level: 9 }).length;
  console.log(
    `| ${chapter} | ${Math.round(packed / 1000)} kB | ${ready.toFixed(0)} ms | ${slowest.toFixed(0)} ms (${of}) |`,
  );
  if (chapter !== "07_warm_start") continue;
  engine.choose(
    engine.description.scenes.findIndex(({ key }) => key === "pyramid"),
    [0, 1],
  );
  const before = processor(),
    steps = 600;
  while (engine.now < steps) engine.goTo(steps, 1e9);
  const rate = (1000 * steps) / (processor() - before);
  console.error(
    `${chapter}: a pyramid of ${engine.bodies(0) - 1} boxes in two variants, states kept: ${rate.toFixed(0)} steps a second`,
  );
}
