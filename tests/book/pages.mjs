/// Every page of the book, as a reader gets it: from a folder and from a server, on a telephone, in the dark, on paper.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import { serve } from "../../tools/book/serve.js";
import { address, folder, html, isSource, launch, newPage, onAll, pagesIn, weight } from "./support/browser.mjs";

const all = pagesIn();
const read = all.filter((page) => !isSource(page));
const sources = all.filter(isSource).slice(0, 3);
const chapter = read.find((page) => page.includes("03_baumgarte/index"));
let browser;

/// In the page: all pictures, those further down, too.
async function loadAll() {
  for (const picture of document.images) picture.loading = "eager";
  await Promise.all([...document.images].map((picture) => picture.decode().catch(() => {})));
  await document.fonts.ready;
}

before(async () => (browser = await launch()));
after(() => browser.close());

test("the whole book is below 30 MB", () => {
  const files = fs.readdirSync(folder, { recursive: true }).map((name) => fs.statSync(path.join(folder, name)));
  const bytes = files.reduce((sum, file) => sum + (file.isFile() ? file.size : 0), 0);
  assert.ok(bytes < 30e6, `${bytes} bytes`);
});

test("every link and every picture of every page, sources among them, is there, with its anchor", () => {
  const ids = new Map(
    all.map((page) => [page, new Set([...html(page).matchAll(/<[a-z][^<>]* id="?([^\s">]*)/g)].map(([, id]) => id))]),
  );
  const wrong = [];
  let count = 0;
  for (const page of all) {
    for (const [, target] of html(page).matchAll(/<[a-z][^<>]* (?:href|src|data-film)="?([^\s">]*)/g)) {
      if (/^(https?|mailto|data):/.test(target)) continue;
      const [name, anchor] = decodeURIComponent(target).split("#");
      const file = name ? path.posix.join(path.posix.dirname(page), name) : page;
      ++count;
      if (
        path.posix.isAbsolute(name) ||
        !fs.existsSync(path.join(folder, file)) ||
        fs.statSync(path.join(folder, file)).isDirectory()
      )
        wrong.push(`${page}: ${target}`);
      else if (anchor?.startsWith("live=")) {
        const [, experiment] = /^live=(\w+)/.exec(anchor);
        if (!html(file).includes(`data-chapter=${experiment} `))
          wrong.push(`${page}: ${target}: it is not played there`);
      } else if (anchor && !ids.get(file)?.has(anchor)) wrong.push(`${page}: ${target}: no such anchor`);
    }
  }
  assert.deepEqual(wrong, []);
  assert.ok(count > 10000, `only ${count} links`);
});

test("from a folder, 360 pixels wide: nothing fails, nothing is wider than the page, formulas and pictures are there, all in 1.5 MB", async () => {
  const weights = [];
  await onAll(browser, [...read, ...sources], { viewport: { width: 360, height: 740 } }, async (page, name) => {
    const files = new Set();
    const note = (request) => files.add(decodeURIComponent(new URL(request.url()).pathname));
    page.on("request", note);
    await page.goto(address(name));
    await page.evaluate(loadAll);
    page.off("request", note);
    weights.push({ name, kB: Math.round([...files].reduce((sum, file) => sum + weight(file), 0) / 1000) });
    const seen = await page.evaluate(() => {
      const pictures = [...document.images];
      const sticksOut = (element) =>
        element.getBoundingClientRect().right > innerWidth && !element.parentElement.closest(".table, pre, .formula");
      const text = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
      const dollars = [];
      while (text.nextNode()) {
        const { data, parentElement } = text.currentNode;
        if (data.includes("$") && !parentElement.closest("code, script, annotation")) dollars.push(data);
      }
      return {
        wide: document.documentElement.scrollWidth,
        wider:
          document.documentElement.scrollWidth <= innerWidth
            ? []
            : [...document.querySelectorAll("body *")].filter(sticksOut).map((e) => e.outerHTML.slice(0, 100)),
        dollars,
        errors: document.querySelectorAll(".katex-error").length,
        without: pictures.filter((picture) => !picture.alt.trim()).map((picture) => picture.src),
        missing: pictures.filter((picture) => picture.naturalWidth === 0).map((picture) => picture.src),
        titles: document.querySelectorAll("h1").length,
        landmarks: ["main", "header", "nav"].every((landmark) => document.querySelector(landmark)),
        folded: document.querySelectorAll("details[open]").length,
      };
    });
    assert.deepEqual(page.wrong, [], name);
    assert.deepEqual(
      seen,
      { wide: 360, wider: [], dollars: [], errors: 0, without: [], missing: [], titles: 1, landmarks: true, folded: 0 },
      name,
    );
  });
  const heaviest = weights.filter(({ name }) => name !== "gallery.html").sort((a, b) => b.kB - a.kB); // the gallery loads what is seen
  console.log(
    heaviest
      .slice(0, 3)
      .map(({ name, kB }) => `${name}: ${kB} kB`)
      .join("; "),
  );
  assert.ok(heaviest[0].kB < 1500, heaviest[0].name);
});

test("from a server: nothing fails", async () => {
  const server = await serve(folder);
  await onAll(browser, [...read, ...sources], {}, async (page, name) => {
    await page.goto(`http://127.0.0.1:${server.address().port}/${name}`);
    assert.deepEqual(page.wrong, [], name);
  });
  server.close();
});

test("the search finds a word in the text, a letter of a formula, and leads there by the keyboard", async () => {
  const page = await newPage(browser);
  await page.goto(address(chapter));
  await page.keyboard.press("/");
  await page.keyboard.type("slop");
  await page.waitForSelector(".found li a");
  const found = await page.$$eval(".found li a", (links) => links.map((a) => a.getAttribute("href")));
  assert.ok(
    found.some((href) => href.includes("04_slop/index.html")),
    found.join(" "),
  );
  await page.fill("#search", "β");
  await page.waitForFunction(() => document.querySelector(".found .count").textContent.includes("places"));
  await page.fill("#search", "painlevé rod");
  await page.waitForFunction(() => document.querySelector(".found li a")?.textContent.includes("ainlev"));
  const first = await page.$eval(".found li a", (link) => link.href);
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("Enter");
  await page.waitForURL(first);
  for (const [question, file] of [
    ["why does my stack fall", "docs/symptoms.html"],
    ["sinking", "docs/symptoms.html"],
    ["XPBD", "docs/methods.html"],
    ["jittering", "04_slop/index.html"],
    ["heavy box qqqq", "17_direct_contacts/index.html"], // no page has all of these words
  ]) {
    await page.fill("#search", question);
    await page.waitForFunction(
      (wanted) => [...document.querySelectorAll(".found li a")].slice(0, 10).some(({ href }) => href.includes(wanted)),
      file,
      { timeout: 10000 },
    );
  }
  await page.fill("#search", "qqqq");
  await page.waitForFunction(() => document.querySelector(".found .count").textContent.includes("Nothing"));
  await page.keyboard.press("Escape");
  assert.equal(await page.isVisible(".found"), false);
  assert.deepEqual(page.wrong, []);
  await page.close();
});

test("an address that is none, in any folder of a host: a page in the book's looks, whose links lead back", async () => {
  const server = await serve(path.dirname(folder)); // the book is a folder of that host
  const home = `http://127.0.0.1:${server.address().port}/${path.basename(folder)}/`;
  const page = await newPage(browser);
  const missing = html("404.html");
  for (const away of ["nosuch.html", "chapters/99_none/index.html", "docs/figures/nosuch/a.html?b#c"]) {
    await page.route(home + away.replace(/#.*/, ""), (route) =>
      route.fulfill({ status: 404, contentType: "text/html; charset=utf-8", body: missing }),
    );
    await page.goto(home + away);
    assert.equal(await page.locator("h1").innerText(), "There is no such page");
    assert.equal(
      await page
        .locator("article a")
        .first()
        .evaluate((link) => link.href),
      `${home}index.html`,
    );
    await page.locator("article a").first().click();
    await page.waitForURL(`${home}index.html`);
  }
  assert.deepEqual(
    page.wrong.filter((text) => !/404/.test(text)),
    [],
  );
  await page.close();
  server.close();
});

test("dark as the system has it, or as the switch says, on the next page, too", async () => {
  const paper = (page) => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const page = await newPage(browser, { colorScheme: "light" });
  await page.goto(address(chapter));
  const light = await paper(page);
  await page.emulateMedia({ colorScheme: "dark" });
  const dark = await paper(page);
  assert.notEqual(light, dark);
  await page.click("button.theme");
  assert.equal(await paper(page), light);
  await page.goto(address("gallery.html"));
  assert.equal(await paper(page), light);
  await page.click("button.theme");
  assert.equal(await paper(page), dark);
  await page.close();
});

test("the contents open and close on a telephone, by the keyboard, too", async () => {
  const page = await newPage(browser, { viewport: { width: 360, height: 740 } });
  await page.goto(address(chapter));
  assert.equal(await page.isVisible("nav.course"), false);
  await page.keyboard.press("Tab");
  assert.equal(await page.evaluate(() => document.activeElement.className), "skip");
  await page.keyboard.press("Tab");
  await page.keyboard.press("Enter");
  assert.equal(await page.isVisible("nav.course"), true);
  assert.equal(await page.getAttribute("button.menu", "aria-expanded"), "true");
  await page.keyboard.press("Escape");
  await page.waitForSelector("nav.course", { state: "hidden" });
  await page.close();
});

test("a link into what is folded opens it; on paper nothing is folded, and every page is there", async () => {
  const page = await newPage(browser);
  await page.goto(address(chapter));
  assert.equal(await page.$$eval("details[open]", (all) => all.length), 0);
  const folded = await page.$$eval("details", (all) => all.length);
  const opened = page.evaluate(
    () =>
      new Promise((resolve) =>
        addEventListener("beforeprint", () =>
          setTimeout(() => resolve(document.querySelectorAll("details[open]").length)),
        ),
      ),
  );
  const paper = await page.pdf({ format: "A4" });
  assert.equal(await opened, folded);
  assert.equal(paper.subarray(0, 5).toString(), "%PDF-");
  assert.equal(await page.$$eval("details[open]", (all) => all.length), 0);
  await page.evaluate(() => {
    document.querySelector("details").lastElementChild.id = "deep-inside";
    location.hash = "deep-inside";
  });
  await page.waitForSelector("details[open]");
  assert.deepEqual(page.wrong, []);
  await page.close();
});

test("the film stands still until it is asked for", async () => {
  const page = await newPage(browser);
  await page.goto(address("index.html"));
  const shown = () => page.getAttribute("figure.film img", "src");
  const still = await shown();
  await page.click("button.play");
  assert.match(await shown(), /film\.webp$/);
  await page.click("button.play");
  assert.equal(await shown(), still);
  await page.close();
});

test("without JavaScript the pages and the contents are there", async () => {
  const page = await newPage(browser, { javaScriptEnabled: false, viewport: { width: 360, height: 740 } });
  await page.goto(address(chapter));
  assert.ok(await page.isVisible("nav.course a[aria-current]"));
  assert.ok(await page.isVisible("article .katex"));
  assert.equal(await page.isVisible("#search"), false);
  await page.close();
});
