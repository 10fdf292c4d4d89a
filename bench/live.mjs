// How fast the experiments of the pages are, in this machine's chromium without a graphics card: node bench/live.mjs
import fs from "node:fs";
import path from "node:path";
import { gzipSync } from "node:zlib";
import { chapters, launch, newPage, pageOf, root } from "../tests/book/support/live.mjs";

const browser = await launch();
const packed = (file) => Math.round(gzipSync(fs.readFileSync(file), { level: 9 }).length / 1000);
const median = (values) => values.sort((a, b) => a - b)[values.length >> 1];

console.log("| chapter | script, gzip | first picture | a slider answers, the slowest |");
console.log("| --- | --- | --- | --- |");
for (const chapter of chapters()) {
  const firsts = [];
  let slowest = 0, of = "";
  for (let round = 0; round < 3; ++round) {
    const page = await newPage(browser, { reducedMotion: "reduce" });
    await page.goto(pageOf(chapter));
    firsts.push(await page.evaluate(async () => {
      const began = performance.now();
      window.player = await window.PUSHBACK_LIVE_TEST.start();
      player.stage.draw();
      player.stage.canvas.getContext("webgl2").finish();
      return performance.now() - began;
    }));
    if (round === 0) {
      const times = await page.evaluate(() => {
        const all = [];
        for (const parameter of player.engine.parameters) {
          const values = [...(player.engine.values[parameter.flag] || [])];
          if (!values.length) continue;
          values[values.length - 1] = parameter.whole ? Math.min(parameter.most, values[values.length - 1] + 1) : Math.min(parameter.most, values[values.length - 1] * 1.01);
          player.seek(0);
          player.controls.change(parameter, values, false);
          all.push([player.answered, parameter.flag]);
          player.controls.change(parameter, null, false);
        }
        return all;
      });
      [slowest, of] = times.sort((a, b) => b[0] - a[0])[0];
    }
    await page.close();
  }
  console.log(`| ${chapter} | ${packed(path.join(root, "build/wasm/live", `${chapter}.js`))} kB | ${(median(firsts) / 1000).toFixed(2)} s | ${slowest.toFixed(0)} ms (${of}) |`);
}

if (chapters().includes("07_warm_start")) {
  const page = await newPage(browser, { reducedMotion: "reduce" });
  await page.goto(pageOf("07_warm_start"));
  const seen = await page.evaluate(async () => {
    const player = await window.PUSHBACK_LIVE_TEST.start();
    player.chooseScene(player.engine.description.scenes.findIndex(({ key }) => key === "pyramid"));
    player.engine.choose(player.engine.sceneIndex, [0, 1]);
    const began = performance.now(), steps = 600;
    while (player.engine.now < steps) player.engine.goTo(steps, 1e9);
    return { rate: (1000 * steps) / (performance.now() - began), bodies: player.engine.bodies(0) - 1, memory: player.engine.module.HEAP8.length / 1e6 };
  });
  console.log(`\nThe pyramid of ${seen.bodies} boxes in two variants, two substeps of two sweeps each: ${seen.rate.toFixed(0)} steps a second, states kept; ${seen.memory.toFixed(0)} MB.`);
}
await browser.close();
