/// What the pages count is so: how many scenes there are, which have joints, that each has its line in docs/speed.md, and the
/// bytes that stand there; and what they promise of includes.
#include <fmt/format.h>

#include <algorithm>

#include "pushback/chapters/01_velocity_constraint/row.h"
#include "pushback/engine/islands/scene_questions.h"
#include "pushback/tools/catalogue/catalogue.h"
#include "tests/support/call.h"

using namespace pushback;

TEST_CASE("chapter 20's page counts the scenes and those that call for joints") {
  const std::vector<NamedScene> scenes = all_scenes();
  std::vector<std::string> jointed;
  for (const NamedScene& scene : scenes) {
    World world;
    scene.fill(world);
    if (NeedsJoints::in(world).yes) jointed.push_back(scene.name);
  }
  const auto of_joints = std::count_if(jointed.begin(), jointed.end(), [](const std::string& name) {
    return name.starts_with("13-") || name.starts_with("14-") || name.starts_with("15-");
  });
  REQUIRE(jointed.size() == static_cast<std::size_t>(of_joints) + 1);
  CHECK(jointed.back() == "18-chain");
  const std::string page = text_of(fs::path(SOURCE_DIR) / "chapters/20_only_what_is_needed/README.md");
  const std::string sentence = fmt::format(
      "Of {} scenes, the {} of chapters 13 to 15 and the chain of 18 call for joints", scenes.size(), of_joints);
  INFO(sentence);
  CHECK(contains(page, sentence));
}

TEST_CASE("chapter 20's page shows what ./course effects prints") {
  const std::string page = text_of(fs::path(SOURCE_DIR) / "chapters/20_only_what_is_needed/README.md");
  for (const std::string scene : {"20-ice", "15-swing"}) {
    const Ended ended = call_program(EFFECTS_PROGRAM, scene);
    REQUIRE(ended.status == 0);
    INFO(ended.out);
    CHECK(contains(page, "```\n$ ./course effects " + scene + "\n" + ended.out + "```\n"));
  }
}

TEST_CASE("docs/speed.md has the bytes of a contact and of a row") {
  if (sizeof(Real) != sizeof(double)) return;  // the page is about double
  const std::string page = text_of(fs::path(SOURCE_DIR) / "docs/speed.md");
  CHECK(contains(page, fmt::format("| `Contact` | {} |", sizeof(Contact))));
  CHECK(contains(page, fmt::format("| a `Row`; three with friction | {}; {} |", sizeof(Row), 3 * sizeof(Row))));
}

TEST_CASE("a chapter includes no later chapter, and its plain loop no other one") {
  const std::string start = "#include \"pushback/chapters/";
  int includes = 0, loops = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(SOURCE_DIR) / "chapters")) {
    const std::string file = fs::relative(entry.path(), fs::path(SOURCE_DIR) / "chapters").string();
    const fs::path extension = entry.path().extension();
    if (std::isdigit(static_cast<unsigned char>(file[0])) == 0 || (extension != ".h" && extension != ".cpp")) continue;
    const std::string chapter = file.substr(0, file.find('/'));
    const bool plain = file == chapter + "/flat.h" || file == chapter + "/flat.cpp";
    loops += file == chapter + "/flat.cpp";
    for (const std::string& line : lines_of(text_of(entry.path()))) {
      if (!line.starts_with(start)) continue;
      INFO(file << ": " << line);
      CHECK(line.substr(start.size(), 2) <= chapter.substr(0, 2));
      CHECK((!plain || line == start + chapter + "/flat.h\""));
      ++includes;
    }
  }
  CHECK(includes > 100);
  CHECK(loops == 15);  // of chapters 01 to 14, and 21
}

TEST_CASE("the rooms are in order: common, chapters 00 to 15, the engine's four, later chapters, tools") {
  // What each room may include, besides itself.
  const std::vector<std::string> rooms{"common/",         "chapters/0",       "chapters/1[0-5]",
                                       "engine/direct/",  "engine/substeps/", "engine/half_step/",
                                       "engine/islands/", "engine/presets.h", "chapters/(1[6-9]|2)"};
  const auto place_of = [&](const std::string& file) {
    for (std::size_t i = 0; i < rooms.size(); ++i)
      if (std::regex_search(file, std::regex("^" + rooms[i]))) return i;
    return rooms.size();
  };
  int includes = 0;
  static const std::regex include("^#include \"(pushback/)?([^\"]*)\"");
  for (const std::string room : {"common", "chapters", "engine"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(SOURCE_DIR) / room)) {
      if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
      const std::string file = fs::relative(entry.path(), SOURCE_DIR).string();
      for (const std::string& line : lines_of(text_of(entry.path()))) {
        std::smatch found;
        if (!std::regex_search(line, found, include)) continue;
        INFO(file << ": " << line);
        CHECK(place_of(found[2]) <= place_of(file));
        ++includes;
      }
    }
  }
  CHECK(includes > 900);
}

TEST_CASE("the page before chapter 00 shows lines of chapter 13's numbers") {
  const std::vector<std::string> printed = lines_of(text_of(fs::path(SOURCE_DIR) / "renders/13_joints/numbers.md"));
  int rows = 0;
  for (const std::string& line : lines_of(text_of(fs::path(SOURCE_DIR) / "docs/before_you_start.md"))) {
    if (!line.starts_with("|")) continue;
    INFO(line);
    CHECK(std::find(printed.begin(), printed.end(), line) != printed.end());
    ++rows;
  }
  CHECK(rows == 4);
}
