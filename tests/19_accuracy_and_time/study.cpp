/// Chapter 19: fronts and limits of what was measured, the programs that measure, and parts that make the whole. No test looks at a
/// clock.
#include <fmt/format.h>

#include <cmath>
#include <random>

#include "pushback/common/basics/input.h"
#include "pushback/tools/measure/results/origin.h"
#include "pushback/tools/measure/study/every_motion.h"
#include "pushback/tools/measure/study/limits.h"
#include "pushback/tools/measure/study/report.h"
#include "tests/support/call.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"

using namespace pushback;
using namespace pushback::study;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

Measured point(double seconds, double error) {
  return {.engine = "motion", .method = "slim", .sweeps = 1, .error = error, .seconds = {seconds}};
}
/// Times and errors of few values, so that many are alike; some lost.
Measurements some(std::mt19937& random) {
  Measurements found;
  for (std::size_t count = 1 + random() % 30; found.size() < count;)
    found.push_back(
        point(1 + static_cast<double>(random() % 8), random() % 6 == 0 ? infinite : static_cast<double>(random() % 8)));
  return found;
}
bool no_worse(const Measured& one, const Measured& other) {
  return one.median() <= other.median() && one.error <= other.error;
}

}  // namespace

// ---- front -----------------------------------------------------------------------------------------------------------

TEST_CASE("the front is sorted, nobody on it is worse than another, and all else is") {
  std::mt19937 random(14);
  for (int trial = 0; trial < 500; ++trial) {
    const Measurements all = some(random), found = front(all);
    for (std::size_t i = 1; i < found.size(); ++i) {
      CHECK(found[i - 1].median() < found[i].median());
      CHECK(found[i - 1].error > found[i].error);
    }
    for (const Measured& one : all) {
      if (!std::isfinite(one.error)) continue;
      CHECK(std::any_of(found.begin(), found.end(), [&](const Measured& other) { return no_worse(other, one); }));
    }
    for (const Measured& one : found) {
      CHECK(std::isfinite(one.error));
      for (const Measured& other : all) CHECK((!no_worse(other, one) || no_worse(one, other)));
    }
    Measurements turned(all.rbegin(), all.rend());
    const Measurements again = front(turned);
    REQUIRE(again.size() == found.size());
    for (std::size_t i = 0; i < found.size(); ++i)
      CHECK((no_worse(again[i], found[i]) && no_worse(found[i], again[i])));
  }
  CHECK(front({}).empty());
  CHECK(front({point(1, infinite)}).empty());
}

TEST_CASE("the cheapest is the fastest of those that are near enough, and what is near the front is so by its factor") {
  std::mt19937 random(15);
  for (int trial = 0; trial < 500; ++trial) {
    const Measurements all = some(random);
    for (double error = -0.5; error < 9; ++error) {
      double least = infinite;
      for (const Measured& one : all)
        if (one.error <= error) least = std::min(least, one.median());
      const auto found = cheapest(all, error);
      REQUIRE(found.has_value() == std::isfinite(least));
      if (found) CHECK((found->median() == least && found->error <= error));
    }
    for (const Measured& one : all) {
      for (const double slack : {1.0, 2.0, 3.5}) {
        bool near = std::isfinite(one.error);
        for (const Measured& other : all)
          near = near && !(other.error <= one.error && slack * other.median() < one.median());
        CHECK(is_near_front(one, all, slack) == near);
      }
    }
  }
  CHECK(!cheapest({}, 1));
}

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

/// A program that is a script: it prints what `answers` (lines of a shell's case) say.
class StandIns {
 public:
  void add(const std::string& name, const std::string& methods, const std::string& answers) {
    const fs::path file = scratch_ / name;
    std::ofstream(file) << "#!/bin/sh\nshift\n"
                        << "if [ $# = 0 ]; then printf '" << methods << "'; exit 0; fi\n"
                        << "for s in \"$@\"; do case $s in --*) break;; " << answers << " esac; done\nexit 0\n";
    fs::permissions(file, fs::perms::owner_all);
    engines_.push_back({name, "called " + name});
  }
  RoundOptions options(int rounds) const { return {.engines = engines_, .programs = scratch_ / ".", .rounds = rounds}; }

 private:
  Scratch scratch_;
  std::vector<Engine> engines_;
};

const std::string good = "*) echo \"$s error 1e-3 seconds 2e-2 row-solves 5\";;";

Motion tried(int most_substeps, int most_sweeps, int most_passes) {
  Motion motion = motion_named("bounce");
  motion.most_substeps = most_substeps;
  motion.most_sweeps = most_sweeps;
  motion.most_passes = most_passes;
  return motion;
}
std::string failure(const Motion& motion, const RoundOptions& options) {
  try {
    measure(motion, options);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("what is no line of measurements is refused") {
  const std::string heading = lines_of(csv_of({}))[0] + "\n", good_line = "bounce,motion,a,1,1,1e-3,5,1,1,1,1 2";
  CHECK(read_csv(heading + good_line + "\n").at("bounce")[0].median() == 1.5);
  for (const char* line : {"", "bounce,motion,a,1,1,1e-3,5,1,1,1,", "bounce,motion,a,1,1,1e-3,5,1,1,1,1 x",
                           "bounce,motion,a,1,1,1e-3,x,1,1,1,1", "bounce,motion,a,1,1,soon,5,1,1,1,1",
                           "bounce,motion,a,one,1,1e-3,5,1,1,1,1"}) {
    INFO(line);
    CHECK_THROWS_AS(read_csv(heading + line + "\n"), InvalidInput);
  }
  CHECK_THROWS_AS(read_csv(good_line), InvalidInput);
}

TEST_CASE("a program that fails, or prints what is no measurement, is named") {
  for (const auto& [answers, part] : std::vector<std::pair<std::string, std::string>>{
           {"*) exit 3;;", "failed"},
           {"*) echo garbage;;", "garbage"},
           {"*) echo \"$s error soon seconds 1 row-solves 5\";;", "soon"},
           {"*) echo \"$s error 1x seconds 1 row-solves 5\";;", "1x"},
           {"*) echo \"$s error nan seconds 1 row-solves 5\";;", "nan"},
           {"*) echo \"$s error -1 seconds 1 row-solves 5\";;", "-1"},
           {"*) echo \"$s error 1 seconds soon row-solves 5\";;", "soon"},
           {"*) echo \"$s error 1 seconds -1 row-solves 5\";;", "-1"},
           {"*) echo \"$s error 1 seconds 1\";;", "a/1/1"},
           {"*) echo \"$s error 1 seconds 1 row-solves many\";;", "many"},
           {"*) echo \"$s error 1 seconds 1 row-solves -1\";;", "-1"},
           {"*) echo \"b/1/1 error 1 seconds 1 row-solves 5\";;", "b/1/1"},
           {"a/1/1) echo \"$s error 1 seconds 1 row-solves 5\";;", "printed 1 lines for 2 settings"},
           {"*) ;;", "printed 0 lines for 2 settings"},
           {"*) echo; echo; echo;;", "printed 6 lines for 2 settings"}}) {
    StandIns programs;
    programs.add("motion_odd", "a/SMALL-STEPS/SWEEPS: method\\n", answers);
    const std::string said = failure(tried(2, 1, 2), programs.options(0));
    INFO(answers << ": " << said);
    CHECK(contains(said, "motion_odd"));
    CHECK(contains(said, part));
  }
  StandIns programs;
  programs.add("motion", "", good);
  CHECK(measure(tried(2, 1, 2), programs.options(2)).empty());  // it plays nothing of this
  RoundOptions options = programs.options(0);
  options.engines = {{"motion_that_is_not_there", "x"}};
  CHECK(contains(failure(tried(2, 1, 2), options), "motion_that_is_not_there"));
}

// ---- errors that are measured ---------------------------------------------------------------------------------------

namespace {

/// m, of a setting that the program plays.
double error(const std::string& motion, const std::string& setting, const fs::path& program = MOTION_WIDE_PROGRAM) {
  const Ended played = call_program(program, motion + " " + setting + " --at-least 0", 100);
  INFO(motion << " " << setting << ": " << played.out << played.err);
  REQUIRE(played.out.starts_with(setting + " error "));
  return std::stod(played.out.substr(setting.size() + 7));
}

}  // namespace

TEST_CASE("the errors of the committed study are those that its settings have") {
  const AllMeasured all = read_csv(text_of("renders/19_accuracy_and_time/study.csv"));
  for (const auto& [motion, engine, setting] :
       std::vector<std::array<std::string, 3>>{{"bounce", "motion", "slim/16/4"},
                                               {"stack-10", "motion", "direct-contacts/16/1"},
                                               {"chain", "motion", "direct-joints/32/1"},
                                               {"break", "motion_wide", "impact/1"},
                                               {"pyramid-10", "motion_wide", "half-step/1"},
                                               {"conveyor", "motion_wide", "half-step/4"}}) {
    INFO(motion << " " << setting);
    const Measurements& of_motion = all.at(motion);
    const auto found = std::find_if(of_motion.begin(), of_motion.end(), [&](const Measured& one) {
      return one.engine == engine && one.setting() == setting;
    });
    REQUIRE(found != of_motion.end());
    const double now = error(motion, setting, fs::path(MOTION_PROGRAM).parent_path() / engine);
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

TEST_CASE("each motion and engine is one part's, in turn, and ours in float goes with ours in double") {
  const std::vector<Engine> engines{{"motion", ""}, {"motion_float", ""}, {"motion_wide", ""}, {"motion_ode", ""}};
  std::vector<const Motion*> motions;
  for (const char* const name : {"bounce", "sliding", "break"}) motions.push_back(&motion_named(name));
  for (const std::size_t of : {1, 2, 3, 4, 5, 9}) {
    std::map<std::string, int> played;
    for (std::size_t part = 1; part <= of; ++part) {
      const auto pieces = pieces_of(motions, engines, {part, of});
      CHECK(!pieces.empty());
      for (const Piece& piece : pieces) {
        CHECK(piece.engines.size() == (of <= 3 ? 4 : piece.engines[0].program == "motion" ? 2 : 1));
        for (const Engine& engine : piece.engines) ++played[piece.motion->name + " " + engine.program];
        if (piece.engines[0].program == "motion") CHECK(piece.engines[1].program == "motion_float");
      }
    }
    CHECK(played.size() == 12);
    for (const auto& [what, times] : played) CHECK(times == 1);
  }
  CHECK(complaint([&] { pieces_of(motions, engines, {1, 10}); }) ==
        "--shard is '1/10': there are 3 motions and engines to them, 9 pieces in all, and each part needs one");
}

// ---- the program -----------------------------------------------------------------------------------------------------

TEST_CASE("the study refuses what it cannot do, before it has written anything") {
  const Scratch scratch;
  const std::string out = " --out '" + (scratch / "out").string() + "'";
  for (const auto& [arguments, part] : std::vector<std::pair<std::string, std::string>>{{"--only nothing", "'nothing'"},
                                                                                        {"--rounds 0", "--rounds"},
                                                                                        {"--rounds many", "--rounds"},
                                                                                        {"--what", "--what"}}) {
    const Ended ended = call_program(STUDY_PROGRAM, arguments + out);
    INFO(arguments << ": " << ended.err);
    CHECK(ended.status == 2);
    CHECK(contains(ended.err, part));
    CHECK(ended.out.empty());
    CHECK(!fs::exists(scratch / "out"));
  }
  CHECK(call_program(STUDY_PROGRAM, "--help").status == 0);
}

TEST_CASE("parts of the study, each measured on a machine of its own, make the whole") {
  const Scratch scratch;
  const fs::path folder = scratch / "out/19_accuracy_and_time";
  AllMeasured whole;
  for (std::size_t i = 0; i < all_motions().size(); ++i) {
    const Measured one{
        .engine = "motion", .method = "steady", .sweeps = 1, .error = 1e-3, .seconds = {0.5 + static_cast<double>(i)}};
    whole[all_motions()[i].name] = {one};
    const fs::path part = folder / fmt::format("shard_{}_of_2", 1 + i % 2);
    fs::create_directories(part);
    AllMeasured so_far;
    if (fs::exists(part / "study.csv")) so_far = read_csv(text_of(part / "study.csv"));
    so_far[all_motions()[i].name] = {one};
    std::ofstream(part / "study.csv") << csv_of(so_far);
    std::ofstream(part / "machine.md") << "machine of part " << 1 + i % 2 << "\n";
    std::ofstream(part / "origin.txt") << origin_text({"machine", "compiler", "commit"});
  }
  const std::string out = " --out '" + (scratch / "out").string() + "'";
  const Ended ended = call_program(STUDY_PROGRAM, "--join 2" + out, 100);
  INFO(ended.err);
  CHECK(ended.status == 0);
  CHECK(text_of(folder / "study.csv") == csv_of(whole));
  CHECK(text_of(folder / "machine.md") == "machine of part 1\n\nmachine of part 2\n\n");
  for (const Origin& other : {Origin{"another", "compiler", "commit"},
                              {"machine", "another", "commit"},
                              {"machine", "compiler", "another"}}) {
    std::ofstream(folder / "shard_2_of_2/origin.txt") << origin_text(other);
    const Ended mixed = call_program(STUDY_PROGRAM, "--join 2" + out);
    INFO(mixed.err);
    CHECK(mixed.status == 2);
    CHECK(contains(mixed.err, "shard_2_of_2/origin.txt"));
    CHECK(contains(mixed.err, "'another'"));
  }
  fs::remove(folder / "shard_2_of_2/origin.txt");
  CHECK(call_program(STUDY_PROGRAM, "--join 2" + out).status == 2);
  const Ended missing = call_program(STUDY_PROGRAM, "--join 3" + out);
  CHECK(missing.status == 2);
  CHECK(contains(missing.err, "shard_1_of_3"));
  CHECK(contains(call_program(STUDY_PROGRAM, "--shard 1/99 --only bounce" + out).err, "1 motions and engines to them"));
}
