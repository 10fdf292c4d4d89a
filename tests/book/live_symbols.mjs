/// What a page binds together: a symbol in its formulas, its code and its pictures, and a variant's number with its picture.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { launch, running, seek, settled } from "./support/browser.mjs";

let browser;
before(async () => (browser = await launch({ draws: true })));
after(() => browser.close());

/// Of the experiment, or of a small picture, the pixels in the colour in which something is lit.
async function drawn(page, figure = ".pb-stage") {
  await settled(page);
  return page.evaluate((figure) => {
    player.view.stage.draw();
    const from = document.querySelector(`${figure} canvas`),
      { width, height } = from;
    const pen = new OffscreenCanvas(width, height).getContext("2d");
    pen.drawImage(from, 0, 0);
    const { data } = pen.getImageData(0, 0, width, height);
    let count = 0;
    for (let i = 0; i < data.length; i += 4)
      if (data[i] > 160 && data[i + 1] < 60 && data[i + 2] > 60 && data[i + 2] < 170) ++count;
    return count;
  }, figure);
}
/// What is lit in all parts of the page of this kind.
const lit = (page, part) => page.$$eval(`${part} .lit`, (all) => all.map(({ textContent }) => textContent));

/// Points at the first one that the reader can see.
async function pointAt(page, symbol) {
  const shown = page.locator(`.katex-html [data-symbol="${symbol}"]:visible`).first();
  await shown.scrollIntoViewIfNeeded();
  await shown.hover();
}

test("a symbol that is pointed at is lit in formulas, code and picture, until the pointer leaves it; a click keeps it", async () => {
  const page = await running(
    browser,
    "chapters/01_velocity_constraint/index.html",
    "live=01_velocity_constraint&show=1",
  );
  await seek(page, 40);
  assert.equal(await drawn(page), 0);
  const pictures = [];
  for (const [symbol, names] of [
    ["n", ["n", "normal"]],
    ["d", ["depth"]],
    ["λ", ["impulse", "lambda"]],
  ]) {
    await pointAt(page, symbol);
    pictures.push(await drawn(page));
    const formulas = await lit(page, ".katex-html");
    assert.ok(formulas.length > 1 && formulas.every((text) => text === symbol), `${symbol}: ${formulas}`);
    assert.deepEqual([...new Set(await lit(page, "code"))].sort(), names, symbol);
  }
  assert.ok(Math.min(...pictures) > 30, `${pictures} pixels`);
  assert.equal(new Set(pictures).size, 3, "three symbols, three pictures");
  await page.mouse.move(2, 300);
  assert.equal(await drawn(page), 0);
  await pointAt(page, "λ");
  await page.mouse.down();
  await page.mouse.up();
  await page.mouse.move(2, 300);
  assert.ok((await drawn(page)) > 30);
  await page.locator("h1").click();
  assert.equal(await drawn(page), 0);
  assert.deepEqual(page.wrong, []);
  await page.close();
});

test("a small picture shows it, too, in the instant in which it stands", async () => {
  const page = await running(browser, "chapters/01_velocity_constraint/index.html", "live=01_velocity_constraint");
  await page.locator(".small-live:not(.rows)").nth(1).scrollIntoViewIfNeeded();
  await page.evaluate(async () => {
    const second = (await PUSHBACK_LIVE_TEST.small).filter(({ clip }) => clip)[1];
    second.figure.id = "second";
    second.time = second.clip.seconds;
    second.take(5000);
    second.draw();
  });
  assert.equal(await drawn(page, "#second"), 0);
  await page.locator('p:has-text("It pulls.") .katex-html [data-symbol="λ"]').hover();
  await page.waitForFunction(() => document.documentElement.dataset.lit === "λ");
  assert.ok((await drawn(page, "#second")) > 30);
  await page.close();
});

test("by the keyboard and by a finger, too; β lights its sliders, also of small pictures", async () => {
  const options = { viewport: { width: 390, height: 844 }, hasTouch: true };
  const page = await running(browser, "chapters/03_baumgarte/index.html", "live=03_baumgarte", options);
  const sliders = () => page.locator(":is(.pb-parameter, .small-live label).lit").count();
  await page.locator('[data-symbol="d"][tabindex]').focus();
  assert.ok((await lit(page, ".katex-html")).length > 20);
  assert.equal(await sliders(), 0);
  await page.locator('[data-symbol="β"][tabindex]').focus();
  assert.equal(await sliders(), 4);
  await page.locator("h1").tap();
  assert.equal(await sliders(), 0);
  await page.locator('.katex-html [data-symbol="β"]:visible').first().tap();
  assert.equal(await sliders(), 4);
  await page.close();
});

test("each variant's picture says its number, on a telephone its tab", async () => {
  for (const [width, place, said] of [
    [1280, ".pb-label", ["highest jump120 mm", "highest jump631 mm"]],
    [390, ".pb-tabs button", ["120 mm", "631 mm"]],
  ]) {
    const options = { viewport: { width, height: 844 } };
    const page = await running(browser, "chapters/03_baumgarte/index.html", "live=03_baumgarte&show=2,3", options);
    const names = ["▲ β = 0.5", "◆ β = 1"];
    assert.deepEqual(await page.locator(place).allTextContents(), names, "nothing is measured yet");
    await seek(page, await page.evaluate(() => player.engine.steps));
    const all = names.map((name, i) => name + said[i]);
    assert.deepEqual(await page.locator(place).allTextContents(), all);
    if (width < 480) await page.getByRole("tab").first().click();
    assert.deepEqual(await page.locator(place).allTextContents(), all);
    await page.close();
  }
});
