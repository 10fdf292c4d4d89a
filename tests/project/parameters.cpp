/// The chapters' parameters, as --parameters prints them: whatever a reader chooses between their ends, the program ends well,
/// and the closed forms follow.
#include <fmt/format.h>

#include <cmath>
#include <regex>
#include <sstream>

#include "tests/support/call.h"

namespace {

struct Slider {
  std::string flag, least, most;
  bool whole;
};

std::vector<std::string> chapters() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(CHAPTER_DIR)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_regular_file() && std::regex_match(name, std::regex("[0-9]{2}_[a-z_]+"))) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<Slider> sliders_of(const std::string& chapter) {
  const Ended printed = call_program(fs::path(CHAPTER_DIR) / chapter, "--parameters");
  REQUIRE(printed.status == 0);
  static const std::regex object(
      R"re(\{"flag": "(--[a-z-]+)", "symbol": "[^"]*", "unit": "[^"]*", "what": "[^"]+", "default": \[[^\]]+\], )re"
      R"re("least": ([^,]+), "most": ([^,]+), "whole": (true|false)\})re");
  std::vector<Slider> sliders;
  for (std::sregex_iterator at(printed.out.begin(), printed.out.end(), object), end; at != end; ++at)
    sliders.push_back({(*at)[1], (*at)[2], (*at)[3], (*at)[4] == "true"});
  const auto lines = lines_of(printed.out);
  CHECK(sliders.size() == lines.size());  // an object a line: none that was not understood
  return sliders;
}

/// A run of the scenes, and what it wrote.
struct Outcome {
  int status;
  std::string err, numbers, metrics;
};
Outcome run(const std::string& chapter, const std::string& arguments) {
  const Scratch scratch;
  const Ended ended = call_program(fs::path(CHAPTER_DIR) / chapter,
                                   "--no-images --no-study --out '" + (scratch / "out").string() + "' " + arguments,
                                   60);  // s: with sanitizers, chapter 17 at a mass ratio of 10,000 takes more than 20
  const fs::path folder = scratch / "out" / chapter;
  if (ended.status != 0) return {ended.status, ended.err, {}, {}};
  return {0, ended.err, text_of(folder / "numbers.md"), text_of(folder / "metrics.csv")};
}

/// How often something stands where a number should.
std::ptrdiff_t no_numbers(const Outcome& outcome) {
  static const std::regex word("\\b(nan|inf)\\b|–");
  const auto count = [](const std::string& text) {
    return std::distance(std::sregex_iterator(text.begin(), text.end(), word), std::sregex_iterator());
  };
  return count(outcome.numbers) + count(outcome.metrics);
}

/// What was measured, and what it should be, of a cell of numbers.md: "1.72 m (should be 1.72)".
struct Cell {
  double measured, expected;
};
/// Of the tables with `table` in their heading.
std::vector<Cell> cells_of(const std::string& numbers, const std::string& variant, const std::string& table,
                           const std::string& column) {
  static const std::regex cell(R"(^ (< )?(-?[0-9.e+-]+)[^(]*\(should be (< )?(-?[0-9.e+-]+)\))");
  std::vector<Cell> cells;
  std::string heading, before;
  for (const std::string& line : lines_of(numbers)) {
    if (line.rfind("| ---", 0) == 0) heading = before;
    before = line;
    if (!contains(heading, table)) continue;
    const std::size_t marker_ends = line.find(' ', 2);
    if (marker_ends == std::string::npos || line.compare(marker_ends + 1, variant.size(), variant) != 0) continue;
    std::istringstream headings(heading), texts(line);
    std::string above, text;
    for (std::smatch at; std::getline(headings, above, '|') && std::getline(texts, text, '|');)
      if (contains(above, column) && std::regex_search(text, at, cell))
        cells.push_back({at[1].matched ? 0 : std::stod(at[2]), at[3].matched ? 0 : std::stod(at[4])});
  }
  return cells;
}

/// In the default tests those that take the fewest seconds; ./course check runs them all.
const std::vector<std::string> quick{"00_naive_impulses", "02_clamping", "05_restitution", "22_wide"};

void end_well_at_the_ends(const std::string& chapter) {
  const std::string shortly = "--seconds 0.15 ";
  const Outcome by_default = run(chapter, shortly);
  INFO(chapter << ": " << by_default.err);
  REQUIRE(by_default.status == 0);
  for (const Slider& slider : sliders_of(chapter)) {
    for (const std::string& value : {slider.least, slider.most}) {
      const Outcome outcome = run(chapter, shortly + slider.flag + " " + value);
      INFO(slider.flag << " " << value << ": " << outcome.err << "\n" << outcome.numbers);
      CHECK(outcome.status == 0);
      CHECK(no_numbers(outcome) <= no_numbers(by_default));
    }
  }
}

}  // namespace

TEST_CASE("at both ends of each parameter a chapter ends with status 0, and with numbers where the default has them") {
  for (const std::string& chapter : quick) end_well_at_the_ends(chapter);
}

TEST_CASE("at both ends of each parameter: in all other chapters", "[checked]") {
  for (const std::string& chapter : chapters())
    if (std::ranges::count(quick, chapter) == 0) end_well_at_the_ends(chapter);
}

namespace {

/// Chapter | variant, which does what it should | it may be off by that part of what it should be | and by that much | arguments of
/// each run | the tables that have it | their columns. Empty: each table that has such a variant, each column that says what should be.
const std::string follows = R"(
01_velocity_constraint | no constraint | 0.01 | 0 | --speed 0.5; --speed 2.5; --speed 7 | It stops a fall | thrown
01_velocity_constraint | no constraint | 0.01 | 0 | --speed 2.5 | It pushes | red box falls
01_velocity_constraint | n as it is | 0.01 | 1e-3 | --slope 0; --slope 0.1; --slope 0.6 | |
03_baumgarte | contact, β | 0.01 | 0 | --depth 0.001; --depth 0.2; --beta 0.03,0.3,0.97 | |
03_baumgarte | equality, β | 0 | 1e-6 | --depth 0.001; --depth 0.2; --beta 0.03,0.3,0.97 | |
05_restitution | bounce or push-out | 0.01 | 0 | --bounciness 1; --bounciness 1 --drop 1 --threshold 3 | first apex |
06_friction | bounded by μ Σλₙ | 0.01 | 0.01 | --slope 0.05; --slope 0.9 | tan θ |
06_friction | bounded by μ Σλₙ | 0.01 | 1e-4 | --mu 0.3; --mu 1.5; --speed 1; --speed 8 | rolling |
08_friction_cone | cone | 0 | 0.01 | --mu 0.25; --mu 0.65; --speed 1; --speed 7 | |
09_impacts | from the surface | 0.02 | 0.006 | --bounciness 1; --bounciness 0.6 --drop 1; --threshold 3 | |
09_impacts | touching, simultaneous | 0.01 | 0 | --gap 0.08; --gap 0.5 | |
10_position_correction | split impulse | 0.01 | 1e-6 | --ball-depth 0.2; --beta 0.5; --most 0.004 | |
10_position_correction | non-linear | 0.01 | 1e-6 | --ball-depth 0.2; --beta 0.5; --most 0.004; --rounds 1; --rounds 7 | |
12_soft_contacts | 32 substeps | 0.01 | 1e-6 | --depth 0.005 BALL 5; --depth 0.2 BALL 200 | |
12_soft_contacts | 32 substeps | 0.01 | 0 | --depth 0.02 --hertz 60 --damping-ratio 1 BALL 20 | |
12_soft_contacts | 32 substeps | 0.01 | 0 | --mass-ratio 1 PAIR one; --mass-ratio 100 PAIR a-hundred | |
13_joints | β = 0.2 | 0.02 | 0 | PENDULUMS --release 0.1; PENDULUMS --release 2.2 --dt 0.004 | |
15_limits_motors_springs | 3.78 kg m² | 0 | 0.01 | --torque 4; --torque 1000 | |
15_limits_motors_springs | limit, λ ≥ 0 | 0 | 1e-3 | --stop -60; --stop 0; --stop 60 | |
15_limits_motors_springs | 1.5 kg | 0.01 | 0 | --load 2.1; --load 10 | |
15_limits_motors_springs | 2 kg and | 0.01 | 1e-3 | --heavy 2.1; --heavy 4 | |
15_limits_motors_springs | three motors | 0.01 | 0.01 | --slope 8; --slope 30 | |
17_direct_contacts | direct contact solve | 0 | 1e-3 | --mass-ratio 1; --mass-ratio 10000 | |
18_direct_joints | direct joint solve | 0 | 1e-6 | --links 1; --links 40; --mass-ratio 10000 | |
)";

/// Only what is looked at, where a scene takes long.
std::string with_variants(std::string arguments) {
  for (const auto& [word, variants] : std::vector<std::pair<std::string, std::string>>{
           {"BALL (\\d+)",
            "--variants $1-mm-too-deep-without-gravity_32-substeps-hard,"
            "$1-mm-too-deep-without-gravity_32-substeps-soft-not-relaxed"},
           {"PAIR ([a-z-]+)", "--variants $1-times-heavier-than-what-it-lies-on_32-substeps-soft"},
           {"PENDULUMS", "--variants a-ball-on-a-rod-a-plank-on-a-hinge_beta-0.2"}})
    arguments = std::regex_replace(arguments, std::regex(word), variants);
  return arguments;
}

/// Without the spaces around each part.
std::vector<std::string> divided(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, at);) {
    const std::size_t begin = part.find_first_not_of(' '), end = part.find_last_not_of(' ');
    parts.push_back(begin == std::string::npos ? "" : part.substr(begin, end - begin + 1));
  }
  return parts;
}

}  // namespace

TEST_CASE("closed forms follow the parameters of their scenes") {
  for (const std::string& line : divided(follows, '\n')) {
    if (line.empty()) continue;
    const std::vector<std::string> its = divided(line + " ", '|');
    REQUIRE(its.size() == 7);
    for (const std::string& arguments : divided(its[4], ';')) {
      const Outcome outcome = run(its[0], with_variants(arguments));
      INFO(its[0] << " " << arguments << "\n" << outcome.err << outcome.numbers);
      REQUIRE(outcome.status == 0);
      const std::vector<Cell> cells = cells_of(outcome.numbers, its[1], its[5], its[6]);
      CHECK(!cells.empty());
      for (const auto& [measured, expected] : cells)
        CHECK(std::abs(measured - expected) <= std::stod(its[2]) * std::abs(expected) + std::stod(its[3]));
    }
  }
}
