/// What a reader does with an experiment, read off the simulation's state: time, parameters, the hand, the address, challenges, hard cases.
/// After ./course book, which compiles all of them.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import { home } from "../../tools/book/experiments.js";
import { challengeOf, challengesIn, clipOf, stateOf, stepsOf } from "../../tools/book/marks.js";
import {
  address,
  bits,
  engineOf,
  experiments,
  html,
  launch,
  newPage,
  running,
  seek,
  settled,
} from "./support/browser.mjs";

const chapter = "03_baumgarte";
const page03 = `chapters/${chapter}/index.html`;
const opened = (state = "", options) => running(browser, page03, `live=${chapter}${state}`, options);
const now = (page) => page.evaluate(() => player.engine.now);
const names = (page) => page.evaluate(() => player.engine.lanes.map(({ name }) => name));
let browser;
before(async () => (browser = await launch({ draws: true })));
after(() => browser.close());

test("play, pause, the time line, the speed, by buttons and by keys", async () => {
  const page = await opened();
  await page.getByRole("slider", { name: "Time", exact: true }).fill("30");
  await settled(page);
  assert.equal(await now(page), 30);
  await page.getByRole("combobox", { name: "Speed" }).selectOption({ label: "8 times as fast" });
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await page.waitForFunction(() => !player.playing && player.engine.now === player.engine.steps);
  await page.getByRole("combobox", { name: "Speed" }).selectOption({ label: "1/32 of real time" }); // so that it still plays when asked
  const canvas = page.locator(".pb-canvas");
  await canvas.focus();
  await page.keyboard.press("Home");
  await page.keyboard.press(".");
  assert.equal(await now(page), 1);
  for (const [key, changes] of [
    ["ArrowLeft", "turn"],
    ["ArrowUp", "rise"],
    ["+", "zoom"],
  ]) {
    const camera = () => page.evaluate((what) => player.view.stage.camera[what], changes);
    const before = await camera();
    await page.keyboard.press(key);
    assert.notEqual(await camera(), before, key);
  }
  await page.keyboard.press("Space");
  assert.ok(await page.evaluate(() => player.playing));
  await page.keyboard.press("Space");
  assert.deepEqual(page.wrong, []);
  await page.close();
});

test("sliders change what is simulated, at the same instant; reset, one more, one less; what is not allowed is refused", async () => {
  const page = await opened();
  await seek(page, 20);
  const usual = await bits(page);
  const depth = page.getByRole("spinbutton", { name: "Overlap at the start, as a number" });
  await depth.fill("0.1");
  await depth.press("Enter");
  await settled(page);
  assert.equal(await now(page), 20);
  assert.match(await page.evaluate(() => player.engine.scene.name), /^100 mm too deep/);
  await page.getByRole("button", { name: "Reset: Overlap at the start" }).click();
  await settled(page);
  assert.deepEqual(await bits(page), usual);
  await page.getByRole("slider", { name: "Baumgarte factors to put side by side, 4 of 4" }).fill("280");
  await settled(page);
  assert.deepEqual(await names(page), ["β = 0", "β = 0.2", "β = 0.5", "β = 1.4"]);
  await page.getByRole("button", { name: "Leave out: Baumgarte factors to put side by side, 1 of 4" }).click();
  await settled(page);
  assert.equal((await names(page)).length, 3);
  await page.getByRole("button", { name: "One more: Baumgarte" }).click();
  await settled(page);
  assert.equal((await names(page)).length, 4);
  await depth.fill("5");
  await depth.press("Enter");
  assert.match(await page.getByRole("alert").textContent(), /--depth: '5' is not allowed/);
  assert.deepEqual(page.wrong, []);
  await page.close();
});

test("scenes, variants, what is drawn; numbers stand beside what they should be; a click on a curve goes there", async () => {
  const page = await opened();
  await page.getByRole("checkbox", { name: "β = 0.5" }).uncheck();
  assert.deepEqual(await names(page), ["β = 0", "β = 0.2", "β = 1"]);
  await seek(page, 6);
  const picture = () =>
    page.evaluate(() => {
      player.view.stage.draw();
      return player.view.stage.canvas.toDataURL();
    });
  const whole = await picture();
  await page.getByRole("checkbox", { name: "what should be" }).uncheck();
  assert.notEqual(await picture(), whole);
  const over = page.locator(".pb-deck .u-over"),
    box = await over.boundingBox();
  await over.click({ position: { x: box.width / 2, y: box.height / 2 } });
  await settled(page);
  assert.equal(await now(page), 24);
  await page.getByRole("combobox", { name: "Scene" }).selectOption({ index: 1 });
  await seek(page, 10);
  const [is, should] = await page.evaluate(() => player.engine.number(0, 0));
  assert.deepEqual([is, should], ["0.72 m/s", "0.72 m/s"]); // 0.2 * 0.06 m * 60/s
  assert.ok((await page.getByRole("row", { name: /exit speed/ }).textContent()).includes(`${is}\u00a0(should be`));
  assert.deepEqual(page.wrong, []);
  await page.close();
});

test("a body that is pulled follows in every variant; going back plays the pull again", async () => {
  const page = await opened();
  await seek(page, 40);
  const untouched = await bits(page);
  await seek(page, 10);
  // Where a body is found under the mouse.
  const spot = await page.evaluate(() => {
    player.bringIntoView();
    const { stage } = player.view;
    const { left, top, width, height } = stage.panes[0];
    const box = stage.canvas.getBoundingClientRect();
    for (let y = 2; y < height; y += 4)
      for (let x = 2; x < width; x += 4) {
        if (!stage.grabAt(left + x, top + y, 0)) continue;
        player.engine.letGo();
        return [box.left + left + x + 2, box.top + top + y + 2];
      }
    return null;
  });
  await page.mouse.move(...spot);
  await page.mouse.down();
  assert.ok(await page.evaluate(() => player.held && player.playing), "the body is held, and time goes on");
  await page.evaluate(() => (player.speed = 4));
  await page.mouse.move(spot[0], spot[1] - 60, { steps: 3 });
  await page.waitForFunction(() => player.engine.now >= 30 || !player.playing);
  await page.mouse.up();
  await page.evaluate(() => player.pause());
  await seek(page, 40);
  const pulled = await bits(page);
  for (const lane of pulled.keys()) assert.notEqual(pulled[lane], untouched[lane], `variant ${lane}`);
  await seek(page, 5);
  await seek(page, 40);
  assert.deepEqual(await bits(page), pulled);
  assert.deepEqual(page.wrong, []);
  await page.close();
});

test("the address holds the state, and what it says wrongly is left as it is", async () => {
  const page = await opened("&beta=0.2,1.4&step=12&see=1&view=0.3,0.1,1,0,0");
  const seen = await bits(page);
  await page.evaluate(() => player.remember());
  await page.waitForFunction(() => location.hash.includes("scene=gravity"));
  const again = await newPage(browser);
  await again.goto(page.url());
  await again.waitForFunction(() => (window.player = window.PUSHBACK_LIVE_TEST.player()) && player.engine.now === 12);
  assert.deepEqual(await bits(again), seen);
  assert.deepEqual(await again.evaluate(() => [player.shown, player.view.stage.camera.turn]), [1, 0.3]);
  assert.deepEqual(again.wrong, []);
  await again.close();
  await page.close();
  const wrong = await opened("&beta=9&scene=nowhere&show=70&step=-4&view=1,2");
  assert.match(await wrong.getByRole("alert").textContent(), /--beta: '9' is not allowed/);
  assert.equal(await now(wrong), 0);
  await wrong.close();
});

test("a scene that has no variant with these values cannot be chosen, and where one is left without any, another begins", async () => {
  const { key, name } = (await engineOf(chapter)).description.scenes[1];
  const page = await opened(`&beta=0&scene=${key}`);
  assert.match(await page.getByRole("alert").textContent(), /has no variant/);
  assert.deepEqual(await names(page), ["β = 0"]);
  assert.ok(await page.evaluate(() => document.querySelectorAll(".pb-scene option")[1].disabled));
  await page.evaluate((state) => (location.hash = state), `live=${chapter}&beta=0,0.5&scene=${key}`);
  await page.waitForFunction(() => player.engine.sceneIndex === 1);
  await page.evaluate(() => player.set("--beta=0", true));
  await settled(page);
  assert.match(await page.getByRole("alert").textContent(), /has no variant/);
  assert.ok((await page.getByRole("alert").textContent()).includes(name));
  assert.deepEqual(await names(page), ["β = 0"]);
  assert.deepEqual(page.wrong, []);
  await page.close();
});

test("a scene plays within some five seconds, in a picture that keeps its size", async () => {
  for (const name of experiments.filter((one) => ["07_warm_start", "12_soft_contacts"].includes(one))) {
    const page = await running(browser, `chapters/${name}/index.html`, `live=${name}`);
    const seconds = await page.evaluate(() => (player.engine.steps * player.engine.dt) / player.speed);
    assert.ok(seconds <= 6, `${name}: ${seconds} s`);
    const size = () => page.evaluate(() => player.view.stage.size.height);
    await page.evaluate(() => document.querySelectorAll(".pb-fold").forEach((fold) => (fold.open = false)));
    await settled(page);
    const start = await size();
    await seek(page, 60);
    await page.evaluate(() => new Promise((done) => setTimeout(done, 500)));
    assert.equal(await size(), start, name);
    await page.close();
  }
});

test("a figure plays the scene of the sheet in whose place it is, and on a telephone the variant that the guess names", async () => {
  const name = "12_soft_contacts";
  if (!experiments.includes(name)) return;
  for (const [file, scene, first] of [
    ["index", "ball", "32 substeps, hard"],
    ["relax", "a-stack-of-twenty", "32 substeps, soft"],
    ["tall_columns", "column", "32 substeps, 30 Hz"],
  ]) {
    const options = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
    const page = await running(browser, `chapters/${name}/${file}.html`, `live=${name}`, options);
    const seen = await page.evaluate(() => [
      player.engine.scene.key,
      player.engine.lanes[player.view.stage.panes[0].lane].name,
    ]);
    assert.deepEqual(seen, [scene, first], file);
    await page.close();
  }
});

test("a legend of a curve marks each variant once", async () => {
  const page = await opened();
  const marks = await page.evaluate(() =>
    [...document.querySelectorAll(".pb-deck .u-series")]
      .slice(1, 1 + player.engine.lanes.length)
      .map((row) => [row.querySelectorAll("th > :not(.u-label)").length, row.querySelector(".u-label").textContent]),
  );
  assert.deepEqual(
    marks,
    (await names(page)).map((name) => [1, name]),
  );
  await page.close();
});

test("words that set the figure are links to its state; the browser's own way leads back to them", async () => {
  const page = await opened("&step=5");
  await page.locator("summary", { hasText: "Answer" }).first().click();
  const link = page.locator("a.sets").last();
  const asked = new URLSearchParams((await link.getAttribute("href")).slice(1));
  await link.click();
  await page.waitForFunction((beta) => player.state.get("beta") === beta, asked.get("beta"));
  assert.equal(await page.evaluate(() => player.engine.scene.key), asked.get("scene"));
  assert.ok(await page.evaluate(() => document.activeElement === player.view.stage.canvas));
  await page.goBack();
  await page.waitForFunction(() => player.engine.now === 5);
  const { top, bottom } = await link.evaluate((element) => element.getBoundingClientRect().toJSON());
  assert.ok(top >= 0 && bottom <= 800, `the words stand from ${top} to ${bottom}`);
  assert.deepEqual(page.wrong, []);
  await page.close();
});

test("on a telephone the variant that the guess asks about is seen first, and nothing lies on its picture, nor on the answer", async () => {
  const page = await opened("", { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  assert.equal(await page.getByRole("tab", { selected: true }).textContent(), "◆ β = 1");
  const covered = await page.evaluate(() => {
    const { canvas, labels } = player.view.stage;
    const { top } = canvas.getBoundingClientRect();
    return [...labels.children].filter((one) => one.getBoundingClientRect().bottom > top + 1).length;
  });
  assert.equal(covered, 0);
  await page.locator("summary", { hasText: "Answer" }).first().tap();
  const words = page.locator("details[open] p").first();
  await words.scrollIntoViewIfNeeded();
  const free = await words.evaluate((element) => {
    const { left, top, bottom } = element.getBoundingClientRect();
    return element.contains(document.elementFromPoint(left + 20, (top + bottom) / 2));
  });
  assert.ok(free, "something lies on the answer");
  assert.deepEqual(page.wrong, []);
  await page.close();
});

test("on a telephone: a tab for each variant, nothing wider than the page, a picture that stays above what is scrolled", async () => {
  const page = await opened("", { viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true });
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 360);
  await page.getByRole("tab").nth(3).tap();
  assert.deepEqual(await page.evaluate(() => player.view.stage.panes.map(({ lane }) => lane)), [3]);
  await page.locator(".pb-foot").scrollIntoViewIfNeeded();
  assert.ok(await page.evaluate(() => player.view.stage.canvas.getBoundingClientRect().bottom > 100));
  assert.deepEqual(page.wrong, []);
  await page.close();
});

const toy = experiments.includes("07_warm_start") ? false : "the experiment of the front page is not compiled";
test("the front page begins with two stacks that run without a click, and one switch", { skip: toy }, async () => {
  const page = await newPage(browser, { reducedMotion: "no-preference", viewport: { width: 800, height: 500 } });
  await page.goto(address("index.html"));
  const painted = await page.waitForFunction(
    () => performance.getEntriesByName("first-contentful-paint")[0]?.startTime,
  );
  console.log(`painted after ${Math.round(await painted.jsonValue())} ms`);
  await page.waitForFunction(() => document.querySelector("figure.toy img").naturalWidth > 0);
  await page.waitForFunction(() => (window.player = window.PUSHBACK_LIVE_TEST?.player())?.engine.now > 0);
  /** m, of the top boxes after ten seconds. */
  const heights = () =>
    page.evaluate(() => {
      player.pause();
      while (player.engine.now < 600) player.seek(600);
      return [0, 1].map((lane) => player.engine.body(lane, player.engine.bodies(lane) - 1).position[1]);
    });
  await page.locator(".pb-hint").waitFor();
  const [forgotten, remembered] = await heights();
  assert.ok(forgotten < 2 && remembered > 9, `${forgotten} m, ${remembered} m`);
  assert.equal(await page.isVisible(".pb-deck"), false);
  assert.equal(await page.evaluate(() => location.hash), "");
  await page.getByRole("checkbox", { name: "remember impulses" }).check();
  assert.ok(await page.evaluate(() => player.playing && player.engine.now < 600), "it begins again");
  assert.ok((await heights()).every((height) => height > 9));
  const [left, right] = await bits(page);
  assert.equal(left, right);
  await page.getByRole("button", { name: "all controls" }).click();
  assert.ok((await page.isVisible(".pb-deck")) && !(await page.isVisible(".pb-hint")));
  assert.deepEqual(page.wrong, []);
  await page.close();
});

test("without graphics, or where they are lost, the still picture and a sentence; time goes on", async () => {
  const other = await launch();
  const page = await newPage(other);
  await page.goto(address(page03));
  await page.getByRole("button", { name: "Run it here" }).click();
  await page.getByText("this browser shows no WebGL 2").waitFor();
  assert.ok(await page.locator("figure.live img").isVisible());
  await page.getByRole("button", { name: "One step on" }).click();
  assert.equal(await page.evaluate(() => window.PUSHBACK_LIVE_TEST.player().engine.now), 1);
  await other.close();
  const lost = await opened("&step=10");
  await lost.evaluate(() => {
    window.loser = player.view.stage.canvas.getContext("webgl2").getExtension("WEBGL_lose_context");
    loser.loseContext();
  });
  await lost.getByText("took the graphics of this page away").waitFor();
  await lost.evaluate(() => loser.restoreContext());
  await lost.waitForFunction(() => !player.view.stage.problem && !document.querySelector(".pb-still"));
  assert.equal(await now(lost), 10);
  await lost.close();
});

const whole = experiments.includes("16_whole_problem") ? false : "chapter 16 is not compiled";
test(
  "a problem of one step is solved iteration by iteration, to and fro, to the same bits",
  { skip: whole },
  async () => {
    const page = await running(browser, "chapters/16_whole_problem/index.html", "live=16_whole_problem&iteration=3");
    const impulses = () =>
      page.evaluate(() => player.engine.problem.methods.map((_, i) => Array.from(player.engine.impulses(i))));
    const shown = (iteration) => page.waitForFunction((k) => player.iterations.drawn === k, iteration);
    await shown(3);
    const three = await impulses();
    await page.getByRole("button", { name: "One iteration on" }).click();
    await shown(4);
    assert.notDeepEqual(await impulses(), three);
    await page.getByRole("button", { name: "One iteration back" }).click();
    await shown(3);
    assert.deepEqual(await impulses(), three);
    await page.getByRole("button", { name: "Play the iterations" }).click();
    await page.waitForFunction(() => player.engine.iteration > 8);
    await page.getByRole("button", { name: "Pause the iterations" }).click();
    assert.deepEqual(page.wrong, []);
    await page.close();
  },
);

test("marks that ask for what does not exist are refused", async () => {
  const engine = await engineOf(chapter);
  const refused = (asked, why) => assert.throws(() => clipOf({ scene: "gravity", ...asked }, engine), why);
  refused({ scene: "no-such" }, /there is no scene no-such; there are gravity, /);
  refused({ variants: "β = 7" }, /there is no variant β = 7/);
  refused({ values: "nosuch=1" }, /nosuch/);
  refused({ values: "beta=x" }, /x is no number/);
  refused({ slider: "nosuch" }, /there is no parameter/);
  refused({ number: "nosuch" }, /there is no number nosuch/);
  refused({ colour: "red" }, /nothing is called colour/);
  refused({ number: "highest jump", guess: "0 up 0", within: "1" }, /up is no number/);
  refused({ draw: "nosuch" }, /there is no series nosuch/);
  assert.throws(() => stepsOf({ of: "cold|hot" }, ["cold", "warm"]), /there is no step hot; there are cold, warm/);
  engine.set("");
  assert.throws(() => stateOf({ scene: "gravity", at: "99" }, engine), /99 s is not within the scene's/);
});

const challenges = challengesIn(fs.readFileSync(path.join(home, "docs/challenges.md"), "utf8"));
globalThis.self = globalThis; // what a page's script finds in its window
await import("../../tools/book/live/challenge.js");

for (const one of challenges.filter(({ asked }) => experiments.includes(asked.chapter))) {
  test(`${one.title}: not reached as it begins; ours is, with the score that we say`, async () => {
    const engine = await engineOf(one.asked.chapter);
    const asked = challengeOf(one, engine);
    const challenge = new globalThis.PushbackLive.Challenge(asked, engine);
    const verdict = (own) => {
      assert.equal(challenge.begin(own), "");
      while (engine.now < engine.steps) engine.goTo(engine.steps, 1000);
      return challenge.verdict();
    };
    const begun = verdict();
    assert.ok(!begun.met || challenge.better(asked.ours, begun.score), "it begins as good as ours");
    const { met, score, asks } = verdict(new Map(asked.best));
    assert.ok(met, JSON.stringify(asks));
    assert.ok(Math.abs(score - asked.ours) < 1e-3 * Math.abs(asked.ours) + 1e-9, `its score is ${score}`);
  });
}

test("a challenge is judged on its page, and its link is the score", async () => {
  const one = challenges.find(({ asked }) => asked.chapter === chapter);
  const asked = challengeOf(one, await engineOf(chapter));
  const own = asked.best.map(([flag, value]) => `&${flag.slice(2)}=${value}`).join("");
  const page = await opened(`&challenge=${asked.key}&dt=0.004`);
  assert.equal(await page.evaluate(() => player.state.get("dt")), null); // it may not be changed
  const flags = await page.evaluate(() => [...document.querySelectorAll("[data-flag]")].map((e) => e.dataset.flag));
  assert.deepEqual(flags.sort(), [...asked.free].sort());
  await page.getByRole("button", { name: "play it to its end" }).click();
  await page.getByText("Not reached: no score.").waitFor();
  await page.evaluate((state) => (location.hash = state), `live=${chapter}&challenge=${asked.key}${own}&step=9999`);
  await page.getByText(`Your score: ${Number(asked.ours.toPrecision(4))} ${asked.unit}`).waitFor();
  await page.getByRole("button", { name: "leave the challenge" }).click();
  assert.equal(await page.evaluate(() => player.state.get("challenge")), null);
  assert.deepEqual(page.wrong, []);
  await page.close();
});

const hardCases = experiments.includes("hard_cases") ? false : "the hard cases are not compiled";
test("each cell of the table of hard cases leads to its case under its stage", { skip: hardCases }, async () => {
  const { scenes } = (await engineOf("hard_cases")).description;
  const cells = [
    ...html("renders/hard_cases/table.html").matchAll(/<td[^>]*><a href="([^"#]*)#(live=[^"]*)" title="([^"]*)"/g),
  ];
  assert.equal(cells.length, scenes.length * scenes[0].variants.length);
  for (const [, , state, title] of cells) {
    const asked = new URLSearchParams(state.replaceAll("&amp;", "&"));
    const scene = scenes.find(({ key }) => key === asked.get("scene"));
    const shown = asked.get("show").split(",").map(Number);
    assert.equal(scene?.variants[shown[0]].name, title, state);
    assert.equal(new Set(shown.filter((place) => scene.variants[place])).size, 4, state);
  }
  const moving = await newPage(browser, { reducedMotion: "no-preference" });
  await moving.goto(address("renders/hard_cases/table.html"));
  await moving.locator('td a[href*="scene=ball-and-chain&"]').nth(7).click();
  await moving.waitForFunction(() => window.PUSHBACK_LIVE_TEST?.player()?.engine.now > 1);
  assert.equal(await moving.evaluate(() => window.PUSHBACK_LIVE_TEST.player().engine.lanes.length), 4);
  await moving.close();
  const page = await running(browser, "docs/hard_cases.html", "live=hard_cases&scene=ball-and-chain&show=0");
  await seek(page, 5);
  await page.getByText(/00 naive: ended at 0.0167 s: .*joint/).waitFor();
  assert.deepEqual(page.wrong, []);
  await page.close();
});
