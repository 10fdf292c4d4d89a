/// One step's problem, solved iteration by iteration on the pages whose chapters have one: what its controls do is read off the
/// impulses and residuals of the chapter's program.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { chapters, engineOf, launch, newPage, pageOf } from "./support/live.mjs";

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const withProblems = [];
for (const chapter of chapters()) if ((await engineOf(chapter)).description.problems.length) withProblems.push(chapter);
const without = chapters().find((chapter) => !withProblems.includes(chapter));

/// A page whose experiment runs, as `player` there.
async function running(address, options = {}) {
  const page = await newPage(browser, { reducedMotion: "reduce", ...options });
  page.setDefaultTimeout(120000);
  await page.goto(address);
  await page.evaluate(async () => {
    window.player = await window.PUSHBACK_LIVE_TEST.start();
  });
  await arrived(page, 0);
  return page;
}
const arrived = (page, iteration) =>
  page.waitForFunction(
    (k) => !player.iterations.element.inert && player.engine.iteration === k && player.iterations.drawn === k,
    iteration,
  );
const goTo = async (page, iteration) => {
  await page.evaluate((k) => player.iterations.go(k), iteration);
  await arrived(page, iteration);
};
/// Of each method, to the last bit.
const impulses = (page) =>
  page.evaluate(() => player.engine.problem.methods.map((_, i) => Array.from(player.engine.impulses(i))));
const press = (page, name) => page.getByRole("button", { name, exact: true }).click();

test("the chapters on whole problems have one, the others have none", async () => {
  assert.deepEqual(
    withProblems,
    ["16_whole_problem", "17_direct_contacts", "18_direct_joints"].filter((one) => chapters().includes(one)),
  );
  if (!without) return;
  const page = await newPage(browser, { reducedMotion: "reduce" });
  await page.goto(pageOf(without));
  await page.evaluate(() => window.PUSHBACK_LIVE_TEST.start());
  assert.ok(await page.locator(".pb-iterations").isHidden());
  assert.deepEqual(page.wrong, []);
  await page.close();
});

for (const chapter of withProblems) {
  test(`${chapter}: what is left falls, an iteration back has the same bits, the matrix is drawn`, async () => {
    const page = await running(pageOf(chapter));
    const problems = await page.evaluate(() => player.engine.description.problems.length);
    for (let which = 0; which < problems; ++which) {
      await page.getByRole("combobox", { name: "Problem" }).selectOption({ index: which });
      await arrived(page, 0);
      const nothing = await impulses(page);
      assert.ok(nothing.flat().every((value) => value === 0));
      await press(page, "One iteration on");
      await arrived(page, 1);
      const one = await impulses(page);
      assert.notDeepEqual(one, nothing);
      await press(page, "One iteration on");
      await arrived(page, 2);
      await press(page, "One iteration back");
      await arrived(page, 1);
      assert.deepEqual(await impulses(page), one);
      await goTo(page, 40);
      const forty = await impulses(page);
      await goTo(page, 1000);
      await goTo(page, 1);
      assert.deepEqual(await impulses(page), one);
      await goTo(page, 40);
      assert.deepEqual(await impulses(page), forty);
      const residuals = await page.evaluate(() =>
        player.engine.problem.methods.map((_, i) => Array.from(player.engine.residuals(i))),
      );
      for (const all of residuals) {
        assert.ok(Math.abs(all[0] - 1) < 0.2, `${all[0]} of no impulse`);
        assert.ok(all[all.length - 1] < 0.5 * all[0], `${all[all.length - 1]} after ${all.length - 1}`);
      }
      const cells = page.locator(".pb-iterations tbody td");
      const told = await cells.allTextContents();
      residuals.forEach((all, i) => {
        const last = Math.min(40, all.length - 1);
        assert.ok(Math.abs(parseFloat(told[i]) / all[last] - 1) < 0.06, `${told[i]}, not ${all[last]}`);
        assert.equal(told[i].includes("at its end"), last < 40);
      });
      const matrix = await page.evaluate(() => {
        const { picture } = player.iterations,
          { rows } = player.engine.problem,
          numbers = player.engine.matrix;
        const { width, height } = picture.canvas,
          copy = Object.assign(document.createElement("canvas"), { width, height }).getContext("2d");
        copy.drawImage(picture.canvas, 0, 0);
        const pixels = copy.getImageData(0, 0, width, height).data;
        let largest = 0,
          wrong = 0;
        for (let i = 2; i < numbers.length; i += 3) largest = Math.max(largest, Math.abs(numbers[i]));
        for (let i = 0; i < numbers.length; i += 3) {
          const [row, column, value] = [numbers[i], numbers[i + 1], numbers[i + 2]];
          if (Math.abs(value) < 1e-3 * largest) continue;
          const at = (index) => Math.floor((index + 0.5) * picture.cell);
          const from = 4 * ((picture.head + at(row)) * width + picture.left + at(column));
          const framed = picture.lens.hidden ? false : row <= 24 && column <= 24; // the lens's frame crosses them
          if (!framed && value > 0 !== pixels[from + 2] > pixels[from]) ++wrong;
        }
        return { wrong, rows, alt: picture.canvas.getAttribute("aria-label") };
      });
      assert.equal(matrix.wrong, 0, "cells of the other colour");
      assert.match(matrix.alt, new RegExp(`^The matrix of ${matrix.rows} rows and columns, 3 for each of`));
    }
    assert.deepEqual(page.wrong, []);
    await page.close();
  });
}

test("slider, play, curve, parameters, address", { skip: !withProblems.includes("16_whole_problem") }, async () => {
  const page = await running(pageOf("16_whole_problem"));
  const slider = page.getByRole("slider", { name: "Iteration", exact: true });
  await slider.fill("7");
  await arrived(page, 7);
  await press(page, "Play the iterations");
  await page.waitForFunction(() => player.engine.iteration > 9);
  await press(page, "Pause the iterations");
  assert.ok(await page.evaluate(() => !player.iterations.playing));
  const over = page.locator(".pb-iterations .u-over"),
    box = await over.boundingBox();
  await over.click({ position: { x: box.width / 3, y: box.height / 2 } }); // the axis goes from 1 to 1000 by equal factors
  await arrived(page, 10);
  const twenty = await page.evaluate(() => player.engine.problem.rows);
  const boxes = page.getByRole("spinbutton", { name: "Boxes of the stack, as a number" });
  await boxes.fill("10");
  await boxes.press("Enter");
  await page.waitForFunction((rows) => player.engine.problem.rows !== rows, twenty);
  await arrived(page, 10);
  assert.equal(await page.evaluate(() => player.engine.problem.rows), twenty / 2);
  await page.getByRole("combobox", { name: "Problem" }).selectOption({ index: 1 });
  await goTo(page, 33);
  const seen = await impulses(page);
  await page.waitForFunction(() => /problem=1&iteration=33/.test(location.hash));
  const address = page.url();
  assert.deepEqual(page.wrong, []);
  await page.close();
  const again = await newPage(browser, { reducedMotion: "reduce" });
  await again.goto(address);
  await again.waitForFunction(() => (window.player = window.PUSHBACK_LIVE_TEST.player()));
  await arrived(again, 33);
  assert.deepEqual(await impulses(again), seen);
  await again.goto(`${address.split("#")[0]}#live=16_whole_problem&problem=7&iteration=-2`);
  await again.reload();
  await again.waitForFunction(() => (window.player = window.PUSHBACK_LIVE_TEST.player()));
  await arrived(again, 0);
  assert.equal(await again.evaluate(() => player.iterations.which), 0);
  assert.deepEqual(again.wrong, []);
  await again.close();
});

test("a number of the matrix is read, and the part around it enlarged; 360 pixels suffice", async () => {
  const page = await running(pageOf(withProblems[0]), { viewport: { width: 360, height: 740 } });
  await page.locator(".pb-matrix").scrollIntoViewIfNeeded();
  const box = await page.locator(".pb-matrix").boundingBox();
  await page.mouse.move(box.x + 0.3 * box.width, box.y + 0.4 * box.height);
  const [read, known] = await page.evaluate(() => {
    const { picture } = player.iterations;
    return [picture.read.textContent, picture.corner];
  });
  assert.match(read, /^contact \d+, row [123], by an impulse on contact \d+, row [123]: -?[\d.e-]+ \/kg$/);
  assert.ok(
    known.every((at) => at > 0 && at % 3 === 0),
    String(known),
  );
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 360);
  assert.deepEqual(page.wrong, []);
  await page.close();
});
