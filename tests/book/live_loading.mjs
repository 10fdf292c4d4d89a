/// What the book weighs, and what a page asks for until its experiment is seen: from a folder, and from a server far away.
import assert from "node:assert/strict";
import { randomBytes } from "node:crypto";
import fs from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import { gunzipSync, gzipSync } from "node:zlib";
import { difference } from "../../tools/book/difference.js";
import { experimentsIn, liveFiles } from "../../tools/book/live_files.js";
import { serve } from "../../tools/book/serve.js";
import { address, folder } from "./support/browser.mjs";
import { built, engineOf, launch, newPage } from "./support/live.mjs";

const chapter = "03_baumgarte";
const page = `chapters/${chapter}/index.html`;
let browser;
before(async () => (browser = await launch()));
after(() => browser.close()); // with all its pages

function filesIn(at) {
  return fs.readdirSync(at, { withFileTypes: true }).flatMap((entry) => {
    const name = path.join(at, entry.name);
    return entry.isDirectory() ? filesIn(name) : [name];
  });
}

test("the whole book is below 30 MB", () => {
  const files = filesIn(folder);
  const MB = files.reduce((sum, name) => sum + fs.statSync(name).size, 0) / 1e6;
  console.log(`${MB.toFixed(1)} MB in ${files.length} files`);
  assert.ok(MB < 30, `${MB} MB`);
});

test("what differs from other bytes, joined with them, is the same bytes; and is short where they are alike", async () => {
  await engineOf(chapter); // brings the page's side along
  const { joined } = globalThis.PushbackLive;
  const from = randomBytes(50000);
  const changed = Buffer.concat([
    from.subarray(20000),
    Buffer.from("between"),
    from.subarray(100, 30000),
    randomBytes(40),
  ]);
  changed[5000] ^= 1;
  for (const to of [from, changed, randomBytes(3000), Buffer.alloc(0), from.subarray(7, 9)])
    assert.deepEqual(Buffer.from(joined(from, difference(from, to))), to);
  assert.deepEqual(Buffer.from(joined(Buffer.alloc(0), difference(Buffer.alloc(0), from))), from);
  const stored = (to) => gzipSync(difference(from, to), { level: 9 }).length;
  assert.ok(stored(changed) < 250, `${stored(changed)} bytes`);
  const numbers = from.map((byte, i) => (i % 20 === 0 ? byte + 3 : byte)); // nowhere 20 bytes that are alike
  assert.deepEqual(Buffer.from(joined(from, difference(from, numbers))), Buffer.from(numbers));
  assert.ok(stored(numbers) < 500, `${stored(numbers)} bytes`);
});

test("the same programs make the same files, each smaller than the program compressed, and the program again", async () => {
  const files = liveFiles(built);
  assert.deepEqual(liveFiles(built), files);
  await engineOf(chapter);
  const { joined } = globalThis.PushbackLive;
  const page = {}; // its window
  for (const { text } of files.filter(({ name }) => name.startsWith("programs/"))) new Function("self", text)(page);
  const { common: _, ...programs } = page.PUSHBACK_PROGRAMS;
  const unpacked = ({ packed }) => gunzipSync(Buffer.from(packed, "base64"));
  const whole = (program) =>
    program.from ? joined(whole(page.PUSHBACK_PROGRAMS[program.from]), unpacked(program)) : unpacked(program);
  assert.deepEqual(Object.keys(programs).sort(), experimentsIn(built));
  for (const [name, program] of Object.entries(programs)) {
    const made = Buffer.concat(["js", "wasm"].map((ending) => fs.readFileSync(path.join(built, `${name}.${ending}`))));
    assert.ok(Buffer.from(whole(program)).equals(made), name);
    assert.ok(program.packed.length < gzipSync(made).length, name);
    // What a page loads: the program, what it starts from, and at most one more.
    assert.ok(program.from === "common" || programs[program.from].from === "common", name);
  }
});

/// Scrolls to the first small picture as soon as there is one, and notes when it is drawn, s after the address was asked for.
const untilSmall = () =>
  new Promise((resolve) => {
    const look = () => {
      const figure = document.querySelector("figure.small-live");
      figure?.scrollIntoView();
      if (figure && !figure.querySelector("button").disabled && figure.querySelector("canvas").width !== 300)
        return resolve(performance.now() / 1000);
      requestAnimationFrame(look);
    };
    look();
  });
/// The same of the large one, to which the address leads.
const untilLarge = () =>
  new Promise((resolve) => {
    const look = () => {
      const player = window.PUSHBACK_LIVE_TEST?.player();
      if (player?.stage.panes && !player.stage.problem) return resolve(performance.now() / 1000);
      requestAnimationFrame(look);
    };
    look();
  });

for (const [what, until, hash] of [
  ["a small picture", untilSmall, ""],
  ["the experiment", untilLarge, `#live=${chapter}`],
]) {
  test(`${what}: the same from a folder and from a server, in few requests`, async (t) => {
    const server = await serve(folder);
    t.after(() => server.close());
    const wide = `http://127.0.0.1:${server.address().port}/${page}${hash}`;
    for (const [from, network] of [
      [`${address(page)}${hash}`, null],
      [wide, null],
      [wide, { downloadThroughput: 9e6 / 8, uploadThroughput: 9e6 / 8, latency: 150, offline: false }],
    ]) {
      const context = await browser.newContext(); // nothing in its cache
      const tab = await newPage(context, { viewport: undefined });
      tab.setDefaultTimeout(60000);
      const asked = [];
      tab.on("request", (request) => asked.push(request.url()));
      if (network) {
        const session = await context.newCDPSession(tab);
        await session.send("Network.enable");
        await session.send("Network.emulateNetworkConditions", network);
      }
      await tab.goto(from, { waitUntil: "commit" });
      const seconds = await tab.evaluate(until);
      const scripts = asked.filter((one) => /\/live\/(?!pieces)/.test(one)); // pieces: of the large figure, where it is near
      console.log(
        `${what}, ${from.slice(0, 4)}${network ? ", 9 Mbit/s, 150 ms" : ""}: ${seconds.toFixed(2)} s, ${asked.length} requests`,
      );
      assert.deepEqual(scripts.map((one) => path.basename(new URL(one).pathname)).sort(), [
        `${chapter}.js`,
        "common.js",
        "engine.js",
        "live.css",
        "live.js",
      ]);
      assert.ok(asked.length <= 30, `${asked.length} requests`);
      assert.deepEqual(tab.wrong, []);
      await context.close();
    }
  });
}

test("a browser that cannot unpack programs says so, and the page is whole", async () => {
  const tab = await newPage(browser);
  await tab.addInitScript(() => delete window.DecompressionStream);
  await tab.goto(address(page));
  await tab.evaluate(() => window.PUSHBACK_LIVE_TEST.start());
  assert.match(await tab.textContent(".pb-start-said"), /this browser cannot unpack it: .*Safari from 16\.4/);
  await tab.evaluate(() => document.querySelector("figure.small-live").scrollIntoView());
  await tab.waitForFunction(() => [...document.querySelectorAll("figure.small-live")].every(({ hidden }) => hidden));
  await tab.close();
});
