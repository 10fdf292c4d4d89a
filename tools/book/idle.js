/// Which parameters change nothing that is seen in which scene of an experiment: node tools/book/idle.js [NAME...] plays every pair of
/// them, and lists those in tools/book/idle.json. A page leaves their sliders out in that scene.
import fs from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { engineOf, experimentsIn, home, idle, programs } from "./experiments.js";

const most = 600; // steps that a pair is played
const near = 1e-4; // m: what moves by less is seen by nobody
const drawn = 0.005; // of a curve's height: the same of a curve

/// {"--flag": [places of the scenes where it changes nothing]} of one experiment.
export async function idleIn(name) {
  const engine = await engineOf(path.join(programs, `${name}.js`));
  const found = {};
  const problems = [...seenOfProblems(engine)];
  const waiting = engine.parameters.filter((one) => !acts(engine, one, problems, seenOfProblems));
  engine.set("");
  engine.description.scenes.forEach((scene, which) => {
    const still = new Set(waiting);
    for (let first = 0; first < scene.variants.length; first += 4) {
      const places = scene.variants.map((_, place) => place).slice(first, first + 4);
      const played = function* (one) {
        one.choose(which, places);
        yield* seen(one);
      };
      engine.set("");
      const usual = [...played(engine)];
      for (const parameter of still) if (acts(engine, parameter, usual, played)) still.delete(parameter);
    }
    for (const { flag } of still) (found[flag] ??= []).push(which);
  });
  return found;
}

/// Whether a reader sees anything else at both ends of the parameter's range, and in the middle; of a list with the others as they are.
function acts(engine, { flag, least, most: last, whole, default: usual }, before, look) {
  const middle = least > 0 && last / least >= 100 ? Math.sqrt(least * last) : (least + last) / 2;
  return [last, least, whole ? Math.round(middle) : middle].some((value) => {
    if (engine.set(`${flag}=${[value, ...usual.slice(1)]}`)) return true; // what is refused is said: that is something
    let at = 0;
    for (const now of look(engine)) if (!alike(now, before[at++])) return true;
    return at !== before.length;
  });
}

/// A text, or {values, within}.
function alike(now, then) {
  if (typeof now === "string" || typeof then !== "object") return now === then;
  return (
    now.values.length === then.values.length && now.values.every((x, i) => !(Math.abs(x - then.values[i]) > now.within))
  );
}

/// What a scene shows, one after the other: names, but not how many sweeps a variant has; where bodies are; numbers and curves.
function* seen(engine) {
  const { scene, lanes } = engine;
  const variants = scene.variants.map(({ sweeps, ...rest }) => rest);
  const references = lanes.map(({ lane, references: all }) => all.map((_, i) => [...engine.reference(lane, i)]));
  yield JSON.stringify([{ ...scene, variants }, references, engine.steps]);
  for (let step = 1; step <= Math.min(engine.steps, most); ++step) {
    engine.goTo(step, 1e9);
    const bodies = lanes.flatMap(({ lane }) =>
      Array.from({ length: engine.bodies(lane) }, (_, body) => engine.body(lane, body).position),
    );
    yield { values: bodies.flat(), within: near };
    yield lanes.map(({ lane }) => engine.mishap(lane)).join();
  }
  yield JSON.stringify(lanes.map(({ lane }) => scene.numbers.map((_, i) => engine.number(lane, i))));
  for (const { lane } of lanes)
    for (const [i, { log, drawn: isDrawn }] of scene.series.entries()) {
      if (!isDrawn) continue;
      const values = [...engine.series(lane, i)].map((x) => (log ? Math.log10(Math.max(x, 1e-9)) : x));
      yield { values, within: drawn * Math.max(...values.map(Math.abs)) };
    }
}

/// The problems of one step, with what three iterations leave. Without any, every parameter stays to be looked at.
function* seenOfProblems(engine) {
  for (const which of engine.description.problems.keys()) {
    engine.hold(which);
    while (engine.iteration < 3) engine.iterate(3, 1e9);
    const residuals = engine.problem.methods.map((_, i) => [...engine.residuals(i)]);
    yield JSON.stringify([engine.problem, [...engine.matrix], residuals]);
  }
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const names = process.argv.slice(2);
  for (const name of names.length ? names : experimentsIn(programs).filter((one) => /^\d\d_/.test(one))) {
    idle[name] = await idleIn(name);
    console.log(`${name}: ${JSON.stringify(idle[name])}`);
  }
  const lines = Object.entries(idle)
    .sort()
    .map(([name, flags]) => `  "${name}": ${JSON.stringify(flags)}`);
  fs.writeFileSync(path.join(home, "tools/book/idle.json"), `{\n${lines.join(",\n")}\n}\n`);
}
