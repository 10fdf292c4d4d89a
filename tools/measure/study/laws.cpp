#include <fmt/format.h>

#include <algorithm>

#include "pushback/tools/measure/results/markdown.h"
#include "pushback/tools/measure/study/limits.h"
#include "pushback/tools/measure/study/relaxed_law.h"
#include "pushback/tools/measure/study/report.h"

namespace pushback::study {

namespace {

/// In what a method's equations differ from those of Newton, Signorini and Coulomb, whatever the step.
struct Law {
  const char* method;
  const char* says;
};
constexpr Law laws[] = {{"full", "friction pyramid; slop of 5 mm"},
                        {"full-cold", "the same"},
                        {"slim", "slop of 0.1 mm"},
                        {"slim-cold", "the same"},
                        {"no-slop", "nothing"},
                        {"split", "nothing"},
                        {"nonlinear", "nothing"},
                        {"soft", "springs; never harder than 240 Hz"},
                        {"steady", "the same"},
                        {"steady-cold", "the same"},
                        {"direct-contacts", "rest depth of 1 µm"},
                        {"once", "springs; never harder than 240 Hz"},
                        {"wide", "the same"},
                        {"wide-float", "the same; rows in float"},
                        {"wide-stiff", "springs as hard as the substeps allow"},
                        {"joints", "nothing"},
                        {"warm-joints", "adds up its position correction"},
                        {"split-joints", "nothing"},
                        {"steady-joints", "nothing"},
                        {"direct-joints", "nothing"},
                        {"jointed", "nothing"},
                        {"half-step", "nothing"},
                        {"order-4", "nothing"},
                        {"impact", "nothing"},
                        {"by-island", "as `wide` where contacts are many"},
                        {"within", "as `by-island`; springs as hard as the substeps allow; threshold up to 1 mm/s"},
                        {"xpbd", "velocities' normal impulses carry no friction"},
                        {"avbd", "nothing; no restitution"},
                        {"nncg", "slop of 0.1 mm"},
                        {"sap", "relaxed cone; springs as hard as the step allows; no restitution"},
                        {"sap-lagged", "friction a step late; springs as hard as the step allows; no restitution"},
                        {"bullet", "friction pyramid along the slip; float"},
                        {"bullet-split", "the same"},
                        {"bullet-nncg", "the same"},
                        {"bullet-dantzig", "the same; softness"},
                        {"bullet-double", "friction pyramid along the slip"},
                        {"bullet-double-split", "the same"},
                        {"bullet-double-nncg", "the same"},
                        {"bullet-double-dantzig", "the same; softness"},
                        {"ode", "friction pyramid on fixed axes; softness"},
                        {"ode-aligned", "friction pyramid along the slip; softness"},
                        {"ode-exact", "the same"},
                        {"box3d", "springs of 30 Hz; bounces after all substeps, from 1 m/s on; float"},
                        {"box3d-stiff", "springs as hard as the substeps allow; bounces after all substeps; float"},
                        {"box3d-often", "the same, in each substep"},
                        {"box3d-manifolds-anew", "as `box3d-stiff`"},
                        {"jolt", "slop of 20 mm; bounces from 1 m/s on; no gyroscopic torque; float"},
                        {"jolt-tuned", "nothing; float"},
                        {"jolt-close", "nothing; float"},
                        {"mujoco", "relaxed cone; springs as hard as the step allows"},
                        {"mujoco-default", "relaxed cone; springs of 0.02 s"},
                        {"mujoco-pgs", "as `mujoco`"},
                        {"mujoco-noslip", "as `mujoco`, with less slip"},
                        {"mujoco-tolerance", "as `mujoco`"},
                        {"mujoco-pyramid", "as `mujoco`; friction pyramid on fixed axes"},
                        {"mujoco-cg", "as `mujoco`"},
                        {"mujoco-bounce", "springs that bounce, as hard as the step allows"},
                        {"mujoco-rk4", "as `mujoco`; nothing on pins"},
                        {"mujoco-connect", "springs as hard as the step allows"}};

std::string law_of(const std::string& method) {
  for (const Law& law : laws)
    if (law.method == method) return law.says;
  return "–";
}

}  // namespace

std::string table_of_limits(const std::vector<MotionMeasured>& all) {
  std::string text;
  for (const std::vector<std::string>& names :
       {std::vector<std::string>{"bounce", "incline", "sliding", "rolling", "break"},
        {"stack-10", "pyramid-10", "heavy-on-light"},
        {"pendulum", "chain", "top", "pendulum-at-wall"},
        {"gaps", "superball", "conveyor"},
        {"grasp", "chaplygin", "hulls-1015"}}) {
    std::vector<const MotionMeasured*> motions;
    for (const std::string& name : names)
      for (const MotionMeasured& measured : all)
        if (measured.motion->name == name) motions.push_back(&measured);
    if (motions.empty()) continue;
    std::vector<std::string> heads{"method", "what its law adds or leaves out"};
    for (const MotionMeasured* measured : motions) heads.push_back(fmt::format("`{}`", measured->motion->name));
    text += (text.empty() ? "" : "\n") + markdown_heads(heads);
    std::vector<std::pair<std::string, std::string>>
        rows;  // engine and method, in the order in which they were measured
    for (const MotionMeasured* measured : motions)
      for (const Measured& one : measured->all)
        // Float is left to the engines that have nothing else.
        if (const std::pair row{one.engine, one.method};
            one.engine != "motion_float" && std::find(rows.begin(), rows.end(), row) == rows.end())
          rows.push_back(row);
    for (const auto& [engine, method] : rows) {
      std::vector<std::string> cells{fmt::format("`{}`", method), law_of(method)};
      for (const MotionMeasured* measured : motions) cells.push_back(limit_of(measured->all, engine, method).text());
      text += markdown_row(cells);
    }
  }
  return text;
}

std::string table_of_hops(const std::vector<MotionMeasured>& all) {
  std::string text = markdown_heads(
      {"motion", "lift-off", "top of the first hop", "error there", "`mujoco` as h → 0", "`mujoco-pgs` as h → 0"});
  for (const MotionMeasured& measured : all) {
    const auto hop = hop_of(*measured.motion);
    if (!hop) continue;
    const auto remains = [&](const std::string& method) {
      return limit_of(measured.all, "motion_mujoco", method).remains();
    };
    text += fmt::format("| {} | {:.3f} m/s | {:.1f} mm | {:.1f} mm | {} | {} |\n", measured.motion->title, hop->speed,
                        1000 * hop->height, 1000 * hop->error, remains("mujoco"), remains("mujoco-pgs"));
  }
  return text;
}

}  // namespace pushback::study
