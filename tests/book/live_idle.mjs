/// Which sliders change nothing in which scene, played again: a page shows none of them there.
import assert from "node:assert/strict";
import { test } from "node:test";
import { idle, idleIn, played } from "../../tools/book/idle.js";

/// They take minutes: PUSHBACK_ALL_IDLE=1 plays them, too.
const slow = ["12_soft_contacts", "21_detected_once", "22_wide"];

test("the list has each experiment", () => assert.deepEqual(Object.keys(idle), played()));

for (const name of played()) {
  const skip = slow.includes(name) && !process.env.PUSHBACK_ALL_IDLE && "it takes minutes";
  test(`${name}: the sliders left out change nothing, all others something`, { skip }, async () => {
    assert.deepEqual(await idleIn(name), idle[name], "node tools/book/idle.js --write");
  });
}
