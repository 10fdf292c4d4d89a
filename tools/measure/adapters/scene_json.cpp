#include "pushback/tools/measure/adapters/scene_json.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>

#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/chapters/13_joints/hinge.h"
#include "pushback/chapters/15_limits_motors_springs/limits.h"
#include "pushback/chapters/15_limits_motors_springs/motor.h"
#include "pushback/common/basics/files.h"
#include "pushback/common/basics/input.h"
#include "pushback/tools/measure/peers/engine.h"
#include "pushback/tools/measure/peers/joint_shape.h"

namespace pushback {

Json json_of(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

Vec3 vec3_of(const Json& json) {
  return {json[0].get<Real>(), json[1].get<Real>(), json[2].get<Real>()};
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

/// In the order of JointShape's kinds: the word, and what is said of such a joint beside whom it joins.
struct JointWords {
  const char* kind;
  std::vector<std::string> fields;
};
const std::array<JointWords, 6> joint_words{{{"ball_and_socket", {"anchor"}},
                                             {"hinge", {"anchor", "axis"}},
                                             {"angle_limits", {"axis", "low", "high"}},
                                             {"twist_limits", {"axis", "low", "high"}},
                                             {"cone_limit", {"axis", "axis_b", "high"}},
                                             {"motor", {"axis", "speed", "torque"}}}};

Json joint_json(const World& world, const Joint& joint) {
  const JointShape shape = shape_of(world, joint);
  const JointWords& words = joint_words[static_cast<std::size_t>(shape.kind)];
  const Json numbers{{"anchor", json_of(shape.anchor_b)},
                     {"axis", json_of(shape.axis)},
                     {"axis_b", json_of(shape.axis_b)},
                     {"low", shape.low},
                     {"high", shape.high},
                     {"speed", shape.speed},
                     {"torque", shape.torque}};
  Json json{
      {"kind", words.kind}, {"a", index_json(joint.a)}, {"b", index_json(joint.b)}, {"colliding", joint.colliding}};
  for (const std::string& field : words.fields) json[field] = numbers[field];
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

// SI units. Whatever a scene has between these, steps end soon, and with finite numbers.
constexpr Real largest = 1e6;           // of a length, an acceleration, an angle
constexpr Real fastest = 1e5;           // also of a spin
constexpr Real smallest_length = 1e-9;  // also of an axis
constexpr Real smallest_mass = 1e-12, largest_mass = 1e12;
constexpr Real smallest_inertia = 1e-30, largest_inertia = 1e24;  // of such masses and lengths
constexpr Real largest_torque = 1e12;

/// An object that is read, and how it is called in what is said of it: "body 3".
class From {
 public:
  From(const Json& json, std::string name) : json_(json), name_(std::move(name)) {
    if (!json.is_object()) throw InvalidInput(fmt::format("{} is {}: an object is needed", name_, json.dump()));
  }
  bool has(const char* field) const { return json_.contains(field); }
  bool is_null(const char* field) const { return has(field) && json_[field].is_null(); }
  /// What is misspelt would be left out.
  void has_only(const std::vector<std::string>& fields) const {
    for (const auto& [field, value] : json_.items())
      if (std::find(fields.begin(), fields.end(), field) == fields.end())
        throw InvalidInput(
            fmt::format("{} has the field '{}': only {} are allowed", name_, field, fmt::join(fields, ", ")));
  }
  [[noreturn]] void wrong(const char* field, const std::string& needed) const {
    throw InvalidInput(fmt::format("{} of {} is {}: {} is needed", field, name_, json_[field].dump(), needed));
  }
  From object(const char* field) const { return {of(field), fmt::format("{} of {}", field, name_)}; }
  const Json& list(const char* field) const { return of(field, &Json::is_array, "a list"); }
  std::string word(const char* field) const { return of(field, &Json::is_string, "a word"); }
  bool yes(const char* field) const { return of(field, &Json::is_boolean, "true or false"); }
  Real number(const char* field, Real least, Real most) const {
    if (!is_number(of(field), least, most)) wrong(field, fmt::format("a number from {} to {}", least, most));
    return json_[field].get<Real>();
  }
  Real length(const char* field) const { return number(field, smallest_length, largest); }
  /// Of one of so many bodies, or null: the world.
  int index(const char* field, std::size_t bodies) const {
    if (of(field).is_null()) return the_world;
    if (!json_[field].is_number_unsigned() || json_[field].get<std::uint64_t>() >= bodies)
      wrong(field, fmt::format("the index of a body, from 0 to {}, or null for the world,", bodies - 1));
    return json_[field];
  }
  Vec3 vector(const char* field, Real least = -largest, Real most = largest) const {
    return vector_of(of(field), field, least, most);
  }
  std::vector<Vec3> vectors(const char* field) const {
    std::vector<Vec3> all;
    for (const Json& one : list(field)) all.push_back(vector_of(one, field, -largest, largest));
    return all;
  }
  Vec3 direction(const char* field) const {
    const Vec3 v = vector(field);
    if (v.norm() < smallest_length) wrong(field, "a vector that is not 0");
    return v;
  }
  Quat quaternion(const char* field) const {
    const Json& q = of(field);
    const Quat read = are_numbers(q, 4, -2, 2) ? Quat(q[0], q[1], q[2], q[3]) : Quat(0, 0, 0, 0);
    if (std::abs(read.norm() - 1) > Real(0.01)) wrong(field, "four numbers, w x y z, of length 1,");
    return read.normalized();
  }

 private:
  const Json& of(const char* field) const {
    if (!has(field)) throw InvalidInput(fmt::format("{} has no {}", name_, field));
    return json_[field];
  }
  const Json& of(const char* field, bool (Json::*is)() const noexcept, const char* needed) const {
    if (!(of(field).*is)()) wrong(field, needed);
    return json_[field];
  }
  static bool is_number(const Json& json, Real least, Real most) {
    return json.is_number() && json.get<Real>() >= least && json.get<Real>() <= most;
  }
  static bool are_numbers(const Json& list, std::size_t count, Real least, Real most) {
    return list.is_array() && list.size() == count &&
           std::all_of(list.begin(), list.end(), [&](const Json& x) { return is_number(x, least, most); });
  }
  Vec3 vector_of(const Json& v, const char* field, Real least, Real most) const {
    if (!are_numbers(v, 3, least, most)) wrong(field, fmt::format("three numbers from {} to {}", least, most));
    return vec3_of(v);
  }

  const Json& json_;
  std::string name_;
};

/// In the order of the kinds of Shape: the word for a kind, its fields, and a body of this shape and mass.
struct ShapeWords {
  const char* kind;
  std::vector<std::string> fields;
  Body (*made)(const From& from, Real mass);
};
const std::array<ShapeWords, 5> shape_words{
    {{"sphere", {"radius"}, [](const From& from, Real mass) { return sphere(from.length("radius"), mass); }},
     {"box",
      {"half_extents"},
      [](const From& from, Real mass) { return box(from.vector("half_extents", smallest_length), mass); }},
     {"capsule",
      {"radius", "half_length"},
      [](const From& from, Real mass) { return capsule(from.length("radius"), from.length("half_length"), mass); }},
     {"hull", {"corners"}, [](const From& from, Real mass) { return hull(from.vectors("corners"), mass); }},
     {"half_space", {"normal"}, [](const From& from, Real) { return half_space(from.direction("normal")); }}}};

/// Finds the entry of a list for the kind of `from`, which may contain these fields and those of the entry, and no others.
template <class List>
const auto& of_kind(const List& list, const From& from, const std::string& needed, std::vector<std::string> fields) {
  const std::string word = from.word("kind");
  const auto found = std::find_if(list.begin(), list.end(), [&](const auto& one) { return one.kind == word; });
  if (found == list.end()) from.wrong("kind", needed);
  fields.insert(fields.end(), found->fields.begin(), found->fields.end());
  from.has_only(fields);
  return *found;
}

/// Principal moments, of which none is larger than the sum of the other two: I_x + I_y - I_z = 2 ∫ z² dm.
Vec3 inertia_from(const From& from) {
  const Vec3 inertia = from.vector("inertia", smallest_inertia, largest_inertia);
  if (2 * inertia.maxCoeff() > (1 + Real(1e-6)) * inertia.sum())
    from.wrong("inertia", "three numbers, none larger than the sum of the other two,");
  return inertia;
}

Body body_from(const From& from) {
  from.has_only({"position", "orientation", "velocity", "angular_velocity", "mass", "inertia", "friction",
                 "restitution", "shape"});
  const bool moves = !from.is_null("mass");
  const Real mass = moves ? from.number("mass", smallest_mass, largest_mass) : 1;  // what does not move loses it
  const From shape = from.object("shape");
  Body body = of_kind(shape_words, shape, "sphere, box, capsule, hull or half_space", {"kind"}).made(shape, mass);
  if (moves && std::holds_alternative<HalfSpace>(body.shape))
    from.wrong("mass", "null, since a half-space never moves,");
  if (!moves && from.has("inertia") && !from.is_null("inertia")) from.wrong("inertia", "null, as for the mass,");
  const bool is_hull = std::holds_alternative<Hull>(body.shape);
  if (!moves) {
    body.fixed();
  } else if (from.has("inertia")) {
    const Vec3 inertia = inertia_from(from);
    if (!is_hull) body.principal_inverse_inertia = inertia.cwiseInverse();
  }
  // A hull as it comes has its own axes: the file's turn comes after.
  const Quat turn = from.has("orientation") ? from.quaternion("orientation") : Quat::Identity();
  body.oriented(turn * body.orientation).at(from.vector("position") + turn * (is_hull ? body.position : Vec3::Zero()));
  if (from.has("velocity")) body.moving(from.vector("velocity", -fastest, fastest));
  if (from.has("angular_velocity")) body.spinning(from.vector("angular_velocity", -fastest, fastest));
  if (from.has("friction")) body.rough(from.number("friction", 0, largest));
  if (from.has("restitution")) body.bouncy(from.number("restitution", 0, 1));
  return body;
}

Joint joint_from(const From& from, const World& world) {
  const JointWords& words =
      of_kind(joint_words, from, "ball_and_socket, hinge, angle_limits, twist_limits, cone_limit or motor",
              {"kind", "a", "b", "colliding"});
  const int a = from.index("a", world.bodies.size()), b = from.index("b", world.bodies.size());
  const auto angle = [&](const char* field) { return from.number(field, -largest, largest); };
  switch (static_cast<JointShape::Kind>(&words - joint_words.data())) {
    case JointShape::ball_and_socket:
      return ball_and_socket(world, a, b, from.vector("anchor"));
    case JointShape::hinge:
      return hinge(world, a, b, from.vector("anchor"), from.direction("axis"));
    case JointShape::angle_limits:
      return angle_limits(world, a, b, from.direction("axis"), angle("low"), angle("high"));
    case JointShape::twist_limits:
      return twist_limits(world, a, b, from.direction("axis"), angle("low"), angle("high"));
    case JointShape::cone_limit:
      return cone_limit(world, a, b, from.direction("axis"), from.direction("axis_b"), angle("high"));
    case JointShape::motor:
      break;
  }
  return motor_at_speed(world, a, b, from.direction("axis"), from.number("speed", -fastest, fastest),
                        from.number("torque", 0, largest_torque));
}

/// Calls `make` for one entry of a list. Its error messages begin with the name of the entry.
template <class Make>
auto made(const std::string& name, const Json& json, const Make& make) {
  try {
    return make(From(json, name));
  } catch (const InvalidInput& problem) {
    const std::string said = problem.what();
    throw InvalidInput(said.find(name) == std::string::npos ? name + ": " + said : said);
  }
}

/// Reads a file, and refuses what Json::parse would let pass: a field that is there twice, and nesting so deep that the
/// destructor would overflow the stack.
class SceneParser {
 public:
  Json parsed(const std::string& text) {
    return Json::parse(text, [this](int depth, Json::parse_event_t event, Json& at) {
      read(depth, event, at);
      return true;
    });
  }

 private:
  static constexpr int deepest = 16;
  struct Open {
    std::string name = {};  // of an object or list: "body 3"
    bool list = false;
    std::string field = {};  // of an object: the latest; of a list: its own
    std::set<std::string> fields = {};
    int items = 0;  // of a list, read so far
  };

  void read(int depth, Json::parse_event_t event, const Json& at) {
    using Event = Json::parse_event_t;
    Open& in = open_.back();
    if (event == Event::key) {
      in.field = at.get<std::string>();
      if (!in.fields.insert(in.field).second)
        throw InvalidInput(fmt::format("{} has the field '{}' twice: once is needed", in.name, in.field));
    } else if (event == Event::object_start || event == Event::array_start) {
      if (depth >= deepest)
        throw InvalidInput(fmt::format("{} is nested {} deep: at most {} is allowed", in.name, depth, deepest));
      open_.push_back({name_in(in), event == Event::array_start, in.field});
    } else {
      if (event != Event::value) open_.pop_back();
      ++open_.back().items;
    }
  }
  std::string name_in(const Open& in) const {
    if (open_.size() == 1) return "the scene";
    if (!in.list) return fmt::format("{} of {}", in.field, in.name);
    return fmt::format("{} {}", in.field == "bodies" ? "body" : in.field == "joints" ? "joint" : in.field, in.items);
  }

  std::vector<Open> open_{{}};  // the first one is around all
};

}  // namespace

World scene_of(const Json& json) {
  const From from(json, "the scene");
  from.has_only({"gravity", "bodies", "joints"});
  World world;
  if (from.has("gravity")) world.gravity = from.vector("gravity");
  for (const Json& one : from.list("bodies"))
    world.add(made(fmt::format("body {}", world.bodies.size()), one, body_from));
  if (world.bodies.empty()) from.wrong("bodies", "a list of one body or more");
  if (!from.has("joints")) return world;
  for (const Json& one : from.list("joints"))
    world.joints.push_back(made(fmt::format("joint {}", world.joints.size()), one, [&](const From& joint) {
      Joint read = joint_from(joint, world);
      if (joint.has("colliding")) read.colliding = joint.yes("colliding");
      return read;
    }));
  return world;
}

World scene_in(const std::filesystem::path& file) {
  Json json;
  try {
    json = SceneParser().parsed(read_text_file(file));
  } catch (const Json::exception& problem) {
    throw InvalidInput(fmt::format("{} is no JSON: {}", file.string(), problem.what()));
  }
  return scene_of(json);
}

}  // namespace pushback
