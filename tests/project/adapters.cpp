// Engines that others enter: what they are asked, and what they may answer.
#include <cstdlib>

#include "pushback/chapters/13_joints/hinge.h"
#include "pushback/chapters/15_limits_motors_springs/limits.h"
#include "pushback/chapters/15_limits_motors_springs/motor.h"
#include "pushback/common/basics/files.h"
#include "pushback/common/bodies/random.h"
#include "pushback/tools/measure/adapters/scene_json.h"
#include "pushback/tools/measure/hard_cases/hard_case.h"
#include "pushback/tools/measure/peers/joint_shape.h"
#include "pushback/tools/measure/study/every_motion.h"
#include "pushback/tools/measure/study/ours.h"
#include "tests/project/jointed.h"
#include "tests/support/call.h"
#include "tests/support/complaint.h"

using namespace pushback;

namespace {

struct InEnvironment {
  InEnvironment(const char* variable, const std::string& value) : name(variable) { setenv(name, value.c_str(), 1); }
  ~InEnvironment() { unsetenv(name); }
  InEnvironment(const InEnvironment&) = delete;
  InEnvironment& operator=(const InEnvironment&) = delete;
  const char* name;
};

}  // namespace

TEST_CASE("what an adapter says of a motion is what the engine behind it does, to the last bit", "[slow]") {
  const InEnvironment ours("PUSHBACK_ADAPTER", OURS_PROGRAM);
  for (const Motion& motion : every_motion()) {
    const Ended played = call_program(MOTION_PROGRAM, motion.name + " ours/2/4 ours/4/2 --at-least 0", 60);
    INFO(motion.name << ": " << played.err);
    if (has_conveyor(motion)) {  // the question has no words for it
      CHECK(played.status == 2);
      CHECK(contains(played.err, "none plays conveyor"));
      continue;
    }
    REQUIRE(played.status == 0);
    const auto lines = lines_of(played.out);
    REQUIRE(lines.size() == 2);
    const auto truth = motion.truth(motion.frames());
    for (const auto& [line, setting] : {std::pair{lines[0], Setting{2, 4}}, {lines[1], Setting{4, 2}}}) {
      const Method ours_here{.name = "ours", .title = "", .begin = by_ours(Jointed{})};
      const double error = play(motion, truth, ours_here, setting, {.at_least = 0}).error;
      CHECK(contains(line, fmt::format(" error {:.4e} ", error)));
      CHECK(contains(line, " row-solves –"));
    }
  }
}

TEST_CASE("an adapter that answers wrongly is told what was asked, what it said and what is needed") {
  const InEnvironment ours("PUSHBACK_ADAPTER", OURS_PROGRAM);
  for (const auto& [defect, said] : {std::pair{"ends", "ended without an answer"},
                                     {"hangs", "gave no answer within 20 s"},
                                     {"talks", "an object in JSON, on a line is needed"},
                                     {"few", "one of 13 numbers for each of the 2 bodies"},
                                     {"short", "one of 13 numbers for each of the 2 bodies"},
                                     {"slow", "which is what the answer took, is needed"},
                                     {"nameless", "\"name\": \"a word\""}}) {
    const InEnvironment wrong("ADAPTER_DEFECT", defect);
    const Ended ended = call_program(MOTION_PROGRAM, "bounce ours/1/1", 60);
    INFO(defect << ": " << ended.out << ended.err);
    CHECK(ended.status == 1);
    CHECK(ended.out.empty());
    CHECK(contains(ended.err, said));
  }
  const InEnvironment wrong("ADAPTER_DEFECT", "words");  // no number is NaN: the body is lost
  CHECK(contains(call_program(MOTION_PROGRAM, "bounce ours/1/1").out, " error lost "));
}

TEST_CASE("what is no adapter is refused, with what is allowed") {
  Scratch scratch;
  write_text_file(scratch / "text.txt", "hello");
  for (const auto& [file, said] :
       {std::pair{(scratch / "none.mjs").string(), std::string("the name of a file is needed")},
        {(scratch / "text.txt").string(), std::string("ends in .mjs, .js or .py")}}) {
    const InEnvironment named("PUSHBACK_ADAPTER", file);
    const Ended ended = call_program(MOTION_PROGRAM, "");
    INFO(file << ": " << ended.err);
    CHECK(ended.status == 2);
    CHECK(contains(ended.err, said));
    CHECK(contains(ended.err, file));
  }
  CHECK(call_program(MOTION_PROGRAM, "").status == 2);
  CHECK(contains(call_program(MOTION_PROGRAM, "").err, "PUSHBACK_ADAPTER is not set"));
  CHECK(call_program(MOTION_PROGRAM, "--setting ours --hard-case stack-10 --out .").status == 2);
}

TEST_CASE("hard cases go through an adapter as well: bodies that are put, driven and pushed") {
  Scratch scratch;
  for (const char* const name : {"bullet", "squeezed", "heavy-chain", "middle-axis"}) {
    const Ended ended = call_program(
        PEERS_PROGRAM, fmt::format("--adapter {} {} --jobs 1 --out {}", OURS_PROGRAM, name, (scratch / "out").string()),
        60);
    INFO(name << ": " << ended.out << ended.err);
    CHECK(ended.status == 0);
    CHECK(fs::exists(scratch / "out" / "hard_cases" / "part" / "peers.csv"));
  }
}

/// The same, but for the rounding of numbers.
void check_alike(const Json& is, const Json& was, double margin) {
  if (was.is_number()) {
    CHECK(is.get<double>() == Approx(was.get<double>()).epsilon(1e-14).margin(margin));
  } else if (was.is_structured()) {
    REQUIRE(is.size() == was.size());
    for (const auto& [field, value] : was.items()) {
      INFO(field);
      check_alike(was.is_array() ? is[std::stoul(field)] : is.at(field), value, margin);
    }
  } else {
    CHECK(is == was);
  }
}

/// False where it has no words, which is said.
bool is_read_again(const World& world) {
  const std::string lacks = complaint([&] { scene_json(world); });
  if (!lacks.empty()) {
    CHECK(contains(lacks, "not possible"));
    return false;
  }
  Json json = scene_json(world), again = scene_json(scene_of(Json::parse(json.dump())));
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    if (!std::holds_alternative<Hull>(world.bodies[i].shape)) continue;
    for (const char* const field : {"shape", "inertia", "orientation"})  // a hull may have its axes in another order
      json["bodies"][i].erase(field), again["bodies"][i].erase(field);
  }
  check_alike(again, json, 1e-9);
  return true;
}

TEST_CASE("a scene is the same when it is read again: every motion, every hard case that has words") {
  for (const Motion& motion : every_motion()) {
    INFO(motion.name);
    World world;
    motion.begin(world);
    CHECK(is_read_again(world) != has_conveyor(motion));
  }
  std::size_t with_words = 0;
  for (const HardCase& hard_case : hard_cases()) {
    INFO(hard_case.name);
    World world;
    hard_case.scene.fill(world);
    with_words += is_read_again(world) ? 1 : 0;
  }
  CHECK(with_words > hard_cases().size() / 2);
}

/// Engines have joints, not equations: which joint it is is read off what it asks for, which other code made of the same numbers.
TEST_CASE("the joint that is read off equations is the one that was made, however the bodies are turned") {
  Random random(5);
  for (int i = 0; i < 100; ++i) {
    World world;
    for (int k = 0; k < 2; ++k)
      world.add(box({1, 2, 3}, 4).turned(Real(0.3) * static_cast<Real>(i), random.direction()).at(random.direction()));
    const Vec3 anchor = 3 * random.direction(), axis = random.direction();
    const Vec3 axis_b = i % 4 == 0 ? axis : i % 4 == 1 ? Vec3(Vec3::Unit(i / 4 % 3)) : random.direction();
    const Real angle = Real(0.1) + Real(0.02) * static_cast<Real>(i);
    INFO(i);
    const int a = i % 3 == 0 ? the_world : 0;
    world.joints = {hinge(world, a, 1, anchor, axis), angle_limits(world, 0, 1, axis, -angle, 0),
                    twist_limits(world, 0, 1, axis, -angle, angle / 2), motor_at_speed(world, 0, 1, axis, -angle, 7)};
    CHECK(is_read_again(world));
    const auto read = [&](std::size_t joint) { return shape_of(world, world.joints[joint]); };
    CHECK(read(0).axis.cross(axis).norm() < Real(1e-9));
    CHECK((read(0).anchor_a - anchor).norm() < Real(1e-9));
    CHECK((read(1).axis - axis).norm() < Real(1e-9));
    CHECK(read(1).low == Approx(-angle).margin(1e-9));
    CHECK(read(2).high == Approx(angle / 2).margin(1e-9));
    CHECK((read(3).axis - axis).norm() < Real(1e-9));
    CHECK(read(3).speed == Approx(-angle));
    CHECK(read(3).torque == 7);
    const JointShape cone = shape_of(world, cone_limit(world, 0, 1, axis, axis_b, angle));
    CHECK(cone.axis.cross(axis).norm() < Real(1e-9));
    CHECK((cone.axis.dot(axis) * cone.axis_b - axis_b).norm() < Real(1e-7));  // both, or neither, are reversed
    CHECK(cone.high == Approx(angle).margin(1e-6));
    const Joint held = ball_and_socket(world, 0, 1, anchor);
    world.bodies[1].position += Real(0.25) * Vec3::UnitX();  // the gap is there, too
    const JointShape apart = shape_of(world, held);
    CHECK((apart.anchor_b - apart.anchor_a - Real(0.25) * Vec3::UnitX()).norm() < Real(1e-9));
    world.bodies[1].turned(Real(0.05), axis);
    CHECK(read(2).high == Approx(angle / 2 - Real(0.05)).margin(1e-6));
    const Joint servo = motor_to_angle(world, 0, 1, axis, [](Real) { return Real(0); }, 7);
    CHECK(contains(complaint([&] { shape_of(world, servo); }), "not possible: a motor to an angle"));
  }
}

TEST_CASE("a scene that cannot be read is refused: which body or joint, which field, what it is and what is needed") {
  const Json good = Json::parse(R"({
    "gravity": [0, -9.81, 0],
    "bodies": [{"shape": {"kind": "half_space", "normal": [0, 1, 0]}, "mass": null, "position": [0, 0, 0]},
               {"shape": {"kind": "box", "half_extents": [1, 1, 1]}, "mass": 1, "position": [0, 1, 0],
                "orientation": [1, 0, 0, 0], "velocity": [0, 0, 0], "angular_velocity": [0, 0, 0],
                "inertia": [1, 1, 1], "friction": 0.5, "restitution": 0}],
    "joints": [{"kind": "hinge", "a": null, "b": 1, "anchor": [0, 1, 0], "axis": [0, 0, 1], "colliding": false},
               {"kind": "motor", "a": null, "b": 1, "axis": [0, 0, 1], "speed": 1, "torque": 1},
               {"kind": "angle_limits", "a": null, "b": 1, "axis": [0, 0, 1], "low": -1, "high": 1}]})");
  CHECK(scene_of(good).joints.size() == 3);
  struct Wrong {
    const char *place, *value, *said;
  };
  for (const auto& [place, value, said] : std::vector<Wrong>{
           {"", "[]", "the scene is []: an object is needed"},
           {"", "{}", "the scene has no bodies"},
           {"/bodies", "3", "bodies of the scene is 3: a list is needed"},
           {"/bodies", "[]", "bodies of the scene is []: a list of one body or more is needed"},
           {"/bodies/0", "{}", "body 0 has no mass"},
           {"/gravity", "[0, 1]", "gravity of the scene is [0,1]: three numbers from -1000000 to 1000000 is needed"},
           {"/bodies/1/shape/kind", "\"torus\"",
            "kind of shape of body 1 is \"torus\": sphere, box, capsule, hull or half_space is needed"},
           {"/bodies/1/shape", R"({"kind": "sphere", "radius": -1})", "radius of shape of body 1 is -1: a number from"},
           {"/bodies/1/mass", "\"heavy\"", "mass of body 1 is \"heavy\""},
           {"/joints/0/kind", "\"weld\"", "kind of joint 0 is \"weld\""},
           {"/gravty", "[0, 0, 0]", "the scene has the field 'gravty': only gravity, bodies, joints are allowed"},
           {"/gravity", "[0, -1e300, 0]", "gravity of the scene is [0,-1e+300,0]"},
           {"/bodies/0/mass", "5", "mass of body 0 is 5: null, since a half-space never moves,"},
           {"/bodies/0/shape/normal", "[0, 0, 0]", "normal of shape of body 0 is [0,0,0]: a vector that is not 0"},
           {"/bodies/1/frction", "0.1", "body 1 has the field 'frction': only position, "},
           {"/bodies/1/friction", "-1", "friction of body 1 is -1: a number from 0 to 1000000"},
           {"/bodies/1/restitution", "1.5", "restitution of body 1 is 1.5: a number from 0 to 1"},
           {"/bodies/1/mass", "0", "mass of body 1 is 0: a number from 1e-12 to 1000000000000"},
           {"/bodies/1/inertia", "[1, 1, 100]",
            "inertia of body 1 is [1,1,100]: three numbers, none larger than the sum"},
           {"/bodies/1/position", "[1e300, 0, 0]", "position of body 1 is [1e+300,0,0]: three numbers from -1000000"},
           {"/bodies/1/velocity", "[0, -1e6, 0]",
            "velocity of body 1 is [0,-1000000.0,0]: three numbers from -100000 to 100000"},
           {"/bodies/1/orientation", "[0, 0, 0, 0]",
            "orientation of body 1 is [0,0,0,0]: four numbers, w x y z, of length 1,"},
           {"/bodies/1/shape/half_extents", "[1, 0, 1]",
            "half_extents of shape of body 1 is [1,0,1]: three numbers from 1e-09"},
           {"/joints/0/b", "4294967297", "b of joint 0 is 4294967297: the index of a body, from 0 to 1, or null"},
           {"/joints/0/b", "0", "joint 0"},  // neither can move
           {"/joints/0/anchr", "[0, 0, 0]",
            "joint 0 has the field 'anchr': only kind, a, b, colliding, anchor, axis are"},
           {"/joints/0/axis", "[0, 0, 0]", "axis of joint 0 is [0,0,0]: a vector that is not 0"},
           {"/joints/0/colliding", "1", "colliding of joint 0 is 1: true or false"},
           {"/joints/1/torque", "-1", "torque of joint 1 is -1: a number from 0 to 1000000000000"},
           {"/joints/2/low", "2", "joint 2"}}) {
    Json wrong = good;
    wrong[Json::json_pointer(place)] = Json::parse(value);
    const std::string complained = complaint([&] { scene_of(wrong); });
    INFO(place << " " << value << "\n" << complained);
    CHECK(contains(complained, said));
  }
  Scratch scratch;
  write_text_file(scratch / "scene.json", "{");
  CHECK(contains(complaint([&] { scene_in(scratch / "scene.json"); }), "is no JSON"));
}
