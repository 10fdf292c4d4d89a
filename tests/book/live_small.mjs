/// Figures that a reader works: a step that is solved row by row, and a guess that is dragged into a small picture.
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
  assert.deepEqual(await labels(), Array(2).fill("Σλ 0 N s\n↓ 1 m/s"));
  const begun = await picture();
  await solve(1);
  assert.deepEqual(await labels(), ["Σλ 0.769 N s\n0 m/s", "Σλ 0 N s\n↓ 0.462 m/s"]);
  assert.notEqual(await picture(), begun, "the arrow grows");
  await solve(1);
  assert.deepEqual(await labels(), ["Σλ 0.769 N s\n↑ 0.249 m/s", "Σλ 0.355 N s\n0 m/s"]);
  await solve(1);
  assert.equal(await said(), "Sweep 2: the impulse goes from 0.769 to 0.578 N s, a correction of −0.191 N\u00a0s.");
  await figure.getByRole("radio", { name: "each correction" }).check();
  assert.equal(await said(), "Sweep 2: the impulse goes from 0.769 to 0.769 N s, a correction of 0 N\u00a0s.");
  assert.deepEqual(page.wrong, []);
  await page.close();
});

test("row by row, a bound of friction grows with its normal impulse, and a warm start has the load before the first row", async () => {
  const rubbing = await rowsOf("06_friction");
  await rubbing.solve(7);
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
    const next = opened.locator("figure.small-live").nth(1);
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
