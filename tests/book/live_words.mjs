/// Words that set a figure, and challenges: what is said is what the experiment shows, first in node and then on the built book's pages.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import { challengeOf, challengesIn, file } from "../../tools/book/challenges.js";
import { stateOf } from "../../tools/book/set.js";
import { markIn } from "../../tools/book/small.js";
import { address } from "./support/browser.mjs";
import { chapters, engineOf, launch, newPage, root } from "./support/live.mjs";
globalThis.self = globalThis; // what a page's script finds in its window
await import("../../tools/book/live/challenge.js");

const { Challenge } = globalThis.PushbackLive;
let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const pageOf = (chapter) => fs.readFileSync(path.join(root, "chapters", chapter, "README.md"), "utf8");
const marked = /(<!-- set: .*?-->)(.*?)<!-- \/set -->/gs;

test("words that set a figure say the number that it shows at that instant", async () => {
  let all = 0;
  for (const chapter of chapters().filter((name) => /^\d\d_/.test(name))) {
    const engine = await engineOf(chapter);
    for (const [, mark, words] of pageOf(chapter).matchAll(marked)) {
      const where = `${chapter}: ${words}`;
      const { scene, places, assignments, step, which, says } = stateOf(markIn(mark, "set"), engine);
      assert.equal(engine.set(assignments), "", where);
      engine.choose(scene, places);
      const last = step || engine.steps;
      while (engine.now < last) engine.goTo(last, 1000);
      for (const { lane } of engine.lanes) assert.equal(engine.mishap(lane), "", where);
      ++all;
      if (!says) continue;
      assert.equal(engine.number(0, which)[0].replaceAll(" ", ""), says.replaceAll(" ", ""), where);
      assert.ok(words.replace(/\s+/g, " ").includes(says), `${where} does not say ${says}`);
    }
  }
  assert.ok(all >= 13, `only ${all} sentences set a figure`);
});

test("words that ask for what does not exist are refused", async () => {
  const engine = await engineOf("03_baumgarte");
  const refused = (text, why) => assert.throws(() => stateOf(markIn(`<!-- set: ${text} -->`, "set"), engine), why);
  refused('scene="no-such"', /there is no scene no-such/);
  refused('scene="gravity" variants="β = 7"', /there is no variant β = 7/);
  refused('scene="gravity" values="beta=9"', /--beta/);
  refused('scene="gravity" at="99"', /99 s is not within the scene's/);
  refused('scene="gravity" at="soon"', /at is no number/);
  refused('scene="gravity" slider="beta"', /nothing is called slider/);
});

test("a click on words shows what they say, from their instant, and leads back to them", async () => {
  const page = await newPage(browser, { reducedMotion: "reduce", viewport: { width: 1280, height: 800 } });
  await page.goto(address("chapters/03_baumgarte/index.html"));
  await page.locator("summary", { hasText: "Answer" }).first().click();
  const link = page.locator("a.sets").first();
  const asked = new URLSearchParams((await link.getAttribute("href")).slice(1));
  const words = (await link.textContent()).trim();
  await link.click();
  await page.waitForFunction(() => (window.player = window.PUSHBACK_LIVE_TEST.player()));
  await page.waitForFunction((step) => player.engine.now === step, Number(asked.get("step") ?? 0));
  assert.equal(await page.evaluate(() => player.engine.scene.key), asked.get("scene"));
  assert.ok((await page.locator(".pb-sentence").textContent()).includes(words));
  assert.ok(await page.evaluate(() => document.activeElement === player.stage.canvas));
  await page.getByRole("button", { name: "back to the sentence" }).click();
  assert.ok(await link.evaluate((element) => element === document.activeElement));
  const { top, bottom } = await link.evaluate((element) => element.getBoundingClientRect().toJSON());
  assert.ok(top >= 0 && bottom <= 800, `the words stand from ${top} to ${bottom}`);
  // Again, from another state: nothing of that is left.
  await page.evaluate(() => player.set("--dt=0.01", true));
  await link.click();
  await page.waitForFunction((step) => player.engine.now === step, Number(asked.get("step") ?? 0));
  assert.equal(await page.evaluate(() => player.state.get("dt")), asked.get("dt"));
  assert.deepEqual(page.wrong, []);
  await page.close();
});

const challenges = challengesIn(fs.readFileSync(path.join(root, file), "utf8"));

function played(engine, challenge, own) {
  assert.equal(challenge.begin(own), "", challenge.title);
  while (engine.now < engine.steps) engine.goTo(engine.steps, 1000);
  return challenge.verdict();
}

for (const one of challenges) {
  test(`${one.title}: not reached as it begins; ours is, with the score that we say`, async () => {
    const engine = await engineOf(one.mark.asked.chapter);
    const asked = challengeOf(one, engine);
    const challenge = new Challenge(asked, engine);
    const begun = played(engine, challenge);
    assert.ok(!begun.met || challenge.better(asked.ours, begun.score), "it begins as good as ours");
    const { met, score, asks } = played(engine, challenge, new Map(asked.best));
    assert.ok(met, JSON.stringify(asks));
    assert.ok(Math.abs(score - asked.ours) < 1e-3 * Math.abs(asked.ours) + 1e-9, `its score is ${score}`);
  });
}

test("two challenges for each part, each with a key of its own", () => {
  const parts = fs.readFileSync(path.join(root, file), "utf8").split(/^## /m).slice(1);
  assert.ok(parts.length >= 5);
  for (const part of parts) assert.ok(challengesIn(part).length >= 2, part.split("\n")[0]);
  const keys = challenges.map(({ mark }) => mark.asked.key);
  assert.equal(new Set(keys).size, keys.length);
});

test("a challenge is judged on its page, and its link is the score", async () => {
  const [one] = challenges;
  const { chapter, key } = one.mark.asked;
  const asked = challengeOf(one, await engineOf(chapter));
  const page = await newPage(browser, { reducedMotion: "reduce", viewport: { width: 1280, height: 800 } });
  await page.goto(address(file.replace(".md", ".html")));
  await page.locator(`a[href*="challenge=${key}"]`).click();
  await page.waitForFunction(() => (window.player = window.PUSHBACK_LIVE_TEST.player()));
  const panel = page.locator(".pb-challenge");
  assert.ok((await panel.textContent()).includes(one.title));
  const flags = await page.evaluate(() => [...player.root_.querySelectorAll("[data-flag]")].map((e) => e.dataset.flag));
  assert.deepEqual(flags.sort(), [...asked.free].sort());
  await page.getByRole("button", { name: "play it to its end" }).click();
  await page.waitForFunction(() => player.engine.now === player.engine.steps);
  await page.waitForFunction(() => /Not reached|Your score/.test(player.task.textContent));
  assert.match(await panel.textContent(), /Not reached/);
  await page.evaluate(
    (own) => player.set([player.controls.assignments, own].filter(Boolean).join(";"), true),
    asked.best.map((pair) => pair.join("=")).join(";"),
  );
  await page.getByRole("button", { name: "play it to its end" }).click();
  await page.waitForFunction(() => /Your score/.test(player.task.textContent));
  const state = await page.evaluate(() => String(player.state));
  await page.goto("about:blank");
  await page.goto(address(`chapters/${chapter}/index.html#${state}`));
  await page.waitForFunction(() => window.PUSHBACK_LIVE_TEST.player()?.task.textContent.includes("Your score"));
  assert.ok((await panel.textContent()).includes(`Your score: ${Number(asked.ours.toPrecision(4))} ${asked.unit}`));
  // An address that changes what may not be changed changes nothing.
  await page.goto("about:blank");
  await page.goto(address(`chapters/${chapter}/index.html#live=${chapter}&challenge=${key}&dt=0.004`));
  await page.waitForFunction(() => (window.player = window.PUSHBACK_LIVE_TEST.player()));
  assert.equal(await page.evaluate(() => player.state.get("dt")), null);
  await page.getByRole("button", { name: "leave the challenge" }).click();
  assert.ok(await panel.isHidden());
  assert.equal(await page.evaluate(() => player.state.get("challenge")), null);
  assert.deepEqual(page.wrong, []);
  await page.close();
});
