#include "pushback/tools/measure/study/kit.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "pushback/chapters/19_accuracy_and_time/truth.h"
#include "pushback/common/basics/input.h"
#include "pushback/common/world/situations.h"
#include "pushback/tools/measure/study/every_motion.h"

namespace pushback {

namespace {

const Setting kit{.substeps = 16, .sweeps = 32};

/// Where bodies are at the begin, and after each frame.
std::vector<Places> places_of(const Method& method, const Motion& motion) {
  MotionRun run(motion, method, kit);
  std::vector<Places> all{run.places()};
  for (int frame = 0; frame < motion.frames(); ++frame) {
    run.frame();
    all.push_back(run.places());
  }
  return all;
}

/// m, of a body from the first frame to the last.
Eigen::Vector3d way_of(const std::vector<Places>& all, std::size_t body = 0) {
  return all.back()[body] - all.front()[body];
}

std::string text(const Eigen::Vector3d& v) {
  return fmt::format("({:.4g}, {:.4g}, {:.4g})", v.x(), v.y(), v.z());
}

Motion motion(double seconds, const std::function<void(World&)>& fill, const std::vector<Pin>& pins = {}) {
  return {.name = "plain", .title = "", .fill = fill, .seconds = seconds, .truth = {}, .pins = pins};
}

struct Said {
  bool right;
  std::string says;
};
using Question = std::function<Said(const std::vector<Places>&)>;

Finding finding(const Method& method, const std::string& about, const Motion& motion, const Question& question) {
  if (!method.plays(motion)) return {about, Finding::not_played, "it says that it does not play this"};
  try {
    const Said said = question(places_of(method, motion));
    return {about, said.right ? Finding::right : Finding::wrong, said.says};
  } catch (const InvalidInput& problem) {
    return {about, Finding::wrong, problem.what()};
  }
}

Finding places(const Method& method) {
  const auto fill = [](World& world) {
    world.gravity.setZero();
    world.add(sphere(Real(0.3), 2).at({1, 2, 3}));
    world.add(box({Real(0.5), Real(0.2), Real(0.1)}, 1).turned(1, Vec3(1, 2, 3).normalized()).at({-4, 5, 6}));
    world.add(half_space(Vec3(0, 1, 1).normalized()).at({0, -3, -4}));
  };
  return finding(method, "places", motion(1, fill), [&](const std::vector<Places>& all) -> Said {
    World world;
    fill(world);
    for (const std::size_t frame : {std::size_t{0}, all.size() - 1}) {
      for (std::size_t body = 0; body < world.bodies.size(); ++body) {
        const Eigen::Vector3d asked = world.bodies[body].position.cast<double>(), is = all[frame][body];
        if ((is - asked).norm() < 1e-5) continue;
        const double ratio = is.norm() / asked.norm();
        const bool scaled = (is - ratio * asked).norm() < 1e-3 * is.norm();
        return {false, fmt::format("{}, body {} is at {}, not at {}: {}",
                                   frame == 0 ? "before anything has moved" : "after a second without gravity", body,
                                   text(is), text(asked),
                                   frame > 0 ? "something moves it"
                                   : scaled  ? fmt::format("{:.3g} times as far; lengths are in metres", ratio)
                                             : "the place is that of the centre of mass, in world axes")};
      }
    }
    return {true, "bodies are where they were put, and stay there without gravity"};
  });
}

Finding gravity(const Method& method) {
  const Vec3 asked(2, -6, 3);
  const auto fill = [&](World& world) {
    world.gravity = asked;
    world.add(sphere(Real(0.3), 2));
  };
  return finding(method, "gravity", motion(1, fill), [&](const std::vector<Places>& all) -> Said {
    const Eigen::Vector3d way = way_of(all), right = asked.cast<double>() / 2;
    const double h = kit.dt(), ratio = way.norm() / right.norm();
    const std::string is = fmt::format("in a second a ball falls {}, where {} is right", text(way), text(right));
    if (way.norm() < 1e-6) return {false, is + ": it does not fall"};
    if ((way / way.norm() - right / right.norm()).norm() > 1e-3)
      return {false, is + ": gravity is the scene's, not always 9.81 m/s^2 downwards"};
    if (std::abs(ratio - 1) < 1.01 * h) return {true, is};  // x += h v is off by h / 2 either way
    if (ratio < 1 && ratio > 0.5)
      return {false, fmt::format("{}: slowed, as by a damping of {:.3g} 1/s", is, 3 * (1 - ratio))};
    return {false, fmt::format("{}: {:.3g} times as far", is, ratio)};
  });
}

Finding damping(const Method& method) {
  const auto fill = [](World& world) {
    world.gravity.setZero();
    world.add(sphere(Real(0.3), 2).moving({3, -1, 2}));
  };
  return finding(method, "damping", motion(2, fill), [](const std::vector<Places>& all) -> Said {
    const Eigen::Vector3d way = way_of(all), right = 2 * Eigen::Vector3d(3, -1, 2);
    const double ratio = way.norm() / right.norm();
    const std::string is = fmt::format("in 2 s a ball flies {}, where {} is right", text(way), text(right));
    if ((way - right).norm() < 1e-3) return {true, is};  // in float, 1,920 sums round by as much
    if (ratio < 1e-3) return {false, is + ": bodies begin with the velocity that they are given"};
    if (ratio < 1) return {false, fmt::format("{}: a linear damping of some {:.3g} 1/s", is, 1 - ratio)};
    return {false, is};
  });
}

/// A rod on a pin at its end, without gravity.
Finding turning(const Method& method) {
  const auto fill = [](World& world) {
    constexpr Real rate = 3;
    world.gravity.setZero();
    world.add(box({Real(0.5), Real(0.05), Real(0.05)}, 1)
                  .at({Real(0.5), 0, 0})
                  .moving({0, rate / 2, 0})
                  .spinning({0, 0, rate}));
  };
  return finding(
      method, "turning", motion(1, fill, {{the_world, 0, Vec3::Zero()}}), [](const std::vector<Places>& all) -> Said {
        const Eigen::Vector3d at = all.back()[0];
        double angle = std::atan2(at.y(), at.x());
        if (angle < 0) angle += 2 * static_cast<double>(pi);
        const std::string is = fmt::format(
            "a rod on a pin has turned by {:.4g} rad in a second, where 3 is right, and its middle is "
            "{:.4g} m from the pin, where 0.5 is right",
            angle, at.norm());
        if (std::abs(at.norm() - 0.5) > 5e-3) return {false, is + ": the pin is not held, or is elsewhere"};
        if (std::abs(angle - 3) < 0.02) return {true, is};
        if (angle > 0.1 && angle < 3)
          return {false, fmt::format("{}: an angular damping of some {:.3g} 1/s, or not the angular velocity "
                                     "that was given",
                                     is, 2 * (1 - angle / 3))};
        return {false, is + ": angular velocities are in rad/s, in world axes"};
      });
}

Finding inertia(const Method& method) {
  const Body rod = box({Real(0.05), Real(0.5), Real(0.05)}, 3);
  constexpr double angle = 1;
  const auto fill = [&](World& world) {
    world.add(
        Body(rod).turned(angle, Vec3::UnitZ()).at({Real(0.5 * std::sin(angle)), Real(-0.5 * std::cos(angle)), 0}));
  };
  const auto swung = [&](double share) {
    return truth::places_of_hanging({{.mass = 3,
                                      .inertia = share / static_cast<double>(rod.principal_inverse_inertia.z()),
                                      .to_centre = 0.5,
                                      .to_next = 1}},
                                    angle, 30)
        .back()[0];
  };
  return finding(method, "inertia", motion(0.5, fill, {{the_world, 0, Vec3::Zero()}}),
                 [&](const std::vector<Places>& all) -> Said {
                   const Eigen::Vector3d at = all.back()[0], right = swung(1);
                   const std::string is =
                       fmt::format("the middle of a rod that swings is at {} after 0.5 s, where {} is right", text(at),
                                   text(right));
                   if ((at - right).norm() < 0.01) return {true, is};
                   if ((at - swung(0)).norm() < 0.01) return {false, is + ": as if all its mass were in its middle"};
                   return {false, is + ": inertia is that which the scene gives, in kg m^2, about the body's own axes"};
                 });
}

Finding gyroscope(const Method& method) {
  return finding(method, "gyroscope", motion(0.25, any_motion_named("top").fill, any_motion_named("top").pins),
                 [](const std::vector<Places>& all) -> Said {
                   const Eigen::Vector3d at = all.back()[0], right = any_motion_named("top").truth(15).back()[0];
                   const std::string is =
                       fmt::format("a top on a pin is at {} after 0.25 s, where {} is right", text(at), text(right));
                   if ((at - right).norm() < 0.03) return {true, is};
                   return {false,
                           is + ": the angular momentum is to stay, not the angular velocity (a gyroscopic torque)"};
                 });
}

Finding friction(const Method& method) {
  constexpr double mu = 0.6, speed = 4;
  const Eigen::Vector3d ahead = Eigen::Vector3d(1, 0, 1).normalized();
  const auto fill = [&](World& world) {
    world.add(ground().rough(Real(mu)));
    world.add(box({Real(0.5), Real(0.1), Real(0.5)}, 10)
                  .at({0, Real(0.1), 0})
                  .moving((speed * ahead).cast<Real>())
                  .rough(Real(mu)));
  };
  return finding(method, "friction", motion(2, fill), [&](const std::vector<Places>& all) -> Said {
    const Eigen::Vector3d way = way_of(all, 1);
    const double along = way.dot(ahead), aside = (way - along * ahead - way.y() * Eigen::Vector3d::UnitY()).norm();
    const double late = (all.back()[1] - all[all.size() - 7][1]).norm();
    if (std::abs(way.y()) > 0.05)
      return {false,
              fmt::format("a box on the ground goes {:.3g} m up: they do not touch, or not as they are", way.y())};
    if (along < 1e-3)
      return {false,
              "a box with 4 m/s stops at once: friction many times too strong, as of a force taken for an impulse"};
    const double is_mu = speed * speed / (2 * truth::g * along);
    const std::string is =
        fmt::format("a box with 4 m/s slides {:.4g} m and {:.2g} m aside, as by a friction of {:.4g}; {} was asked",
                    along, aside, is_mu, mu);
    const auto near = [&](double value) { return std::abs(is_mu / value - 1) < 0.03; };
    if (late > 1e-3 || along > 7.9) return {false, is + ": it does not stop"};
    if (aside > 0.05) return {false, is + ": a friction pyramid on axes of its own"};
    if (near(mu)) return {true, is};
    if (near(mu * mu)) return {false, is + ": the product of both bodies' friction; give each body its square root"};
    if (near(2 * mu)) return {false, is + ": the sum of both bodies' friction; give each body half"};
    if (near(mu * std::sqrt(2.0))) return {false, is + ": a friction pyramid on fixed axes, stronger at 45 degrees"};
    return {false, is};
  });
}

Finding restitution(const Method& method) {
  constexpr double e = 0.5, drop = 1;
  const auto fill = [](World& world) {
    world.add(ground().bouncy(Real(e)));
    world.add(sphere(Real(0.5), 10).at({0, Real(0.5 + drop), 0}).bouncy(Real(e)));
  };
  return finding(method, "restitution", motion(1, fill), [&](const std::vector<Places>& all) -> Said {
    // It falls for 0.452 s, and is highest again 0.226 s later; looked for among all that come after.
    double highest = -1;
    for (std::size_t frame = 29; frame < all.size(); ++frame) highest = std::max(highest, all[frame][1].y() - 0.5);
    if (highest > 0.9)
      return {false,
              fmt::format("a ball dropped by 1 m is at {:.3g} m again: it does not touch the ground as it should",
                          highest)};
    const double is_e = std::sqrt(std::max(0.0, highest) / drop);
    const std::string is = fmt::format(
        "a ball dropped by 1 m comes up to {:.3g} m, a restitution of {:.3g}; {} was asked", highest, is_e, e);
    if (std::abs(is_e - e) < 0.03) return {true, is};
    if (std::abs(is_e - e * e) < 0.03) return {false, is + ": the product of both bodies' restitution"};
    if (is_e < 0.02) return {false, is + ": it does not bounce"};
    return {false, is};
  });
}

Finding sleep(const Method& method) {
  const auto fill = [](World& world) {
    world.gravity.setZero();
    world.add(sphere(Real(0.3), 2).moving({Real(0.005), 0, 0}));
  };
  return finding(method, "sleep", motion(5, fill), [](const std::vector<Places>& all) -> Said {
    const double way = way_of(all).norm();
    const std::string is = fmt::format("a ball of 5 mm/s goes {:.3g} mm in 5 s, where 25 mm is right", 1000 * way);
    if (std::abs(way - 0.025) < 1e-4) return {true, is};
    const double last = (all.back()[0] - all[all.size() - 2][0]).norm();
    return {false, is + (last < 1e-9 ? ": it has fallen asleep" : "")};
  });
}

Finding margins(const Method& method) {
  const auto fill = [](World& world) {
    world.add(ground());
    world.add(sphere(Real(0.5), 10).at({0, Real(0.5), 0}));
    world.add(box(Vec3::Constant(Real(0.5)), 10).at({3, Real(0.5), 0}));
    world.add(box(Vec3::Constant(Real(0.5)), 10).at({3, Real(1.5), 0}));
  };
  return finding(method, "margins", motion(2, fill), [](const std::vector<Places>& all) -> Said {
    const auto up = [&](std::size_t body) { return 1000 * way_of(all, body).y(); };
    const std::string is = fmt::format(
        "after 2 s a ball has come up by {:.3g} mm, a box by {:.3g} mm, one upon it by {:.3g} mm", up(1), up(2), up(3));
    const double most = std::max({up(1), up(2), up(3)}), least = std::min({up(1), up(2), up(3)});
    if (most > 1) return {false, is + ": a margin around shapes"};
    if (least < -50) return {false, is + ": they do not touch"};
    if (least < -1) return {false, is + ": contacts give way, or overlap is allowed"};
    return {true, is};
  });
}

/// Two boxes with a pin in the middle of what they share.
Finding pinned(const Method& method) {
  const auto fill = [](World& world) {
    world.gravity.setZero();
    world.add(box({Real(0.5), Real(0.1), Real(0.1)}, 1));
    world.add(box({Real(0.5), Real(0.1), Real(0.1)}, 1).at({Real(0.8), 0, 0}));
  };
  return finding(method, "pinned pairs", motion(0.5, fill, {{0, 1, {Real(0.4), 0, 0}}}),
                 [](const std::vector<Places>& all) -> Said {
                   const double moved = std::max(way_of(all).norm(), way_of(all, 1).norm());
                   const std::string is =
                       fmt::format("two boxes that overlap and are pinned have moved by {:.3g} mm", 1000 * moved);
                   return {moved < 1e-3, moved < 1e-3 ? is : is + ": pinned pairs do not collide"};
                 });
}

Finding repeats(const Method& method) {
  const auto fill = [](World& world) { stack(world, 4); };
  const Motion stacked = motion(1, fill);
  return finding(method, "same bits", stacked, [&](const std::vector<Places>& all) -> Said {
    const std::vector<Places> again = places_of(method, stacked);
    for (std::size_t frame = 0; frame < all.size(); ++frame)
      for (std::size_t body = 0; body < all[frame].size(); ++body)
        if (all[frame][body] != again[frame][body])
          return {false, fmt::format("played twice, body {} of a stack is at {} and at {} in frame {}", body,
                                     text(all[frame][body]), text(again[frame][body]), frame)};
    return {true, "played twice, a stack does the same to the last bit"};
  });
}

Finding clock_of(const Method& method) {
  const Motion stacked = motion(1, [](World& world) { stack(world, 4); });
  if (!method.plays(stacked)) return {"clock", Finding::not_played, "it says that it does not play a stack"};
  MotionRun run(stacked, method, kit);
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < stacked.frames(); ++i) run.frame();
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (!run.player().seconds()) return {"clock", Finding::right, "it is timed from here"};
  const double own = *run.player().seconds();
  const std::string is =
      fmt::format("a second of a stack took {:.4g} ms by its clock, and {:.4g} ms with all that is asked and answered",
                  1000 * own, 1000 * wall);
  // No engine takes 960 steps of a stack of four in less than 10 ns each.
  return {"clock", own > 1e-5 && own <= wall ? Finding::right : Finding::wrong, is};
}

}  // namespace

std::vector<Finding> findings_of(const Method& method) {
  std::vector<Finding> all;
  for (const auto& ask : {places, gravity, damping, turning, inertia, gyroscope, friction, restitution, sleep, margins,
                          pinned, repeats, clock_of})
    all.push_back(ask(method));
  return all;
}

std::string kit_setting(const Method& method) {
  return fmt::format("{} substeps of 1/60 s{}", kit.substeps,
                     method.sweeps ? fmt::format(", of {} sweeps each", kit.sweeps) : "");
}

}  // namespace pushback
