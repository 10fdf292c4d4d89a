/// Which parameters change nothing that is seen in which scene of an experiment: node tools/book/idle.js [--write] [NAME...] plays every pair of
/// them, and lists those in tools/book/idle.json. A page leaves their sliders out in that scene. tests/book/live_idle.mjs plays
/// them, too, and fails where the list is not what it plays.
import fs from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { engineOf } from "./experiments.js";
import { experimentsIn } from "./live_files.js";

const home = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../..");
const list = path.join(home, "tools/book/idle.json");
const built = path.join(home, "build/wasm/programs");
const most = 600; // steps that a pair is played
const seen = 1e-4; // m: what moves by less is seen by nobody
const drawn = 0.005; // of a curve's height: the same of a curve

/// {NAME: {"--flag": [places of the scenes where it changes nothing]}}
export const idle = JSON.parse(fs.readFileSync(list, "utf8"));

/// Those that can be asked for: the hard cases have no parameters of their own.
export const played = () => experimentsIn(built).filter((name) => /^\d\d_/.test(name));

/// Of one experiment.
export async function idleIn(name) {
  const engine = await engineOf(path.join(built, `${name}.js`));
  const found = {};
  const usualProblems = problemsIn(engine);
  const posed = new Set(engine.parameters.filter((one) => !sameProblems(engine, one, usualProblems)));
  engine.description.scenes.forEach((scene, which) => {
    const waiting = new Set(engine.parameters.filter((one) => !posed.has(one)));
    for (let first = 0; first < scene.variants.length && waiting.size; first += 4) {
      const places = scene.variants.map((_, place) => place).slice(first, first + 4);
      engine.set("");
      engine.choose(which, places);
      const usual = new Trace(engine);
      for (const parameter of waiting) if (acts(engine, which, places, parameter, usual)) waiting.delete(parameter);
    }
    for (const { flag } of waiting) (found[flag] ??= []).push(which);
  });
  return found;
}

/// What a scene shows, step by step.
class Trace {
  #steps = [];

  constructor(engine) {
    this.steps = engine.steps;
    this.told = told(engine);
    this.last = Math.min(engine.steps, most);
    while (this.#steps.length < this.last) this.#steps.push(instant(engine, this.#steps.length + 1));
    this.end = measured(engine);
  }
  /// Whether a reader sees the same of the engine as it is now.
  same(engine) {
    if (engine.steps !== this.steps || told(engine) !== this.told) return false;
    for (let step = 1; step <= this.last; ++step) {
      const now = instant(engine, step),
        then = this.#steps[step - 1];
      if (now.mishaps !== then.mishaps || now.places.length !== then.places.length) return false;
      if (now.places.some((x, i) => Math.abs(x - then.places[i]) > seen)) return false;
    }
    const { words, curves } = measured(engine);
    return words === this.end.words && curves.every((one, i) => alike(one, this.end.curves[i]));
  }
}

/// Names, series and references, but not how many sweeps and substeps a variant is said to have.
function told(engine) {
  const { scene } = engine;
  return JSON.stringify([
    { ...scene, variants: scene.variants.map(({ sweeps, substeps, ...rest }) => rest) },
    engine.lanes.map(({ lane, references }) => references.map((_, i) => [...engine.reference(lane, i)])),
  ]);
}

function instant(engine, step) {
  engine.goTo(step, 1e9);
  const places = engine.lanes.flatMap(({ lane }) =>
    Array.from({ length: engine.bodies(lane) }, (_, body) => engine.body(lane, body).position).flat(),
  );
  return { places, mishaps: engine.lanes.map(({ lane }) => engine.mishap(lane)).join() };
}

/// The numbers as they are written, and the curves that are drawn.
function measured(engine) {
  const { numbers, series } = engine.scene;
  return {
    words: JSON.stringify(engine.lanes.map(({ lane }) => numbers.map((_, i) => engine.number(lane, i)))),
    curves: engine.lanes.flatMap(({ lane }) =>
      series.flatMap(({ log, drawn }, i) => {
        if (!drawn) return [];
        const values = engine.series(lane, i);
        return [log ? values.map((x) => Math.log10(Math.max(x, 1e-9))) : values];
      }),
    ),
  };
}
function alike(now, then) {
  const size = Math.max(...then.map(Math.abs), ...now.map(Math.abs));
  return now.every((x, i) => !(Math.abs(x - then[i]) > drawn * size));
}

function acts(engine, which, places, parameter, usual) {
  for (const value of values(parameter)) {
    if (engine.set(`${parameter.flag}=${value}`)) return true; // what is refused is said: that is something
    engine.choose(which, places);
    if (!usual.same(engine)) return true;
  }
  return false;
}

/// Both ends of its range, and the middle; of a list with the others as they are.
function values({ least, most, whole, default: usual }) {
  const middle = least > 0 && most / least >= 100 ? Math.sqrt(least * most) : (least + most) / 2;
  const rest = usual.slice(1);
  return [most, least, whole ? Math.round(middle) : middle].map((value) => [value, ...rest].join());
}

/// The problems of one step, with what three iterations leave.
function problemsIn(engine) {
  return JSON.stringify(
    engine.description.problems.map((_, which) => {
      engine.hold(which);
      while (engine.iteration < 3) engine.iterate(3, 1e9);
      return [engine.problem, [...engine.matrix], engine.problem.methods.map((_, i) => [...engine.residuals(i)])];
    }),
  );
}
function sameProblems(engine, parameter, usual) {
  const same = values(parameter).every(
    (value) => engine.set(`${parameter.flag}=${value}`) === "" && problemsIn(engine) === usual,
  );
  engine.set("");
  return engine.description.problems.length ? same : true;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const words = process.argv.slice(2);
  const names = words.filter((word) => word !== "--write");
  const now = names.length ? { ...idle } : {};
  for (const name of names.length ? names : played()) {
    const began = performance.now();
    now[name] = await idleIn(name);
    console.log(`${name}: ${JSON.stringify(now[name])}, ${((performance.now() - began) / 1000).toFixed(1)} s`);
  }
  const sorted = Object.fromEntries(Object.entries(now).sort());
  const lines = Object.entries(sorted).map(([name, flags]) => `  "${name}": ${JSON.stringify(flags)}`);
  if (words.includes("--write")) fs.writeFileSync(list, `{\n${lines.join(",\n")}\n}\n`);
}
