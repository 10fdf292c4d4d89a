/// Pages of each kind by the rules of WCAG 2 AA, as far as axe can tell.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import axe from "axe-core";
import { address, isSource, launch, onAll, pagesIn } from "./support/browser.mjs";

const chapter = "chapters/03_baumgarte/index.html";
const source = pagesIn().find(isSource);
let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

test("accessible by the rules of WCAG 2 AA, light and dark", async () => {
  const names = [
    "index.html",
    chapter,
    "docs/hard_cases.html",
    "renders/hard_cases/table.html",
    "docs/notation.html",
    "gallery.html",
    source,
  ];
  for (const colorScheme of ["light", "dark"]) {
    await onAll(browser, names, { colorScheme }, async (page, name) => {
      await page.goto(address(name));
      await page.evaluate(() => document.querySelectorAll("details").forEach((details) => (details.open = true)));
      await page.addScriptTag({ content: axe.source });
      const { violations } = await page.evaluate(
        (dark) => axe.run({ runOnly: dark ? ["color-contrast"] : ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa"] }),
        colorScheme === "dark",
      );
      assert.deepEqual(
        violations.map(({ id, nodes }) => `${id}: ${nodes[0].html.slice(0, 120)} ${nodes[0].failureSummary}`),
        [],
        `${name}, ${colorScheme}`,
      );
    });
  }
});
