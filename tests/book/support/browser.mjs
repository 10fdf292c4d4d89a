/// The book in a browser: Debian's Chromium, driven by playwright-core.
import fs from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { chromium } from "playwright-core";

export const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../../..");
export const folder = path.join(root, "build/book");
export const address = (page) => `file://${folder}/${page}`;

/// All pages of the built book, sources among them, as seen from its folder.
export function pagesIn(at = "") {
  return fs.readdirSync(path.join(folder, at), { withFileTypes: true }).flatMap((entry) => {
    const name = path.posix.join(at, entry.name);
    if (entry.isDirectory()) return pagesIn(name);
    return name.endsWith(".html") ? [name] : [];
  });
}

export const html = (page) => fs.readFileSync(path.join(folder, page), "utf8");
export const isSource = (page) => html(page).includes('<body class="source">');

/// The bytes that a server sends for a file: texts compressed.
export function weight(file) {
  const bytes = fs.readFileSync(file);
  return /\.(html|css|js|svg)$/.test(file) ? gzipSync(bytes).length : bytes.length;
}

/// Without a GPU, nor one in software, unless `args` ask for it: pages of text are drawn faster so.
export function launch(args = ["--disable-gpu", "--disable-software-rasterizer"]) {
  return chromium.launch({
    executablePath: process.env.PUSHBACK_CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox", ...args],
  });
}

/// A page that keeps what went wrong on it: `page.wrong`.
export async function newPage(browser, options = {}) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 }, ...options });
  page.setDefaultTimeout(120000); // for a machine that has much else to do
  page.wrong = [];
  page.on("console", (message) => ["error", "warning"].includes(message.type()) && page.wrong.push(message.text()));
  page.on("pageerror", (error) => page.wrong.push(error.message));
  page.on("requestfailed", (request) => {
    const { errorText } = request.failure();
    if (errorText !== "net::ERR_ABORTED") page.wrong.push(`${errorText}: ${request.url()}`); // aborted: the next page was asked for
  });
  page.on(
    "response",
    (response) => response.status() >= 400 && page.wrong.push(`${response.status()}: ${response.url()}`),
  );
  return page;
}

/// Runs the work on all items, two at a time, each time with a page of its own, and fails with all that failed.
export async function onAll(browser, items, options, work) {
  const waiting = [...items];
  const failed = [];
  const worker = async () => {
    const page = await newPage(browser, options);
    for (let item = waiting.shift(); item; item = waiting.shift()) {
      page.wrong.length = 0;
      await work(page, item).catch((error) => failed.push(error.message));
    }
    await page.close();
  };
  await Promise.all([worker(), worker()]);
  if (failed.length) throw new Error(failed.join("\n\n"));
}
