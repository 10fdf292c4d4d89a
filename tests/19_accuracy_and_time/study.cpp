/// Chapter 19: what is worth choosing of what was measured, the rounds in which it is measured, and what is said of it. What is
/// measured here was made up, or printed by programs that are scripts; no test looks at a clock.
#include <fmt/format.h>

#include <cmath>
#include <random>

#include "pushback/common/basics/input.h"
#include "pushback/common/experiment/plot_layout.h"
#include "pushback/tools/study/every_motion.h"
#include "pushback/tools/study/limits.h"
#include "pushback/tools/study/machine.h"
#include "pushback/tools/study/report.h"
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

/// Of one engine, in float or not.
Measured of(const std::string& engine, const std::string& method, int substeps, int sweeps, double error,
            double seconds) {
  return {.engine = engine,
          .method = method,
          .substeps = substeps,
          .sweeps = sweeps,
          .error = error,
          .row_solves = 600,
          .seconds = {seconds}};
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

TEST_CASE(
    "how many times slower: 1 as we are, 2 where all of ours take twice as long, infinite where we never get there") {
  std::mt19937 random(16);
  for (int trial = 0; trial < 200; ++trial) {
    const Measurements all = some(random);
    Measurements slow = all, vague = all;
    for (Measured& one : slow) one.seconds[0] *= 2;
    for (Measured& one : vague) one.error += 0.5;
    if (front(all).empty()) {
      CHECK(times_slower(all, all, 0, 100) == 0);
      continue;
    }
    CHECK(times_slower(all, all, 0, 100) == 1);
    CHECK(times_slower(slow, all, 0, 100) == 2);
    CHECK(times_slower(all, slow, 0, 100) == 0.5);
    CHECK(times_slower(vague, all, 0, 100) == infinite);
    CHECK(times_slower({}, all, 0, 100) == infinite);
    CHECK(times_slower(all, {}, 0, 100) == 0);
  }
  const Measurements ours{point(3, 5), point(8, 1)}, theirs{point(1, 5), point(4, 1)};
  CHECK(times_slower(ours, theirs, 0, 10) == 3);
  CHECK(times_slower(ours, theirs, 0, 4) == 2);  // the first is out of what is asked for
  CHECK(times_slower(ours, theirs, 2, 10) == 3);
  CHECK(times_slower(ours, theirs, 6, 10) == 0);
  CHECK(times_slower(ours, theirs, 1, 5) == 3);  // ends belong to it
}

TEST_CASE("the slope of a power is its exponent") {
  for (const double power : {-2.0, 0.0, 0.5, 3.0}) {
    std::vector<double> x, y;
    for (const double one : {1.0, 2.0, 7.0, 64.0}) {
      x.push_back(one);
      y.push_back(3 * std::pow(one, power));
    }
    CHECK(slope(x, y) == Approx(power).margin(1e-12));
  }
  CHECK(slope({1, 2, 4}, {1, 4, 4}) == Approx(1));  // by least squares: (0, 0), (1, 2), (2, 2)
}

TEST_CASE("median, quartiles and setting of a measurement") {
  Measured one{.engine = "motion", .method = "slim", .substeps = 8, .sweeps = 4, .seconds = {1, 2, 3, 4, 50}};
  CHECK(one.median() == 3);
  CHECK(one.quartile(1) == 2);
  CHECK(one.quartile(3) == 4);
  CHECK(one.setting() == "slim/8/4");
  one.sweeps = 0;
  CHECK(one.setting() == "slim/8");
  one.seconds = {1, 2, 4, 8};  // between two of them by proportion: no timing is median and quartile at once
  CHECK((one.quartile(1) == 1.75 && one.median() == 3 && one.quartile(3) == 5));
  one.seconds = {7};
  CHECK((one.median() == 7 && one.quartile(1) == 7 && one.quartile(3) == 7));
}

// ---- limits ----------------------------------------------------------------------------------------------------------

namespace {

/// a + b h^p at h = 1, 1/2 ... , each times 1 - noise ... 1 + noise.
std::vector<double> errors(double a, double b, double p, int settings, double noise = 0, unsigned seed = 0) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> factor(1 - noise, 1 + noise);
  std::vector<double> found;
  for (int i = 0; i < settings; ++i) found.push_back((a + b * std::pow(2, -p * i)) * factor(random));
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

TEST_CASE("noise is not taken for a limit, nor a limit for noise") {
  for (unsigned seed = 0; seed < 200; ++seed) {
    INFO(seed);
    const Limit level = limit_of(errors(1, 0.5, 1, 10, 0.05, seed));
    CHECK(level.kind == Limit::Kind::reached);
    CHECK(level.least == Approx(1).epsilon(0.15));
    const auto rough = errors(0, 1, 1, 10, 0.3, seed);
    const Limit fall = limit_of(rough);
    CHECK(fall.kind != Limit::Kind::reached);
    CHECK(fall.most <= *std::max_element(rough.end() - 3, rough.end()));
  }
}

TEST_CASE("few settings, lost ones, errors that rise") {
  CHECK(limit_of({}).kind == Limit::Kind::unknown);
  CHECK(limit_of({1, 1}).kind == Limit::Kind::unknown);
  CHECK(limit_of({1, 1, infinite}).kind == Limit::Kind::unknown);
  CHECK(limit_of({1, infinite, 1, 1}).kind == Limit::Kind::unknown);
  CHECK(limit_of({infinite, 1, 1, 1}).kind == Limit::Kind::reached);
  CHECK(limit_of({5, 2, 1.9, 2.1}).least == 2);  // level: the median
  const Limit rising = limit_of({1, 2, 4, 8});
  CHECK(rising.kind == Limit::Kind::scattered);
  CHECK((rising.least == 2 && rising.most == 8 && rising.order == 0));
  CHECK(limit_of({1, 2, 3, 3.5, 3.75}).kind != Limit::Kind::falling);
  // To and fro as it falls, as a ball's error does that is hit early or late in a step.
  const Limit fall = limit_of({64, 20, 30, 8, 3, 4});
  CHECK(fall.kind == Limit::Kind::falling);
  CHECK(fall.most == 8);
  CHECK(limit_of({64, 20, 30, 40, 8, 50}).kind == Limit::Kind::scattered);
  CHECK(limit_of({10, 9, 8, 7, 12, 6}).kind == Limit::Kind::scattered);  // lower, yet not by half
}

TEST_CASE("a limit is said with two digits, and no more than can be known") {
  CHECK(limit_of({}).text() == "–");
  CHECK(limit_of(errors(0.3282, 0.02, 1, 6)).text() == "328 mm, order 1.0");
  CHECK(limit_of(errors(0, 0.0032, 1, 6)).text() == "< 0.10 mm, order 1.0");
  CHECK(limit_of(errors(0, 0.0032, 1, 6)).remains() == "< 0.10 mm");
  CHECK(limit_of({1e-2, 1e-3, 4e-3}).text() == "1.0 to 10 mm");
  CHECK(limit_of({1e-12, 1e-13, 4e-13}).text() == "< 0.0001 mm");
  CHECK(limit_of({1e-2, 0, 4e-3}).text() == "0.00010 to 10 mm");
}

TEST_CASE("limits are taken of the most sweeps that five step sizes were tried with, and gaps end them") {
  Measurements all;
  for (int i = 0; i < 6; ++i) {
    all.push_back(of("motion", "slim", 1 << i, 1, 7, 1));
    if (i < 5) all.push_back(of("motion", "slim", 1 << i, 4, 1 + std::pow(2, -i), 1));
    if (i < 4) all.push_back(of("motion", "slim", 1 << i, 16, 9, 1));
    all.push_back(of("motion", "other", 1 << i, 16, 3, 1));
    all.push_back(of("motion_ode", "slim", 1 << i, 64, 5, 1));
  }
  CHECK(limit_of(all, "motion", "slim").least == Approx(1));
  CHECK(limit_of(all, "motion", "slim", 16).least == 9);
  CHECK(limit_of(all, "motion_ode", "slim").least == 5);
  CHECK(limit_of(all, "motion", "none").kind == Limit::Kind::unknown);
  CHECK(limit_of({}, "motion", "slim", 4).kind == Limit::Kind::unknown);
  CHECK((least_limit(all, "motion", 16).first == "slim" && least_limit(all, "motion", 16).second.least == Approx(1)));
  CHECK(least_limit(all, "motion_bullet", 1).first.empty());
  const Measurements gap{of("motion", "a", 1, 1, 1, 1), of("motion", "a", 2, 1, 1, 1), of("motion", "a", 8, 1, 1, 1),
                         of("motion", "a", 16, 1, 1, 1)};
  CHECK(limit_of(gap, "motion", "a").kind == Limit::Kind::unknown);
  std::mt19937 random(17);
  Measurements mixed = all;
  std::shuffle(mixed.begin(), mixed.end(), random);
  CHECK(limit_of(mixed, "motion", "slim").text() == limit_of(all, "motion", "slim").text());
}

TEST_CASE(
    "methods are compared in the same steps: what was played more finely is cut, what was not so finely left out") {
  Measurements all;
  for (int i = 0; i < 12; ++i) {
    const double error = std::ldexp(1, -i);  // of first order, whoever plays
    if (i < 6) all.push_back(of("motion", "slim", 1 << i, 4, error, 1));
    if (i < 3) all.push_back(of("motion", "short", 1 << i, 4, 1e-9, 1));
    all.push_back(of("motion", "direct", 1 << i, 0, 0.99 * error, 1));
    if (i < 9) all.push_back(of("motion_ode", "ode", 1 << i, 0, error, 1));
  }
  CHECK(finest_of(all, "motion") == 32);
  CHECK(finest_of(all, "motion_ode") == 256);  // it has no method with sweeps
  CHECK(finest_of(all, "motion_bullet") == 0);
  CHECK(least_limit(all, "motion", 32).first == "direct");
  CHECK(least_limit(all, "motion", 32).second.most == Approx(0.99 / 32));
  CHECK(least_limit(all, "motion_ode", 32).second.most == Approx(1.0 / 32));
  CHECK(least_limit(all, "motion", 2048).second.most == Approx(0.99 / 2048));
  CHECK(limit_of(all, "motion", "direct", 0, 8).most == Approx(0.99 / 8));
  const std::string table =
      table_of_others({{&motion_named("bounce"), all}}, {{"motion", "ours"}, {"motion_ode", "ODE"}});
  CHECK(contains(table, "| 32 | < 31 mm (`ode`) | < 31 mm (`direct`) |\n"));
}

// ---- rounds ----------------------------------------------------------------------------------------------------------

namespace {

/// Programs that are scripts: they write down how they are called, and print what `answers` (lines of a shell's case) say.
class StandIns {
 public:
  void add(const std::string& name, const std::string& methods, const std::string& answers) {
    const fs::path file = scratch_ / name;
    std::ofstream(file) << "#!/bin/sh\necho \"" << name << " $*\" >>'" << log().string() << "'\nshift\n"
                        << "if [ $# = 0 ]; then printf '" << methods << "'; exit 0; fi\n"
                        << "for s in \"$@\"; do case $s in --*) break;; " << answers << " esac; done\nexit 0\n";
    fs::permissions(file, fs::perms::owner_all);
    engines_.push_back({name, "called " + name});
  }
  RoundOptions options(int rounds) const { return {.engines = engines_, .programs = scratch_ / ".", .rounds = rounds}; }
  fs::path log() const { return scratch_ / "log"; }
  std::vector<std::string> calls() const { return lines_of(text_of(log())); }

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

TEST_CASE(
    "the grid is all powers that the motion wants to have tried, and no others, and each once where no round follows") {
  StandIns programs;
  programs.add("motion", "one/SMALL-STEPS/SWEEPS: first\\ntwo/SMALL-STEPS: second\\n", good);
  for (const bool quick : {false, true}) {
    for (const auto& [steps, sweeps, passes] : {std::array{16, 64, 64}, {256, 4, 128}, {1, 1, 1}, {5, 5, 10}}) {
      RoundOptions options = programs.options(0);
      options.quick = quick;
      const Measurements all = measure(tried(steps, sweeps, passes), options);
      std::vector<std::string> wanted, found;
      const int most_passes = quick ? std::max(1, passes / 8) : passes,
                most_steps = quick ? std::min(64, steps) : steps;
      for (int n = 1; n <= most_steps; n *= quick ? 4 : 2)
        for (int m = 1; m <= sweeps; m *= 4)
          if (n * m <= most_passes) wanted.push_back(fmt::format("one/{}/{}", n, m));
      for (int n = 1; n <= most_steps && n <= most_passes; n *= quick ? 4 : 2)
        wanted.push_back(fmt::format("two/{}", n));
      for (const Measured& one : all) {
        found.push_back(one.setting());
        CHECK(one.engine == "motion");
        CHECK(one.error == 1e-3);
        CHECK(one.seconds == std::vector<double>{2e-2});
        CHECK(one.row_solves == 5);
        CHECK(!one.late);
      }
      CHECK(found == wanted);
    }
  }
}

TEST_CASE(
    "in float only what is near the front is played, and rounds repeat what is near one, one whole round after the "
    "other") {
  StandIns programs;
  // fast and bad, slow and good, slow and bad, as slow as can be near, lost
  const std::string answers =
      "a/1/1) echo \"$s error 1 seconds 1 row-solves 5\";; b/1/1) echo \"$s error 0.1 seconds 10 row-solves 5\";; "
      "c/1/1) echo \"$s error 1 seconds 9 row-solves 5\";; d/1/1) echo \"$s error 0.1 seconds 12.5 row-solves 5\";; "
      "e/1/1) echo \"$s error lost seconds 0.1 row-solves 5\";; f/1/1) echo \"$s error late seconds 0.1 row-solves "
      "5\";;";
  std::string methods;
  for (const char c : std::string("abcdef")) methods += fmt::format("{}/SMALL-STEPS/SWEEPS: method\\n", c);
  programs.add("motion", methods, answers);
  programs.add("motion_float", "",
               "b/1/1) echo \"$s error 5 seconds 20 row-solves 5\";; *) echo \"$s error 1 seconds 2 row-solves 5\";;");
  programs.add("motion_ode", "o/SMALL-STEPS: method\\n", good);
  const Measurements all = measure(tried(1, 1, 1), programs.options(2));
  const std::string round =
      "motion bounce a/1/1 b/1/1 d/1/1 --at-most 5|motion_float bounce a/1/1 d/1/1 --at-most 5|"
      "motion_ode bounce o/1 --at-most 5|";
  std::string calls;
  for (const std::string& call : programs.calls()) calls += call + "|";
  CHECK(calls ==
        "motion bounce|motion bounce a/1/1 b/1/1 c/1/1 d/1/1 e/1/1 f/1/1 --at-most 5|"
        "motion_float bounce a/1/1 b/1/1 d/1/1 --at-most 5|motion_ode bounce|motion_ode bounce o/1 --at-most 5|" +
            round + round);
  REQUIRE(all.size() == 10);
  for (const Measured& one : all) {
    INFO(one.engine << " " << one.setting());
    const bool ours = one.engine == "motion",
               near = ours ? std::string("abd").find(one.method) != std::string::npos : one.error != 5;
    CHECK(one.seconds.size() == (near ? 3 : 1));
    CHECK(std::isfinite(one.error) == !(ours && (one.method == "e" || one.method == "f")));
    CHECK(one.late == (one.method == "f"));
  }
  const auto lines = lines_of(csv_of({{"bounce", all}, {"aaa", {all[0]}}}));
  REQUIRE(lines.size() == 12);
  for (const std::string& line : lines) CHECK(fields_of(line).size() == fields_of(lines[0]).size());
  CHECK(lines[1] ==
        "aaa,motion,a,1,1,1.0000e+00,5.0000e+00,1.0000e+00,1.0000e+00,1.0000e+00,1.0000e+00 1.0000e+00 1.0000e+00");
  CHECK(contains(lines[6], "bounce,motion,e,1,1,lost,"));
  CHECK(contains(lines[7], "bounce,motion,f,1,1,late,"));
  CHECK(contains(lines[11], "bounce,motion_ode,o,1,0,1.0000e-03,"));
}

TEST_CASE("what is timed again is near the robust front: a setting that is good by chance hides no other") {
  StandIns programs;
  programs.add(
      "motion", "lucky/SMALL-STEPS: method\\nsure/SMALL-STEPS: method\\n",
      "lucky/1) echo \"$s error 0.1 seconds 1 row-solves 5\";; "
      "lucky/2) echo \"$s error 1 seconds 2 row-solves 5\";; sure/1) echo \"$s error 0.5 seconds 1.5 row-solves 5\";; "
      "sure/2) echo \"$s error 0.5 seconds 3 row-solves 5\";;");
  for (const Measured& one : measure(tried(2, 1, 2), programs.options(1))) {
    INFO(one.setting());
    CHECK(one.seconds.size() == (one.substeps == 1 ? 2 : 1));
  }
}

TEST_CASE("times of all rounds are kept, ascending") {
  StandIns programs;
  programs.add(
      "motion", "a/SMALL-STEPS/SWEEPS: method\\n",
      "*) echo \"$s error 1 seconds $((9 - $(grep -c -e at-most '" + programs.log().string() + "'))) row-solves 5\";;");
  const Measurements all = measure(tried(1, 1, 1), programs.options(3));
  REQUIRE(all.size() == 1);
  CHECK(all[0].seconds == std::vector<double>{5, 6, 7, 8});
}

TEST_CASE("what is read back from the csv is what was written: every time, and row solves where there are any") {
  StandIns programs;
  programs.add(
      "motion", "a/SMALL-STEPS/SWEEPS: method\\nb/SMALL-STEPS: method\\n",
      "b/*) echo \"$s error late seconds 5 row-solves –\";; *) echo \"$s error 1.2345e-03 seconds $(grep -c -e "
      "at-most '" +
          programs.log().string() + "').1e-3 row-solves 5.6789e+03\";;");
  programs.add("motion_ode", "c/SMALL-STEPS: method\\n", "*) echo \"$s error lost seconds 0.25 row-solves 0\";;");
  const AllMeasured all{{"bounce", measure(tried(1, 1, 1), programs.options(3))}};
  const std::string text = csv_of(all);
  const AllMeasured again = read_csv(text);
  CHECK(csv_of(again) == text);
  REQUIRE(again.at("bounce").size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    const Measured &one = all.at("bounce")[i], &other = again.at("bounce")[i];
    CHECK(one.setting() == other.setting());
    CHECK(one.seconds == other.seconds);
    CHECK((one.median() == other.median() && one.quartile(1) == other.quartile(1)));
    CHECK(one.error == other.error);
    CHECK(one.late == other.late);
    CHECK(one.row_solves == other.row_solves);
  }
  CHECK(again.at("bounce")[0].seconds.size() == 4);
  CHECK(again.at("bounce")[0].row_solves == 5678.9);
  CHECK(!again.at("bounce")[1].row_solves);
  CHECK(again.at("bounce")[2].row_solves == 0);
  const std::string heading = lines_of(text)[0] + "\n", good_line = "bounce,motion,a,1,1,1e-3,5,1,1,1,1 2";
  CHECK(read_csv(heading + good_line + "\n").at("bounce")[0].median() == 1.5);
  for (const char* line : {"", "bounce,motion,a,1,1,1e-3,5,1,1,1,", "bounce,motion,a,1,1,1e-3,5,1,1,1,1 x",
                           "bounce,motion,a,1,1,1e-3,x,1,1,1,1", "bounce,motion,a,1,1,soon,5,1,1,1,1",
                           "bounce,motion,a,one,1,1e-3,5,1,1,1,1"}) {
    INFO(line);
    CHECK_THROWS_AS(read_csv(heading + line + "\n"), InvalidInput);
  }
  CHECK_THROWS_AS(read_csv(good_line), InvalidInput);
}

TEST_CASE("the table of the machine says how many settings of each engine were tried, repeated, lost and given up") {
  Measured again = of("motion", "slim", 1, 1, 1e-3, 1), lost = of("motion", "slim", 2, 1, infinite, 1), late = lost;
  again.seconds = {1, 2, 3};
  late.late = true;
  const AllMeasured all{{"bounce", {again, lost, late, of("motion_ode", "o", 1, 1, 1, 1)}}, {"chain", {again}}};
  const std::string text = table_of_machine({.load_before = "0.25, 0.5, 1",
                                             .load_after = "1, 1, 1",
                                             .took = std::chrono::seconds(61),
                                             .versions = {"Pushback 7", "ODE 8"}},
                                            {{"motion", "ours"}, {"motion_ode", "ODE"}}, all);
  CHECK(contains(text, "| 0.25, 0.5, 1 |"));
  CHECK(contains(text, "2 min"));
  CHECK(contains(text, "| ours | Pushback 7 | 4 | 2 | 1 | 1 |\n"));
  CHECK(contains(text, "| ODE | ODE 8 | 1 | 0 | 0 | 0 |\n"));
  CHECK(contains(processor(), " cores"));
  const std::string load = load_now();
  CHECK(std::count(load.begin(), load.end(), ',') == 2);
  CHECK(contains(version_of({"motion", "ours"}, fs::path(MOTION_PROGRAM).parent_path()), "Pushback, "));
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

TEST_CASE("a program that crashes loses the settings by which it does, and the others are measured") {
  StandIns programs;
  programs.add("motion_odd", "a/SMALL-STEPS/SWEEPS: method\\n",
               "a/2/*) kill -9 $$;; *) echo \"$s error 1e-3 seconds 2e-2 row-solves 5\";;");
  RoundOptions options = programs.options(2);
  std::vector<std::string> said;
  options.say = [&](const std::string& what) { said.push_back(what); };
  const Measurements all = measure(tried(4, 1, 4), options);
  REQUIRE(all.size() == 3);
  for (const Measured& one : all) {
    CHECK(std::isinf(one.error) == (one.substeps == 2));
    CHECK_FALSE(one.late);
  }
  CHECK(std::count(said.begin(), said.end(), "bounce: motion_odd crashed, by a/2/1") == 1);
  CHECK(all[2].seconds.size() == 3);  // what is near the front is timed on
  CHECK(contains(csv_of({{"bounce", all}}), "a,2,1,lost,"));
  CHECK(read_csv(csv_of({{"bounce", all}})).at("bounce").size() == 3);
  StandIns broken;  // a list of methods is no play
  std::ofstream(broken.options(0).programs / "motion_gone") << "#!/bin/sh\nkill -9 $$\n";
  fs::permissions(broken.options(0).programs / "motion_gone", fs::perms::owner_all);
  RoundOptions gone = broken.options(0);
  gone.engines = {{"motion_gone", "x"}};
  CHECK(contains(failure(tried(1, 1, 1), gone), "crashed"));
}

TEST_CASE("engines are ours, and those of others that are there") {
  StandIns programs;
  const fs::path folder = programs.options(0).programs;
  CHECK(engines_in(folder, false).size() == 2);
  CHECK_THROWS_AS(engines_in(folder, true), std::runtime_error);
  programs.add("motion_ode", "", good);
  const auto found = engines_in(folder, true);
  REQUIRE(found.size() == 3);
  CHECK((found[0].program == "motion" && found[1].program == "motion_float" && found[2].program == "motion_ode"));
  CHECK(engines_in(folder, false).size() == 2);
}

TEST_CASE("only the methods that are asked for are played") {
  StandIns programs;
  programs.add("motion", "slim/SMALL-STEPS/SWEEPS: a\\nfull/SMALL-STEPS/SWEEPS: b\\n", good);
  RoundOptions options = programs.options(0);
  CHECK(measure(tried(1, 1, 1), options).size() == 2);
  options.methods = {"slim"};
  const Measurements some = measure(tried(1, 1, 1), options);
  REQUIRE(some.size() == 1);
  CHECK(some[0].method == "slim");
}

TEST_CASE("the solvers that detect once play with ours, whether others are asked for or not") {
  StandIns programs;
  const fs::path folder = programs.options(0).programs;
  programs.add("motion_wide", "", good);
  CHECK_THROWS_AS(engines_in(folder, true), std::runtime_error);  // it is none of the others
  programs.add("motion_ode", "", good);
  for (const bool others : {false, true}) {
    const auto found = engines_in(folder, others);
    REQUIRE(found.size() == (others ? 4 : 3));
    CHECK(found[2].program == "motion_wide");
  }
}

TEST_CASE("the program itself is understood") {
  RoundOptions options;
  options.engines = {{"motion", "ours"}};
  options.programs = fs::path(MOTION_PROGRAM).parent_path();
  options.rounds = 0;
  const Measurements all = measure(tried(2, 4, 8), options);
  REQUIRE(all.size() == 11 * 4);
  for (const Measured& one : all) {
    INFO(one.setting());
    CHECK(one.error < 0.2);
    CHECK(one.row_solves.has_value() == (one.method != "direct-contacts"));
    CHECK(one.row_solves.value_or(1) > 0);
  }
}

// ---- report ----------------------------------------------------------------------------------------------------------

namespace {

/// 60 frames, so 0.006 s in all are 100 us a frame.
Motion minute() {
  Motion motion = motion_named("bounce");
  motion.name = "stack-10";
  motion.title = "minute";
  motion.seconds = 1;
  return motion;
}
const Motion motion_of_60 = minute();
const std::vector<Engine> three{{"motion", "ours"}, {"motion_float", "ours, float"}, {"motion_ode", "ODE"}};

std::vector<MotionMeasured> made_up() {
  return {{&motion_of_60,
           {of("motion", "slim", 4, 1, 5e-2, 0.003), of("motion", "slim", 4, 4, 5e-3, 0.006),
            of("motion", "slim", 4, 16, 5e-4, 0.012), of("motion", "slim-cold", 4, 4, 1e-2, 0.003),
            of("motion", "slim-cold", 4, 16, 2e-3, 0.003), of("motion", "soft", 1, 4, infinite, 0.001),
            of("motion_float", "slim", 4, 4, 2.5e-3, 0.0048), of("motion_ode", "o", 1, 4, 5e-3, 0.06),
            of("motion_ode", "o", 1, 16, 5e-4, 0.018)}}};
}

}  // namespace

TEST_CASE("the table of the cheapest says which, and what it costs a frame") {
  const auto lines = lines_of(table_of_cheapest(made_up()));
  REQUIRE(lines.size() == 3);
  CHECK(lines[2] ==
        "| minute | 7 | `slim-cold/4/4`: 50 µs (50 to 50), 10 row solves, 10 mm off, – remains "
        "| `slim/4/16`: 200 µs (200 to 200), 10 row solves, 0.5 mm off, – remains | not reached | not reached |");
  auto no_rows = made_up();
  for (Measured& one : no_rows[0].all) one.row_solves.reset();
  CHECK(contains(lines_of(table_of_cheapest(no_rows))[2],
                 "`slim-cold/4/4`: 50 µs (50 to 50), – row solves, 10 mm off, – remains |"));
  auto only_float = made_up();
  only_float[0].all = {of("motion_float", "slim", 4, 4, 2.5e-3, 0.0048), of("motion_ode", "o", 1, 16, 5e-5, 0.001)};
  CHECK(
      lines_of(table_of_cheapest(only_float))[2] ==
      "| minute | 1 | `slim/4/4` in float: 80 µs (80 to 80), 10 row solves, 2.5 mm off, – remains | not reached | not "
      "reached | not reached |");
  auto once = made_up();
  for (int i = 0; i < 6; ++i)
    once[0].all.push_back(of("motion_wide", "wide-float", 1 << i, 1, 0.003 * std::pow(2, -i), 0.0006));
  CHECK(contains(
      lines_of(table_of_cheapest(once))[2],
      "| `wide-float/32/1`: 10 µs (10 to 10), 10 row solves, 0.0938 mm off, < 0.094 mm remains | not reached |"));
}

TEST_CASE("the table of the engines has a row a motion: the cheapest below a millimetre, or how near it comes") {
  auto all = made_up();
  const auto row = [&] { return lines_of(table_of_engines(all)).back(); };
  REQUIRE(lines_of(table_of_engines(all)).size() == 3);
  CHECK(row() == "| minute | – | 200 µs, `slim/4/16` | – | 300 µs, `o/1/16` | – |");
  all[0].all.push_back(of("motion_bullet", "bullet", 1, 4, 7e-3, 0.01));
  all[0].all.push_back(of("motion_bullet_double", "bullet-double", 1, 4, 2e-3, 0.02));
  CHECK(row() == "| minute | – | 200 µs, `slim/4/16` | not below 2 mm | 300 µs, `o/1/16` | – |");
  all[0].all.push_back(of("motion_ode", "o", 2, 16, 3e-3, 0.02));  // finer, and farther off
  CHECK(row() == "| minute | – | 200 µs, `slim/4/16` | not below 2 mm | not below 3 mm | – |");
  // One that is told 1 mm: without a division, its own error.
  all[0].all.push_back(of("motion_wide", "within", 4, 1, 1e-5, 0.3));
  all[0].all.push_back(of("motion_wide", "within", 1, 4, 1e-5, 0.3));
  CHECK(row() == "| minute | – | 200 µs, `slim/4/16` | not below 2 mm | not below 3 mm | – |");
  all[0].all.push_back(of("motion_wide", "within", 1, 1, 2e-3, 0.06));
  CHECK(row() == "| minute | 1000 µs, 2 mm off | 200 µs, `slim/4/16` | not below 2 mm | not below 3 mm | – |");
  all[0].all.push_back(of("motion_adapter", "entered", 1, 1, 2e-4, 0.006));
  CHECK(contains(lines_of(table_of_engines(all))[0], "| MuJoCo | entered |"));
  CHECK(row().ends_with(" | – | 100 µs, `entered/1/1` |"));
  all[0].all.push_back(of("motion_box3d", "box3d", 4, 1, 3e-4, 0.003));
  CHECK(contains(lines_of(table_of_engines(all))[0], "| MuJoCo | Box3D | entered |"));
  CHECK(row().ends_with(" | – | 50 µs, `box3d/4/1` | 100 µs, `entered/1/1` |"));
}

TEST_CASE("the table of the others says how many times as long they take") {
  auto all = made_up();
  const auto others = [&] { return lines_of(table_of_others(all, three)); };
  REQUIRE(others().size() == 3);  // none for ours
  // Below 1 cm and 1 mm: 0.018 s against our 0.003 s and 0.012 s; for their best, 5e-4 in 0.018 s, we take 0.012 s.
  CHECK(others()[2] ==
        "| minute | ODE | 2 | 6 times as long | 1.5 times as long | not reached | not reached | 0.67 times its time | "
        "1 | – | – |");
  all[0].all.back().error = 5e-5;
  CHECK(others()[2] ==
        "| minute | ODE | 2 | 6 times as long | 1.5 times as long | 300 µs, we not at all | not reached | we do not "
        "reach all of it "
        "| 1 "
        "| – | – |");
  all[0].all.push_back(of("motion_wide", "wide", 1, 1, 1e-5, 0.006));  // ours as well
  REQUIRE(others().size() == 3);
  CHECK(others()[2] ==
        "| minute | ODE | 2 | 6 times as long | 3 times as long | 3 times as long | not reached | 0.33 times its time "
        "| 1 | – | – |");
  all[0].all.push_back(of("motion_wide", "wide", 1, 1, 1e-5, 0.0001234));
  CHECK(
      contains(others()[2],
               "| 146 times as long | 146 times as long | 146 times as long | not reached | 0.0069 times its time |"));
  all[0].all.back().seconds = {0.018 / 99.7};
  CHECK(contains(others()[2], "| 100 times as long |"));
  all[0].all.resize(7);
  CHECK(contains(others()[2], "| it does not play this |"));
  all[0].all.push_back(of("motion_ode", "o", 1, 1, 0.5, 1));
  CHECK(others()[2] ==
        "| minute | ODE | 1 | not reached | not reached | not reached | not reached | it has no such front | 1 | – | – "
        "|");
}

TEST_CASE("tables and diagrams are of robust errors") {
  // As Bullet on the slope: half a millimetre in one setting, centimetres in those that are finer.
  const Measurements bullet{of("motion_ode", "o", 1, 1, 2e-2, 0.001), of("motion_ode", "o", 8, 4, 5e-4, 0.002),
                            of("motion_ode", "o", 16, 4, 5e-3, 0.004), of("motion_ode", "o", 32, 4, 4e-4, 0.008)};
  Measurements all = bullet;
  all.push_back(of("motion", "slim", 4, 4, 5e-4, 0.004));
  CHECK(contains(table_of_others({{&motion_of_60, all}}, three),
                 "| minute | ODE | 4 | 0.5 times as long | 2 times as long | not reached | "));
  const Panel panel = work_precision({&motion_of_60, all}, three);
  REQUIRE(panel.curves.size() == 3);
  CHECK(panel.curves[1].y.size() == 3);
  CHECK(panel.curves[1].y[1] == Approx(5e-3));
  Measurements mine = all;
  for (Measured& one : mine) one.engine = "motion";
  const Panel methods = fronts_of_methods({&motion_of_60, mine}, "motion");
  REQUIRE(methods.curves.size() == 2);
  REQUIRE(methods.curves[0].y.size() == 3);
  CHECK(methods.curves[0].y[1] == Approx(5e-3));
  CHECK(contains(table_of_cheapest({{&motion_of_60, mine}}), "| 5 | `o/8/4`: "));
  CHECK(contains(table_of_cheapest({{&motion_of_60, mine}}), " 5 mm off"));
}

TEST_CASE("the table of the knobs has slopes, and what a change of method does") {
  auto all = made_up();
  all[0].all.push_back(of("motion", "nonlinear", 1, 4, 7, 7));  // nobody's cold sister
  const std::string text = table_of_knobs(all);
  // Errors as sweeps^(log4 0.1), times as sweeps^(1/2)
  CHECK(contains(text, fmt::format("| sweeps doubled | stack-10 | times {:.2f}, slope {:.2f} | times 1.41 | – | `slim` "
                                   "with 4 substeps, 1 to 16 |\n",
                                   std::sqrt(0.1), std::log(0.1) / std::log(4.0))));
  CHECK(!contains(text, "substeps doubled"));
  // 2 times the error in half the time, and 4 times in a quarter
  CHECK(contains(
      text, "| `slim` without warm start | stack-10 | 2.8 times the error | 0.35 times the time | – | 2 settings |\n"));
  CHECK(
      contains(text, "| float for double | stack-10 | 0.5 times the error | 0.8 times the time | – | 1 settings |\n"));
  CHECK(!contains(text, "nan"));
  CHECK(!contains(text, "inf"));
}

TEST_CASE("each table says what remains, of which method, by which law") {
  Measurements slim, hops;
  for (int i = 0; i < 6; ++i) {
    slim.push_back(of("motion", "slim", 1 << i, 4, 0.002 + 0.01 * std::pow(2, -i), 1));
    slim.push_back(of("motion_float", "slim", 1 << i, 4, 0.5, 0.5));
    slim.push_back(of("motion_ode", "ode", 1 << i, 4, 0.05 * std::pow(2, -i), 2));
    hops.push_back(of("motion_mujoco", "mujoco", 1 << i, 0, 0.33, 1));
  }
  const std::vector<MotionMeasured> all{{&motion_of_60, slim}, {&motion_named("sliding"), hops}};
  const std::string limits = table_of_limits(all);
  CHECK(contains(limits, "| `slim` | slop of 0.1 mm | 2.0 mm, order 1.0 |\n"));
  CHECK(contains(limits, "| `ode` | friction pyramid on fixed axes; softness | < 1.6 mm, order 1.0 |\n"));
  CHECK(contains(limits, "| `mujoco` | relaxed cone; springs as hard as the step allows | 330 mm |\n"));
  CHECK(lines_of(limits).size() == 3 + 1 + 4);  // two tables and a line between them; nothing of float
  CHECK(contains(table_of_others(all, three), "| 32 | < 1.6 mm (`ode`) | 2.0 mm (`slim`) |\n"));
  CHECK(contains(table_of_cheapest(all), "7 mm off, 2.0 mm remains "));
  auto with_once = all;
  for (int i = 0; i < 6; ++i)
    with_once[0].all.push_back(of("motion_wide", "once", 1 << i, 4, 0.001 + 0.01 * std::pow(2, -i), 1));
  CHECK(contains(table_of_others(with_once, three), "| 32 | < 1.6 mm (`ode`) | 1.0 mm (`once`) |\n"));
  CHECK(lines_of(table_of_hops(all)).back() ==
        "| a box slides and stops | 2.400 m/s | 293.6 mm | 328.2 mm | 330 mm | – |");
  auto made = made_up();
  made[0].all.clear();
  for (int i = 0; i < 6; ++i) made[0].all.push_back(of("motion", "soft", 1 << i, 1, 0.002 + 0.01 * std::pow(2, -i), 1));
  CHECK(contains(table_of_knobs(made), " | 2.0 mm | `soft` with 1 sweeps, 1 to 32 |\n"));
}

TEST_CASE("every method that plays anything has its law in the table of limits") {
  for (const auto& [engine, program] : {std::pair{"motion", MOTION_PROGRAM}, {"motion_wide", MOTION_WIDE_PROGRAM}}) {
    for (const Motion& motion : every_motion()) {
      const Ended listed = call_program(program, motion.name);
      REQUIRE(listed.status == 0);
      for (const std::string& line : lines_of(listed.out)) {
        const std::string name = line.substr(0, line.find_first_of("/:"));
        INFO(motion.name << " " << name);
        const std::string text = table_of_limits({{&motion, {of(engine, name, 1, 1, 1, 1)}}});
        CHECK(contains(text, "| `" + name + "` | "));
        CHECK(!contains(text, "` | – |"));
      }
    }
  }
}

TEST_CASE("a top and a pendulum at a wall are played beside the ten, each solver by its order") {
  for (const char* const program : {MOTION_PROGRAM, MOTION_WIDE_PROGRAM}) {
    const std::vector<std::string> motions = lines_of(call_program(program, "").out);
    std::vector<std::string> further;
    for (std::size_t i = all_motions().size(); i < motions.size(); ++i)
      further.push_back(motions[i].substr(0, motions[i].find(':')));
    CHECK(further == std::vector<std::string>{"top", "pendulum-at-wall", "gaps", "superball", "conveyor", "grasp",
                                              "chaplygin", "hulls-1015"});
  }
  CHECK(contains(call_program(MOTION_PROGRAM, "top").out, "direct-joints/SMALL-STEPS/SWEEPS"));
  CHECK(lines_of(call_program(MOTION_PROGRAM, "pendulum-at-wall").out).size() ==
        1);  // joints, and contacts that bounce
  CHECK(&any_motion_named("top") == &every_motion()[all_motions().size()]);
  CHECK(contains(complaint([] { any_motion_named("nowhere"); }), "pendulum-at-wall"));
  for (const Motion& motion : all_motions()) CHECK(has_contacts(motion) == motion.pins.empty());
  CHECK(!has_contacts(any_motion_named("top")));
  CHECK(has_contacts(any_motion_named("pendulum-at-wall")));
  CHECK(has_contacts(any_motion_named("grasp")));

  const auto error = [](const std::string& motion, const std::string& setting) {
    const Ended played = call_program(MOTION_WIDE_PROGRAM, motion + " " + setting + " --at-least 0");
    INFO(motion << " " << setting << ": " << played.out << played.err);
    REQUIRE(played.out.starts_with(setting + " error "));
    return std::stod(played.out.substr(setting.size() + 7));
  };
  const double top = error("top", "half-step/8"), meets = error("pendulum-at-wall", "impact/4");
  CHECK(top < 1e-4);
  CHECK(top / error("top", "half-step/32") == Approx(16).epsilon(0.05));
  CHECK(error("top", "order-4/1") / error("top", "order-4/2") == Approx(16).epsilon(0.2));
  CHECK(error("top", "wide/64/1") / error("top", "wide/256/1") == Approx(4).epsilon(0.1));
  CHECK(meets < 1e-4);
  CHECK(meets / error("pendulum-at-wall", "impact/16") == Approx(16).epsilon(0.05));
  // An impact at the end of the substep is of first order.
  CHECK(error("pendulum-at-wall", "half-step/8") > 30 * error("pendulum-at-wall", "impact/8"));
  const Ended back = call_program(MOTION_WIDE_PROGRAM, "pendulum-at-wall order-4/1");
  CHECK(back.status == 2);  // contacts do not go back in time
  CHECK(back.out.empty());
}

TEST_CASE("diagrams have a curve for each engine that has something to show, and for each method") {
  const auto all = made_up();
  const Panel panel = work_precision(all[0], three);
  REQUIRE(panel.curves.size() == 4);
  CHECK(panel.curves[0].x.size() == 5);  // a dot for each of ours that is not lost
  CHECK(panel.curves[0].style == Curve::Style::points);
  CHECK(panel.curves[1].label == "ODE, of 2");  // settings, of which its line was chosen
  CHECK(panel.curves[2].label == "ours, float, of 1");
  CHECK(panel.curves[3].label == "ours, of 6");
  CHECK(panel.curves[1].x.size() == 1);  // the other is slower and worse
  REQUIRE(panel.curves[3].x.size() == 2);
  CHECK(panel.curves[3].x[0] == Approx(3));  // ms of wall time for a second
  CHECK(panel.curves[3].y[0] == Approx(2e-3));
  CHECK((panel.log_x && panel.log_y));
  const Panel methods = fronts_of_methods(all[0], "motion");
  REQUIRE(methods.curves.size() == 2);
  CHECK((methods.curves[0].label == "slim" && methods.curves[1].label == "slim-cold"));
  CHECK(methods.curves[0].colour == methods.curves[1].colour);
  CHECK(methods.curves[1].style == Curve::Style::dashed);
  CHECK(methods.curves[0].x.size() == 3);
  // What divides steps itself has its colour everywhere, and its sister that of hers.
  const MotionMeasured divided{
      &motion_of_60,
      {of("motion_wide", "wide", 1, 1, 1e-3, 1), of("motion_wide", "wide-stiff", 1, 1, 1e-3, 1),
       of("motion_wide", "impact", 1, 1, 1e-3, 1)}};
  const Panel steps = fronts_of_methods(divided, "motion_wide");
  REQUIRE(steps.curves.size() == 3);
  CHECK((steps.curves[0].colour == line_colour(1) && steps.curves[1].colour == line_colour(1)));
  CHECK(steps.curves[1].style == Curve::Style::dashed);
  CHECK(steps.curves[2].colour == line_colour(7));
  const auto knobs = panels_of_knobs(all);
  REQUIRE(knobs.size() == 1);
  CHECK(knobs[0].title == "more sweeps: a stack, a pyramid");
  REQUIRE(knobs[0].curves.size() == 2);
  CHECK(knobs[0].curves[0].label == "stack-10, slim");
  CHECK(knobs[0].curves[0].x == std::vector<Real>{1, 4, 16});
}

TEST_CASE("of all engines, those are drawn of which something was measured") {
  const AllMeasured all{{"bounce", {of("motion", "slim", 1, 1, 1, 1), of("motion_ode", "ode", 1, 1, 1, 1)}}};
  const std::vector<Engine> engines = engines_of(all);
  REQUIRE(engines.size() == 2);
  CHECK((engines[0].program == "motion" && engines[1].program == "motion_ode"));
  CHECK(engines[0].colour != engines[1].colour);
  CHECK(engines_of({}).empty());
}

TEST_CASE("no two engines look alike: those of one colour differ in line and shape") {
  AllMeasured all;
  for (const char* engine : {"motion", "motion_float", "motion_wide", "motion_bullet", "motion_bullet_double",
                             "motion_ode", "motion_mujoco", "motion_box3d", "motion_jolt", "motion_adapter"})
    all["bounce"].push_back(of(engine, "any", 1, 1, 1e-3, 1));
  const std::vector<Engine> engines = engines_of(all);
  REQUIRE(engines.size() == 10);
  const Panel panel = work_precision({&motion_of_60, all["bounce"]}, engines);
  REQUIRE(panel.curves.size() == 11);  // and the dots of ours
  for (std::size_t a = 1; a < panel.curves.size(); ++a) {
    for (std::size_t b = 1; b < a; ++b) {
      const Curve &one = panel.curves[a], &other = panel.curves[b];
      INFO(one.label << ", " << other.label);
      CHECK((one.colour != other.colour || (one.style != other.style && one.marker != other.marker)));
    }
  }
}

TEST_CASE("an error of 0 is drawn at the floor, a tenth of a micrometre, and errors have lines to compare with") {
  const Panel panel = work_precision({&motion_of_60, {of("motion", "slim", 1, 1, 0, 1)}}, three);
  REQUIRE(panel.curves.size() == 2);
  CHECK(drawn(panel, panel.curves[1].y[0]) == Approx(1e-7));
  REQUIRE(panel.lines.size() == 4);
  CHECK((panel.lines[0].label == "1 cm" && panel.lines[0].value == Approx(1e-2)));
  CHECK((panel.lines[2].label == "0.1 mm" && panel.lines[2].value == Approx(1e-4)));
  CHECK((panel.lines[3].label == "1 µm" && panel.lines[3].value == Approx(1e-6)));
}

TEST_CASE("where nothing was measured there is little to say, and nothing breaks") {
  for (const std::vector<MotionMeasured>& all : {std::vector<MotionMeasured>{},
                                                 {{&motion_of_60, {}}},
                                                 {{&motion_of_60, {of("motion", "slim", 1, 1, infinite, 1)}}}}) {
    for (const std::string& text : {table_of_cheapest(all), table_of_engines(all), table_of_others(all, three),
                                    table_of_knobs(all), table_of_limits(all), table_of_hops(all)}) {
      CHECK((all.empty() || lines_of(text).size() >= 2));
      CHECK(!contains(text, "nan"));
      CHECK(!contains(text, "inf"));
    }
    CHECK(panels_of_knobs(all).empty());
    for (const MotionMeasured& measured : all) {
      CHECK(work_precision(measured, three).curves.empty());
      CHECK(fronts_of_methods(measured, "motion").curves.empty());
    }
  }
  CHECK(lines_of(csv_of({})).size() == 1);
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

TEST_CASE("what parts have measured is put together in the order of the whole") {
  const auto measured = [](const std::string& engine) { return of(engine, "m", 1, 1, 1, 1); };
  const AllMeasured whole{{"bounce", {measured("motion"), measured("motion_wide"), measured("motion_ode")}},
                          {"sliding", {measured("motion_ode"), measured("motion_mine")}}};
  const AllMeasured one{{"bounce", {measured("motion_ode")}}, {"sliding", {measured("motion_mine")}}},
      two{{"bounce", {measured("motion"), measured("motion_wide")}}}, three{{"sliding", {measured("motion_ode")}}};
  CHECK(csv_of(together({one, two, three})) == csv_of(whole));
  CHECK(csv_of(together({three, two, one})) == csv_of(whole));
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
  for (const std::string file : {"work_precision.png", "cheapest.md", "limits.md"}) CHECK(fs::exists(folder / file));
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
