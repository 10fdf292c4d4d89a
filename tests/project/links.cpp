/// Every link on every page leads somewhere, and one can walk from the first chapter to the last and back to the front page.
#include "tests/project/links.h"

/// The root of the sources, as seen from the working directory of the tests.
#ifndef SOURCE_DIR
#define SOURCE_DIR "."
#endif

TEST_CASE("every link on every page leads somewhere") {
  const std::vector<fs::path> pages = pages_in(SOURCE_DIR);
  CHECK(pages.size() >= 20);  // the front page, the chapters' and some of docs/, at least
  std::size_t links = 0;
  for (const fs::path& page : pages) {
    links += targets_in(text_of(page)).size();
    for (const std::string& wrong : wrong_links(page)) FAIL_CHECK(wrong);
  }
  CHECK(links > 100);
}

TEST_CASE("at its foot, each chapter links to the one before and the one behind it, the last to the front page") {
  std::vector<std::string> chapters;
  for (const auto& entry : fs::directory_iterator(fs::path(SOURCE_DIR) / "chapters")) {
    if (fs::exists(entry.path() / "README.md")) chapters.push_back(entry.path().filename().string());
  }
  std::sort(chapters.begin(), chapters.end());
  REQUIRE(chapters.size() >= 16);
  for (std::size_t i = 0; i < chapters.size(); ++i) {
    INFO(chapters[i]);
    std::vector<std::string> wanted;
    if (i > 0) wanted.push_back("../" + chapters[i - 1] + "/README.md");
    wanted.push_back(i + 1 < chapters.size() ? "../" + chapters[i + 1] + "/README.md" : "../../README.md");
    const std::vector<std::string> lines =
        lines_of(text_of(fs::path(SOURCE_DIR) / "chapters" / chapters[i] / "README.md"));
    CHECK(targets_in(lines.back()) == wanted);
  }
}
