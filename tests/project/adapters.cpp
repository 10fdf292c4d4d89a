// Engines that others enter: what they are asked, what they may answer, and the test kit that says what they get wrong.
#include <Eigen/LU>
#include <cstdlib>
#include <map>

#include "pushback/common/basics/files.h"
#include "pushback/tools/measure/adapters/scene_json.h"
#include "pushback/tools/measure/hard_cases/hard_case.h"
#include "pushback/tools/measure/study/every_motion.h"
#include "pushback/tools/measure/study/kit.h"
#include "tests/project/jointed.h"
#include "tests/support/call.h"
#include "tests/support/complaint.h"

using namespace pushback;

namespace {

/// What is wrong with an engine. All zeros: nothing.
struct Defect {
  double scale = 1;                                                 // of places
  std::function<void(World&)> begins = [](World&) {};               // as the world is handed over
  std::function<void(World&, Real h)> after = [](World&, Real) {};  // each substep
  std::function<double()> clock = {};                               // s a substep, of its own
};

/// Ours, with a defect. It learns of damping, sleep and so on by the ways in which other engines have them.
class Ours : public PlayerInSubsteps {
 public:
  Ours(const Motion& motion, const Setting& setting, Defect defect)
      : h_(static_cast<Real>(setting.dt())), sweeps_(setting.sweeps), defect_(std::move(defect)) {
    motion.begin(world_);
    defect_.begins(world_);
  }
  void substep() override {
    world_.step(solver_, h_, sweeps_);
    defect_.after(world_, h_);
    if (defect_.clock) seconds_ += defect_.clock();
  }
  Eigen::Vector3d place(std::size_t body) const override {
    return defect_.scale * world_.bodies[body].position.cast<double>();
  }
  std::optional<double> seconds() const override {
    if (!defect_.clock) return {};
    return seconds_;
  }

 private:
  World world_;
  Jointed solver_;
  Real h_;
  int sweeps_;
  Defect defect_;
  double seconds_ = 0;
};

Method method_with(const Defect& defect) {
  return {.name = "ours",
          .title = "ours",
          .plays = [](const Motion&) { return true; },
          .begin = [defect](const Motion& motion, const Setting& setting) -> std::unique_ptr<Player> {
            return std::make_unique<Ours>(motion, setting, defect);
          }};
}

/// What the kit finds wrong, by what it is about.
std::map<std::string, std::string> wrong_with(const Defect& defect) {
  std::map<std::string, std::string> wrong;
  for (const Finding& finding : findings_of(method_with(defect)))
    if (finding.is == Finding::wrong) wrong[finding.about] = finding.says;
  return wrong;
}

/// A change of each body that moves, as the world begins.
auto of_bodies(const std::function<void(Body&)>& change) {
  return [change](World& world) {
    for (Body& body : world.bodies) change(body);
  };
}

/// As an engine without the gyroscopic torque: w += h I^-1 (w x I w) undoes what turning does to it.
void no_gyroscope(World& world, Real h) {
  for (Body& body : world.bodies) {
    if (!body.movable()) continue;
    const Vec3 spin = body.inverse_inertia.inverse() * body.angular_velocity;
    body.angular_velocity += h * (body.inverse_inertia * body.angular_velocity.cross(spin));
  }
}

struct InEnvironment {
  InEnvironment(const char* variable, const std::string& value) : name(variable) { setenv(name, value.c_str(), 1); }
  ~InEnvironment() { unsetenv(name); }
  InEnvironment(const InEnvironment&) = delete;
  InEnvironment& operator=(const InEnvironment&) = delete;
  const char* name;
};

}  // namespace

TEST_CASE("a right engine answers all thirteen questions rightly") {
  const auto all = findings_of(method_with({}));
  CHECK(all.size() == 13);
  for (const Finding& finding : all) {
    INFO(finding.about << ": " << finding.says);
    CHECK(finding.is == Finding::right);
  }
}

TEST_CASE("each mistake is found where it is, and said as what it looks like") {
  const auto found = [](const Defect& defect, const std::string& about, const std::string& part) {
    const auto wrong = wrong_with(defect);
    std::string all;
    for (const auto& [where, says] : wrong) all += where + ": " + says + "\n";
    INFO("looked for \"" << part << "\" about " << about << ", and found\n" << all);
    REQUIRE(wrong.contains(about));
    CHECK(contains(wrong.at(about), part));
  };
  found({.scale = 100}, "places", "100 times as far; lengths are in metres");
  found({.begins = [](World& world) { world.gravity = {0, Real(-9.81), 0}; }}, "gravity",
        "not always 9.81 m/s^2 downwards");
  found({.after = [](World& world,
                     Real h) { of_bodies([h](Body& body) { body.velocity *= 1 - Real(0.05) * h; })(world); }},
        "damping", "a linear damping of some 0.04");  // (1 - exp(-0.1)) / 2: x = v (1 - exp(-c t)) / c
  found({.after = [](World& world,
                     Real h) { of_bodies([h](Body& body) { body.angular_velocity *= 1 - Real(0.1) * h; })(world); }},
        "turning", "an angular damping of some 0.0");
  found({.begins = of_bodies([](Body& body) {
           body.principal_inverse_inertia *= 10;
           body.refresh_inertia();
         })},
        "inertia", "inertia is that which the scene gives");
  // What a torque-free turn needs is taken out again: w stays as it is.
  found({.after = no_gyroscope}, "gyroscope", "not the angular velocity");
  found({.begins = of_bodies([](Body& body) { body.friction *= body.friction; })}, "friction",
        "give each body its square root");
  found({.begins = of_bodies([](Body& body) { body.restitution *= body.restitution; })}, "restitution",
        "the product of both");
  found({.after =
             [](World& world, Real) {
               of_bodies([](Body& body) {
                 if (body.velocity.norm() < Real(0.01)) body.velocity.setZero();
               })(world);
             }},
        "sleep", "it has fallen asleep");
  found({.begins = of_bodies([](Body& body) { body.skin = Real(0.005); })}, "margins", "a margin around shapes");
  found({.begins =
             [](World& world) {
               for (Joint& joint : world.joints) joint.colliding = true;
             }},
        "pinned pairs", "pinned pairs do not collide");
  Real other = 0;
  found({.begins = of_bodies([&other](Body& body) { body.position.x() += other += Real(1e-9); })}, "same bits",
        "played twice");
  found({.clock = [] { return 1.0; }}, "clock", "ms by its clock");
}

TEST_CASE("what an adapter says of a motion is what the engine behind it does, to the last bit") {
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
      const double error = play(motion, truth, method_with({}), setting, {.at_least = 0}).error;
      CHECK(contains(line, fmt::format(" error {:.4e} ", error)));
      CHECK(contains(line, " row-solves –"));
    }
  }
}

TEST_CASE("the kit by an adapter: ours is right, and the template falls through the ground") {
  {
    const InEnvironment ours("PUSHBACK_ADAPTER", OURS_PROGRAM);
    const Ended checked = call_program(MOTION_PROGRAM, "--check", 60);
    INFO(checked.out << checked.err);
    CHECK(checked.status == 0);
    CHECK(contains(checked.out, "✓ friction: a box with 4 m/s slides"));
    CHECK(contains(call_program(MOTION_PROGRAM, "--version").out, "Pushback through a pipe, through a pipe"));
  }
  const InEnvironment fresh("PUSHBACK_ADAPTER", TEMPLATE_PROGRAM);
  const Ended checked = call_program(MOTION_PROGRAM, "--check");
  INFO(checked.out << checked.err);
  CHECK(checked.status == 1);
  for (const char* const said :
       {"✓ places", "✓ gravity", "✓ damping", "– turning: it says that it does not play this", "✗ friction",
        "✗ restitution", "✗ margins", "they do not touch", "✓ sleep", "✓ same bits"})
    CHECK(contains(checked.out, said));
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
  CHECK(call_program(HARD_CASES_PROGRAM, "stack-10 --setting ours").status == 2);
  const InEnvironment fresh("PUSHBACK_ADAPTER", TEMPLATE_PROGRAM);  // it has no joints
  CHECK(contains(call_program(MOTION_PROGRAM, "pendulum template/1").err, "'template': none plays pendulum"));
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

TEST_CASE("a scene is the same when it is read again: every motion, every hard case that has words") {
  const auto same = [](const World& world) {
    const Json json = scene_json(world);
    const Json again = scene_json(scene_of(Json::parse(json.dump())));
    REQUIRE(again["bodies"].size() == json["bodies"].size());
    CHECK(again["gravity"] == json["gravity"]);
    for (std::size_t i = 0; i < json["bodies"].size(); ++i) {
      const Json &was = json["bodies"][i], &is = again["bodies"][i];
      INFO("body " << i << ": " << was.dump() << "\n" << is.dump());
      if (was["shape"]["kind"] != "hull") {  // a hull may have its axes in another order
        CHECK(is["shape"] == was["shape"]);
        for (const char* const field : {"inertia", "orientation"})
          if (!was[field].is_null())
            for (std::size_t k = 0; k < was[field].size(); ++k)
              CHECK(is[field][k].get<double>() == Approx(was[field][k].get<double>()).epsilon(1e-14).margin(1e-15));
      }
      CHECK(is["mass"].is_null() == was["mass"].is_null());
      if (!was["mass"].is_null()) CHECK(is["mass"].get<double>() == Approx(was["mass"].get<double>()).epsilon(1e-15));
      for (const char* const field : {"velocity", "angular_velocity", "friction", "restitution"})
        CHECK(is[field] == was[field]);
      for (std::size_t k = 0; k < 3; ++k)
        CHECK(is["position"][k].get<double>() == Approx(was["position"][k].get<double>()).margin(1e-12));
    }
    REQUIRE(again["joints"].size() == json["joints"].size());
    for (std::size_t i = 0; i < json["joints"].size(); ++i)
      for (const auto& [field, value] : json["joints"][i].items()) {
        INFO("joint " << i << ", " << field);
        if (value.is_array())
          for (std::size_t k = 0; k < 3; ++k)
            CHECK(again["joints"][i][field][k].get<double>() == Approx(value[k].get<double>()).margin(1e-9));
        else if (value.is_number_float())
          CHECK(again["joints"][i][field].get<double>() == Approx(value.get<double>()).margin(1e-9));
        else CHECK(again["joints"][i][field] == value);
      }
  };
  for (const Motion& motion : every_motion()) {
    INFO(motion.name);
    World world;
    motion.begin(world);
    if (has_conveyor(motion)) CHECK(contains(complaint([&] { scene_json(world); }), "a conveyor"));
    else same(world);
  }
  for (const HardCase& hard_case : hard_cases()) {
    INFO(hard_case.name);
    World world;
    hard_case.scene.fill(world);
    try {
      scene_json(world);
    } catch (const InvalidInput& lacks) {
      CHECK(contains(lacks.what(), "not possible"));
      continue;
    }
    same(world);
  }
}

TEST_CASE("a scene that cannot be read is refused: which body, which field, what is needed") {
  const auto refused = [](const std::string& text, const std::string& said) {
    const std::string complained = complaint([&] { scene_of(Json::parse(text)); });
    INFO(text << "\n" << complained);
    CHECK(contains(complained, said));
  };
  const std::string ground =
      R"({"shape": {"kind": "half_space", "normal": [0, 1, 0]}, "mass": null, "position": [0, 0, 0]})";
  refused("[]", "the scene is []: an object is needed");
  refused("{}", "the scene has no bodies");
  refused(R"({"bodies": 3})", "bodies of the scene is 3: a list is needed");
  refused(R"({"gravity": [0, 1], "bodies": []})",
          "gravity of the scene is [0,1]: three numbers from -1000000 to 1000000 is needed");
  refused(R"({"bodies": [{}]})", "body 0 has no mass");
  refused(R"({"bodies": [{"shape": {"kind": "torus"}, "mass": 1, "position": [0, 0, 0]}]})",
          "kind of shape of body 0 is \"torus\": sphere, box, capsule, hull or half_space is needed");
  refused(R"({"bodies": [{"shape": {"kind": "sphere", "radius": -1}, "mass": 1, "position": [0, 0, 0]}]})",
          "radius of shape of body 0 is -1: a number from 1e-09");
  refused(R"({"bodies": [{"shape": {"kind": "sphere", "radius": "big"}, "mass": 1, "position": [0, 0, 0]}]})",
          "radius of shape of body 0 is \"big\": a number from 1e-09 to 1000000 is needed");
  refused(R"({"bodies": [)" + ground +
              R"(, {"shape": {"kind": "sphere", "radius": 1}, "mass": "heavy", "position": [0, 0, 0]}]})",
          "mass of body 1 is \"heavy\"");
  refused(R"({"bodies": [)" + ground + R"(], "joints": [{"kind": "weld", "a": null, "b": 0}]})",
          "kind of joint 0 is \"weld\"");
  refused(R"({"bodies": []})", "bodies of the scene is []: a list of one body or more is needed");
  Scratch scratch;
  write_text_file(scratch / "scene.json", "{");
  CHECK(contains(complaint([&] { scene_in(scratch / "scene.json"); }), "is no JSON"));
}

TEST_CASE("a scene with a wrong field or a number that no step can use is refused by the name of its body or joint") {
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
}
