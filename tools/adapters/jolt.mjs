// Jolt, as it is published for JavaScript: compiled to WebAssembly, in float, on one thread. docs/benchmark.md says what is asked.
import { readFileSync } from "node:fs";
import { createInterface } from "node:readline";
import initJolt from "jolt-physics/wasm-compat";

const Jolt = await initJolt();
const version = JSON.parse(readFileSync(new URL("node_modules/jolt-physics/package.json", import.meta.url))).version;

const settings = [
  { name: "jolt", what: "as it comes: 10 velocity and 2 position sweeps a step", sweeps: false },
  {
    name: "jolt-tuned",
    what: "as many velocity sweeps as are asked, a quarter as many of positions, bounces at any speed, no allowed overlap, no convex radius",
    sweeps: true,
    substeps: 8,
    iterations: 16,
  },
].map((setting) => ({ float: true, ...setting }));

const still = ({ velocity, angular_velocity }) => [...velocity, ...angular_velocity].every((x) => x === 0);

/** Calls `use` with a value of Jolt's, and frees it. */
function lent(value, use) {
  const result = use(value);
  Jolt.destroy(value);
  return result;
}
const vec3 = (v, use) => lent(new Jolt.Vec3(...v), use);
const place = (v, use) => lent(new Jolt.RVec3(...v), use);
const turn = ([w, x, y, z], use) => lent(new Jolt.Quat(x, y, z, w), use);

let jolt, system, bodies, filter;

function shapeOf(shape, radius) {
  switch (shape.kind) {
    case "sphere":
      return new Jolt.SphereShape(shape.radius);
    case "box":
      return vec3(shape.half_extents, (half) => new Jolt.BoxShape(half, Math.min(radius, ...shape.half_extents)));
    case "capsule":
      return new Jolt.CapsuleShape(shape.half_length, shape.radius);
    case "hull": {
      const description = new Jolt.ConvexHullShapeSettings();
      for (const corner of shape.corners) vec3(corner, (point) => description.mPoints.push_back(point));
      description.mMaxConvexRadius = radius;
      return description.Create().Get();
    }
    default:
      return vec3(shape.normal, (normal) =>
        lent(new Jolt.Plane(normal, 0), (plane) => new Jolt.PlaneShape(plane, undefined, 1000)),
      );
  }
}

const [resting, moving] = [0, 1]; // object layers

function bodyOf(body, index, tuned) {
  const type = body.mass !== null ? "Dynamic" : still(body) ? "Static" : "Kinematic";
  const layer = type === "Static" ? resting : moving;
  const shape = shapeOf(body.shape, tuned ? 0 : 0.05); // 0.05 m is what it comes with
  const made = place(body.position, (at) =>
    turn(body.orientation, (to) =>
      lent(new Jolt.BodyCreationSettings(shape, at, to, Jolt[`EMotionType_${type}`], layer), (description) => {
        Object.assign(description, {
          mFriction: body.friction, // of a pair: the geometric mean, and the larger restitution
          mRestitution: body.restitution,
          mLinearDamping: 0,
          mAngularDamping: 0,
          mMaxLinearVelocity: 1e4,
          mMaxAngularVelocity: 1e4,
          mAllowSleeping: false,
          mApplyGyroscopicForce: tuned, // it comes without
        });
        description.mCollisionGroup.SetGroupFilter(filter);
        description.mCollisionGroup.SetGroupID(0);
        description.mCollisionGroup.SetSubGroupID(index);
        if (body.mass !== null) {
          description.mOverrideMassProperties = Jolt.EOverrideMassProperties_MassAndInertiaProvided;
          description.mMassPropertiesOverride.mMass = body.mass;
          vec3(body.inertia, (inertia) => {
            description.mMassPropertiesOverride.mInertia = Jolt.Mat44.prototype.sScaleVec3(inertia);
          });
        }
        return system.GetBodyInterface().CreateBody(description);
      }),
    ),
  );
  system.GetBodyInterface().AddBody(made.GetID(), Jolt.EActivation_Activate);
  if (type !== "Static") {
    vec3(body.velocity, (v) => made.SetLinearVelocity(v));
    vec3(body.angular_velocity, (w) => made.SetAngularVelocity(w));
  }
  return made;
}

function begin(scene) {
  if (jolt) Jolt.destroy(jolt);
  const description = new Jolt.JoltSettings();
  const pairs = new Jolt.ObjectLayerPairFilterTable(2);
  pairs.EnableCollision(resting, moving);
  pairs.EnableCollision(moving, moving);
  const layers = new Jolt.BroadPhaseLayerInterfaceTable(2, 2);
  for (const layer of [resting, moving]) layers.MapObjectToBroadPhaseLayer(layer, new Jolt.BroadPhaseLayer(layer));
  Object.assign(description, {
    mMaxBodies: scene.bodies.length + 2,
    mMaxBodyPairs: 64 + 32 * scene.bodies.length,
    mMaxContactConstraints: 64 + 32 * scene.bodies.length,
    mMaxWorkerThreads: 0,
    mObjectLayerPairFilter: pairs,
    mBroadPhaseLayerInterface: layers,
    mObjectVsBroadPhaseLayerFilter: new Jolt.ObjectVsBroadPhaseLayerFilterTable(layers, 2, pairs, 2),
  });
  jolt = lent(description, (all) => new Jolt.JoltInterface(all)); // it owns the filters
  system = jolt.GetPhysicsSystem();
  vec3(scene.gravity, (gravity) => system.SetGravity(gravity));
}

function open({ setting, sweeps, scene }) {
  const lacking = scene.joints.find(({ kind }) => kind !== "ball_and_socket");
  if (lacking) return { plays: false, lacks: lacking.kind.replace("_", " ") };
  begin(scene);
  const tuned = setting === "jolt-tuned";
  const physics = system.GetPhysicsSettings();
  physics.mAllowSleeping = false;
  if (tuned) {
    physics.mNumVelocitySteps = sweeps;
    physics.mNumPositionSteps = Math.max(1, Math.floor(sweeps / 4));
    physics.mPenetrationSlop = 0;
    physics.mMinVelocityForRestitution = 0;
  }
  system.SetPhysicsSettings(physics);
  filter = new Jolt.GroupFilterTable(scene.bodies.length);
  bodies = scene.bodies.map((body, index) => bodyOf(body, index, tuned));
  for (const joint of scene.joints) {
    const held = (index) => (index === null ? Jolt.Body.prototype.sFixedToWorld : bodies[index]);
    const constraint = lent(new Jolt.PointConstraintSettings(), (description) => {
      description.mSpace = Jolt.EConstraintSpace_WorldSpace;
      place(joint.anchor, (at) => Object.assign(description, { mPoint1: at, mPoint2: at }));
      return description.Create(held(joint.a), held(joint.b));
    });
    system.AddConstraint(constraint);
    if (joint.a !== null && joint.b !== null && !joint.colliding) filter.DisableCollision(joint.a, joint.b);
  }
  return { plays: true };
}

function step({ steps, h, put = [], push = [] }) {
  const interface_ = system.GetBodyInterface();
  for (const { body, position, orientation, velocity, angular_velocity } of put) {
    const id = bodies[body].GetID();
    place(position, (at) =>
      turn(orientation, (to) => interface_.SetPositionAndRotation(id, at, to, Jolt.EActivation_Activate)),
    );
    if (bodies[body].IsStatic()) continue;
    vec3(velocity, (v) => bodies[body].SetLinearVelocity(v));
    vec3(angular_velocity, (w) => bodies[body].SetAngularVelocity(w));
  }
  let seconds = 0;
  for (let i = 0; i < steps; ++i) {
    for (const { body, force, torque } of push) {
      vec3(force, (f) => bodies[body].AddForce(f));
      vec3(torque, (t) => bodies[body].AddTorque(t));
    }
    const begun = performance.now();
    jolt.Step(h, 1);
    seconds += (performance.now() - begun) / 1000;
  }
  const states = bodies.map((body) => {
    if (!body.IsDynamic()) return null;
    const [p, q] = [body.GetCenterOfMassPosition(), body.GetRotation()];
    const state = [p.GetX(), p.GetY(), p.GetZ(), q.GetW(), q.GetX(), q.GetY(), q.GetZ()];
    for (const v of [body.GetLinearVelocity(), body.GetAngularVelocity()]) state.push(v.GetX(), v.GetY(), v.GetZ());
    return state;
  });
  return { seconds, states };
}

const answers = { settings: () => ({ engine: `Jolt (jolt-physics ${version}), WebAssembly`, settings }), open, step };

for await (const line of createInterface({ input: process.stdin })) {
  const asked = JSON.parse(line);
  process.stdout.write(JSON.stringify(answers[asked.ask](asked)) + "\n");
}
