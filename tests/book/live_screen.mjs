/// What a reader sees at once: the experiment of each page of the built book in the window of a laptop and of a telephone.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { idle } from "../../tools/book/idle.js";
import { address } from "./support/browser.mjs";
import { chapters, launch, newPage } from "./support/live.mjs";

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const played = chapters().filter((name) => name !== "hard_cases");
const laptop = { viewport: { width: 1280, height: 800 } },
  telephone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

/// A chapter's page in the book, its experiment asked for as a reader asks: `player` there.
async function asked(chapter, options) {
  const page = await newPage(browser, { reducedMotion: "reduce", ...options });
  await page.goto(address(`chapters/${chapter}/index.html`));
  await page.getByRole("button", { name: /^(Show me|Run it here)$/ }).click();
  await page.waitForFunction(() => (window.player = window.PUSHBACK_LIVE_TEST.player()));
  await page.evaluate(() => new Promise((done) => setTimeout(done, 200)));
  return page;
}

/// How far the first of what `selector` finds reaches out of the window, below the bar; null where there is none that is seen.
const hidden = (page, selector) =>
  page.evaluate((wanted) => {
    const element = [...player.root_.querySelectorAll(wanted)].find((one) => one.getClientRects().length);
    if (!element) return null;
    const { top, bottom } = element.getBoundingClientRect();
    return Math.max(0, player.barred - top, bottom - innerHeight);
  }, selector);

for (const chapter of played) {
  test(`${chapter}: picture, transport, first slider and first curve fit one screen of 1280 by 800`, async () => {
    const page = await asked(chapter, laptop);
    for (const part of [".pb-canvas", ".pb-transport"])
      assert.ok((await hidden(page, part)) <= 1, `${part}: ${await hidden(page, part)} pixels out of sight`);
    const { sliders, curves } = await page.evaluate(() => ({
      sliders: player.deck.querySelectorAll("[data-flag]").length, // a parameter may have a value a variant
      curves: player.curves.plots.length,
    }));
    assert.ok(sliders <= 2, `${sliders} parameters`);
    if (sliders) assert.ok((await hidden(page, ".pb-deck input[type=range]")) <= 1, "its slider is out of sight");
    if (curves) assert.ok((await hidden(page, ".pb-deck .pb-plot")) <= 1, "its curve is out of sight");
    const high = await page.evaluate(() => player.stage.canvas.clientHeight);
    assert.ok(high >= 180, `the picture is only ${high} pixels high`);
    assert.ok(await page.evaluate(() => document.activeElement === player.stage.canvas), "keys go elsewhere");
    assert.deepEqual(page.wrong, []);
    await page.close();
  });
}

test("every page has a slider that acts in the scene of its sheet, and shows none that changes nothing there", async () => {
  for (const chapter of played) {
    const page = await asked(chapter, laptop);
    const { scene, flags } = await page.evaluate(() => ({
      scene: player.engine.sceneIndex,
      flags: [...player.root_.querySelectorAll("[data-flag]")].map(({ dataset }) => dataset.flag),
    }));
    assert.ok(flags.length > 0, `${chapter}: no slider`);
    const without = flags.filter((flag) => idle[chapter][flag]?.includes(scene));
    assert.deepEqual(without, [], chapter);
    await page.close();
  }
});

test("on a telephone: a tab for each variant, and a picture that stays above what is scrolled", async () => {
  const page = await asked("03_baumgarte", telephone);
  const tabs = page.getByRole("tab");
  assert.deepEqual(
    (await tabs.allInnerTexts()).map((text) => text.trim().replace(/^\S /, "")),
    await page.evaluate(() => player.engine.lanes.map(({ name }) => name)),
  );
  const chosen = () => page.evaluate(() => player.stage.panes.map(({ lane }) => lane));
  assert.deepEqual(await chosen(), [0]);
  await tabs.nth(3).tap();
  assert.deepEqual(await chosen(), [3]);
  assert.equal(await tabs.nth(3).getAttribute("aria-selected"), "true");
  await tabs.nth(3).press("ArrowRight");
  assert.deepEqual(await chosen(), [0]);
  assert.equal(
    await page.evaluate(() => document.activeElement.getAttribute("aria-label")),
    await tabs.nth(0).getAttribute("aria-label"),
  );
  await page.evaluate(() => scrollBy(0, player.deck.offsetHeight - 40));
  assert.ok((await hidden(page, ".pb-canvas")) <= 1, "the picture is scrolled away");
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  assert.deepEqual(page.wrong, []);
  await page.close();
});

test("what is out of sight waits, and goes on when it is seen", async () => {
  const page = await asked("03_baumgarte", { ...laptop, reducedMotion: "no-preference" });
  await page.evaluate(() => {
    player.speed = 1 / 32;
    player.go(0);
    player.play();
  });
  const playing = (yes) => page.waitForFunction((wanted) => player.playing === wanted, yes);
  await playing(true);
  await page.evaluate(() => scrollTo(0, 0));
  await playing(false);
  const left = await page.evaluate(() => player.engine.now);
  await page.waitForTimeout(300);
  assert.equal(await page.evaluate(() => player.engine.now), left);
  await page.evaluate(() => player.view.scrollIntoView());
  await playing(true);
  await page.getByRole("button", { name: "Pause" }).click();
  await page.evaluate(() => scrollTo(0, 0));
  await page.waitForTimeout(100);
  await page.evaluate(() => player.view.scrollIntoView());
  await page.waitForTimeout(300);
  assert.equal(await page.evaluate(() => player.playing), false, "what somebody paused stays so");
  await page.close();
});

test("an axis is named in the colour of the theme, also where the theme changes while it runs", async () => {
  const page = await asked("03_baumgarte", { ...laptop, colorScheme: "light" });
  const ink = () =>
    page.evaluate(() => {
      const canvas = player.root_.querySelector(".pb-plot canvas");
      const { data } = canvas.getContext("2d").getImageData(0, 0, 30 * devicePixelRatio, canvas.height);
      let [dark, light] = [0, 0];
      for (let i = 0; i < data.length; i += 4) {
        if (data[i + 3] < 128) continue;
        const bright = data[i] + data[i + 1] + data[i + 2];
        if (bright < 240) ++dark;
        if (bright > 525) ++light;
      }
      return { dark, light };
    });
  const day = await ink();
  await page.emulateMedia({ colorScheme: "dark", reducedMotion: "reduce" });
  await page.waitForTimeout(200);
  const night = await ink();
  assert.ok(day.dark > day.light, JSON.stringify(day));
  assert.ok(night.light > night.dark, JSON.stringify(night));
  await page.close();
});

test("a guess among pictures: taken by the keyboard, seen beside the answer once it has been played", async () => {
  const page = await newPage(browser, { reducedMotion: "reduce", ...laptop });
  await page.goto(address("chapters/03_baumgarte/index.html"));
  const guessed = page.getByRole("group", { name: "Your guess" });
  assert.equal(await guessed.getByRole("radio").count(), 4);
  assert.equal(await guessed.getByRole("img").count(), 4);
  const run = page.getByRole("button", { name: "Guess, then run it" });
  assert.ok(await run.isDisabled());
  await guessed.getByRole("radio").first().focus();
  await page.keyboard.press("ArrowDown");
  assert.ok(
    await guessed
      .getByRole("radio", { name: /stays a|hops/ })
      .first()
      .isChecked(),
  );
  await guessed.getByRole("img").nth(2).click(); // a picture is its own label
  assert.ok(await guessed.getByRole("radio").nth(2).isChecked());
  await run.click();
  await page.waitForFunction(() => (window.player = window.PUSHBACK_LIVE_TEST.player()));
  const compared = page.locator(".pb-compare");
  await compared.waitFor();
  assert.match(await compared.getByRole("img").getAttribute("src"), /guess_3\.png$/);
  assert.match(await compared.innerText(), /β = 1 is picture 1/);
  assert.ok(await page.getByText("Your guess: picture 3: The box comes up").isVisible());
  assert.ok((await hidden(page, ".pb-deck input[type=range]")) <= 1, "its slider is out of sight");
  assert.deepEqual(page.wrong, []);
  await page.close();
});
