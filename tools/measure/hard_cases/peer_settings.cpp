/// In which settings other engines play hard cases. They were named before the first of the further ones was played.
#include "pushback/tools/measure/hard_cases/peers.h"

namespace pushback {

namespace {

constexpr Real of_float = Real(std::numeric_limits<float>::epsilon());

std::vector<PeerSetting> bullet() {
  return {
      {.name = "Bullet", .what = "as it comes: float, 10 iterations a step", .engine = "bullet", .epsilon = of_float},
      {.name = "Bullet for accuracy",
       .what = "double, 8 substeps of 50 iterations, friction in two directions, split impulse at any depth, all of "
               "the warm start, ERP 0.8 for joints, continuous detection; what bounces touches from where it "
               "touches, and bounces at any speed; a margin of 0.1 mm around hulls",
       .tuned = true,
       .substeps = 8,
       .sweeps = 50,
       .options = "continuous"},
      {.what = "4 substeps of 10 iterations", .tuned = true, .substeps = 4},
      {.what = "8 substeps of 50 iterations, without continuous detection", .tuned = true, .substeps = 8, .sweeps = 50},
      {.what = "8 substeps of 50 iterations, no split impulse",
       .tuned = true,
       .substeps = 8,
       .sweeps = 50,
       .options = "joint"},
      {.what = "32 substeps of 10 iterations", .tuned = true, .substeps = 32},
      {.what = "32 substeps of 50 iterations", .tuned = true, .substeps = 32, .sweeps = 50},
      {.what = "a step of 400 iterations", .tuned = true, .sweeps = 400},
      {.what = "8 substeps, solved directly by Dantzig's method", .tuned = true, .substeps = 8, .options = "dantzig"},
      {.what = "8 substeps of 50 iterations of conjugate gradients",
       .tuned = true,
       .substeps = 8,
       .sweeps = 50,
       .options = "nncg"}};
}

std::vector<PeerSetting> ode() {
  return {
      {.name = "ODE", .what = "as it comes: QuickStep, 20 iterations a step, friction as a pyramid", .sweeps = 20},
      {.name = "ODE for accuracy",
       .what = "8 substeps; up to 16 contacts are solved directly, more by QuickStep in 200 iterations; the pyramid "
               "lies along the sliding; overlap stays up to 0.5 mm and is pushed out at 3 m/s at most",
       .tuned = true,
       .substeps = 8,
       .sweeps = 200,
       .options = "few"},
      {.what = "8 substeps of 20 iterations", .tuned = true, .substeps = 8, .sweeps = 20},
      {.what = "8 substeps of 200 iterations", .tuned = true, .substeps = 8, .sweeps = 200},
      {.what = "8 substeps, all solved directly", .tuned = true, .substeps = 8, .options = "direct"},
      {.what = "a step, all solved directly", .tuned = true, .options = "direct"},
      {.what = "32 substeps, all solved directly", .tuned = true, .substeps = 32, .options = "direct"},
      {.what = "a step of 400 iterations", .tuned = true, .sweeps = 400},
      {.what = "32 substeps of 50 iterations", .tuned = true, .substeps = 32, .sweeps = 50},
      {.what = "32 substeps of 200 iterations, up to 16 contacts solved directly",
       .tuned = true,
       .substeps = 32,
       .sweeps = 200,
       .options = "few"}};
}

/// Hard: contacts with solref 2 h, solimp 0.9999.
std::vector<PeerSetting> mujoco() {
  const auto hard = [](int substeps, const std::string& options) {
    return PeerSetting{.what = fmt::format("{} hard substeps, {}", substeps, options),
                       .tuned = true,
                       .substeps = substeps,
                       .options = options};
  };
  PeerSetting accurate = hard(8, "cone='elliptic' impratio='10' tolerance='1e-10' iterations='200'");
  accurate.name = "MuJoCo for accuracy";
  accurate.what =
      "8 substeps, an elliptic cone, impratio 10, tolerance 1e-10, contacts as hard as the substep allows "
      "(solref 2 h, solimp 0.9999)";
  return {
      {.name = "MuJoCo",
       .what =
           "as it comes: steps of 2 ms, Newton's method, friction as a pyramid, contacts of a time constant of 0.02 s",
       .substeps = 8},
      accurate,
      hard(8, "cone='elliptic' tolerance='1e-12' iterations='200'"),
      hard(8, "cone='elliptic' noslip_iterations='3'"),
      hard(8, "cone='pyramidal'"),
      hard(8, "cone='elliptic' integrator='RK4'"),
      hard(8, "cone='elliptic' solver='CG'"),
      hard(32, "cone='elliptic' tolerance='1e-12' iterations='200'"),
      hard(32, "cone='elliptic' impratio='100' tolerance='1e-10' noslip_iterations='3'"),
      {.what = "8 substeps of soft contacts, cone='elliptic' impratio='10'",
       .substeps = 8,
       .options = "cone='elliptic' impratio='10'"}};
}

std::vector<PeerSetting> box3d() {
  const auto stiff = [](int substeps, int own, const std::string& options = "") {
    return PeerSetting{.what = fmt::format("as stiff, {} step{} of {} substeps{}", substeps, substeps > 1 ? "s" : "",
                                           own, options == "anew" ? ", manifolds made in each step" : ""),
                       .tuned = true,
                       .substeps = substeps,
                       .own_substeps = own,
                       .options = options};
  };
  PeerSetting accurate = stiff(8, 8, "bullets");
  accurate.name = "Box3D for accuracy";
  accurate.what =
      "8 steps of 8 substeps, contacts and joints as stiff as these allow; what bounces does so at any speed; bodies "
      "may "
      "have 10 km/s; those that begin fast are bullets";
  return {{.name = "Box3D", .what = "as it comes: float, 4 substeps", .own_substeps = 4},
          accurate,
          stiff(1, 8),
          stiff(1, 32),
          stiff(8, 8),
          stiff(8, 4),
          stiff(32, 4),
          stiff(8, 4, "anew"),
          {.what = "32 substeps, as it comes otherwise", .own_substeps = 32},
          {.what = "8 steps of 4 substeps, as it comes otherwise", .substeps = 8, .own_substeps = 4}};
}

std::vector<PeerSetting> jolt() {
  const auto tuned = [](int substeps, int sweeps, const std::string& options, const std::string& what) {
    return PeerSetting{
        .what = fmt::format("{} substeps of {} and {} iterations, {}", substeps, sweeps, std::max(1, sweeps / 4), what),
        .tuned = true,
        .substeps = substeps,
        .sweeps = sweeps,
        .options = options};
  };
  PeerSetting accurate = tuned(8, 16, "cast close", "");
  accurate.name = "Jolt for accuracy";
  accurate.what =
      "8 substeps of 16 velocity and 4 position iterations, bounces at any speed, no allowed overlap, no rounding, a "
      "gyroscopic torque, contacts from 1 mm on, and a cast along the way of each body";
  return {{.name = "Jolt",
           .what = "as it comes: float, 10 velocity and 2 position iterations a step, corners rounded by 50 mm"},
          accurate,
          tuned(8, 16, "", "contacts from 20 mm on"),
          tuned(8, 16, "close", "contacts from 1 mm on"),
          tuned(8, 16, "cast", "contacts from 20 mm on, cast"),
          tuned(4, 32, "close", "contacts from 1 mm on"),
          tuned(32, 16, "", "contacts from 20 mm on"),
          tuned(32, 16, "cast close", "contacts from 1 mm on, cast"),
          tuned(1, 100, "cast", "contacts from 20 mm on, cast"),
          {.what = "32 substeps, as it comes otherwise", .substeps = 32}};
}

}  // namespace

const std::vector<PeerSetting>& peer_settings() {
  static const std::vector<PeerSetting> all = [] {
    std::vector<PeerSetting> list;
    for (const auto& [engine, ten] : {std::pair("bullet_double", bullet()),
                                      {"ode", ode()},
                                      {"mujoco", mujoco()},
                                      {"box3d", box3d()},
                                      {"jolt", jolt()}})
      for (PeerSetting setting : ten) {
        const std::size_t place = list.size() % 10;
        setting.further = place > 1;
        if (setting.further) setting.name = fmt::format("{} {}", ten.front().name, place + 1);
        if (setting.engine.empty()) setting.engine = engine;
        if (ten.front().name == "Box3D" || ten.front().name == "Jolt") setting.epsilon = of_float;
        list.push_back(std::move(setting));
      }
    return list;
  }();
  return all;
}

}  // namespace pushback
