#include <cmath>

#include "pushback/common/world/situations.h"
#include "pushback/tools/measure/adapters/scene_json.h"
#include "pushback/tools/measure/outside/scene.h"

namespace pushback::outside {

namespace {

/// Degrees: of a cone whose mean height and mean radius are the pile's. A cone's are H/4 and R/2.
Real slope_of_cone(const World& now) {
  Vec3 middle = Vec3::Zero();
  Real count = 0, radius = 0;
  for (const Body& body : now.bodies)
    if (body.movable()) middle += body.position, ++count;
  middle /= count;
  for (const Body& body : now.bodies)
    if (body.movable()) radius += std::hypot(body.position.x() - middle.x(), body.position.z() - middle.z()) / count;
  return std::atan(2 * middle.y() / radius) * 180 / pi;
}

// ---- ragdolls ------------------------------------------------------------------------------------------------------------

/// Adds MuJoCo's humanoid, turned and moved, to a scene that already has its ground.
void add_humanoid(Json& scene, const Json& humanoid, const Quat& turn, const Vec3& move) {
  const auto before = static_cast<unsigned>(scene["bodies"].size()) - 1;
  for (std::size_t i = 1; i < humanoid["bodies"].size(); ++i) {
    Json body = humanoid["bodies"][i];
    body["position"] = json_of(Vec3(turn * vec3_of(body["position"]) + move));
    Quat own = Quat::Identity();
    if (const Json q = body.value("orientation", Json()); !q.is_null()) own = Quat(q[0], q[1], q[2], q[3]);
    body["orientation"] = json_of((turn * own).normalized());
    scene["bodies"].push_back(body);
  }
  for (Json joint : humanoid["joints"]) {
    for (const char* end : {"a", "b"}) joint[end] = joint[end].get<unsigned>() + before;
    if (joint.contains("anchor")) joint["anchor"] = json_of(Vec3(turn * vec3_of(joint["anchor"]) + move));
    for (const char* axis : {"axis", "axis_b"})
      if (joint.contains(axis)) joint[axis] = json_of(Vec3(turn * vec3_of(joint[axis])));
    scene["joints"].push_back(joint);
  }
}

/// Ten piles of ten, 4 m apart, each humanoid 0.6 m above the other and turned by a tenth of a turn, as in Jolt's scene.
void ragdolls(World& world) {
  const Json humanoid = Json::parse(scene_text("humanoid"));
  Json scene = humanoid;
  scene["bodies"] = Json::array({humanoid["bodies"][0]});
  scene["joints"] = Json::array();
  for (int i = 0; i < 100; ++i) {
    const Quat lying(Eigen::AngleAxis<Real>(pi / 2, Vec3::UnitZ()));
    const Quat turn(Eigen::AngleAxis<Real>(2 * pi * Real(i % 10) / 10, Vec3::UnitY()));
    const int across = 4 * (i / 10 % 5), along = 4 * (i / 50);
    add_humanoid(scene, humanoid, turn * lying, {Real(across), Real(0.6) * Real(i % 10 + 1), Real(along)});
  }
  world = scene_of(scene);
}

// ---- hulls ---------------------------------------------------------------------------------------------------------------

/// The source's own random numbers: one hull of 32 points on a sphere of 2 m.
std::vector<Vec3> points_of_hull() {
  std::uint32_t state = 42;
  const auto next = [&state] {
    state = state * 2147001325U + 715136305U;
    return Real(state & 0xffffU) / 65535 - Real(0.5);
  };
  std::vector<Vec3> points;
  while (points.size() < 32) {
    const Real x = next(), y = next(), z = next();
    const Vec3 point(x, y, z);
    if (point.squaredNorm() <= Real(0.25)) points.push_back(2 * point.normalized());
  }
  return points;
}

/// 32 of its 80 layers of 64.
void hulls(World& world) {
  world.gravity = {0, -10, 0};
  world.add(ground().rough(Real(0.6)));
  const Body one = hull(points_of_hull(), 25000);  // some 1000 kg/m^3
  for (int i = 0; i < 2048; ++i) {
    Body next = one;
    const int layer = i / 64, along = i / 8 % 8;
    const Vec3 place(4 * Real(i % 8) - 16, 2 + 4 * Real(layer), 4 * Real(along) - 16);
    world.add(next.at(place + one.position).rough(Real(0.6)));
  }
}

// ---- drum ----------------------------------------------------------------------------------------------------------------

constexpr Real drum_speed = 25 * pi / 180;  // rad/s

/// Immovable, from z = -10 to 10: solid between two radii and two angles.
void add_panel(World& world, Real inner, Real outer, Real from, Real to) {
  std::vector<Vec3> points;
  for (const Real z : {-10, 10})
    for (const Real r : {inner, outer})
      for (const Real angle : {from, to}) points.push_back({r * std::cos(angle), r * std::sin(angle), z});
  world.add(hull(points, 1).fixed().rough(Real(0.6)));
}

/// n x n x n cubes, `apart` m from centre to centre, in a drum of 36 panels. The drum's axis is the axis z.
void drum(World& world, bool paddles, int n, Real half, Real apart) {
  world.gravity = {0, -10, 0};
  world.add(half_space({0, 1, 0}).at({0, -21, 0}).rough(Real(0.6)));
  for (int i = 0; i < 36; ++i) {
    const Real from = Real(i) * pi / 18, to = from + pi / 18;
    add_panel(world, 16, 18, from - pi / 180, to + pi / 180);
    if (paddles && i % 9 == 0) add_panel(world, 14, 16, from, to);
  }
  for (int i = 0; i < n * n * n; ++i) {
    const int x = i / n / n - n / 2, y = i / n % n - n / 2, z = i % n - n / 2;
    world.add(box(Vec3::Constant(half), 8000 * half * half * half)
                  .rough(Real(0.6))
                  .at(apart * Vec3(Real(x), Real(y), Real(z))));
  }
}

void turn_drum(World& world, const World& start, Real dt) {
  const Quat turn(Eigen::AngleAxis<Real>(drum_speed * (world.time + dt), Vec3::UnitZ()));
  for (std::size_t i = 0; i < start.bodies.size(); ++i)
    if (std::holds_alternative<Hull>(start.bodies[i].shape))
      world.bodies[i].moved_to(turn * start.bodies[i].position, turn * start.bodies[i].orientation, dt);
}

}  // namespace

const std::vector<LargeScene>& large_scenes() {
  static const std::vector<LargeScene> all{
      {.name = "boxes_512", .fill = [](World& world) { heap(world, 8, 8, -4); }, .slope = slope_of_cone},
      {.name = "boxes_4000", .fill = [](World& world) { heap(world, 20, 10, -10); }, .slope = slope_of_cone},
      {.name = "ragdolls_100", .fill = ragdolls},
      {.name = "hulls_2048", .fill = hulls},
      {.name = "drum_with_paddles",
       .fill = [](World& world) { drum(world, true, 8, Real(0.2), Real(0.8)); },
       .drive = turn_drum,
       .drum = drum_speed},
      {.name = "smooth_drum",
       .fill = [](World& world) { drum(world, false, 10, Real(0.5), Real(1.5)); },
       .drive = turn_drum,
       .drum = drum_speed}};
  return all;
}

const LargeScene* large_scene(const std::string& name) {
  for (const LargeScene& scene : large_scenes())
    if (scene.name == name) return &scene;
  return nullptr;
}

}  // namespace pushback::outside
