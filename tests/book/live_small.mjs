/// Figures that a reader works: a step that is solved row by row, and a guess that is dragged or drawn into a small picture.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { address, launch, newPage } from "./support/browser.mjs";

let browser;
before(async () => (browser = await launch({ draws: true })));
after(() => browser.close());

async function rowsOf(chapter) {
  const page = await newPage(browser);
  await page.goto(address(`chapters/${chapter}/index.html`));
  const figure = page.locator("figure.rows");
  await figure.scrollIntoViewIfNeeded();
  await page.waitForSelector(".rows-label .sum");
  const next = figure.getByRole("button", { name: "Solve the next contact" });
  return {
    page,
    figure,
    solve: async (times) => {
      for (let i = 0; i < times; ++i) await next.click();
    },
    labels: () => figure.locator(".rows-label").evaluateAll((all) => all.map(({ innerText }) => innerText)),
    said: () => figure.getByRole("status").textContent(),
    picture: () => figure.locator("canvas").evaluate((canvas) => canvas.toDataURL()),
  };
}

test("each click solves the next contact: chapter 02's table, where a correction is negative and its sum is not", async () => {
  const { page, figure, solve, labels, said, picture } = await rowsOf("02_clamping");
  assert.deepEqual(await labels(), ["Σλ₁ 0 N s\n↓ 1 m/s", "Σλ₂ 0 N s\n↓ 1 m/s"]);
  const begun = await picture();
  await solve(1);
  assert.deepEqual(await labels(), ["Σλ₁ 0.769 N s\n0 m/s", "Σλ₂ 0 N s\n↓ 0.462 m/s"]);
  assert.notEqual(await picture(), begun, "the arrow grows");
  await solve(1);
  assert.deepEqual(await labels(), ["Σλ₁ 0.769 N s\n↑ 0.249 m/s", "Σλ₂ 0.355 N s\n0 m/s"]);
  await solve(1);
  assert.equal(
    await said(),
    "Sweep 2, row 1: the impulse goes from 0.769 to 0.578\u00a0N\u00a0s, a correction of −0.191\u00a0N\u00a0s.",
  );
  await figure.getByRole("radio", { name: "each correction" }).check();
  assert.equal(
    await said(),
    "Sweep 2, row 1: the impulse goes from 0.769 to 0.769\u00a0N\u00a0s, a correction of 0\u00a0N\u00a0s.",
  );
  assert.deepEqual(page.wrong, []);
  await page.close();
});

test("row by row, a bound of friction grows with its normal impulse, and a warm start has the load before the first row", async () => {
  const rubbing = await rowsOf("06_friction");
  /** Left, right and height of what has one of the two colours of impulses, in parts of the picture's height from its middle. */
  const arrows = (violet) =>
    rubbing.figure.locator("canvas").evaluate((canvas, violet) => {
      const { width, height } = canvas,
        copy = new OffscreenCanvas(width, height).getContext("2d"),
        found = [];
      copy.drawImage(canvas, 0, 0);
      const { data } = copy.getImageData(0, 0, width, height);
      for (let i = 0; i < data.length; i += 4)
        if (data[i + 2] > 170 && data[i + (violet ? 1 : 0)] < 70 && data[i + (violet ? 0 : 1)] > 80)
          found.push([(i / 4) % width, Math.floor(i / 4 / width)]);
      const [x, y] = [0, 1].map((axis) => found.map((one) => one[axis]));
      return [Math.min(...x) - width / 2, Math.max(...x) - width / 2, Math.max(...y) - Math.min(...y)].map(
        (p) => p / height,
      );
    }, violet);
  await rubbing.solve(1);
  assert.ok((await arrows(false))[2] > 0.09, "the first impulse is seen");
  await rubbing.solve(6);
  const [left, right, high] = await arrows(true);
  assert.ok(left > -0.16 && right < 0.16 && right - left > 0.035 && high > 0.01, "friction is seen, beside no label");
  assert.match((await rubbing.labels())[0], /Σλₙ 0.4 N s.*Σλₜ −0.2 N s\nlimit ±0.2\n/s);
  await rubbing.figure.getByRole("button", { name: "Play" }).click();
  await rubbing.page.waitForFunction(() =>
    document.querySelector(".rows [role=status]").textContent.startsWith("Sweep 2"),
  );
  await rubbing.figure.getByRole("button", { name: "Pause" }).click();
  assert.deepEqual(rubbing.page.wrong, []);
  await rubbing.page.close();
  const standing = await rowsOf("07_warm_start");
  const load = (corner) => `Σλ ${corner} N s\n0 m/s`;
  assert.match((await standing.labels())[0], /^Σλ 0 N s\n↓/);
  await standing.figure.getByRole("radio", { name: "warm" }).check();
  assert.deepEqual(await standing.labels(), [24.5, 24.5, 16.3, 16.3, 8.17, 8.17].map(load));
  assert.deepEqual(standing.page.wrong, []);
  await standing.page.close();
});

test("a guess is dragged or set by keys; played, it is right or wrong in numbers; another picture has no outline", async () => {
  const page = await newPage(browser);
  await page.goto(address("chapters/03_baumgarte/index.html"));
  const figure = page.locator("figure.small-live", { hasText: "Drag the box" });
  await figure.scrollIntoViewIfNeeded();
  const slider = figure.getByRole("slider", { name: "your guess" }),
    play = figure.getByRole("button");
  await page.waitForFunction((input) => !input.disabled, await slider.elementHandle());
  const told = () => figure.locator("figcaption output").textContent();
  const verdict = async () => {
    await play.click();
    await page.waitForFunction(
      (one) => one.querySelector("figcaption output").textContent,
      await figure.elementHandle(),
    );
    return told();
  };
  const box = await figure.locator("canvas").boundingBox();
  const to = (height) => [box.x + box.width / 2, box.y + height * box.height];
  await page.mouse.move(...to(0.75));
  await page.mouse.down();
  await page.mouse.move(...to(0.2), { steps: 4 });
  const dragged = Number(await slider.getAttribute("aria-valuetext").then(parseFloat));
  assert.ok(dragged > 700 && dragged <= 1000, `dragged to ${dragged} mm`);
  await page.mouse.up();
  await page.mouse.move(...to(0.5));
  assert.equal(parseFloat(await slider.getAttribute("aria-valuetext")), dragged, "let go, it stays");
  assert.equal(await verdict(), `You: ${dragged} mm. It is 631 mm. ✗ Too high.`);
  await slider.focus();
  await page.keyboard.press("Home");
  assert.equal(await told(), "");
  for (let i = 0; i < 66; ++i) await page.keyboard.press("ArrowRight");
  assert.equal(await verdict(), "You: 600 mm. It is 631 mm. ✓ Right.");
  const another = async (opened) => {
    const next = opened.locator("figure.small-live", { has: opened.getByRole("slider") }).nth(1);
    await next.scrollIntoViewIfNeeded();
    await opened.waitForFunction((input) => !input.disabled, await next.getByRole("slider").elementHandle());
    await next.getByRole("slider").fill("1");
    return next.locator("canvas").evaluate((canvas) => canvas.toDataURL());
  };
  const fresh = await newPage(browser);
  await fresh.goto(address("chapters/03_baumgarte/index.html"));
  assert.equal(await another(page), await another(fresh), "its outlines stay in its picture");
  await fresh.close();
  assert.deepEqual(page.wrong, []);
  await page.close();
});

test("a picture that comes into sight while another plays begins once that one has left", async () => {
  const page = await newPage(browser, { reducedMotion: "no-preference", viewport: { width: 1280, height: 1000 } });
  await page.goto(address("chapters/03_baumgarte/index.html"));
  const [first, second] = [3, 4].map((place) => page.locator("figure.small-live").nth(place));
  /** Scrolls until so much lies between a picture's end and the top of the window, and its observers know. */
  const to = (figure, pixels) =>
    figure.evaluate(async (one, end) => {
      scrollBy({ top: one.getBoundingClientRect().bottom - end, behavior: "instant" });
      for (let i = 0; i < 3; ++i) await new Promise(requestAnimationFrame);
    }, pixels);
  const playing = async (figure) =>
    page.waitForFunction((one) => one.classList.contains("playing"), await figure.elementHandle());
  await to(first, 960);
  await playing(first);
  await to(second, 960);
  await second.locator("button:enabled").waitFor(); // it is made when it comes near
  await to(second, 960);
  await to(first, 60);
  await playing(second);
  assert.deepEqual(page.wrong, []);
  await page.close();
});

/// In each chapter the truth as a formula of the time, s, what a reader may take it for, and how far that is off, at least and at most.
const climbs = (t) => {
  const k = [0.64, 1.97, 9].findIndex((lands) => t < lands);
  return [2, 2.15, 2.47][k] - 4.905 * (t - [0, 1.31, 2.67][k]) ** 2;
};
const curves = {
  "03_baumgarte": { seconds: 0.25, right: (t) => 60 * 0.8 ** (60 * t), wrong: () => 60, off: [48, 58] },
  "04_slop": { seconds: 1, right: () => 8, wrong: (t) => 8 + 12 * t, off: [11, 12.5] },
  "05_restitution": { seconds: 3, right: climbs, wrong: (t) => 2 - 0.5 * t, off: [1.2, 1.9] },
};
for (const [chapter, { seconds, right, wrong, off }] of Object.entries(curves))
  test(`${chapter}: a curve is drawn into an empty plot; played, the truth is over it, and it is right or wrong by a number`, async () => {
    const hasTouch = chapter === "04_slop";
    const page = await newPage(browser, { hasTouch });
    const finger = hasTouch && (await page.context().newCDPSession(page));
    await page.goto(address(`chapters/${chapter}/index.html`));
    const figure = page.locator("figure.draws");
    await figure.scrollIntoViewIfNeeded();
    await figure.locator("button:enabled").waitFor();
    await figure.evaluate((one) => one.scrollIntoView({ block: "center" }));
    const told = () => figure.locator("figcaption output").textContent();
    const plot = figure.locator(".u-over");
    const { from, to } = await figure.evaluate((one) => JSON.parse(one.dataset.clip).curve);
    /** How many pixels of the plot have the truth's colour. */
    const truth = () =>
      figure.evaluate((one) => {
        const canvas = one.querySelector(".u-wrap canvas"),
          { colour } = JSON.parse(one.dataset.clip).curve;
        const pen = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d");
        pen.drawImage(canvas, 0, 0);
        const { data } = pen.getImageData(0, 0, canvas.width, canvas.height);
        const wanted = [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));
        return data.filter((_, i) => i % 4 === 0 && wanted.every((c, k) => Math.abs(data[i + k] - c) < 8)).length;
      });
    const draw = async (curve, part = 1) => {
      const box = await plot.boundingBox();
      const at = (i) => [
        box.x + (box.width * part * i) / 100,
        box.y + box.height * (1 - (curve((seconds * part * i) / 100) - from) / (to - from)),
      ];
      const touch = (type, ...points) =>
        finger.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y]) => ({ x, y })) });
      if (finger) await touch("touchStart", at(0));
      else await page.mouse.move(...at(0)).then(() => page.mouse.down());
      for (let i = 1; i <= 100; ++i) await (finger ? touch("touchMove", at(i)) : page.mouse.move(...at(i)));
      await (finger ? touch("touchEnd") : page.mouse.up());
    };
    const verdict = async () => {
      await figure.getByRole("button", { name: "Play" }).click();
      await page.waitForFunction((one) => /✓|✗|No verdict/.test(one.textContent), await figure.elementHandle());
      return told();
    };
    assert.match(
      await told(),
      /^Draw it from the left edge to the right edge\. A curve within [\d.]+\s\S+, or [\d.]+\ss early or late, is right\./,
    );
    await draw(wrong, 0.4);
    assert.match(await told(), /^Draw it from the left/);
    assert.match(await verdict(), /^No verdict/);
    await draw(wrong);
    assert.equal(await truth(), 0, "nothing of the truth is seen while somebody draws");
    assert.match(await told(), /^Now play/);
    const [, amount] = /^Your curve is up to ([\d.]+).*✗ Wrong: up to/.exec(await verdict());
    assert.ok(Number(amount) >= off[0] && Number(amount) <= off[1], amount);
    assert.ok((await truth()) > 100, "the truth is drawn");
    await draw(right);
    assert.match(await verdict(), /✓ Right/);
    assert.deepEqual(page.wrong, []);
    await page.close();
  });
