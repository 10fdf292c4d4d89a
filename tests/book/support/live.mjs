/// A page with one live figure, made of tools/book/live/ and of what em++ has built, so that the experiments are tested without the book.
import fs from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";
import { engineOf as engineIn } from "../../../tools/book/experiments.js";
import { idle } from "../../../tools/book/idle.js";
import { experimentsIn, liveFiles } from "../../../tools/book/live_files.js";

export const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../../..");
const folder = path.join(root, "build/live_pages");
export const built = path.join(root, process.env.PUSHBACK_WASM ?? "build/wasm/programs");

export const chapters = () => experimentsIn(built);

/// A chapter's program in node, without a page.
export const engineOf = (chapter) => engineIn(path.join(built, `${chapter}.js`));

function link(from, to) {
  fs.rmSync(to, { force: true, recursive: true });
  fs.symlinkSync(from, to);
}

let files; // the same for all pages

/// The address of a page with this chapter's figure. `guess`: it asks for one first.
export function pageOf(chapter, { guess = false } = {}) {
  const live = path.join(folder, "live");
  fs.mkdirSync(path.join(live, "programs"), { recursive: true });
  for (const { name, text } of (files ??= liveFiles(built))) fs.writeFileSync(path.join(live, name), text);
  link(path.join(root, "renders"), path.join(folder, "renders"));
  const asked = guess
    ? "<h2>Your guess</h2><p>How high does it jump?</p><details><summary>Answer</summary><p>631 mm.</p></details>"
    : "";
  const name = `${chapter}${guess ? "_guess" : ""}.html`;
  const still = chapter === "hard_cases" ? "overview.png" : "sheet.png";
  fs.writeFileSync(
    path.join(folder, name),
    `<!doctype html><html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width"><title>${chapter}</title><link rel="icon" href="data:,">
<style>:root { color-scheme: light dark; } body { max-width: 46rem; margin: 1rem auto; padding: 0 1rem; font: 16px/1.5 sans-serif; } img { max-width: 100%; }</style>
<link rel="stylesheet" href="live/live.css"><script src="live/live.js" defer></script></head>
<body><h1>${chapter}</h1>${asked}
<figure class="live sheet" data-chapter="${chapter}" data-root="." data-idle='${JSON.stringify(idle[chapter] ?? {})}'><img src="renders/${chapter}/${still}" alt="The sheet"></figure></body></html>`,
  );
  return `file://${folder}/${name}`;
}

/// Draws by software; `webgl`: whether pages may draw at all.
export function launch({ webgl = true } = {}) {
  const drawing = webgl
    ? ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
    : ["--disable-gpu", "--disable-3d-apis"];
  return chromium.launch({
    executablePath: process.env.PUSHBACK_CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox", ...drawing],
  });
}

/// A page that keeps what went wrong on it: `page.wrong`.
export async function newPage(browser, options = {}) {
  const page = await browser.newPage({ viewport: { width: 1000, height: 900 }, ...options });
  page.wrong = [];
  page.on(
    "console",
    (message) =>
      ["error", "warning"].includes(message.type()) &&
      !message.text().includes("GPU stall") &&
      page.wrong.push(message.text()),
  );
  page.on("pageerror", (error) => page.wrong.push(error.message));
  // What is still on its way when a page is left is no failure.
  page.on(
    "requestfailed",
    (request) =>
      request.failure()?.errorText !== "net::ERR_ABORTED" &&
      page.wrong.push(`failed: ${request.url()}, ${request.failure()?.errorText}`),
  );
  return page;
}
