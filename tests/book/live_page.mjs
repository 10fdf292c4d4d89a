/// Each experiment that is compiled for the browser, one at least: it computes what its own program computes, to the last bit; its page says
/// the numbers that it shows; and on its page it runs, and comes back to the same bits.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { home } from "../../tools/book/experiments.js";
import { clipOf, markIn, stateOf } from "../../tools/book/marks.js";
import { bits, engineOf, experiments, html, launch, running, seek } from "./support/browser.mjs";

const chapters = experiments.filter((name) => /^\d\d_/.test(name));
const most = Number(process.env.PUSHBACK_LIVE_STEPS ?? 120); // steps of each variant: the slowest take a second each
let browser;
before(async () => (browser = await launch({ draws: true })));
after(() => browser.close());

const columns = "time kinetic_energy potential_energy px py pz lx ly lz deepest_overlap contacts rows residual".split(
  " ",
);
/// Those that differ: how "chapter / scene / variant" begins, and the function that the library of em++ rounds otherwise.
const roundedOtherwise = {
  "08_friction_cone / twelve planks, and where they should stop / cone": "hypot",
  "12_soft_contacts / a stack of forty / 32 substeps, all together": "hypot",
  "13_joints / a door on a hinge": "atan2",
  "15_limits_motors_springs": "atan2, sin",
  "16_whole_problem / a stack of twenty": "hypot",
  "17_direct_contacts / a thousand times heavier on four": "hypot",
  "21_detected_once / a cube rolls / detected in each substep": "hypot",
  "21_detected_once / a stack of forty": "hypot",
  "21_detected_once / a thousand times heavier than what it lies on": "hypot",
  "22_wide / the pyramid in three ways / chapter 21": "hypot",
  "22_wide / a thousand times heavier than what it lies on / chapter 21": "hypot",
};
const rounding = 1e-12; // of a number, or in its unit where that is less than 1
/// What a method leaves that stops at a residual of 1e-10: N m s, where 100 400 kg press with 16 400 N s a step.
const leftOver = { "17_direct_contacts / a thousand times heavier on four, every step from nothing / direct": 1e-4 };
const entryFor = (table, where) => Object.entries(table).find(([begin]) => where.startsWith(begin))?.[1];

/// "scene / variant" -> the rows of its steps, as the chapter's own program writes them.
function metricsOf(program, chapter) {
  const out = fs.mkdtempSync(path.join(os.tmpdir(), "pushback_bits_"));
  execFileSync(program, ["--no-images", "--no-study", "--out", out], { stdio: "ignore" });
  const text = fs.readFileSync(path.join(out, chapter, "metrics.csv"), "utf8");
  fs.rmSync(out, { recursive: true });
  const [head, ...rows] = text.trim().split("\n");
  const at = columns.map((name) => head.split(",").indexOf(name) - 2);
  const metrics = new Map();
  for (const row of rows) {
    const [, scene, variant, rest] = /^"([^"]*)","([^"]*)",(.*)$/.exec(row);
    const numbers = rest.split(",").map(Number);
    const key = `${scene} / ${variant}`;
    metrics.set(key, [...(metrics.get(key) ?? []), at.map((column) => numbers[column])]);
  }
  return metrics;
}

/// The first step of a lane that differs, in words, or undefined.
function differs(engine, lane, where, told, last) {
  for (let step = 0; step < Math.min(last, engine.played(lane)); ++step) {
    const seen = engine.numbers(engine.module._live_sample(lane, step), columns.length);
    const off = columns.filter((_, i) => !Object.is(seen[i] + 0, told[step][i] + 0));
    if (!off.length) continue;
    const far = Math.max(...seen.map((x, i) => Math.abs(x - told[step][i]) / Math.max(1, Math.abs(x))));
    const allowed = entryFor(roundedOtherwise, where) ? (entryFor(leftOver, where) ?? rounding) : 0;
    return far <= allowed ? undefined : `${where}, step ${step + 1}: ${off} off by ${far}`; // from there on both go their ways
  }
  return undefined;
}

for (const chapter of chapters) {
  const program = ["release", "ci"]
    .map((preset) => path.join(home, "build", preset, "programs", chapter))
    .find((file) => fs.existsSync(file));
  test(`${chapter}: the same bits as by g++`, { skip: !program && "its program is not built" }, async () => {
    const engine = await engineOf(chapter);
    const metrics = metricsOf(program, chapter);
    const different = [];
    engine.description.scenes.forEach((scene, which) => {
      for (let first = 0; first < scene.variants.length; first += 4) {
        engine.choose(which, scene.variants.map((_, place) => place).slice(first, first + 4));
        const last = Math.min(engine.steps, most);
        while (engine.now < last) engine.goTo(last, 1e9);
        for (const { lane, name } of engine.lanes) {
          const told = metrics.get(`${scene.name} / ${name}`);
          assert.ok(told, `${scene.name} / ${name} is not in metrics.csv`);
          different.push(differs(engine, lane, `${chapter} / ${scene.name} / ${name}`, told, last));
        }
      }
    });
    assert.deepEqual(different.filter(Boolean), []);
  });

  test(`${chapter}: its sentences say what the experiment shows, and its sliders change it`, async () => {
    const engine = await engineOf(chapter);
    const folder = path.join(home, "chapters", chapter);
    const text = fs
      .readdirSync(folder)
      .filter((name) => name.endsWith(".md"))
      .map((name) => fs.readFileSync(path.join(folder, name), "utf8"))
      .join("\n\n");
    const played = ({ assignments, scene, places, which, steps }, own = "") => {
      assert.equal(engine.set([assignments, own].filter(Boolean).join(";")), "");
      engine.choose(scene, places);
      const last = Math.min(engine.steps, steps ?? engine.steps);
      while (engine.now < last) engine.goTo(last, 1000);
      for (const { lane } of engine.lanes) assert.equal(engine.mishap(lane), "", chapter);
      return { said: which >= 0 && engine.number(0, which)[0].replaceAll(" ", ""), state: engine.hash(0) };
    };
    for (const [, before, html] of text.matchAll(/(?<=\n\n)((?:[^\n]+\n)+?)(<!-- live: .*?-->)/g)) {
      const clip = clipOf(markIn(html, "live"), engine);
      const { says } = clip,
        slider = clip.guess ? null : clip.slider;
      const steps = Math.round(clip.seconds / engine.dt);
      const own = (value) =>
        played({ ...clip, which: clip.number?.which ?? -1, steps }, slider && `${slider.flag}=${value}`);
      const usual = own(slider?.value);
      if (says) {
        assert.equal(usual.said, says.replaceAll(" ", ""), html);
        assert.ok(before.includes(says), `${says} does not stand above ${html}`);
      }
      if (slider) assert.notDeepEqual(own(slider.from), own(slider.from + slider.notches * slider.step), html);
    }
    for (const [, html, words] of text.matchAll(/(<!-- set: .*?-->)(.*?)<!-- \/set -->/gs)) {
      engine.set("");
      const { scene, index, says, step, ...rest } = stateOf(markIn(html, "set"), engine);
      const { said } = played({ ...rest, scene: index, steps: step || undefined });
      if (!says) continue;
      assert.equal(said, says.replaceAll(" ", ""), html);
      assert.ok(words.replace(/\s+/g, " ").includes(says), `${words} does not say ${says}`);
    }
  });

  test(`${chapter}: on its page it is drawn and fits the window, and an instant has the same bits however it is reached`, async () => {
    const page = await running(browser, `chapters/${chapter}/index.html`, `live=${chapter}`);
    await page.evaluate(() => document.querySelectorAll(".pb-fold").forEach((fold) => (fold.open = false)));
    await page.evaluate(() => new Promise((done) => setTimeout(done, 300)));
    const seen = await page.evaluate(() => {
      const { view } = player;
      player.bringIntoView();
      view.stage.draw();
      const gl = view.stage.canvas.getContext("webgl2");
      const pixels = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
      gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
      const colours = new Set();
      for (let i = 0; i < pixels.length; i += 4 * 37) colours.add(pixels.slice(i, i + 3).join());
      const parts = [".pb-canvas", ".pb-transport", ".pb-deck input[type=range]"];
      const hidden = parts.filter(
        (part) => view.root.querySelector(part)?.getBoundingClientRect().bottom > innerHeight + 1,
      );
      const sliders = view.deck.querySelectorAll("[data-flag]").length;
      return { problem: view.stage.problem, colours: colours.size, hidden, sliders };
    });
    assert.equal(seen.problem, "");
    assert.ok(seen.colours > 20, `only ${seen.colours} colours`);
    assert.deepEqual(seen.hidden, []);
    assert.ok(seen.sliders > 0, "no slider acts in the scene of its sheet");
    const last = Math.min(60, await page.evaluate(() => player.engine.steps));
    const start = await bits(page);
    await page.getByRole("button", { name: "One step on" }).click();
    const one = await bits(page);
    assert.notDeepEqual(one, start);
    await seek(page, last);
    const end = await bits(page);
    await page.getByRole("button", { name: "To the start" }).click();
    assert.deepEqual(await bits(page), start);
    await seek(page, 1);
    assert.deepEqual(await bits(page), one);
    await seek(page, last);
    assert.deepEqual(await bits(page), end);
    assert.deepEqual(page.wrong, []);
    await page.close();
  });
}

test("a page asks before it runs, and then plays; small pictures play beside their sentences", async () => {
  const page = await browser.newPage();
  const [chapter] = chapters.filter((name) => html(`chapters/${name}/index.html`).includes("small-live"));
  await page.goto(`file://${home}/build/book/chapters/${chapter}/index.html`);
  await page.getByRole("button", { name: "Run it here" }).click();
  await page.waitForFunction(() => window.PUSHBACK_LIVE_TEST.player()?.engine.now > 1);
  const picture = page.locator(".small-live").first();
  await picture.scrollIntoViewIfNeeded();
  await picture.locator("button:enabled").waitFor();
  await page.waitForFunction(async () => (await window.PUSHBACK_LIVE_TEST.small)?.some(({ drawn }) => drawn > 2));
  await page.close();
});
