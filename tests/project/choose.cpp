/// ./course choose: what it says of a scene is what comes out, and what it cannot read it refuses.
#include <fmt/format.h>

#include <regex>

#include "tests/support/call.h"
#include "tests/support/catch.h"

#ifndef CHOOSE_PROGRAM
#define CHOOSE_PROGRAM "build/release/programs/choose"
#endif

using namespace pushback;

namespace {

/// mm, of the line that begins so; 0 where it is less than can be said.
double error_of(const std::string& text, const std::string& begins) {
  std::smatch found;
  REQUIRE(std::regex_search(text, found, std::regex(begins + ".*; error (less than )?([0-9.e+-]+) mm")));
  return found[1].matched ? 0 : std::stod(found[2]);
}

}  // namespace

TEST_CASE("choose: what slides and what swings keeps what is asked") {
  for (const char* scene : {"06-slide", "13-pendulums"})
    for (const auto& [asked, mm] : {std::pair("1mm", 1.0), {"10 um", 0.01}}) {
      const Ended ended =
          call_program(CHOOSE_PROGRAM, fmt::format("{} --no-images --seconds 2 --error '{}'", scene, asked),
                       120);  // s: with sanitizers it takes more than 20
      INFO(scene << "\n" << ended.out << ended.err);
      REQUIRE(ended.status == 0);
      CHECK(error_of(ended.out, "measured:") <= 2 * mm);  // in two seconds
    }
}

TEST_CASE("choose: an error of first or second order is predicted within a factor of two") {
  const Scratch scratch;
  const std::string hit = (scratch / "hit.json").string();  // two boxes that turn, and hit each other in the air
  std::ofstream(hit) << R"({"bodies": [
      {"shape": {"kind": "box", "half_extents": [0.3, 0.1, 0.2]}, "mass": 2, "position": [-1, 1, 0], "velocity": [2, 0, 0],
       "angular_velocity": [1, 2, 3], "restitution": 1, "friction": 0.3},
      {"shape": {"kind": "box", "half_extents": [0.2, 0.2, 0.4]}, "mass": 3, "position": [1, 1, 0], "velocity": [-2, 0, 0],
       "angular_velocity": [3, 1, -2], "restitution": 1, "friction": 0.3}]})";
  for (const std::string& words :
       std::vector<std::string>{"15-winches --seconds 1", "15-pulleys --seconds 1", "'" + hit + "' --seconds 1",
                                "'" + hit + "' --seconds 1 --error 10mm"}) {
    const Ended ended = call_program(CHOOSE_PROGRAM, fmt::format("{} --no-images", words), 120);
    INFO(ended.out << ended.err);
    REQUIRE(ended.status == 0);
    const double predicted = error_of(ended.out, "predicted:"), measured = error_of(ended.out, "measured:");
    CHECK(predicted <= 2 * measured);
    CHECK(measured <= 2 * predicted);
  }
  const Ended rests = call_program(CHOOSE_PROGRAM, "07-ten-boxes --seconds 1 --no-images", 120);
  INFO(rests.out << rests.err);
  CHECK(error_of(rests.out, "predicted:") == 0);
  CHECK(error_of(rests.out, "measured:") == 0);
}

TEST_CASE("choose: what cannot be predicted is said, and why, before the scene is played") {
  for (const auto& [words, why] :
       {std::pair("03-sunken --seconds 0.5", "not predictable: bodies begin 60 mm deep in each other"),
        {"06-slide", "not predictable: in steps half as long a body is"},
        {"26-chain", "not predictable: places part by a factor of e every"}}) {
    const Ended ended = call_program(CHOOSE_PROGRAM, fmt::format("{} --finer 2 --no-images", words), 120);
    INFO(ended.out << ended.err);
    REQUIRE(ended.status == 0);
    const std::size_t said = ended.out.find(why);
    REQUIRE(said != std::string::npos);
    CHECK(said < ended.out.find("measured:"));
  }
}

TEST_CASE("choose: a budget that buys anything has the least error, and one that buys nothing is refused") {
  const Ended ended = call_program(CHOOSE_PROGRAM, "02-landing --seconds 0.3 --finer 2 --no-images --budget 10s");
  INFO(ended.out << ended.err);
  CHECK(ended.status == 0);
  CHECK(ended.out.find("within 0.001 mm a second") != std::string::npos);
  CHECK(call_program(CHOOSE_PROGRAM, "02-landing --seconds 0.3 --no-images --budget 0.000001us").status == 2);
}

TEST_CASE("choose: what cannot be meant is named, with status 2, and nothing is written") {
  const Scratch scratch;
  for (const auto& [words, named] : std::vector<std::pair<std::string, std::string>>{
           {"nowhere", "scene is 'nowhere'"},
           {"06-slide --error 1", "--error is '1'"},
           {"06-slide --error -1mm", "--error is '-1mm'"},
           {"06-slide --error infmm", "--error is 'infmm'"},
           {"06-slide --error 1e9m", "--error is '1e9m': from 1e-15 to 1000 m"},
           {"06-slide --out=", "--out"},
           {"06-slide --budget 1mm", "--budget is '1mm'"},
           {"06-slide --seconds 1000", "--seconds"},
           {"06-slide --finer 1", "--finer"},
           {"06-slide --error 1mm --budget 1ms", "--budget"}}) {
    const Ended ended = call_program(CHOOSE_PROGRAM, words + " --out '" + (scratch / "out").string() + "'");
    INFO(words << "\n" << ended.out << ended.err);
    CHECK(ended.status == 2);
    CHECK(ended.err.find(named) != std::string::npos);
    CHECK_FALSE(fs::exists(scratch / "out"));
  }
}

TEST_CASE("choose: a scene's file that is a folder, or in which nothing can move, is refused") {
  const Scratch scratch;
  fs::create_directory(scratch / "folder.json");
  std::ofstream(scratch / "still.json")
      << R"({"bodies": [{"shape": {"kind": "half_space", "normal": [0, 1, 0]}, "mass": null, "position": [0, 0, 0]}]})";
  for (const auto& [file, said] : {std::pair("folder.json", "folder.json' is a folder: a file is needed"),
                                   {"still.json", "still.json: no body can move"},
                                   {"none.json", "none.json' cannot be read: No such file"}}) {
    const Ended ended = call_program(CHOOSE_PROGRAM, "--no-images '" + (scratch / file).string() + "'");
    INFO(file << "\n" << ended.out << ended.err);
    CHECK(ended.status == 2);
    CHECK(contains(ended.err, said));
  }
}
