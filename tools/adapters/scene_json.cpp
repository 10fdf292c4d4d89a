#include "pushback/tools/adapters/scene_json.h"

#include <fmt/format.h>

#include <algorithm>

#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/chapters/13_joints/hinge.h"
#include "pushback/chapters/15_limits_motors_springs/limits.h"
#include "pushback/chapters/15_limits_motors_springs/motor.h"
#include "pushback/common/basics/files.h"
#include "pushback/common/basics/input.h"
#include "pushback/tools/peers/engine.h"
#include "pushback/tools/peers/joint_shape.h"

namespace pushback {

Json json_of(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

Json json_of(const Quat& q) {
  return {q.w(), q.x(), q.y(), q.z()};
}

namespace {

Json shape_json(const Shape& shape) {
  if (const auto* ball = std::get_if<Sphere>(&shape)) return {{"kind", "sphere"}, {"radius", ball->radius}};
  if (const auto* box = std::get_if<Box>(&shape))
    return {{"kind", "box"}, {"half_extents", json_of(box->half_extents)}};
  if (const auto* capsule = std::get_if<Capsule>(&shape))
    return {{"kind", "capsule"}, {"radius", capsule->radius}, {"half_length", capsule->half_length}};
  if (const auto* half_space = std::get_if<HalfSpace>(&shape))
    return {{"kind", "half_space"}, {"normal", json_of(half_space->normal)}};
  Json corners = Json::array();
  for (const Vec3& corner : std::get<Hull>(shape).solid->corners) corners.push_back(json_of(corner));
  return {{"kind", "hull"}, {"corners", corners}};
}

Json index_json(int index) {
  return index == the_world ? Json() : Json(index);
}

Json joint_json(const World& world, const Joint& joint) {
  const JointShape shape = shape_of(world, joint);
  Json json{{"kind", ""}, {"a", index_json(joint.a)}, {"b", index_json(joint.b)}, {"colliding", joint.colliding}};
  switch (shape.kind) {
    case JointShape::ball_and_socket:
    case JointShape::hinge:
      json["kind"] = shape.kind == JointShape::hinge ? "hinge" : "ball_and_socket";
      json["anchor"] = json_of(shape.anchor_b);
      if (shape.kind == JointShape::hinge) json["axis"] = json_of(shape.axis);
      break;
    case JointShape::angle_limits:
    case JointShape::twist_limits:
      json["kind"] = shape.kind == JointShape::angle_limits ? "angle_limits" : "twist_limits";
      json["axis"] = json_of(shape.axis);
      json["low"] = shape.low;
      json["high"] = shape.high;
      break;
    case JointShape::cone_limit:
      json["kind"] = "cone_limit";
      json["axis"] = json_of(shape.axis);
      json["axis_b"] = json_of(shape.axis_b);
      json["high"] = shape.high;
      break;
    case JointShape::motor:
      json["kind"] = "motor";
      json["axis"] = json_of(shape.axis);
      json["speed"] = shape.speed;
      json["torque"] = shape.torque;
  }
  return json;
}

}  // namespace

Json state_json(const Body& body) {
  return {{"body", body.index},
          {"position", json_of(body.position)},
          {"orientation", json_of(body.orientation)},
          {"velocity", json_of(body.velocity)},
          {"angular_velocity", json_of(body.angular_velocity)}};
}

Json scene_json(const World& world) {
  Json bodies = Json::array(), joints = Json::array();
  for (const Body& body : world.bodies) {
    check_plain(body);
    Json json = state_json(body);
    json.erase("body");
    json["mass"] = body.movable() ? Json(1 / body.inverse_mass) : Json();
    json["inertia"] = body.movable() ? json_of(Vec3(body.principal_inverse_inertia.cwiseInverse())) : Json();
    json["friction"] = body.friction;
    json["restitution"] = body.restitution;
    json["shape"] = shape_json(body.shape);
    bodies.push_back(json);
  }
  for (const Joint& joint : world.joints) joints.push_back(joint_json(world, joint));
  return {{"gravity", json_of(world.gravity)}, {"bodies", bodies}, {"joints", joints}};
}

namespace {

/// An object that is read, and how it is called in what is said of it: "body 3".
class From {
 public:
  From(const Json& json, std::string name) : json_(json), name_(std::move(name)) {
    if (!json.is_object()) throw InvalidInput(fmt::format("{} is {}: an object is needed", name_, json.dump()));
  }
  bool has(const char* field) const { return json_.contains(field); }
  bool is_null(const char* field) const { return has(field) && json_[field].is_null(); }
  const Json& list(const char* field) const {
    if (!of(field).is_array()) wrong(field, "a list");
    return json_[field];
  }
  From object(const char* field) const { return {of(field), fmt::format("{} of {}", field, name_)}; }
  std::string word(const char* field) const {
    if (!of(field).is_string()) wrong(field, "a word");
    return json_[field];
  }
  Real number(const char* field) const {
    if (!of(field).is_number()) wrong(field, "a number");
    return json_[field].get<Real>();
  }
  bool yes(const char* field) const {
    if (!of(field).is_boolean()) wrong(field, "true or false");
    return json_[field];
  }
  /// The place of a body, or null: the world.
  int index(const char* field) const {
    if (of(field).is_null()) return the_world;
    if (!json_[field].is_number_unsigned()) wrong(field, "the place of a body, or null for the world");
    return json_[field];
  }
  Vec3 vector(const char* field) const {
    of(field);
    return vector_of(json_[field], field);
  }
  Quat quaternion(const char* field) const {
    const Json& q = of(field);
    if (!q.is_array() || q.size() != 4 || !std::all_of(q.begin(), q.end(), [](const Json& x) { return x.is_number(); }))
      wrong(field, "four numbers, w x y z,");
    return Quat(q[0], q[1], q[2], q[3]);
  }
  std::vector<Vec3> vectors(const char* field) const {
    std::vector<Vec3> all;
    for (const Json& one : list(field)) all.push_back(vector_of(one, field));
    return all;
  }
  [[noreturn]] void wrong(const char* field, const std::string& needed) const {
    throw InvalidInput(fmt::format("{} of {} is {}: {} is needed", field, name_, json_[field].dump(), needed));
  }

 private:
  const Json& of(const char* field) const {
    if (!has(field)) throw InvalidInput(fmt::format("{} has no {}", name_, field));
    return json_[field];
  }
  Vec3 vector_of(const Json& v, const char* field) const {
    if (!v.is_array() || v.size() != 3 || !std::all_of(v.begin(), v.end(), [](const Json& x) { return x.is_number(); }))
      wrong(field, "three numbers");
    return {v[0].get<Real>(), v[1].get<Real>(), v[2].get<Real>()};
  }

  const Json& json_;
  std::string name_;
};

/// One that nothing moves gets any mass, and loses it.
Body body_of_shape(const From& from, Real mass) {
  const std::string kind = from.word("kind");
  if (kind == "sphere") return sphere(from.number("radius"), mass);
  if (kind == "box") return box(from.vector("half_extents"), mass);
  if (kind == "capsule") return capsule(from.number("radius"), from.number("half_length"), mass);
  if (kind == "hull") return hull(from.vectors("corners"), mass);
  if (kind == "half_space") return half_space(from.vector("normal"));
  from.wrong("kind", "sphere, box, capsule, hull or half_space");
}

Body body_from(const From& from) {
  const bool moves = !from.is_null("mass");
  const Real mass = moves ? from.number("mass") : 1;
  Body body = body_of_shape(from.object("shape"), mass);
  const bool is_hull = std::holds_alternative<Hull>(body.shape);
  if (!moves) body.fixed();
  else if (!is_hull && from.has("inertia")) body.principal_inverse_inertia = from.vector("inertia").cwiseInverse();
  // A hull as it comes has its own axes: the file's turn comes after.
  const Quat turn = from.has("orientation") ? from.quaternion("orientation") : Quat::Identity();
  body.oriented(turn * body.orientation).at(from.vector("position") + turn * (is_hull ? body.position : Vec3::Zero()));
  if (from.has("velocity")) body.moving(from.vector("velocity"));
  if (from.has("angular_velocity")) body.spinning(from.vector("angular_velocity"));
  if (from.has("friction")) body.rough(from.number("friction"));
  if (from.has("restitution")) body.bouncy(from.number("restitution"));
  return body;
}

Joint joint_from(const From& from, const World& world) {
  const std::string kind = from.word("kind");
  const int a = from.index("a"), b = from.index("b");
  if (kind == "ball_and_socket") return ball_and_socket(world, a, b, from.vector("anchor"));
  if (kind == "hinge") return hinge(world, a, b, from.vector("anchor"), from.vector("axis"));
  if (kind == "angle_limits")
    return angle_limits(world, a, b, from.vector("axis"), from.number("low"), from.number("high"));
  if (kind == "twist_limits")
    return twist_limits(world, a, b, from.vector("axis"), from.number("low"), from.number("high"));
  if (kind == "cone_limit")
    return cone_limit(world, a, b, from.vector("axis"), from.vector("axis_b"), from.number("high"));
  if (kind == "motor")
    return motor_at_speed(world, a, b, from.vector("axis"), from.number("speed"), from.number("torque"));
  from.wrong("kind", "ball_and_socket, hinge, angle_limits, twist_limits, cone_limit or motor");
}

}  // namespace

World scene_of(const Json& json) {
  const From from(json, "the scene");
  World world;
  if (from.has("gravity")) world.gravity = from.vector("gravity");
  for (const Json& one : from.list("bodies")) {
    const std::string name = fmt::format("body {}", world.bodies.size());
    try {
      world.add(body_from(From(one, name)));
    } catch (const InvalidInput& problem) {
      const std::string said = problem.what();
      throw InvalidInput(said.find(name) == std::string::npos ? name + ": " + said : said);
    }
  }
  if (!from.has("joints")) return world;
  for (const Json& one : from.list("joints")) {
    const From joint(one, fmt::format("joint {}", world.joints.size()));
    world.joints.push_back(joint_from(joint, world));
    if (joint.has("colliding")) world.joints.back().colliding = joint.yes("colliding");
  }
  return world;
}

World scene_in(const std::filesystem::path& file) {
  Json json;
  try {
    json = Json::parse(read_text_file(file));
  } catch (const Json::exception& problem) {
    throw InvalidInput(fmt::format("{} is no JSON: {}", file.string(), problem.what()));
  }
  return scene_of(json.is_object() && json.contains("scene") ? json["scene"] : json);
}

}  // namespace pushback
