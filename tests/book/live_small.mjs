/// The small pictures beside sentences: each is played, and its slider moved from end to end, first in node and then on its page. What
/// the sentence says is what the picture shows.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import { readBook } from "../../tools/book/book.js";
import { clipOf, markIn } from "../../tools/book/small.js";
import { address, html } from "./support/browser.mjs";
import { chapters, engineOf, launch, newPage, root } from "./support/live.mjs";

const first = chapters().filter((name) => /^(0\d|1[0-2])_/.test(name));
const pageOf = (chapter) => `chapters/${chapter}/index.html`;
let browser;
before(async () => (browser = await launch()));
after(() => browser.close()); // with all its pages

/// Of a page's text: each mark, and what stands above it as far as an empty line.
function marksOf(chapter) {
  const lines = fs.readFileSync(path.join(root, "chapters", chapter, "README.md"), "utf8").split("\n");
  return lines.flatMap((line, i) => {
    const mark = markIn(line);
    const begin = lines.lastIndexOf("", i) + 1;
    return mark ? [{ mark, line: i + 1, above: lines.slice(begin, i).join(" ") }] : [];
  });
}

function played(engine, clip, value) {
  const own = clip.slider ? [`${clip.slider.flag}=${value}`] : [];
  assert.equal(engine.set([clip.assignments, ...own].filter(Boolean).join(";")), "", `${clip.words}, ${own}`);
  engine.choose(clip.scene, clip.places);
  const steps = Math.min(engine.steps, Math.round(clip.seconds / engine.dt));
  assert.ok(steps > 0, clip.words);
  while (engine.now < steps) engine.goTo(steps, 1000);
  const { lanes } = engine;
  for (const { lane } of lanes) assert.equal(engine.mishap(lane), "", `${clip.words}, ${own}`);
  const numbers = clip.number ? lanes.map(({ lane }) => engine.number(lane, clip.number.which)[0]) : [];
  for (const number of numbers) assert.match(number, /\d/, `${clip.words}, ${own}: ${number}`);
  return { numbers, state: lanes.map(({ lane }) => engine.hash(lane)).join() };
}

test("there are three at least in each of the first chapters", () => {
  assert.ok(first.length, "no chapter is compiled");
  for (const chapter of first) assert.ok(marksOf(chapter).length >= 3, chapter);
});

test("each can be played at the ends of its slider, which change it, and shows the number that its sentence says", async () => {
  for (const chapter of first) {
    const engine = await engineOf(chapter);
    for (const { mark, line, above } of marksOf(chapter)) {
      const where = `${chapter}/README.md:${line}`;
      const clip = clipOf(mark, engine);
      const { slider, says } = clip;
      const { numbers } = played(engine, clip, slider?.value);
      if (says) {
        assert.equal(numbers[0].replaceAll(" ", ""), says.replaceAll(" ", ""), where);
        assert.ok(above.includes(says), `${where}: ${says} does not stand above it`);
      }
      if (slider) {
        const [low, high] = [slider.from, slider.from + slider.notches * slider.step].map((value) =>
          played(engine, clip, value),
        );
        assert.notEqual(low.state, high.state, `${where}: its slider changes nothing`);
      }
    }
  }
});

test("what does not exist is refused, with the line", async () => {
  const engine = await engineOf("03_baumgarte");
  const refused = (text, why) => assert.throws(() => clipOf(markIn(`<!-- live: ${text} -->`), engine), why);
  refused('scene="no-such" values="beta=1"', /there is no scene no-such; there are gravity, /);
  refused('scene="gravity" values="beta=1" variants="β = 2"', /there is no variant β = 2; there are β = 1$/);
  refused('scene="gravity" values="nosuch=1"', /nosuch/);
  refused('scene="gravity" values="beta=x"', /beta=x is no number/);
  refused('scene="gravity" values="beta=3"', /--beta/);
  refused('scene="gravity" values="beta=1" slider="nosuch"', /there is no parameter nosuch/);
  refused('scene="gravity" slider="beta"', /do not say what beta is at first/);
  refused('scene="gravity" values="beta=1" slider="beta" to="9"', /beta goes from 0 to 2/);
  refused('scene="gravity" values="beta=1" slider="beta" step="0.3"', /does not come to 1/);
  refused('scene="gravity" values="beta=1" number="nosuch"', /there is no number nosuch; there are highest jump, /);
  refused('scene="gravity" values="beta=1" says="631 mm"', /it says a number, and shows none/);
  refused('scene="gravity" values="beta=1" colour="red"', /nothing is called colour/);
  refused('scene="gravity" beta=1', /it has the form name="value": beta=1/);
  refused(
    'scene="an-equality-row-follows-d-1-beta" values="beta=0.2" slider="beta"',
    /where beta is 0, there is no such scene/,
  );
  assert.equal(markIn("<!-- numbers.md -->"), null);
  const text = fs.readFileSync(path.join(root, "chapters/03_baumgarte/README.md"), "utf8");
  assert.ok(text.includes("<!-- live: "));
  assert.doesNotMatch(html("chapters/03_baumgarte/index.html"), /<!-- live: /);
  const still = readBook(root).pages.find(({ chapter }) => chapter === "03_baumgarte"); // without experiments
  assert.doesNotMatch(still.html, /small-live|<!-- live: /);
});

/// On the page: the picture of a figure, as text that differs where the pictures do; and how many colours it has.
const seen = (figure) =>
  figure.evaluate((element) => {
    const { width, height } = element.querySelector("canvas");
    const copy = Object.assign(document.createElement("canvas"), { width, height });
    const pen = copy.getContext("2d", { willReadFrequently: true });
    pen.drawImage(element.querySelector("canvas"), 0, 0);
    const { data } = pen.getImageData(0, 0, width, height);
    const colours = new Set();
    let sum = 0;
    for (let i = 0; i < data.length; i += 4) {
      colours.add((data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
      sum = (Math.imul(sum, 31) + data[i] + 7 * data[i + 1] + 13 * data[i + 2]) | 0;
    }
    return { sum, colours: colours.size };
  });
const ready = (figure) => figure.locator("button:enabled").waitFor();
const show = async (figure) => {
  await figure.evaluate((element) => {
    for (let at = element; (at = at.parentElement?.closest("details"));) at.open = true;
    element.scrollIntoView({ block: "center" });
  });
  await ready(figure);
};

for (const chapter of first) {
  test(`${chapter}: each is drawn; its slider, by the keyboard, changes what is seen, within 100 ms`, async () => {
    const page = await newPage(browser, { reducedMotion: "reduce" });
    page.setDefaultTimeout(60000);
    await page.goto(address(pageOf(chapter)));
    const figures = await page.locator("figure.small-live").all();
    assert.ok(figures.length >= 3);
    for (const figure of figures) {
      await show(figure);
      const words = await figure.locator("figcaption").innerText();
      const start = await seen(figure);
      assert.ok(start.colours > 20, `${words}: only ${start.colours} colours`);
      assert.equal(await figure.evaluate((element) => element.classList.contains("playing")), false, words);
      const slider = figure.getByRole("slider");
      if (!(await slider.count())) continue;
      const ends = [];
      for (const key of ["Home", "End"]) {
        await slider.focus();
        const ms = await slider.evaluate((input, to) => {
          input.value = to === "End" ? input.max : input.min;
          const began = performance.now();
          input.dispatchEvent(new Event("input", { bubbles: true }));
          return performance.now() - began; // drawn in there
        }, key);
        assert.ok(ms < 100, `${words}: ${ms.toFixed(0)} ms`);
        await figure.evaluate(async (element) => {
          const picture = (await window.PUSHBACK_LIVE_TEST.small).find((one) => one.figure === element);
          while (picture.drawn !== picture.step) await new Promise(requestAnimationFrame);
        });
        ends.push(await seen(figure));
        const text = await figure.innerText();
        assert.doesNotMatch(text, /nan|undefined/i);
        assert.equal(await slider.getAttribute("aria-valuetext"), await figure.locator("label output").innerText());
      }
      assert.notEqual(ends[0].sum, ends[1].sum, `${words}: its slider changes nothing that is seen`);
    }
    assert.deepEqual(page.wrong, []);
    await page.close();
  });
}

test("one plays by itself when it is first seen, stops at its end, pauses out of sight, and begins again when asked", async () => {
  const page = await newPage(browser);
  page.setDefaultTimeout(60000);
  await page.goto(address(pageOf("03_baumgarte")));
  const figure = page.locator("figure.small-live").first();
  const playing = (yes) => figure.and(page.locator(yes ? ".playing" : ":not(.playing)")).waitFor();
  const step = () => page.evaluate(async () => (await window.PUSHBACK_LIVE_TEST.small)[0].drawn);
  await show(figure);
  await playing(true);
  await page.evaluate(() => scrollTo(0, 0));
  await playing(false);
  const left = await step();
  await page.waitForTimeout(300);
  assert.equal(await step(), left);
  await show(figure);
  await playing(true);
  await playing(false);
  assert.equal(await step(), 24);
  assert.match(await figure.innerText(), /highest jump: 631 mm/);
  await page.waitForTimeout(300);
  await playing(false);
  const button = figure.getByRole("button", { name: /^Play: / });
  await button.focus();
  await page.keyboard.press("Space");
  await playing(true);
  await figure.getByRole("button", { name: /^Pause: / }).press("Enter");
  await playing(false);
  const playingNow = page.locator("figure.small-live.playing");
  await page.locator("figure.small-live").nth(3).getByRole("button").press("Enter");
  assert.equal(await playingNow.count(), 1);
  assert.deepEqual(page.wrong, []);
  await page.close();
});

test("it stands beside its sentence, and below it on a telephone; without JavaScript there is none", async () => {
  const places = async (options) => {
    const page = await newPage(browser, options);
    await page.goto(address(pageOf("03_baumgarte")));
    const seen = await page.evaluate(() => {
      const [figure, text] = document.querySelector(".at-sentence").children;
      const [a, b] = [figure.getBoundingClientRect(), text.getBoundingClientRect()];
      return { width: a.width, beside: a.top < b.bottom && a.left > b.left + 200, below: a.top >= b.bottom };
    });
    await page.close();
    return seen;
  };
  const wide = await places({ viewport: { width: 1280, height: 800 } });
  assert.ok(wide.beside && !wide.below);
  const narrow = await places({ viewport: { width: 360, height: 740 } });
  assert.ok(narrow.below && narrow.width > 300);
  assert.equal((await places({ javaScriptEnabled: false })).width, 0);
});
