/// The files of the benchmark by their schema, and the adapter in JavaScript by the test kit.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import Ajv from "ajv";

const programs = ["release", "ci"]
  .map((preset) => `build/${preset}/programs`)
  .find((folder) => existsSync(`${folder}/benchmark_files`));
const scratch = mkdtempSync(join(tmpdir(), "pushback_files_"));
after(() => rmSync(scratch, { recursive: true }));
const json = (file) => JSON.parse(readFileSync(file, "utf8"));

test("every motion and every hard case is as the schema says, and what is not is refused", () => {
  assert.ok(programs, "benchmark_files is built by ./course test --book");
  assert.equal(spawnSync(`${programs}/benchmark_files`, [scratch]).status, 0);
  const validate = new Ajv({ strictTypes: false, allErrors: true }).compile(
    json("tools/measure/adapters/benchmark.schema.json"),
  );
  const folders = ["motions", "hard_cases"].map((name) => join(scratch, name));
  const files = folders.flatMap((folder) => readdirSync(folder).map((name) => join(folder, name)));
  let seen = 0;
  for (const file of files.filter((name) => name.endsWith(".json"))) {
    ++seen;
    assert.ok(validate(json(file)), `${file}: ${JSON.stringify(validate.errors)}`);
  }
  assert.ok(seen > 60);

  const motion = json(join(scratch, "motions", "bounce.json"));
  for (const spoil of [
    (m) => delete m.truth,
    (m) => (m.version = 2),
    (m) => (m.scene.bodies[1].mass = 0),
    (m) => (m.scene.bodies[1].position = [0, 1]),
    (m) => (m.scene.bodies[1].shape.radius = "large"),
    (m) => (m.scene.bodies[1].colour = 3),
  ]) {
    const spoilt = structuredClone(motion);
    spoil(spoilt);
    assert.ok(!validate(spoilt), spoil.toString());
  }
});

test("the template in JavaScript answers as that in C++ does", () => {
  const said = spawnSync(`${programs}/motion_adapter`, ["--check"], {
    env: { ...process.env, PUSHBACK_ADAPTER: "tools/measure/adapters/template.mjs" },
    encoding: "utf8",
  });
  assert.equal(said.status, 1, said.stderr);
  for (const part of [
    "✓ places",
    "✓ gravity",
    "✓ damping",
    "– turning",
    "✗ friction",
    "they do not touch",
    "✓ same bits",
  ])
    assert.ok(said.stdout.includes(part), `${part}: ${said.stdout}`);
});
