/// The chapters' programs as a student calls them: options, messages, exit statuses, and what they leave behind.

#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "tests/support/call.h"

namespace {

Ended call(const std::string& chapter, const std::string& arguments, int seconds = 20) {
  return call_program(fs::path(CHAPTER_DIR) / chapter, arguments, seconds);
}

/// A run without pictures, and what it wrote.
struct Numbers {
  std::string table;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  std::size_t column(const std::string& name) const {
    const auto found = std::find(header.begin(), header.end(), name);
    if (found == header.end()) FAIL("no column " << name);
    return static_cast<std::size_t>(found - header.begin());
  }
};

Numbers numbers_of(const std::string& chapter, const std::string& arguments, int seconds = 20) {
  const Scratch scratch;
  const Ended outcome = call(chapter, "--no-images --out '" + (scratch / "out").string() + "' " + arguments, seconds);
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  const fs::path folder = scratch / "out" / chapter;
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(scratch / "out")) {
    if (entry.is_regular_file()) files.push_back(entry.path().filename().string());
  }
  std::sort(files.begin(), files.end());
  REQUIRE(files == std::vector<std::string>{"metrics.csv", "numbers.md"});  // and no picture
  Numbers numbers{text_of(folder / "numbers.md"), {}, {}};
  for (const std::string& line : lines_of(text_of(folder / "metrics.csv"))) {
    if (numbers.header.empty()) numbers.header = fields_of(line);
    else numbers.rows.push_back(fields_of(line));
  }
  for (const auto& row : numbers.rows) REQUIRE(row.size() == numbers.header.size());
  return numbers;
}

/// These have no studies that --seconds does not shorten.
const std::vector<std::string> short_chapters{"00_naive_impulses", "04_slop", "13_joints"};

}  // namespace

TEST_CASE("option --parameters prints an experiment's own options as JSON, and --help names them") {
  for (const std::string& chapter : short_chapters) {
    const Ended as_json = call(chapter, "--parameters"), help = call(chapter, "--help");
    INFO(chapter << ": " << as_json.out);
    CHECK(as_json.status == 0);
    CHECK(help.status == 0);
    CHECK(help.err.empty());
    CHECK(as_json.out.starts_with("[{"));
    CHECK(as_json.out.ends_with("}]\n"));
    const std::string flag = "{\"flag\": \"";
    for (std::size_t at = 0; (at = as_json.out.find(flag, at)) != std::string::npos; at += flag.size())
      CHECK(contains(help.out,
                     as_json.out.substr(at + flag.size(), as_json.out.find('"', at + flag.size()) - at - flag.size())));
  }
  CHECK(contains(call("04_slop", "--parameters").out,
                 R"({"flag": "--slop", "symbol": "slop", "unit": "m", "what": "Overlaps to leave alone", )"
                 R"("default": [0, 0.005, 0.02], "least": 0, "most": 0.1, "whole": false})"));
}

TEST_CASE("a value that cannot be used: status 2, a message that names it, and nothing is written") {
  struct Wrong {
    std::string program, arguments;
    std::vector<std::string> named;
  };
  for (const Wrong& wrong : std::vector<Wrong>{
           {"03_baumgarte", "--size 0x0", {"--size", "0x0"}},
           {"03_baumgarte", "--size 4294967936x360", {"--size", "4294967936x360"}},  // 640 in 32 bits
           {"03_baumgarte", "--dt nan", {"--dt", "nan"}},
           {"03_baumgarte", "--sweeps 1.5", {"--sweeps", "1.5"}},
           {"03_baumgarte", "--frames 4294967297", {"--frames", "4294967297", "from 0 to 100000"}},
           {"03_baumgarte", "--dt 1e6", {"--dt", "1e6", "from 1e-06 to 1"}},
           {"03_baumgarte", "--out ''", {"--out", "''"}},
           {"03_baumgarte", "--variants ''", {"--variants", "''"}},
           {"03_baumgarte", "''", {"''"}},
           {"03_baumgarte", "--beta 0.2,,0.4", {"--beta", "'0.2,,0.4'", "between any two commas"}},
           {"03_baumgarte", "--variants unknown", {"--variants", "unknown"}},
           {"03_baumgarte", "--beta 0.2,nan", {"beta", "nan"}},
           {"03_baumgarte", "--banana", {"--banana"}},
           {"03_baumgarte", "banana", {"banana"}},
           // More steps than anyone could wait for.
           {"03_baumgarte", "--seconds 1e30", {"--seconds", "1e+30"}},
           {"03_baumgarte", "--out /dev/null/x", {"--out", "/dev/null/x"}},
           {"hard_cases_fuzz", "--scenes -1", {"--scenes", "'-1'", "from 1 to 1000000"}},
           {"hard_cases_fuzz", "--known 3,,4", {"'3,,4'", "between any two commas"}},
           {"growth", "--tolerance nan", {"'nan'", "a number from 0 to 1000000"}},
           {"solve", "none.dat --sweeps 1e3", {"'1e3'", "a whole number from 0 to 100000000"}},
       }) {
    const Scratch scratch;
    const std::string out = contains(wrong.arguments, "--out") ? "" : "--out '" + (scratch / "out").string() + "' ";
    const bool chapter = std::isdigit(wrong.program[0]) != 0;
    const Ended outcome = call(wrong.program, (chapter ? "--no-images " + out : "") + wrong.arguments);
    INFO(wrong.program << " " << wrong.arguments << ": " << outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    for (const std::string& name : wrong.named) CHECK(contains(outcome.err, name));
    CHECK(outcome.err.size() < 300);  // to be read by a person
    CHECK_FALSE(fs::exists(scratch / "out"));
  }
}

TEST_CASE("metrics.csv has the documented columns and a row for each variant and step") {
  const Numbers numbers = numbers_of("04_slop", "--seconds 0.5 --dt 0.01 --slop 0,0.01");
  const std::string documented =
      "scene variant step time kinetic_energy potential_energy px py pz lx ly lz deepest_overlap contacts found lost "
      "rows residual solver_seconds";
  CHECK(fmt::format("{}", fmt::join(numbers.header, " ")).starts_with(documented));
  std::map<std::string, int> steps;
  for (const auto& row : numbers.rows) {
    const int step = ++steps[row[numbers.column("variant")]];
    CHECK(row[numbers.column("step")] == std::to_string(step));
    CHECK(std::stod(row[numbers.column("time")]) == Approx(0.01 * step));
    CHECK(std::stod(row[numbers.column("solver_seconds")]) >= 0);
  }
  CHECK(steps == std::map<std::string, int>{{"slop = 0 mm", 50}, {"slop = 10 mm", 50}});
}

TEST_CASE("the columns mean what their names say") {
  // Two boxes without a solver for 0.1 s, one let go, one thrown up out of the ground with 5 m/s: momentum m v0 - 2 m g t,
  // energies that add up, contacts in the first step alone.
  Numbers numbers = numbers_of("01_velocity_constraint", "--seconds 0.1 --variants no-constraint");
  std::erase_if(numbers.rows, [&](const auto& row) {
    return row[numbers.column("scene")] != "It stops a fall, and holds what leaves";
  });
  REQUIRE(numbers.rows.size() == 6);
  const auto value = [&](std::size_t row, const std::string& name) {
    return std::stod(numbers.rows[row][numbers.column(name)]);
  };
  for (std::size_t i = 0; i < numbers.rows.size(); ++i) {
    const double t = value(i, "time");
    CHECK(t == Approx(static_cast<double>(i + 1) / 60));
    CHECK(value(i, "py") == Approx(100 * 5 - 200 * 9.81 * t));
    CHECK(value(i, "px") == 0);
    CHECK(value(i, "kinetic_energy") == Approx(50 * (9.81 * 9.81 * t * t + (5 - 9.81 * t) * (5 - 9.81 * t))));
    // Symplectic Euler falls g t h / 2 farther than the parabola.
    CHECK(value(i, "potential_energy") == Approx(100 * 9.81 * (1.54 + 0.49 + 5 * t - 9.81 * t * (t + 1.0 / 60))));
    CHECK(value(i, "contacts") == (i == 0 ? 4 : 0));
    CHECK(value(i, "deepest_overlap") == Approx(i == 0 ? 0.01 : 0));
  }
}

TEST_CASE("options: --variants picks, --sweeps and --dt act") {
  const Numbers all = numbers_of("04_slop", "--seconds 0.2");
  const Numbers one = numbers_of("04_slop", "--seconds 0.2 --variants slop-5-mm");
  const Numbers two = numbers_of("04_slop", "--seconds 0.2 --variants slop-20-mm,slop-0-mm");
  CHECK(one.rows.size() == all.rows.size() / 3);
  CHECK(two.rows.size() == all.rows.size() / 3 * 2);
  for (const auto& row : one.rows) CHECK(row[one.column("variant")] == "slop = 5 mm");
  // Alone it does what it does in company.
  const std::size_t overlap = all.column("deepest_overlap");
  for (std::size_t i = 0; i < one.rows.size(); ++i)
    CHECK(one.rows[i][overlap] == all.rows[one.rows.size() + i][overlap]);

  const Numbers first = numbers_of("06_friction", "--seconds 0.2 --first-scene");
  CHECK(first.rows.size() < numbers_of("06_friction", "--seconds 0.2").rows.size());
  for (const auto& row : first.rows) CHECK(row[first.column("scene")] == first.rows[0][first.column("scene")]);

  CHECK(contains(numbers_of("03_baumgarte", "--seconds 0.1").table, "the tuning rule"));
  CHECK_FALSE(contains(numbers_of("03_baumgarte", "--seconds 0.1 --no-study").table, "the tuning rule"));

  CHECK(numbers_of("04_slop", "--seconds 0.2 --dt 0.005").rows.size() == 3 * 40);
  const Numbers quick = numbers_of("06_friction", "--seconds 0.2 --sweeps 2");
  const Numbers thorough = numbers_of("06_friction", "--seconds 0.2 --sweeps 100");
  const std::size_t residual = quick.column("residual");
  double few = 0, many = 0;
  for (std::size_t i = 0; i < quick.rows.size(); ++i) {
    few += std::stod(quick.rows[i][residual]);
    many += std::stod(thorough.rows[i][residual]);
  }
  CHECK(many < few / 10);
}

TEST_CASE("with pictures: as many frames of each variant as asked for, of the size asked for, a sheet and a plot") {
  const Scratch scratch;
  const std::string asked = "--seconds 0.2 --frames 3 --size 64x48 --variants slop-0-mm,slop-5-mm --out ";
  const Ended outcome = call("04_slop", asked + (scratch / "out").string());
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  const fs::path folder = scratch / "out" / "04_slop";
  for (const std::string name : {"sheet.png", "plot.png", "metrics.csv", "numbers.md"})
    CHECK(fs::file_size(folder / name) > 0);
  for (const std::string variant : {"slop-0-mm", "slop-5-mm"}) {
    int frames = 0;
    for (const auto& entry : fs::directory_iterator(folder / variant)) {
      const std::string png = text_of(entry.path());
      REQUIRE(png.size() > 24);
      CHECK(png.substr(1, 3) == "PNG");
      CHECK(static_cast<unsigned char>(png[19]) == 64);  // width and height: big-endian, from bytes 16 and 20 on
      CHECK(static_cast<unsigned char>(png[23]) == 48);
      ++frames;
    }
    CHECK(frames == 3);
  }
  // The same bytes again, whatever languages and fonts the machine is set up for.
  const std::string program = (fs::path(CHAPTER_DIR) / "04_slop").string();
  REQUIRE(call_program("/usr/bin/env", "LC_ALL=tr_TR.UTF-8 PANGO_LANGUAGE=ja FONTCONFIG_FILE=/dev/null '" + program +
                                           "' " + asked + (scratch / "again").string())
              .status == 0);
  for (const std::string name : {"sheet.png", "thumbnail.png", "slop-5-mm/frame_0001.png"}) {
    INFO(name);
    CHECK(text_of(folder / name) == text_of(scratch / "again" / "04_slop" / name));
  }
}
