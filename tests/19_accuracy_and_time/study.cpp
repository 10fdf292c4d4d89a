/// Chapter 19: limits of what was measured, and the programs that measure. No test looks at a clock.
#include <fmt/format.h>

#include <cmath>

#include "pushback/common/basics/input.h"
#include "pushback/tools/measure/study/every_motion.h"
#include "pushback/tools/measure/study/limits.h"
#include "pushback/tools/measure/study/report.h"
#include "tests/support/call.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"

using namespace pushback;
using namespace pushback::study;

// ---- limits ----------------------------------------------------------------------------------------------------------

namespace {

/// a + b h^p at h = 1, 1/2 ...
std::vector<double> errors(double a, double b, double p, int settings) {
  std::vector<double> found;
  for (int i = 0; i < settings; ++i) found.push_back(a + b * std::pow(2, -p * i));
  return found;
}

}  // namespace

TEST_CASE("what remains as h goes to 0 is found, and of which order the rest is") {
  for (const double p : {0.5, 1.0, 1.5, 2.0, 3.0}) {
    for (const double b : {-0.5, 0.02, 1.0, 10.0}) {
      INFO("p " << p << " b " << b);
      const Limit limit = limit_of(errors(1, b, p, 10));
      CHECK(limit.kind == Limit::Kind::reached);
      CHECK(limit.least == Approx(1).epsilon(1e-6));
      CHECK(limit.most == limit.least);
      CHECK(limit.order == Approx(p).epsilon(1e-6));
    }
  }
}

TEST_CASE("what falls to 0 has no limit but a bound, which is no less than what remains") {
  for (const double p : {0.5, 1.0, 2.0}) {
    for (const double a : {0.0, 1e-5}) {  // of which nothing can be seen yet
      const auto fall = errors(a, 3, p, 8);
      const Limit limit = limit_of(fall);
      CHECK(limit.kind == Limit::Kind::falling);
      CHECK((limit.least == 0 && limit.most == fall.back()));
      CHECK(limit.order == Approx(p).margin(0.05));
    }
  }
  CHECK(limit_of({4, 2, 0}).most == 0);
  // Of second order too, where an extrapolation of first order would stop short of it.
  std::vector<double> both;
  for (double h = 1; h > 1e-3; h /= 2) both.push_back(h + 10 * h * h);
  CHECK(limit_of(both).kind == Limit::Kind::falling);
}

// ---- rounds ----------------------------------------------------------------------------------------------------------

namespace {

/// A script: it prints `methods`, and for settings what `answers` says, lines of a shell's case.
void write_program(const fs::path& file, const std::string& methods, const std::string& answers) {
  std::ofstream(file) << "#!/bin/sh\nshift\n"
                      << "if [ $# = 0 ]; then printf '" << methods << "'; exit 0; fi\n"
                      << "for s in \"$@\"; do case $s in --*) break;; " << answers << " esac; done\nexit 0\n";
  fs::permissions(file, fs::perms::owner_all);
}

/// What `measure` throws with such a program.
std::string failure(const std::string& methods, const std::string& answers) {
  const Scratch scratch;
  write_program(scratch / "motion_odd", methods, answers);
  Motion motion = motion_named("bounce");
  motion.most_substeps = motion.most_passes = 2;
  motion.most_sweeps = 1;
  try {
    const Measurements found = measure(motion, {.engines = {{"motion_odd", "odd", ""}}, .programs = scratch / "."});
    CHECK(found.size() == (methods.empty() ? 0 : 2));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a program that fails, or prints what is no measurement, is named") {
  for (const auto& [answers, part] : std::vector<std::pair<std::string, std::string>>{
           {"*) exit 3;;", "failed"},
           {"*) echo garbage;;", "garbage"},
           {"*) echo \"$s error soon seconds 1 row-solves 5\";;", "soon"},
           {"*) echo \"$s error nan seconds 1 row-solves 5\";;", "nan"},
           {"*) echo \"$s error -1 seconds 1 row-solves 5\";;", "-1"},
           {"*) echo \"$s error 1 seconds soon row-solves 5\";;", "soon"},
           {"*) echo \"$s error 1 seconds 0 row-solves 5\";;", "no time"},
           {"*) echo \"$s error 1 seconds 1\";;", "a/1/1"},
           {"*) echo \"$s error 1 seconds 1 row-solves many\";;", "many"},
           {"*) echo \"b/1/1 error 1 seconds 1 row-solves 5\";;", "b/1/1"},
           {"a/1/1) echo \"$s error 1 seconds 1 row-solves 5\";;", "printed 1 lines for 2 settings"}}) {
    const std::string said = failure("a/SMALL-STEPS/SWEEPS: method\\n", answers);
    INFO(answers << ": " << said);
    CHECK(contains(said, "motion_odd"));
    CHECK(contains(said, part));
  }
  const std::string good = "*) echo \"$s error 1e-3 seconds 2e-2 row-solves 5\";;";
  CHECK(failure("a/SMALL-STEPS/SWEEPS: method\\n", good).empty());
  CHECK(failure("", good).empty());                                              // it plays nothing of this
  CHECK(failure("a/SMALL-STEPS/SWEEPS: method\\n", "*) kill -9 $$;;").empty());  // what crashes is lost
}

TEST_CASE("one method is measured again, in rounds if it is near a front, or a whole engine, and nothing else") {
  const Scratch scratch;
  const std::string answers =
      "new/1024) echo \"$s error 2e-3 seconds 2.4e-2 row-solves 5\";; *) echo \"$s error 2e-3 seconds 2e-2 row-solves "
      "5\";;";
  write_program(scratch / "motion_odd", "", answers);
  write_program(scratch / "motion_mine", "new/SMALL-STEPS: method\\n", answers);
  const auto before = [](const std::string& method, int substeps, const std::vector<double>& seconds) {
    return Measured{
        .engine = "motion_odd", .method = method, .substeps = substeps, .sweeps = 1, .error = 1, .seconds = seconds};
  };
  Measurements all{before("a", 1, {1, 2, 3}), before("b", 1, {1, 2}), before("a", 2, {1}), before("old", 1, {1})};
  all[3].engine = "motion_mine";
  const auto again = [&](const std::string& method) {
    return measure_again(method, motion_named("bounce"), {.engines = {}, .programs = scratch / "."}, all);
  };
  CHECK(again("a") == 2);
  CHECK(all[0].seconds == std::vector<double>(1 + 10, 0.02));
  CHECK(all[1].seconds == std::vector<double>{1, 2});
  CHECK(all[2].seconds == std::vector<double>(1 + 10, 0.02));
  CHECK(all[0].error == 2e-3);
  CHECK(all[1].error == 1);
  CHECK(again("c") == 0);
  CHECK(again("motion_mine") == 12);
  CHECK(all[13].seconds.size() == 1 + 3);  // near the front, but decides nothing
  CHECK((all[1].seconds.size() == 2 && all[3].setting() == "new/1" && all[3].seconds.size() == 1 + 10));
}

TEST_CASE("what is no line of measurements is refused") {
  const std::string heading = lines_of(csv_of({}))[0] + "\n", good_line = "bounce,motion,a,1,1,1e-3,5,1,1,1,1 2";
  CHECK(read_csv(heading + good_line + "\n").at("bounce")[0].median() == 1.5);
  for (const char* line : {"", "bounce,motion,a,1,1,1e-3,5,1,1,1,", "bounce,motion,a,1,1,1e-3,5,1,1,1,1 x",
                           "bounce,motion,a,1,1,1e-3,x,1,1,1,1", "bounce,motion,a,one,1,1e-3,5,1,1,1,1"}) {
    INFO(line);
    CHECK_THROWS_AS(read_csv(heading + line + "\n"), InvalidInput);
  }
  CHECK_THROWS_AS(read_csv(good_line), InvalidInput);
}

// ---- errors that are measured ---------------------------------------------------------------------------------------

namespace {

/// m, of a setting that the program plays.
double error(const std::string& motion, const std::string& setting, const fs::path& program = MOTION_WIDE_PROGRAM) {
  const Ended played = call_program(program, motion + " " + setting + " --at-least 0 --at-most 3600", 300);
  INFO(motion << " " << setting << ": " << played.out << played.err);
  REQUIRE(played.out.starts_with(setting + " error "));
  return std::stod(played.out.substr(setting.size() + 7));
}

}  // namespace

TEST_CASE("the errors of the committed study are those that its settings have") {
  const AllMeasured all = read_csv(text_of("renders/19_accuracy_and_time/study.csv"));
  struct Kept {
    std::string motion, engine, setting;
  };
  for (const Kept& kept : {Kept{"bounce", "motion", "slim/16/4"},
                           {"stack-10", "motion", "direct-contacts/16/1"},
                           {"chain", "motion", "direct-joints/32/1"},
                           {"break", "motion_wide", "impact/1"},
                           {"pyramid-10", "motion_wide", "half-step/1"},
                           {"conveyor", "motion_wide", "half-step/4"}}) {
    INFO(kept.motion << " " << kept.setting);
    const Measurements& of_motion = all.at(kept.motion);
    const auto found = std::find_if(of_motion.begin(), of_motion.end(), [&kept](const Measured& one) {
      return one.engine == kept.engine && one.setting() == kept.setting;
    });
    REQUIRE(found != of_motion.end());
    const double now = error(kept.motion, kept.setting, fs::path(MOTION_PROGRAM).parent_path() / kept.engine);
    CHECK(now == Approx(found->error).epsilon(1e-3).margin(1e-11));
  }
}

TEST_CASE(
    "half steps are of second order, what is cut at impacts stays so, and an impact at a step's end is of first") {
  const double top = error("top", "half-step/8"), meets = error("pendulum-at-wall", "impact/4");
  CHECK(top < 1e-4);
  CHECK(top / error("top", "half-step/32") == Approx(16).epsilon(0.05));
  CHECK(error("top", "order-4/1") / error("top", "order-4/2") == Approx(16).epsilon(0.2));
  CHECK(error("top", "wide/64/1") / error("top", "wide/256/1") == Approx(4).epsilon(0.1));
  CHECK(error("chain", "half-step/64") < 1e-6);  // another solver than the one that made its truth
  CHECK(meets < 1e-4);
  CHECK(meets / error("pendulum-at-wall", "impact/16") == Approx(16).epsilon(0.05));
  // An impact at the end of the substep is of first order.
  CHECK(error("pendulum-at-wall", "half-step/8") > 30 * error("pendulum-at-wall", "impact/8"));
  const Ended back = call_program(MOTION_WIDE_PROGRAM, "pendulum-at-wall order-4/1");
  CHECK(back.status == 2);  // contacts do not go back in time
  CHECK(back.out.empty());
}

TEST_CASE("the committed tables are those of the committed measurements") {
  const AllMeasured measured = read_csv(text_of("renders/19_accuracy_and_time/study.csv"));
  std::vector<MotionMeasured> all;
  for (const Motion& motion : every_motion()) all.push_back({&motion, measured.at(motion.name)});
  for (const auto& [file, table] : {std::pair{"regimes", table_of_regimes(all)},
                                    {"next", table_of_next(all)},
                                    {"half_steps", table_of_half_steps(all)},
                                    {"once", table_of_once(all)},
                                    {"choices", table_of_choices(all)},
                                    {"knobs", table_of_knobs(all)},
                                    {"limits", table_of_limits(all)},
                                    {"cheapest", table_of_cheapest(all)},
                                    {"engines", table_of_engines(all, engines_of(measured))},
                                    {"others", table_of_others(all, engines_of(measured))}}) {
    INFO(file);
    CHECK(table == text_of(fmt::format("renders/19_accuracy_and_time/{}.md", file)));
  }
  const Scratch scratch;
  const fs::path folder = scratch / "26_to_each_its_own";
  fs::create_directories(folder);
  fs::copy("renders/26_to_each_its_own/prices.csv", folder);
  REQUIRE(call_program(PRICES_PROGRAM, "--redraw --out '" + (scratch / "").string() + "'").status == 0);
  CHECK(text_of(folder / "prices.md") == text_of("renders/26_to_each_its_own/prices.md"));
  const auto lines = [&] { return lines_of(text_of(folder / "prices.csv")); };
  const std::size_t before = lines().size();
  REQUIRE(call_program(PRICES_PROGRAM, "--renew gaps --rounds 1 --out '" + (scratch / "").string() + "'").status == 0);
  CHECK(lines().size() == before);  // of engines that are not built, too
  CHECK(lines_of(text_of(folder / "prices.md"))[2] == lines_of(text_of("renders/26_to_each_its_own/prices.md"))[2]);
  CHECK(call_program(PRICES_PROGRAM, "--renew nothing --out '" + (scratch / "").string() + "'").status == 2);
}

// ---- the program -----------------------------------------------------------------------------------------------------

TEST_CASE("the study refuses what it cannot do, before it has written anything") {
  const Scratch scratch;
  for (const auto& [arguments, part] : std::vector<std::pair<std::string, std::string>>{
           {"--only nothing", "'nothing'"}, {"--renew within", "study.csv"}}) {
    const Ended ended = call_program(STUDY_PROGRAM, arguments + " --out '" + (scratch / "out").string() + "'");
    INFO(arguments << ": " << ended.err);
    CHECK(ended.status == 2);
    CHECK(contains(ended.err, part));
    CHECK(!fs::exists(scratch / "out"));
  }
}
