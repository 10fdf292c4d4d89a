/// Every page of the book, as a reader gets it: its links, on a telephone, by the rules of accessibility, found by the search.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { gzipSync } from "node:zlib";
import axe from "axe-core";
import { home } from "../../tools/book/experiments.js";
import { serve } from "../../tools/book/serve.js";
import { address, all, folder, html, isSource, launch, newPage, onAll } from "./support/browser.mjs";

const pages = all();
const sources = pages.filter(isSource).slice(0, 3);
const read = [...pages.filter((page) => !isSource(page)), ...sources];
const chapter = "chapters/03_baumgarte/index.html";
let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

test("the whole book is below 25 MB", () => {
  const files = fs.readdirSync(folder, { recursive: true }).map((name) => fs.statSync(path.join(folder, name)));
  const bytes = files.reduce((sum, file) => sum + (file.isFile() ? file.size : 0), 0);
  console.log(`${(bytes / 1e6).toFixed(1)} MB, ${pages.length} pages`);
  assert.ok(bytes < 25e6, `${bytes} bytes`);
});

test("every link and every picture of every page, sources among them, is there, with its anchor", () => {
  const idsOf = (page) => new Set([...html(page).matchAll(/<[a-z][^<>]* id="?([^\s">]*)/g)].map(([, id]) => id));
  const ids = new Map(pages.map((page) => [page, idsOf(page)]));
  const wrong = [];
  let count = 0;
  for (const page of pages) {
    for (const [, target] of html(page).matchAll(/<[a-z][^<>]* (?:href|src|data-film)="([^"]*)"/g)) {
      if (/^(https?|mailto|data):/.test(target)) continue;
      const [name, anchor] = decodeURIComponent(target.replaceAll("&amp;", "&")).split("#");
      const file = name ? path.posix.join(path.posix.dirname(page), name) : page;
      const there = fs.statSync(path.join(folder, file), { throwIfNoEntry: false })?.isFile();
      const state = /^live=(\w+)/.exec(anchor ?? "");
      ++count;
      if (path.posix.isAbsolute(name) || !there) wrong.push(`${page}: ${target}`);
      else if (state && !html(file).includes(`data-chapter="${state[1]}"`))
        wrong.push(`${page}: ${target}: not played`);
      else if (anchor && !state && !ids.get(file)?.has(anchor)) wrong.push(`${page}: ${target}: no such anchor`);
    }
  }
  assert.deepEqual(wrong, []);
  assert.ok(count > 10000, `only ${count} links`);
});

/// The bytes that a server sends for a file: texts compressed.
function weight(file) {
  const bytes = fs.readFileSync(file);
  return /\.(html|css|js|svg)$/.test(file) ? gzipSync(bytes).length : bytes.length;
}

test("from a folder, 360 pixels wide: nothing fails, nothing is wider than the page, pictures are there and told, all in 1.5 MB", async () => {
  const weights = [];
  await onAll(browser, read, { viewport: { width: 360, height: 740 } }, async (page, name) => {
    const files = new Set();
    const note = (request) => files.add(decodeURIComponent(new URL(request.url()).pathname));
    page.on("request", note);
    await page.goto(address(name));
    const seen = await page.evaluate(async () => {
      const pictures = [...document.images];
      for (const picture of pictures) picture.loading = "eager";
      await Promise.all(pictures.map((picture) => picture.decode().catch(() => {})));
      await document.fonts.ready;
      return {
        wide: document.documentElement.scrollWidth,
        without: pictures.filter((picture) => !picture.alt.trim()).map((picture) => picture.src),
        missing: pictures.filter((picture) => picture.naturalWidth === 0).map((picture) => picture.src),
        titles: document.querySelectorAll("h1").length,
        folded: document.querySelectorAll("details[open]").length,
      };
    });
    page.off("request", note);
    assert.deepEqual(page.wrong, [], name);
    assert.deepEqual(seen, { wide: 360, without: [], missing: [], titles: 1, folded: 0 }, name);
    weights.push({
      name,
      kB: Math.round([...files].reduce((sum, file) => sum + weight(file), 0) / 1000),
    });
  });
  const [heaviest] = weights.filter(({ name }) => name !== "gallery.html").sort((a, b) => b.kB - a.kB); // the gallery loads what is seen
  console.log(`the heaviest: ${heaviest.name}, ${heaviest.kB} kB`);
  assert.ok(heaviest.kB < 1500, heaviest.name);
});

test("the front page is for a reader: the trunk leads on, and how to install is elsewhere", async () => {
  const page = await newPage(browser);
  await page.goto(address("index.html"));
  const words = await page.locator("article").innerText();
  assert.doesNotMatch(words, /\.\/course (book|render|test)\b|in the book|\bbelow\b/i);
  assert.doesNotMatch(words, /github/i);
  const before = await page.$$eval("article p:has(~ h2#the-trunk) a", (links) =>
    links.map((link) => link.getAttribute("href")),
  );
  for (const target of [
    "docs/before_you_start.html",
    "docs/other_systems.html",
    "chapters/00_naive_impulses/index.html",
  ])
    assert.ok(before.includes(target), target);
  assert.equal(await page.locator("a[rel=next]").getAttribute("href"), "./docs/before_you_start.html");
  await page.goto(address("docs/other_systems.html"));
  assert.match(await page.locator("article").innerText(), /\.\/course render/);
  await page.close();
});

test("the contents show where the reader is, in the trunk or in a branch, on a telephone, too", async () => {
  for (const viewport of [
    { width: 1280, height: 800 },
    { width: 390, height: 844 },
  ]) {
    const page = await newPage(browser, { viewport });
    for (const [file, heading] of [
      ["11_substeps", "The trunk"],
      ["16_whole_problem", "Branches of 21"],
    ]) {
      await page.goto(address(`chapters/${file}/index.html`));
      if (viewport.width < 1000) await page.click("button.menu");
      const here = page.locator("nav.course [aria-current]");
      await here.waitFor();
      const seen = await here.evaluate((link) => {
        const heading = link.closest("nav > ul").previousElementSibling;
        const inView = (element) => {
          const { top, bottom } = element.getBoundingClientRect();
          return (
            top >= 0 && bottom <= innerHeight && element.contains(document.elementFromPoint(60, (top + bottom) / 2))
          );
        };
        const background = (element) => getComputedStyle(element).backgroundColor;
        const other = document.querySelector("nav.course li a:not([aria-current])");
        return {
          heading: heading.textContent,
          seen: inView(heading) && inView(link),
          marked: background(link) !== background(other),
          trunk: link.closest("ul.trunk") !== null,
        };
      });
      assert.deepEqual(seen, { heading, seen: true, marked: true, trunk: heading === "The trunk" }, file);
      // by the keyboard: what has the focus is not hidden by a heading that stays in view
      await here.focus();
      for (let i = 0; i < 8; ++i) {
        await page.keyboard.press("Shift+Tab");
        const free = await page.evaluate(() => {
          const { left, top, bottom } = document.activeElement.getBoundingClientRect();
          return document.activeElement.contains(document.elementFromPoint(left + 40, (top + bottom) / 2));
        });
        assert.ok(free, `${file}: ${i}`);
      }
    }
    await page.close();
  }
});

test("accessible by the rules of WCAG 2 AA, light and dark", async () => {
  const rules = {
    light: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa"],
    dark: ["color-contrast"],
  };
  const kinds = ["index.html", chapter, "docs/hard_cases.html", "renders/hard_cases/table.html", "gallery.html"];
  for (const colorScheme of ["light", "dark"]) {
    await onAll(browser, [...kinds, sources[0]], { colorScheme }, async (page, name) => {
      await page.goto(address(name));
      await page.evaluate(() => document.querySelectorAll("details").forEach((details) => (details.open = true)));
      await page.addScriptTag({ content: axe.source });
      const { violations } = await page.evaluate((runOnly) => axe.run({ runOnly }), rules[colorScheme]);
      const told = violations.map(
        ({ id, nodes }) => `${id}: ${nodes[0].html.slice(0, 120)} ${nodes[0].failureSummary}`,
      );
      assert.deepEqual(told, [], `${name}, ${colorScheme}`);
    });
  }
});

test("the search finds words, their forms and letters of formulas, and leads there by the keyboard", async () => {
  const page = await newPage(browser);
  await page.goto(address(chapter));
  for (const [question, file] of [
    ["slop", "04_slop/index.html"],
    ["β", "03_baumgarte/index.html"],
    ["why does my stack fall", "docs/symptoms.html"],
    ["sinking", "docs/symptoms.html"],
    ["heavy box qqqq", "17_direct_contacts/index.html"], // no page has all of these words
  ]) {
    await page.locator("main").focus();
    await page.keyboard.press("/");
    await page.fill("#search", question);
    await page.waitForFunction(
      (wanted) => [...document.querySelectorAll(".found li a")].slice(0, 10).some(({ href }) => href.includes(wanted)),
      file,
      { timeout: 20000 },
    );
  }
  for (const [question, file] of [
    ["tunnelling", "25_moment_of_impact/index.html"],
    ["jitter", "04_slop/index.html"],
    ["bouncing", "05_restitution/index.html"],
  ]) {
    await page.fill("#search", question);
    await page.waitForFunction(
      (wanted) => [...document.querySelectorAll(".found li a")].slice(0, 2).some(({ href }) => href.includes(wanted)),
      file,
      { timeout: 20000 },
    );
  }
  await page.fill("#search", "qqqq");
  await page.getByText("Nothing was found for “qqqq”.").waitFor();
  await page.keyboard.press("Escape");
  assert.equal(await page.isVisible(".found"), false);
  await page.fill("#search", "painlevé rod");
  await page.waitForFunction(() => document.querySelector(".found li a")?.textContent.includes("ainlev"));
  const first = await page.$eval(".found li a", (link) => link.href);
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("Enter");
  await page.waitForURL(first);
  assert.deepEqual(page.wrong, []);
  await page.close();
});

test("an address that is none, in any folder of a host: a page in the book's looks, whose links lead back", async () => {
  const server = await serve(folder);
  const host = `http://127.0.0.1:${server.address().port}/`;
  const page = await newPage(browser);
  for (const away of ["nosuch.html", "chapters/99_none/index.html", "docs/figures/nosuch/a.html?b#c"]) {
    const response = await page.goto(host + away);
    assert.equal(response.status(), 404);
    assert.equal(await page.locator("h1").innerText(), "There is no such page");
    await page.locator("article a").first().click();
    await page.waitForURL(`${host}index.html`);
  }
  await page.close();
  server.closeAllConnections();
  server.close();
});

test("dark as the system has it, or as the switch says, on the next page, too", async () => {
  const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const page = await newPage(browser, { colorScheme: "light" });
  await page.goto(address(chapter));
  const light = await paper();
  await page.emulateMedia({ colorScheme: "dark" });
  assert.notEqual(await paper(), light);
  await page.click("button.theme");
  assert.equal(await paper(), light);
  await page.goto(address("gallery.html"));
  assert.equal(await paper(), light);
  await page.close();
});

test("on a telephone the contents open and close by the keyboard; without scripts contents and formulas are there", async () => {
  const viewport = { width: 360, height: 740 };
  const page = await newPage(browser, { viewport });
  await page.goto(address(chapter));
  assert.equal(await page.isVisible("nav.course"), false);
  await page.keyboard.press("Tab");
  assert.equal(await page.evaluate(() => document.activeElement.className), "skip");
  await page.keyboard.press("Tab");
  await page.keyboard.press("Enter");
  assert.equal(await page.isVisible("nav.course"), true);
  await page.keyboard.press("Escape");
  await page.waitForSelector("nav.course", { state: "hidden" });
  await page.close();
  const plain = await newPage(browser, { javaScriptEnabled: false, viewport });
  await plain.goto(address(chapter));
  for (const part of ["nav.course a[aria-current]", "article .katex"]) assert.ok(await plain.isVisible(part), part);
  assert.equal(await plain.isVisible("#search"), false);
  await plain.close();
});

test("on a telephone what scrolls fades where there is more, a first column stays, a tap enlarges a sheet in its place", async () => {
  const page = await newPage(browser, {
    viewport: { width: 390, height: 844 },
  });
  await page.goto(address("renders/hard_cases/table.html"));
  const table = page.locator(".table").first();
  const seen = () =>
    table.evaluate((one) => ({
      fades: getComputedStyle(one).maskImage !== "none" && one.className.split(" ").slice(1).join(" "),
      first: one.querySelector("tr:nth-child(5) > :first-child").getBoundingClientRect().left,
      second: one.querySelector("tr:nth-child(5) > :nth-child(2)").getBoundingClientRect().left,
    }));
  const before = await seen();
  assert.equal(before.fades, "more-right");
  await table.evaluate((one) => one.scrollTo(1e4, 0));
  await page.waitForFunction(() => !document.querySelector(".table").matches(".more-right"));
  const after = await seen();
  assert.equal(after.first, before.first);
  assert.ok(after.second < after.first);
  await page.goto(address("chapters/07_warm_start/index.html"));
  await page.waitForSelector(".formula.more-right");
  const sheet = page.locator("figure.sheet img").first();
  const width = () => sheet.evaluate((picture) => picture.clientWidth);
  for (const [least, most] of [
    [900, 1100],
    [300, 390],
  ]) {
    await sheet.click();
    assert.ok((await width()) > least && (await width()) < most);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  }
  await page.close();
});

test("in a book that is still, the film stands still until it is asked for; a link into what is folded opens it", async () => {
  const stillBook = fs.mkdtempSync(path.join(os.tmpdir(), "book-"));
  spawnSync(process.execPath, [path.join(home, "tools/book/build.js"), "--still", "--out", stillBook]);
  const page = await newPage(browser);
  await page.goto(`file://${stillBook}/index.html`);
  const shown = () => page.getAttribute("figure.film img", "src");
  const still = await shown();
  await page.click("button.play");
  assert.match(await shown(), /film\.webp$/);
  await page.click("button.play");
  assert.equal(await shown(), still);
  fs.rmSync(stillBook, { recursive: true });
  await page.goto(address(chapter));
  await page.evaluate(() => {
    document.querySelector("details").lastElementChild.id = "deep-inside";
    location.hash = "deep-inside";
  });
  await page.waitForSelector("details[open]");
  await page.close();
});
