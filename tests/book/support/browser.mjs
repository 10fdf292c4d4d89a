/// The built book in a browser: Debian's Chromium, driven by playwright-core.
import fs from "node:fs";
import path from "node:path";
import { chromium } from "playwright-core";
import { engineOf as engineIn, experimentsIn, home, programs } from "../../../tools/book/experiments.js";

export const folder = path.join(home, "build/book");
export const address = (page) => `file://${folder}/${page}`;
export const html = (page) => fs.readFileSync(path.join(folder, page), "utf8");

/// All pages of the book, sources among them, as seen from its folder.
export const all = () => fs.readdirSync(folder, { recursive: true }).filter((name) => name.endsWith(".html"));
export const isSource = (page) => html(page).includes('<body class="source">');

/// The experiments that are compiled, and one of them in node, without a page.
export const experiments = experimentsIn(programs);
export const engineOf = (name) => engineIn(path.join(programs, `${name}.js`));

/// Pages of text are drawn faster without graphics; experiments draw by software: `draws`.
export function launch({ draws = false } = {}) {
  const graphics = draws
    ? ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
    : ["--disable-gpu", "--disable-software-rasterizer", "--disable-3d-apis"];
  return chromium.launch({
    executablePath: process.env.PUSHBACK_CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox", ...graphics],
  });
}

/// A page that keeps what went wrong on it: `page.wrong`. Nothing plays by itself there.
export async function newPage(browser, options = {}) {
  const page = await browser.newPage({
    viewport: { width: 1280, height: 800 },
    reducedMotion: "reduce",
    ...options,
  });
  page.setDefaultTimeout(120000); // for a machine that has much else to do
  page.wrong = [];
  page.on("console", (message) => {
    const text = message.text();
    if (["error", "warning"].includes(message.type()) && !text.includes("GPU stall")) page.wrong.push(text);
  });
  page.on("pageerror", (error) => page.wrong.push(error.message));
  page.on("requestfailed", (request) => {
    const { errorText } = request.failure();
    if (errorText !== "net::ERR_ABORTED") page.wrong.push(`${errorText}: ${request.url()}`); // aborted: the next page was asked for
  });
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

/// The page of an experiment in the book, which shows the state that the address says: `player` there.
export async function running(browser, page, state, options) {
  const opened = await newPage(browser, options);
  await opened.goto(address(`${page}#${state}`));
  await opened.waitForFunction(() => (window.player = window.PUSHBACK_LIVE_TEST?.player()));
  await settled(opened);
  await opened.evaluate(() => document.querySelectorAll(".pb-fold").forEach((fold) => (fold.open = true)));
  return opened;
}
export const settled = (page) =>
  page.waitForFunction(() => !player.playing && player.engine.now === player.target && !player.asked);
export const seek = async (page, step) => {
  await page.evaluate((to) => player.go(to), step);
  await settled(page);
};
/// Of all lanes: where they are, to the last bit.
export const bits = (page) => page.evaluate(() => player.engine.lanes.map(({ lane }) => player.engine.hash(lane)));
