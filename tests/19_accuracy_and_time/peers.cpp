// Other engines in the motions of chapter 19, built only with PUSHBACK_PEERS, once for each engine: what is ours is the
// conversion, so it is looked at where an engine has hardly a way to be wrong.
#include <set>

#include "pushback/chapters/19_accuracy_and_time/truth.h"
#include "pushback/tools/peers/peer.h"
#include "pushback/tools/study/every_motion.h"
#include "pushback/tools/study/kit.h"
#include "pushback/tools/study/relaxed_law.h"
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

TEST_CASE("The chain swings as the truth does once steps are small") {
  for (const Method& method : peer_methods()) {
    INFO(method.name);
    const double error = error_of(method, motion_named("chain"), 32);
    if (method.name == "box3d") CHECK(error > 0.1);  // its joints stay springs of 60 Hz, however small the step
    else CHECK(error < 0.005);
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

namespace {

/// A point that slides by the relaxed law, see relaxed_law.h, and what MuJoCo's hardest contacts add to it. With
///   solref = 2 h, solimp = d   its reference acceleration is   -v / (d h) - r / (4 d h^2),   r: the height less the margin,
/// so what is complementary to r is not u but   s = u + (1/d - 1) v + r / (4 d h)   along the normal, without r along the slip.
struct Hopping {
  double h, mu, k, along;  // s, 1, 1, m/s
  double up = 0, x = 0, y = 0;

  void substep() {
    constexpr double d = 0.9999, margin = 1e-6;
    const double before = up;
    up -= truth::g * h;
    if (y < margin) {
      const double s_n = up + (1 / d - 1) * before + (y - margin) / (4 * d * h), s_t = along / d;
      const double impulse = std::max(0.0, (mu * s_t - s_n) / (1 + k * mu * mu));
      up += impulse;
      along -= k * mu * impulse;
    }
    x += h * (along + (1 - 1 / k) * (start - along));  // of the centre of mass, which k - 1 parts in k turn, not brake
    y += h * up;
  }
  double start = along;
};

}  // namespace

TEST_CASE("MuJoCo's hard contacts lift a sliding body off, as fast and as high as the relaxed law says") {
  for (const Method& method : peer_methods()) {
    if (method.name != "mujoco") continue;
    for (const char* name : {"sliding", "rolling"}) {
      const Motion& motion = motion_named(name);
      World world;
      motion.fill(world);
      const Body& body = world.bodies.back();
      const Eigen::Vector3d begin = body.position.cast<double>(), way = body.velocity.cast<double>().normalized();
      for (const int substeps : {1, 4, 16, 64}) {
        INFO(name << ", " << substeps << " substeps");
        const Setting setting{.substeps = substeps};
        const auto player = method.begin(motion, setting);
        const double k = std::holds_alternative<Sphere>(body.shape) ? 3.5 : 1;
        Hopping wanted{.h = setting.dt(),
                       .mu = static_cast<double>(body.friction),
                       .k = k,
                       .along = static_cast<double>(body.velocity.norm())};
        double first_top = 0, second_top = 0, wanted_second_top = 0;
        const Hop hop = *hop_of(motion);
        const double landing = 2 * hop.speed / truth::g;  // s; give or take two steps
        for (int step = 1; step * setting.dt() < 1.8 * landing; ++step) {
          dynamic_cast<PlayerInSubsteps&>(*player).substep();
          wanted.substep();
          const Eigen::Vector3d moved = player->place(1) - begin;
          if (step == 1) CHECK(moved.y() / setting.dt() == Approx(wanted.up).epsilon(1e-4));
          if (step * setting.dt() < 0.9 * landing) {
            first_top = std::max(first_top, moved.y());
            CHECK(moved.y() == Approx(wanted.y).margin(1e-4));
            CHECK(moved.dot(way) == Approx(wanted.x).margin(1e-4));
          } else if (step * setting.dt() > 1.1 * landing) {
            second_top = std::max(second_top, moved.y());
            wanted_second_top = std::max(wanted_second_top, wanted.y);
          }
        }
        CHECK(first_top == Approx(hop.height).epsilon(0.06 / substeps + 0.002));
        // The depth of the landing step is pushed out, and depends on when in the step it lands: 1e-4 m of height are a quarter of
        // a step with 64 of them.
        CHECK(second_top == Approx(wanted_second_top).epsilon(0.1));
        CHECK(error_of(method, motion, substeps) == Approx(hop.error).epsilon(0.08 / substeps + 0.002));
      }
    }
  }
}

TEST_CASE("MuJoCo's own contacts, of a time constant of 0.02 s, lift a sliding box off the less the shorter the step") {
  for (const Method& method : peer_methods()) {
    if (method.name != "mujoco-default") continue;
    const Motion& motion = motion_named("sliding");
    World world;
    motion.fill(world);
    const double start = static_cast<double>(world.bodies.back().position.y());
    for (const int substeps : {4, 16, 64, 256}) {
      INFO(substeps);
      const Setting setting{.substeps = substeps};
      const auto player = method.begin(motion, setting);
      // Its reference takes h b of the slip away in a step, b = 2 / (0.95 * 0.02 s), and what it allows is soft.
      const double b = 2 / (0.95 * 0.02), bound = 0.5 * setting.dt() * b * 6 / 1.25;
      double before = start, fastest = 0;
      for (int step = 0; step < 3; ++step) {
        dynamic_cast<PlayerInSubsteps&>(*player).substep();
        const double y = player->place(1).y();
        fastest = std::max(fastest, (y - before) / setting.dt());
        before = y;
      }
      CHECK(fastest < bound);
      CHECK(fastest > bound / 2);
    }
  }
}

TEST_CASE("Restitution of a pair is that of its bodies, where an engine bounces at all") {
  for (const Method& method : peer_methods()) {
    if (method.name.find("-split") == std::string::npos && method.name.find("ode") != 0) continue;
    INFO(method.name);
    for (const int substeps : {4, 16}) CHECK(error_of(method, motion_named("bounce"), substeps) < 0.15 / substeps);
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

TEST_CASE("A ball between two planes meets both") {
  // In this flight two planes of bodies of their own would be too many pairs for MuJoCo.
  Motion ball = any_motion_named("superball");
  const auto fill = ball.fill;
  ball.fill = [fill](World& world) {
    fill(world);
    world.bodies[2].moving({1, -6, Real(0.5)}).spinning({30, 4, -80});
  };
  for (const Method& method : peer_methods()) {
    if (!method.plays(ball)) continue;
    INFO(method.name);
    // Each plane by itself reverses the ball: without the ceiling it would be a metre too high after 0.3 s.
    const auto player = method.begin(ball, {.substeps = 64, .sweeps = 16});
    for (int i = 0; i < 90; ++i) {
      player->frame(64);
      CHECK((player->place(2).y() > 0.05 && player->place(2).y() < 0.95));
    }
    CHECK(player->place(1).y() == 1);  // the ceiling
  }
}

TEST_CASE("Row solves: three rows a pin and iteration, where rows are what is solved") {
  const Motion& pendulum = motion_named("pendulum");
  for (const Method& method : peer_methods()) {
    if (!method.plays(pendulum)) continue;
    INFO(method.name);
    const auto truth = pendulum.truth(pendulum.frames());
    const auto solved = [&](int sweeps) {
      return play(pendulum, truth, method, {.substeps = 2, .sweeps = sweeps}, once).row_solves;
    };
    const bool is_bullet =
        method.name == "bullet" || method.name == "bullet-double" || method.name.find("-nncg") != std::string::npos;
    const double one_sweep = pendulum.frames() * 2 * 3;
    if (is_bullet) {
      CHECK(solved(1) == one_sweep);
      CHECK(solved(7) > 3 * one_sweep);
      CHECK(solved(7) <= 7 * one_sweep);  // where nothing is left to correct, it stops
    } else if (method.name == "ode" || method.name == "ode-aligned") {
      CHECK(solved(7) == 7 * one_sweep);
    } else if (method.name == "mujoco-pgs") {
      CHECK(solved(7) == 0);  // a pin of MuJoCo's own is a joint of its tree, and no row
    } else {
      CHECK(!solved(7));
    }
  }
}

TEST_CASE("Row solves: a ball on the ground has one row, and two tangents where it rubs") {
  for (const double mu : {0.0, 0.5}) {
    const auto fill = [mu](World& world) {
      world.add(ground().rough(static_cast<Real>(mu)));
      world.add(sphere(Real(0.5), 1).at({0, Real(0.45), 0}).rough(static_cast<Real>(mu)));  // so deep that it stays
    };
    const auto truth = [](int frames) {
      return std::vector<Places>(static_cast<std::size_t>(frames), {{0, 0, 0}, {0, 0.5, 0}});
    };
    const Motion resting{.name = "rest", .title = "a ball rests", .fill = fill, .seconds = 10.0 / 60, .truth = truth};
    for (const Method& method : peer_methods()) {
      const Played played = play(resting, truth(10), method, {.substeps = 1, .sweeps = 1}, once);
      INFO(method.name << ", mu " << mu);
      if (method.name == "ode") CHECK(played.row_solves.value_or(-1) == 10 * (mu > 0 ? 3 : 1));
      if (method.name == "bullet" || method.name == "bullet-double") CHECK(played.row_solves.value_or(-1) == 10 * 3);
    }
  }
}

TEST_CASE("An engine says its version") {
  CHECK(peer_version().find_first_of("0123456789") != std::string::npos);
}

TEST_CASE("The same engine with the same setting errs by the same, to the bit") {
  for (const Method& method : peer_methods()) {
    for (const char* name : {"heavy-on-light", "chain"}) {
      const Motion& motion = motion_named(name);
      if (!method.plays(motion)) continue;
      INFO(method.name << " " << name);
      CHECK(error_of(method, motion, 2) == error_of(method, motion, 2));
    }
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
