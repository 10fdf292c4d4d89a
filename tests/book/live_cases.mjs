/// A cell of the table of hard cases opens its case under its stage, and the gallery's links open the scenes of the sheets: in the
/// built book.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { address, html } from "./support/browser.mjs";
import { chapters, engineOf, launch, newPage } from "./support/live.mjs";

const table = "renders/hard_cases/table.html";
const linksOf = (page) =>
  [...html(page).matchAll(/<a [^>]*href="([^"]*#live=[^"]*)"(?: title="([^"]*)")?/g)].map(([, href, title]) => {
    const [file, state] = href.replaceAll("&amp;", "&").split("#");
    return { file, state: new URLSearchParams(state), title };
  });

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

/// Opened by a click on the link to this state in the table; `player` there. It does not play by itself.
async function opened(state) {
  const page = await newPage(browser, { reducedMotion: "reduce" });
  page.setDefaultTimeout(120000);
  await page.goto(address(table));
  await page.locator(`td a[href$="#live=hard_cases&${state}"]`).click();
  await page.waitForFunction(() => (window.player = window.PUSHBACK_LIVE_TEST?.player()));
  return page;
}
const seen = (page) =>
  page.evaluate(() => ({
    scene: player.engine.scene.key,
    lanes: player.engine.lanes.map(({ name }) => name),
    problem: player.stage.problem,
  }));
const goTo = async (page, step) => {
  await page.evaluate((to) => player.go(to), step);
  await page.waitForFunction(() => player.engine.now === player.target);
};

test("each cell leads to its case and its stage, by the names that the program has", async () => {
  const { scenes } = (await engineOf("hard_cases")).description;
  const cells = linksOf(table);
  assert.equal(cells.length, scenes.length * scenes[0].variants.length);
  const pairs = new Set();
  for (const { state, title } of cells) {
    const scene = scenes.find(({ key }) => key === state.get("scene"));
    assert.ok(scene, `no case ${state.get("scene")}`);
    assert.equal(scene.variants[Number(state.get("show"))].name, title, scene.key);
    pairs.add(`${scene.key} ${title}`);
  }
  assert.equal(pairs.size, cells.length);
});

test("a click plays the case under the stage: it moves, stops and comes back to the same bits, and another case keeps the stage", async () => {
  const page = await opened("scene=stack-10&show=7");
  assert.deepEqual(await seen(page), { scene: "stack-10", lanes: ["07 warm start"], problem: "" });
  const bits = () => page.evaluate(() => player.engine.hash(0));
  const start = await bits();
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await page.waitForFunction(() => player.engine.now >= 10);
  await page.getByRole("button", { name: "Pause" }).click();
  const played = await page.evaluate(() => player.engine.now);
  const there = await bits();
  assert.notEqual(there, start);
  await goTo(page, 0);
  assert.equal(await bits(), start);
  await goTo(page, played);
  assert.equal(await bits(), there);
  await page.getByRole("combobox", { name: "Scene" }).selectOption({ label: "card house" });
  assert.deepEqual(await seen(page), { scene: "card-house", lanes: ["07 warm start"], problem: "" });
  assert.deepEqual(page.wrong, []);
  await page.close();
});

test("a stage that refuses a case says why; a case of other steps has its own", async () => {
  const refused = await opened("scene=ball-and-chain&show=0");
  await goTo(refused, 5);
  await refused.getByText(/00 naive: ended at 0.0167 s: .*joint/).waitFor();
  assert.deepEqual(refused.wrong, []);
  await refused.close();
  const coarse = await opened("scene=dt-10&show=18&dt=0.1");
  assert.equal(await coarse.evaluate(() => player.engine.dt), 0.1);
  await goTo(coarse, 20);
  assert.deepEqual(await seen(coarse), { scene: "dt-10", lanes: ["22 wide"], problem: "" });
  assert.deepEqual(coarse.wrong, []);
  await coarse.close();
});

test("the gallery leads to every scene of every chapter, and to each hard case", async () => {
  const links = linksOf("gallery.html");
  const named = (name) => links.filter(({ state }) => state.get("live") === name);
  for (const name of chapters()) {
    const { scenes } = (await engineOf(name)).description;
    const first = (scenes.find(({ pictures }) => pictures) ?? scenes[0]).key;
    const seen = new Set(named(name).map(({ state }) => state.get("scene") ?? first));
    assert.deepEqual([...seen].sort(), scenes.map(({ key }) => key).sort(), name);
  }
  assert.equal(named("hard_cases").length, new Set(linksOf(table).map(({ state }) => state.get("scene"))).size);

  const page = await newPage(browser, { reducedMotion: "reduce" });
  page.setDefaultTimeout(120000);
  await page.goto(address("gallery.html"));
  await page.locator('a[href="chapters/05_restitution/index.html#live=05_restitution"]').click();
  await page.waitForFunction(() => (window.player = window.PUSHBACK_LIVE_TEST?.player()));
  const pictures = await page.evaluate(() => player.engine.description.scenes.map((scene) => scene.pictures));
  assert.equal(pictures[0], false); // its sheet is of another
  assert.equal(await page.evaluate(() => player.engine.sceneIndex), pictures.indexOf(true));
  assert.deepEqual(page.wrong, []);
  await page.close();
});
