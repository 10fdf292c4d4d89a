// Rapier, as it is published for JavaScript: compiled to WebAssembly, in float. docs/benchmark.md says what is asked.
import RAPIER from "@dimforge/rapier3d-compat";
import { createInterface } from "node:readline";

await RAPIER.init();

const settings = [
  { name: "rapier", what: "as it comes: 4 solver iterations a step", sweeps: false },
  {
    name: "rapier-once",
    what: "detected once in 1/60 s, whose substeps are its solver iterations",
    sweeps: true,
    substeps: 1,
    iterations: 8,
  },
  {
    name: "rapier-tuned",
    what: "one solver iteration a step with many sweeps, contacts as stiff as the step allows, no allowed overlap",
    sweeps: true,
    substeps: 8,
    iterations: 8,
  },
].map((setting) => ({ float: true, ...setting }));

const xyz = ([x, y, z]) => ({ x, y, z });
const wxyz = ([w, x, y, z]) => ({ w, x, y, z });
const still = ({ velocity, angular_velocity }) => [...velocity, ...angular_velocity].every((x) => x === 0);

let world, bodies, setting;

function shapeOf(shape) {
  switch (shape.kind) {
    case "sphere":
      return RAPIER.ColliderDesc.ball(shape.radius);
    case "box":
      return RAPIER.ColliderDesc.cuboid(...shape.half_extents);
    case "capsule":
      return RAPIER.ColliderDesc.capsule(shape.half_length, shape.radius);
    case "hull":
      return RAPIER.ColliderDesc.convexHull(new Float32Array(shape.corners.flat()));
    default:
      return new RAPIER.ColliderDesc(new RAPIER.HalfSpace(xyz(shape.normal)));
  }
}

function bodyOf(body) {
  const { RigidBodyDesc, CoefficientCombineRule } = RAPIER;
  const description =
    body.mass !== null
      ? RigidBodyDesc.dynamic()
      : still(body)
        ? RigidBodyDesc.fixed()
        : RigidBodyDesc.kinematicVelocityBased();
  description
    .setTranslation(...body.position)
    .setRotation(wxyz(body.orientation))
    .setLinvel(...body.velocity)
    .setAngvel(xyz(body.angular_velocity))
    .setCanSleep(false);
  if (body.mass !== null)
    description.setAdditionalMassProperties(body.mass, xyz([0, 0, 0]), xyz(body.inertia), wxyz([1, 0, 0, 0]));
  const made = world.createRigidBody(description);
  // A pair's friction is the product of these square roots; its restitution is the larger.
  const collider = shapeOf(body.shape)
    .setDensity(0)
    .setFriction(Math.sqrt(body.friction))
    .setFrictionCombineRule(CoefficientCombineRule.Multiply)
    .setRestitution(body.restitution)
    .setRestitutionCombineRule(CoefficientCombineRule.Max);
  world.createCollider(collider, made);
  return made;
}

/** A point or direction of the world on a body: its rotation undone. */
function turnedBack({ x: qx, y: qy, z: qz, w }, [x, y, z]) {
  const [tx, ty, tz] = [2 * (qz * y - qy * z), 2 * (qx * z - qz * x), 2 * (qy * x - qx * y)];
  return xyz([x + w * tx + (qz * ty - qy * tz), y + w * ty + (qx * tz - qz * tx), z + w * tz + (qy * tx - qx * ty)]);
}
function pointOn(body, point) {
  const at = body.translation();
  return turnedBack(body.rotation(), [point[0] - at.x, point[1] - at.y, point[2] - at.z]);
}

function open(asked) {
  const { scene } = asked;
  const lacking = scene.joints.find(({ kind }) => kind !== "ball_and_socket" && kind !== "hinge");
  if (lacking) return { plays: false, lacks: lacking.kind.replace("_", " ") };
  world?.free();
  setting = { ...asked, kind: asked.setting };
  world = new RAPIER.World(xyz(scene.gravity));
  bodies = scene.bodies.map(bodyOf);
  let anchor; // the world, where something hangs on it
  const held = (index) =>
    index === null ? (anchor ??= world.createRigidBody(RAPIER.RigidBodyDesc.fixed())) : bodies[index];
  for (const joint of scene.joints) {
    const a = held(joint.a);
    const b = held(joint.b);
    const on = [a, b].map((body) => pointOn(body, joint.anchor));
    const data =
      joint.kind === "hinge"
        ? RAPIER.JointData.revolute(...on, turnedBack(a.rotation(), joint.axis))
        : RAPIER.JointData.spherical(...on);
    world.createImpulseJoint(data, a, b, true).setContactsEnabled(joint.colliding);
  }
  return { plays: true };
}

/** So many steps at once, where the setting divides a step by itself. */
function stepped(steps, h) {
  const parameters = world.integrationParameters;
  const once = setting.kind === "rapier-once";
  world.timestep = once ? steps * h : h;
  if (once) {
    parameters.numSolverIterations = steps > 1 ? steps : setting.sweeps;
    parameters.numInternalPgsIterations = steps > 1 ? setting.sweeps : 1;
  } else if (setting.kind === "rapier-tuned") {
    parameters.numSolverIterations = 1;
    parameters.numInternalPgsIterations = setting.sweeps;
    parameters.contact_natural_frequency = 1 / (8 * h);
    parameters.normalizedAllowedLinearError = 0;
  }
  const calls = once ? Math.min(1, steps) : steps;
  const begin = performance.now();
  for (let i = 0; i < calls; ++i) world.step();
  return (performance.now() - begin) / 1000;
}

function step({ steps, h, put = [], push = [] }) {
  for (const { body, position, orientation, velocity, angular_velocity } of put) {
    bodies[body].setTranslation(xyz(position), true);
    bodies[body].setRotation(wxyz(orientation), true);
    bodies[body].setLinvel(xyz(velocity), true);
    bodies[body].setAngvel(xyz(angular_velocity), true);
  }
  for (const { body, force, torque } of push) {
    bodies[body].addForce(xyz(force), true);
    bodies[body].addTorque(xyz(torque), true);
  }
  const seconds = stepped(steps, h);
  for (const { body } of push) {
    bodies[body].resetForces(true);
    bodies[body].resetTorques(true);
  }
  const states = bodies.map((body) => {
    if (!body.isDynamic()) return null;
    const [p, q, v, w] = [body.translation(), body.rotation(), body.linvel(), body.angvel()];
    return [p.x, p.y, p.z, q.w, q.x, q.y, q.z, v.x, v.y, v.z, w.x, w.y, w.z];
  });
  return { seconds, states };
}

const answers = { settings: () => ({ engine: `Rapier ${RAPIER.version()}, WebAssembly`, settings }), open, step };

for await (const line of createInterface({ input: process.stdin })) {
  const asked = JSON.parse(line);
  process.stdout.write(JSON.stringify(answers[asked.ask](asked)) + "\n");
}
