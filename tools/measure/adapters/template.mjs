// An adapter to begin with, in JavaScript. It has no engine: bodies fly and fall, and touch nothing. Put yours where "engine" stands.
// docs/benchmark.md says what is asked.
//
//   ./course run adapter template.mjs       what it gets wrong
import { createInterface } from "node:readline";

let world; // engine: what is open

function open({ scene }) {
  if (scene.joints.length) return { plays: false, lacks: "joints" };
  world = { gravity: scene.gravity, bodies: structuredClone(scene.bodies) }; // engine: mass is null where nothing moves the body
  return { plays: true };
}

function step({ steps, h, put = [] }) {
  for (const { body, ...state } of put) Object.assign(world.bodies[body], state);
  const begin = performance.now();
  for (let i = 0; i < steps; ++i) {
    for (const body of world.bodies) {
      if (body.mass === null) continue;
      for (let k = 0; k < 3; ++k) {
        body.velocity[k] += h * world.gravity[k]; // engine: its step
        body.position[k] += h * body.velocity[k];
      }
    }
  }
  const seconds = (performance.now() - begin) / 1000;
  const states = world.bodies.map((body) =>
    body.mass === null ? null : [...body.position, ...body.orientation, ...body.velocity, ...body.angular_velocity],
  );
  return { seconds, states };
}

const answers = {
  settings: () => ({
    engine: "Template 1",
    settings: [{ name: "template", what: "as it comes: bodies fly", sweeps: false }],
  }),
  open,
  step,
};

for await (const line of createInterface({ input: process.stdin })) {
  const asked = JSON.parse(line);
  process.stdout.write(JSON.stringify(answers[asked.ask](asked)) + "\n");
}
