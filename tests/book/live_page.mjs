/// The first page of the built book whose experiment is compiled: it is asked for, plays, and goes back to the same bits. The other
/// tests of experiments need all of them; this one is content with one, for who changes something every hour.
import assert from "node:assert/strict";
import { test } from "node:test";
import { address, html, pagesIn } from "./support/browser.mjs";
import { launch, newPage } from "./support/live.mjs";

const live = pagesIn().find((page) => page.startsWith("chapters/") && html(page).includes("data-chapter="));

test("a page of the book runs its experiment", async () => {
  assert.ok(live, "no page of the book has its experiment");
  const browser = await launch();
  const page = await newPage(browser, { reducedMotion: "reduce" });
  page.setDefaultTimeout(120000);
  await page.goto(address(live));
  await page.getByRole("button", { name: /^(Show me|Run it here)$/ }).click();
  await page.waitForFunction(() => (window.player = window.PUSHBACK_LIVE_TEST.player()));
  const bits = () => page.evaluate(() => player.engine.lanes.map(({ lane }) => player.engine.hash(lane)));
  const start = await bits();
  await page.getByRole("button", { name: "One step on" }).click();
  const one = await bits();
  assert.notDeepEqual(one, start);
  await page.evaluate(() => (player.speed = 8));
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await page.waitForFunction(() => !player.playing && player.engine.now === player.engine.steps);
  await page.evaluate(() => player.go(1));
  await page.waitForFunction(() => player.engine.now === 1);
  assert.deepEqual(await bits(), one);
  const seen = await page.evaluate(() => {
    player.stage.draw();
    const gl = player.stage.canvas.getContext("webgl2");
    const pixels = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
    gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    const colours = new Set();
    for (let i = 0; i < pixels.length; i += 4 * 37)
      colours.add((pixels[i] << 16) | (pixels[i + 1] << 8) | pixels[i + 2]);
    return { colours: colours.size, problem: player.stage.problem, curves: player.curves.plots.length };
  });
  assert.equal(seen.problem, "");
  assert.ok(seen.colours > 20, `only ${seen.colours} colours`);
  assert.ok(seen.curves > 0);
  assert.deepEqual(page.wrong, []);
  await browser.close();
});
