// What a page with an experiment costs in headless Chromium, from disk: node tools/bench/pages.mjs [CHAPTER...]. After ./course book. Wall
// time, drawn by the processor where there is no graphics card, so anything else that the machine does adds to it.
import fs from "node:fs";
import { address, weight } from "../../tests/book/support/browser.mjs";
import { chapters, launch, newPage } from "../../tests/book/support/live.mjs";

const asked = process.argv.slice(2);
const chosen = chapters().filter((name) => !asked.length || asked.some((word) => name.includes(word)));
const pageOf = (name) => (name === "hard_cases" ? `docs/${name}.html` : `chapters/${name}/index.html`);

/// In the page, from a click to the first picture; then the slowest slider, and of what its time consists.
async function measured(page) {
  const began = performance.now();
  window.player = await window.PUSHBACK_LIVE_TEST.start();
  const drawn = () => {
    player.stage.draw();
    const gl = player.stage.canvas.getContext("webgl2");
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4)); // waits until all is drawn
  };
  // Until the whole picture is there again, and how long it takes is known.
  const rest = async () => {
    await new Promise((done) => setTimeout(done, 350));
    drawn();
    await new Promise((done) => setTimeout(done, 20));
  };
  drawn();
  const first = performance.now() - began;
  player.pause();
  let slowest = { ms: 0 };
  for (let scene = 0; scene < player.engine.description.scenes.length; ++scene) {
    player.chooseScene(scene);
    await rest();
    for (const parameter of player.engine.parameters) {
      const values = [...player.controls.usual(parameter)];
      const { whole, least, most } = parameter;
      const last = values.pop();
      values.push(whole ? (last < most ? last + 1 : last - 1) : Math.min(most, Math.max(least, 1.01 * last)));
      const before = performance.now();
      player.controls.change(parameter, values, false);
      const set = performance.now() - before;
      drawn();
      const ms = performance.now() - before;
      if (ms > slowest.ms) slowest = { ms, set, of: parameter.flag, scene: player.engine.scene.key };
      player.controls.change(parameter, null, true);
      await rest();
    }
  }
  return { first, slowest };
}

console.log(
  "| page | loaded, compressed | of that the script | first picture | the slowest slider, drawn | of that without drawing |",
);
console.log("| --- | --- | --- | --- | --- | --- |");
const browser = await launch();
for (const name of chosen) {
  const page = await newPage(browser, { reducedMotion: "reduce", viewport: { width: 1280, height: 800 } });
  page.setDefaultTimeout(600000);
  const files = new Set();
  page.on("request", (request) => files.add(decodeURIComponent(new URL(request.url()).pathname)));
  await page.goto(address(pageOf(name)));
  await page.evaluate(async () => {
    for (const picture of document.images) picture.loading = "eager";
    await Promise.all([...document.images].map((picture) => picture.decode().catch(() => {})));
  });
  const { first, slowest } = await page.evaluate(measured);
  const kB = (list) => Math.round(list.reduce((sum, file) => sum + weight(file), 0) / 1000);
  const all = [...files].filter((file) => fs.existsSync(file));
  const script = all.filter((file) => file.includes("/live/programs/"));
  console.log(
    `| ${name} | ${kB(all)} kB | ${kB(script)} kB | ${first.toFixed(0)} ms | ${slowest.ms.toFixed(0)} ms (${slowest.of} in ${slowest.scene}) | ${slowest.set.toFixed(0)} ms |`,
  );
  if (page.wrong.length) console.error(`${name}: ${page.wrong}`);
  await page.close();
}
await browser.close();
