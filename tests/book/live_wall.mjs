/// The wall of symptoms, which plays clips of many chapters on one page. After ./course book, which compiles all of them.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { address, launch, newPage } from "./support/browser.mjs";

let browser;
before(async () => (browser = await launch({ draws: true })));
after(() => browser.close());

test("the wall of symptoms: clips in sight turn, the switch shows the fix at the same instant, and where nothing should move they stand", async () => {
  const viewport = { width: 1280, height: 1250 };
  const opened = async (reducedMotion) => {
    const page = await newPage(browser, { viewport, reducedMotion });
    await page.goto(address("docs/symptoms.html"));
    await page.waitForFunction(() => document.querySelectorAll(".mended input:enabled").length >= 8);
    await page.evaluate(async () => {
      const clips = await window.PUSHBACK_LIVE_TEST.small;
      window.clip = clips.find(({ clip }) => clip.words.includes("sticks"));
    });
    return page;
  };
  const page = await opened("no-preference");
  await page.waitForFunction(() => clip.playing && clip.drawn > 40);
  await page.waitForFunction(() => clip.playing && clip.drawn < 30); // again
  await page.waitForFunction(() => clip.drawn > 60);
  const picture = () =>
    page.evaluate(() => {
      if (clip.playing) clip.pause();
      return { step: clip.drawn, pixels: clip.canvas.toDataURL() };
    });
  const ill = await picture();
  await page.getByRole("checkbox", { name: "mended: A column sticks" }).check();
  const mended = await picture();
  assert.equal(mended.step, ill.step);
  assert.notEqual(mended.pixels, ill.pixels);
  assert.deepEqual(page.wrong, []);
  await page.close();
  const still = await opened("reduce");
  await still.waitForFunction(() => clip.drawn === clip.steps && !clip.playing);
  await still.close();
});
