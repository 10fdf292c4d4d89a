/// What em++ makes of a chapter computes what g++ makes of it: in each step of each variant of each scene, energies, momenta, overlap,
/// contacts and residual have the same bits as in the program's metrics.csv. Without a browser. Except where
/// a solver calls a function that the library of em++ rounds otherwise: there the first step that differs does so by rounding alone.
/// PUSHBACK_BUILD: the folder of the build whose programs are compared with; build/ci unless it is given.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { test } from "node:test";
import { chapters, engineOf, root } from "./support/live.mjs";

const build = path.resolve(root, process.env.PUSHBACK_BUILD ?? "build/ci");
const columns = [
  "time",
  "kinetic_energy",
  "potential_energy",
  "px",
  "py",
  "pz",
  "lx",
  "ly",
  "lz",
  "deepest_overlap",
  "contacts",
  "rows",
  "residual",
];
/// Those that differ: how "chapter / scene / variant" begins, and by which function.
const roundedOtherwise = {
  "08_friction_cone / twelve planks, and where they should stop / cone": "hypot",
  "12_soft_contacts / a stack of forty / 32 substeps, all together": "hypot",
  "13_joints / a door on a hinge": "atan2",
  "15_limits_motors_springs / a bar, let go, and a stop at 30° / limit": "atan2",
  "15_limits_motors_springs / a bar, let go, and a stop at 30° / the same": "atan2",
  "15_limits_motors_springs / θ = sin t": "atan2, sin",
  "15_limits_motors_springs / two winches": "atan2",
  "15_limits_motors_springs / two pulleys": "atan2",
  "15_limits_motors_springs / face down on a bench": "atan2",
  "15_limits_motors_springs / down the stairs": "atan2",
  "16_whole_problem / a stack of twenty": "hypot",
  "17_direct_contacts / a thousand times heavier on four": "hypot",
  "21_detected_once / a cube rolls / detected in each substep": "hypot",
  "21_detected_once / a stack of forty": "hypot",
  "21_detected_once / a thousand times heavier than what it lies on": "hypot",
  "22_wide / the pyramid in three ways / chapter 21": "hypot",
  "22_wide / a thousand times heavier than what it lies on / chapter 21": "hypot",
};
const rounding = 1e-12; // of a number, or in its unit where that is less than 1
/// What a method leaves that stops at a residual of 1e-10: N m s, where 100 400 kg press with 16 400 N s a step.
const leftOver = { "17_direct_contacts / a thousand times heavier on four, every step from nothing / direct": 1e-4 };
/// So many steps of each variant, since the slowest take a second each.
const most = Number(process.env.PUSHBACK_LIVE_STEPS ?? 120);

/// "scene", "variant" -> the rows of its steps.
function metricsOf(chapter) {
  const out = fs.mkdtempSync(path.join(os.tmpdir(), "pushback_bits_"));
  execFileSync(path.join(build, "chapters", chapter), ["--no-images", "--no-study", "--out", out], { stdio: "ignore" });
  const [head, ...rows] = fs
    .readFileSync(path.join(out, chapter, "metrics.csv"), "utf8")
    .trim()
    .split("\n");
  fs.rmSync(out, { recursive: true });
  const names = head.split(","),
    at = columns.map((name) => names.indexOf(name));
  const metrics = new Map();
  for (const row of rows) {
    const [, scene, variant, rest] = /^"([^"]*)","([^"]*)",(.*)$/.exec(row);
    const numbers = rest.split(",").map(Number),
      key = `${scene} / ${variant}`;
    if (!metrics.has(key)) metrics.set(key, []);
    metrics.get(key).push(at.map((column) => numbers[column - 2]));
  }
  return metrics;
}

for (const chapter of chapters()) {
  const there = fs.statSync(path.join(build, "chapters", chapter), { throwIfNoEntry: false })?.isFile();
  test(`${chapter}: the same bits as by g++`, { skip: !there && "its program is not built" }, async () => {
    const engine = await engineOf(chapter),
      metrics = metricsOf(chapter);
    const different = [],
      rounded = new Set();
    engine.description.scenes.forEach((scene, which) => {
      for (let first = 0; first < scene.variants.length; first += 4) {
        const places = scene.variants.map((_, place) => place).slice(first, first + 4);
        assert.equal(engine.choose(which, places), "");
        const last = Math.min(engine.steps, most);
        while (engine.now < last) engine.goTo(last, 1e9);
        for (const { lane, name } of engine.lanes) {
          const told = metrics.get(`${scene.name} / ${name}`);
          assert.ok(told, `${scene.name} / ${name} is not in metrics.csv`);
          for (let step = 0; step < Math.min(last, engine.played(lane)); ++step) {
            const seen = engine.numbers(engine.module._live_sample(lane, step), columns.length);
            const off = columns.filter(
              (_, i) =>
                !Object.is(seen[i] + 0, told[step][i] + 0) && !(Number.isNaN(seen[i]) && Number.isNaN(told[step][i])),
            );
            if (!off.length) continue;
            const where = `${chapter} / ${scene.name} / ${name}`;
            const known = Object.keys(roundedOtherwise).find((begin) => where.startsWith(begin));
            if (known) {
              const most = Math.max(
                ...seen.map((number, i) => Math.abs(number - told[step][i]) / Math.max(1, Math.abs(number))),
              );
              const [, allowed] = Object.entries(leftOver).find(([begin]) => where.startsWith(begin)) ?? [, rounding];
              assert.ok(most <= allowed, `${where}, step ${step + 1}: off by ${most}`);
              rounded.add(known);
              break;
            }
            different.push(
              `${scene.name} / ${name}, step ${step + 1}: ${off.map((column) => `${column} ${seen[columns.indexOf(column)]}, not ${told[step][columns.indexOf(column)]}`).join("; ")}`,
            );
            break;
          }
        }
      }
    });
    assert.deepEqual(different, []);
    const alike = Object.keys(roundedOtherwise).filter((begin) => begin.startsWith(chapter) && !rounded.has(begin));
    assert.deepEqual(alike, [], "these are said to differ, and do not");
  });
}
