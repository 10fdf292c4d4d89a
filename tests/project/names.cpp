/// Names in the chapters' headers: none is given twice, and the scenes' stay among themselves.
#include <map>
#include <regex>
#include <set>

#include "tests/support/call.h"

/// The root of the sources, as seen from the working directory of the tests.
#ifndef SOURCE_DIR
#define SOURCE_DIR "."
#endif

namespace {

/// What a header of ours defines or declares in `pushback` itself: a line that does not begin with a blank begins with that.
std::set<std::string> names_in(const std::string& header) {
  static const std::regex arguments("<[^<>]*>"), type("^(?:struct|class|enum class|enum|using) (\\w+)\\b(?! *;|::)"),
      other("(\\w+) ?[(={;\\[]"), none("^(?:template|namespace|using|static_assert|struct|class|enum)\\b|operator");
  std::set<std::string> names;
  bool inside = false;
  for (std::string line : lines_of(header)) {
    if (line == "namespace pushback {") inside = true;
    if (line.starts_with("}  // namespace")) inside = false;
    if (!inside || line.empty() || std::isalpha(static_cast<unsigned char>(line[0])) == 0) continue;
    for (std::string before; before != line;) before = std::exchange(line, std::regex_replace(line, arguments, ""));
    std::smatch found;
    if (std::regex_search(line, found, type) ||
        (!std::regex_search(line, none) && std::regex_search(line, found, other)))
      names.insert(found[1]);
  }
  return names;
}

}  // namespace

TEST_CASE("a header's names are found: types, functions, constants, and not those of a namespace of their own") {
  CHECK(
      names_in(
          "namespace pushback {\nclass World;\nusing friction_scenes::Push;\n\nstruct Row : Base<int> {\n  int a;\n};\n"
          "using Rows = std::vector<Row>;\ninline constexpr Real g = Real(9.81);\ntemplate <class T>\n"
          "std::function<Real(const Run&)> apex(T t) {\n  call(t);\n}\nbool operator==(Row, Row);\n}  // namespace "
          "pushback\n"
          "namespace pushback::own {\nint hidden;\n}") == std::set<std::string>{"Row", "Rows", "apex", "g"});
}

TEST_CASE("no two chapters' headers give the same name in namespace pushback") {
  const fs::path chapters = fs::path(SOURCE_DIR) / "chapters";
  std::map<std::string, std::string> chapter_of;
  for (const auto& entry : fs::recursive_directory_iterator(chapters)) {
    if (entry.path().extension() != ".h") continue;
    const std::string chapter = fs::relative(entry.path(), chapters).begin()->string();
    for (const std::string& name : names_in(text_of(entry.path()))) {
      INFO(name << " of " << entry.path());
      CHECK(chapter_of.try_emplace(name, chapter).first->second == chapter);
    }
  }
  CHECK(chapter_of.size() > 150);
}

TEST_CASE("the scenes of a chapter have a namespace of their own, named after its folder") {
  int scenes = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(SOURCE_DIR) / "chapters")) {
    const std::string folder = entry.path().filename().string();
    for (const std::string file : {"scenes.h", "study.h"}) {
      if (!fs::exists(entry.path() / file)) continue;
      INFO(folder << "/" << file);
      CHECK(contains(text_of(entry.path() / file), "\nnamespace pushback::" + folder.substr(3) + "_scenes {\n"));
      CHECK(names_in(text_of(entry.path() / file)).empty());
      ++scenes;
    }
  }
  CHECK(scenes > 20);
}

TEST_CASE("no name of a test has a semicolon: CMake would make two of it, of which ctest runs none") {
  int names = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(SOURCE_DIR) / "tests")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = text_of(entry.path());
    const std::regex name("TEST_CASE\\(\\s*\"([^\"]*)\"");
    for (std::sregex_iterator one(text.begin(), text.end(), name), end; one != end; ++one, ++names) {
      INFO(entry.path() << ": " << (*one)[1]);
      CHECK((*one)[1].str().find(';') == std::string::npos);
    }
  }
  CHECK(names > 700);
}
