/// The wall of symptoms, which plays clips of many chapters on one page, and the sandbox. After ./course book, which compiles all.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { address, bits, launch, newPage, running, seek, settled } from "./support/browser.mjs";

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
  await page.getByRole("checkbox", { name: "fixed: A column sticks" }).check();
  const mended = await picture();
  assert.equal(mended.step, ill.step);
  assert.notEqual(mended.pixels, ill.pixels);
  // A browser that takes the graphics away gives others.
  await page.evaluate(async () => {
    const { canvas } = clip.workshop;
    const lost = new Promise((done) => canvas.addEventListener("webglcontextlost", done));
    canvas.getContext("webgl2").getExtension("WEBGL_lose_context").loseContext();
    await lost;
  });
  await page.getByRole("checkbox", { name: "fixed: A column sticks" }).uncheck();
  assert.equal((await picture()).pixels, ill.pixels);
  assert.deepEqual(page.wrong, []);
  await page.close();
  const still = await opened("reduce");
  await still.waitForFunction(() => clip.drawn === clip.steps && !clip.playing);
  await still.close();
});

const sandbox = (state) => running(browser, "docs/sandbox.html", `live=sandbox&${state}`);

test("the sandbox: with all effects on, the same bits as the solver that is composed of them, also with what is added", async () => {
  const page = await sandbox("show=0,1&actions=30,1,0,0,60,2,0,3&step=150");
  const [switched, composed] = await bits(page);
  assert.equal(switched, composed);
  assert.equal(await page.evaluate(() => player.engine.bodies(0)), 48); // the ground, the pyramid, a box and a ball
  await page.close();
});

test("the sandbox: what is done at an instant is in the link, which makes the same motion; what came after it is forgotten", async () => {
  const page = await sandbox("step=0");
  const actions = () => page.evaluate(() => player.sandbox.actions);
  const act = async (step, work) => {
    await page.evaluate(() => player.pause());
    await seek(page, step);
    await work();
    await page.waitForFunction((from) => player.engine.now > from, step);
  };
  await act(20, () => page.getByRole("button", { name: "add a box" }).click());
  await act(90, () => page.getByRole("button", { name: "throw a ball" }).click());
  await act(60, () => page.getByRole("checkbox", { name: "friction" }).uncheck());
  await act(70, () => page.locator(".pb-canvas").click());
  const done = await actions();
  assert.deepEqual(
    done.map((one) => one.slice(0, 2)),
    [
      [20, 1],
      [60, 0],
      [70, 2],
    ],
  );
  await page.evaluate(() => player.pause());
  await seek(page, 200);
  const link = await page.evaluate(() => String(player.state));
  const other = await sandbox(link.replace("live=sandbox&", ""));
  await settled(other);
  assert.deepEqual(await bits(other), await bits(page));
  assert.equal(await other.getByRole("checkbox", { name: "friction" }).isChecked(), false);
  await seek(other, 50);
  assert.equal(await other.getByRole("checkbox", { name: "friction" }).isChecked(), true);
  const without = await sandbox("step=200");
  assert.notDeepEqual(await bits(without), await bits(page));
  assert.deepEqual([...page.wrong, ...other.wrong], []);
  for (const each of [page, other, without]) await each.close();
});
