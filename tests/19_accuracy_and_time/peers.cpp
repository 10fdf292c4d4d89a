// Other engines in the motions of chapter 19, built only with PUSHBACK_PEERS, once for each engine: what is ours is the
// conversion, so it is looked at where an engine has hardly a way to be wrong.
#include <set>

#include "pushback/chapters/19_accuracy_and_time/truth.h"
#include "pushback/tools/measure/peers/peer.h"
#include "pushback/tools/measure/study/every_motion.h"
#include "pushback/tools/measure/study/kit.h"
#include "pushback/tools/measure/study/relaxed_law.h"
#include "tests/support/catch.h"

using namespace pushback;

namespace {

constexpr Patience once{.at_least = 0, .at_most = 600};
constexpr int some_sweeps = 16;

double error_of(const Method& method, const Motion& motion, int substeps) {
  return play(motion, motion.truth(motion.frames()), method, {.substeps = substeps, .sweeps = some_sweeps}, once).error;
}

/// A turned box and a ball beside it fall for 0.4 s, and are still above the ground.
Motion fall() {
  const auto fill = [](World& world) {
    world.add(ground());
    world.add(
        box({Real(0.1), Real(0.2), Real(0.3)}, 2).turned(Real(0.7), Vec3::UnitX()).at({0, 2, 0}).moving({1, 0, 2}));
    world.add(sphere(Real(0.3), 7).at({-2, 2, 0}).moving({0, 1, 0}));
  };
  const auto truth = [](int frames) {
    std::vector<Places> found;
    for (int frame = 1; frame <= frames; ++frame) {
      const double t = static_cast<double>(frame) / frames_per_second, y = 2 - truth::g * t * t / 2;
      found.push_back({{0, 0, 0}, {t, y, 2 * t}, {-2, y + t, 0}});
    }
    return found;
  };
  return {.name = "fall", .title = "a box and a ball fall", .fill = fill, .seconds = 0.4, .truth = truth};
}

}  // namespace

TEST_CASE("What falls keeps its velocity and gets that of gravity: half a step late, and nothing else") {
  const Motion falling = fall();
  for (const Method& method : peer_methods()) {
    if (!method.plays(falling)) continue;
    INFO(method.name);
    for (const int substeps : {1, 4, 16}) {
      // v += h g, x += h v:   x errs by g h t / 2. One way of Box3D makes its substeps of what are sweeps to others.
      const int divided = substeps * (method.name == "box3d-often" ? some_sweeps : 1);
      if (divided > 64) continue;  // a sum of 6,144 places in float is off by a quarter of what is looked for
      const double late = truth::g * falling.seconds / (2 * frames_per_second * divided);
      CHECK(error_of(method, falling, substeps) == Approx(late).margin(2e-5));  // margin: of float
    }
  }
}

TEST_CASE("A pinned ball swings as the truth does, the closer the smaller the step") {
  for (const Method& method : peer_methods()) {
    INFO(method.name);
    // Jolt moves the joint's bodies once more after each step, and is late by more; so it is as WebAssembly.
    const double first_order = method.name.find("jolt") == 0 ? 0.04 : 0.013;  // m
    for (const int substeps : {1, 4, 16})
      CHECK(error_of(method, motion_named("pendulum"), substeps) < first_order / substeps);
  }
}

TEST_CASE("Friction of a pair is that of its bodies") {
  // A coefficient of mu^2 or of its root would be 1.7 m or 0.23 m wrong. What is wrong here is the engines' own: ODE's pyramid,
  // and MuJoCo's relaxed law, which has the ball lift off.
  for (const Method& method : peer_methods()) {
    if (!method.plays(motion_named("rolling"))) continue;
    INFO(method.name);
    CHECK(error_of(method, motion_named("rolling"), 16) < 0.15);
  }
}

TEST_CASE("MuJoCo's hard contacts lift a sliding body off, and it is off by what the relaxed law says") {
  for (const Method& method : peer_methods()) {
    if (method.name != "mujoco") continue;
    for (const char* name : {"sliding", "rolling"}) {
      const Motion& motion = motion_named(name);
      for (const int substeps : {4, 16, 64}) {
        INFO(name << ", " << substeps << " substeps");
        CHECK(error_of(method, motion, substeps) == Approx(hop_of(motion)->error).epsilon(0.08 / substeps + 0.002));
      }
    }
  }
}

TEST_CASE("A box is carried by a belt where an engine has belts, and the others do not play it") {
  const Motion& belt = any_motion_named("conveyor");
  for (const Method& method : peer_methods()) {
    INFO(method.name);
    CHECK(method.plays(belt) != method.name.starts_with("mujoco"));
    if (!method.plays(belt)) continue;
    // ODE's pyramid on fixed axes has a limit of its own. In double Bullet turns its pyramid by what slips where nothing does: rounding.
    const double each = method.name.starts_with("bullet-double") ? 0.09 : 0.03;
    for (const int substeps : {4, 16})
      CHECK(error_of(method, belt, substeps) < (method.name == "ode" ? 0.21 : each / substeps));
  }
}

TEST_CASE("What the test kit finds wrong is what an engine is known for, and nothing else") {
  const std::set<std::pair<std::string, std::string>> known{{"bullet", "restitution"},
                                                            {"bullet-nncg", "restitution"},
                                                            {"bullet-dantzig", "restitution"},
                                                            {"bullet-double", "restitution"},
                                                            {"bullet-double-nncg", "restitution"},
                                                            {"bullet-double-dantzig", "restitution"},
                                                            {"ode", "friction"},
                                                            {"mujoco-bounce", "restitution"},
                                                            {"jolt", "gyroscope"}};
  for (const Method& method : peer_methods())
    for (const Finding& finding : findings_of(method)) {
      INFO(method.name << ", " << finding.about << ": " << finding.says);
      CHECK((finding.is == Finding::wrong) == known.contains({method.name, finding.about}));
    }
}
