#include <cmath>

#include "pushback/common/basics/quantile.h"
#include "pushback/tools/measure/results/markdown.h"
#include "pushback/tools/measure/study/choice.h"
#include "pushback/tools/measure/study/report.h"

namespace pushback::study {

namespace {

bool is_one_of(const std::string& method, const std::vector<const char*>& methods) {
  return std::any_of(methods.begin(), methods.end(), [&](const char* one) { return method == one; });
}
bool is_of_last_chapters(const Measured& one) {
  return is_one_of(one.method, {"half-step", "order-4", "impact", "by-island", "within"});
}

/// Which of our settings are compared.
struct Regime {
  const char* name;
  bool (*has)(const Measured&);
};
constexpr Regime regimes[] = {
    {"all", [](const Measured&) { return true; }},
    {"without AVX2",
     [](const Measured& one) {
       return !one.method.starts_with("wide") && !is_one_of(one.method, {"by-island", "within"});
     }},
    {"without chapters 24 to 27", [](const Measured& one) { return !is_of_last_chapters(one); }},
    {"`Recommended`, the best of its settings",
     [](const Measured& one) { return is_one_of(one.method, {"by-island", "within"}); }},
    {"`Recommended`, no error set", [](const Measured& one) { return one.setting() == "by-island/2/1"; }},
    {"`Recommended` with 1 mm asked", [](const Measured& one) { return one.setting() == "within/1/1"; }}};

/// Whether the third differences of places are 0 at most times: each body that moves goes along parabolas.
bool is_piecewise_quadratic(const Motion& motion) {
  const std::vector<Places> at = motion.truth(motion.frames());
  int moving = 0, curved = 0;  // of all bodies in all frames
  for (std::size_t i = 3; i < at.size(); ++i)
    for (std::size_t body = 0; body < at[i].size(); ++body) {
      const Eigen::Vector3d first = at[i][body] - at[i - 1][body], before = at[i - 2][body] - at[i - 3][body];
      const double third = (first - 2 * (at[i - 1][body] - at[i - 2][body]) + before).norm();  // m
      moving += first.norm() > 1e-9 ? 1 : 0;
      curved += third > 1e-7 ? 1 : 0;
    }
  return 2 * curved <= moving;
}

/// Theirs by ours; infinite or 0: theirs or ours does not reach the error. Nothing: neither does.
std::optional<double> ratio(const Measurements& our, const Measurements& theirs, double error) {
  const auto one = cheapest(our, error), other = cheapest(theirs, error);
  if (!one) return other ? std::optional(0.0) : std::nullopt;
  return other ? other->median() / one->median() : std::numeric_limits<double>::infinity();
}

struct Compared {
  Measurements our, theirs;
};

std::string count_of(const std::vector<Compared>& motions, double error) {
  int ahead = 0, equal = 0;
  std::vector<double> ratios;
  for (const Compared& one : motions) {
    const auto times = ratio(one.our, one.theirs, error);
    if (!times) continue;
    ratios.push_back(*times);
    const int first = faster(one.our, one.theirs, error);
    ahead += first == 1 ? 1 : 0;
    equal += first == 0 ? 1 : 0;
  }
  const double next = ratios.empty() ? 0 : median(ratios);
  return fmt::format("{}, {} equal; {}", ahead, equal,
                     next == 0          ? "not reached"
                     : std::isinf(next) ? "no other"
                                        : plain(next, 2) + " ×");
}

}  // namespace

std::string table_of_regimes(const std::vector<MotionMeasured>& all) {
  std::vector<std::string> heads{"our settings", "number", "motions"};
  for (const Tolerance& tolerance : all_tolerances) heads.emplace_back(tolerance.name);
  std::string text = markdown_heads(heads);
  std::vector<bool> quadratic;
  for (const MotionMeasured& measured : all) quadratic.push_back(is_piecewise_quadratic(*measured.motion));
  for (const Regime& regime : regimes) {
    std::size_t number = 0;
    std::vector<Compared> of[3];  // all, quadratic, the others
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Compared one{those(of_maker(all[i].all, ours), regime.has), of_others(all[i].all)};
      number += one.our.size();
      of[0].push_back(one);
      of[quadratic[i] ? 1 : 2].push_back(one);
    }
    for (const auto& [group, name] : {std::pair{of[0], "all"}, {of[1], "quadratic or at rest"}, {of[2], "curved"}}) {
      std::vector<std::string> row{regime.name, std::to_string(number), fmt::format("{}, {}", group.size(), name)};
      for (const Tolerance& tolerance : all_tolerances) row.push_back(count_of(group, tolerance.error));
      text += markdown_row(row);
    }
  }
  return text;
}

std::string table_of_next(const std::vector<MotionMeasured>& all) {
  std::vector<std::string> heads{"motion"};
  for (const Tolerance& tolerance : all_tolerances) heads.emplace_back(tolerance.name);
  std::string text = markdown_heads(heads);
  for (const MotionMeasured& measured : all) {
    const Measurements our = of_maker(measured.all, ours), theirs = of_others(measured.all);
    std::vector<std::string> row{measured.motion->title};
    for (const auto& [error, name] : all_tolerances) {
      const auto times = ratio(our, theirs, error);
      row.push_back(!times               ? "not reached"
                    : std::isinf(*times) ? "ours only"
                                         : fmt::format("{} {}{}", maker_of(*cheapest(theirs, error)),
                                                       *times == 0 ? "only" : plain(*times, 2),
                                                       faster(our, theirs, error) == 0 ? ", equal" : ""));
    }
    text += markdown_row(row);
  }
  return text;
}

namespace {

/// A row a motion: our least time with some of our settings, and with others.
std::string table_of_two(const std::vector<MotionMeasured>& all, bool (*before)(const Measured&),
                         bool (*after)(const Measured&)) {
  std::string text = markdown_heads({"motion", "below 1 cm", "below 1 mm", "below 0.1 mm"});
  for (const MotionMeasured& measured : all) {
    const Measurements our = of_maker(measured.all, ours), ones = those(our, before), others = those(our, after);
    std::vector<std::string> row{measured.motion->title};
    for (const double error : {1e-2, 1e-3, 1e-4}) {
      const auto one = cheapest(ones, error), other = cheapest(others, error);
      const auto time = [&](const auto& found) {
        return found ? plain(per_frame(*measured.motion, found->median())) + " µs" : "not reached";
      };
      row.push_back(fmt::format("{}; {}", time(one), time(other)));
      if (one && other)
        row.back() +=
            faster(*one, *other) == 0 ? "; equal" : fmt::format("; {} ×", plain(one->median() / other->median(), 2));
    }
    text += markdown_row(row);
  }
  return text;
}

}  // namespace

std::string table_of_half_steps(const std::vector<MotionMeasured>& all) {
  return table_of_two(
      all, [](const Measured& one) { return !is_of_last_chapters(one); }, [](const Measured&) { return true; });
}

std::string table_of_once(const std::vector<MotionMeasured>& all) {
  return table_of_two(
      all, [](const Measured& one) { return one.engine != "motion_wide"; },
      [](const Measured& one) { return is_one_of(one.method, {"once", "wide", "wide-float"}); });
}

std::string table_of_choices(const std::vector<MotionMeasured>& all) {
  std::string text = markdown_heads({"motion", "engine", "error", "by its own error", "by the robust error"});
  for (const MotionMeasured& measured : all)
    for (const Engine& engine : known_engines()) {
      const Measurements own = of_engine(measured.all, engine.name), counted = robust(own);
      for (const auto& [error, name] : {tolerances[0], tolerances[1], tolerances[2]}) {
        const auto lucky = cheapest(own, error), found = cheapest(counted, error);
        if (!lucky || (found && found->median() < 2 * lucky->median())) continue;
        const auto same = std::find_if(counted.begin(), counted.end(),
                                       [&](const Measured& one) { return one.setting() == lucky->setting(); });
        text += markdown_row({measured.motion->title, engine.title, name,
                              fmt::format("`{}` ({} mm)", lucky->setting(), plain(1000 * same->error, 2)),
                              found ? fmt::format("`{}`, {} times as long", found->setting(),
                                                  plain(found->median() / lucky->median(), 2))
                                    : "not reached"});
      }
    }
  return text;
}

}  // namespace pushback::study
