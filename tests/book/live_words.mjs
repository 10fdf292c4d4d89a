/// The words and pictures around an experiment: guesses, labels, lines that stay together, and how a page shows pictures of bodies.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { address, all, engineOf, experiments, isSource, launch, onAll } from "./support/browser.mjs";

const chapters = all().filter((page) => /^chapters\/\d\d_[^/]*\/index\.html$/.test(page));
const read = all().filter((page) => !isSource(page));
let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

test("a guess offers pictures or words as choices, never a question; questions stay a numbered list", async () => {
  assert.ok(chapters.length >= 28);
  await onAll(browser, chapters, {}, async (page, name) => {
    await page.goto(address(name));
    const guess = await page.evaluate(() => {
      const lists = [],
        controls = [],
        choices = [];
      const heading = document.getElementById("your-guess");
      for (
        let next = heading.nextElementSibling;
        next && !next.matches("h2, details");
        next = next.nextElementSibling
      ) {
        const offered = [next, ...next.querySelectorAll("*")].filter((one) =>
          one.matches("button, input, option, label"),
        );
        for (const one of offered) (/\?/.test(one.textContent) ? controls : choices).push(one.textContent);
        if (!next.matches("ul, ol")) continue;
        const asked = [...next.children].filter((item) => item.textContent.includes("?")).length;
        lists.push({ numbered: next.matches("ol"), items: next.children.length, asked });
      }
      const answer = [...document.querySelectorAll("summary")].some((one) => one.textContent.trim() === "Answer");
      return { lists, controls, answer };
    });
    assert.ok(guess.answer, `${name}: no answer`);
    assert.deepEqual(guess.controls, [], `${name}: questions are offered as answers`);
    for (const { numbered, items, asked } of guess.lists) {
      assert.ok(asked === 0 || asked === items, `${name}: a list of choices and questions`);
      assert.ok(asked === 0 || numbered, `${name}: the questions have no numbers`);
    }
  });
});

test("labels of parameters have at most eight words", async () => {
  const long = [];
  for (const name of experiments)
    for (const { flag, what } of (await engineOf(name)).parameters)
      if (what.split(/\s+/).length > 8) long.push(`${name} ${flag}: ${what}`);
  assert.deepEqual(long, []);
});

for (const width of [390, 1280])
  test(`${width} pixels wide, no line begins with the punctuation after a formula, nor with the unit of a number`, async () => {
    await onAll(browser, read, { viewport: { width, height: 844 } }, async (page, name) => {
      await page.goto(address(name));
      const parted = await page.evaluate(async () => {
        await document.fonts.ready;
        const words = (node) =>
          !node.parentElement.closest("pre, code, .katex, nav, script, style, details:not([open])");
        const wrong = [];
        const top = (node, at) => {
          const range = document.createRange();
          range.setStart(node, at);
          range.setEnd(node, at + 1);
          return range.getBoundingClientRect();
        };
        for (const details of document.querySelectorAll("article details")) details.open = true;
        const walker = document.createTreeWalker(document.querySelector("article"), NodeFilter.SHOW_TEXT);
        let formula = null; // the rectangle of the one that ends just before
        for (let node = walker.nextNode(); node; node = walker.nextNode()) {
          const inside = node.parentElement.closest(".katex-html");
          if (inside) formula = inside.closest(".formula") ? null : [...inside.querySelectorAll(".base")].at(-1);
          if (!words(node)) continue;
          const text = node.data;
          if (formula && /^[,.;:!?)\]”’]/.test(text) && top(node, 0).top > formula.getBoundingClientRect().bottom - 4)
            wrong.push(`${formula.textContent}${text.slice(0, 20)}`);
          formula = null;
          for (const { index } of text.matchAll(/\d\s(?:[kcmµn]?m|[mµ]?s|kg|k?Hz|k?N|rad|%)(?!\w)/g))
            if (top(node, index + 2).top > top(node, index).top + 8) wrong.push(text.slice(index, index + 8));
        }
        return wrong;
      });
      assert.deepEqual(parted, [], name);
    });
  });

test("in the dark, pictures of bodies are dimmed, not turned round; a sheet that can be run begins where others do", async () => {
  await onAll(browser, chapters, { colorScheme: "dark" }, async (page, name) => {
    await page.goto(address(name));
    const seen = await page.evaluate(() => {
      const pictures = document.querySelectorAll(
        ':is(.sheet, .guess, figure) img[src*="/start"], figure:is(.sheet, .guess) img',
      );
      const turned = [...pictures].filter((one) => getComputedStyle(one).filter.includes("invert"));
      const live = document.querySelector("figure.live.sheet");
      const other = Object.assign(document.createElement("figure"), { className: "sheet" });
      live?.before(other);
      const left = (one) => one?.getBoundingClientRect().left;
      return { turned: turned.map((one) => one.getAttribute("src")), off: live ? left(live) - left(other) : 0 };
    });
    assert.deepEqual(seen, { turned: [], off: 0 }, name);
  });
});
