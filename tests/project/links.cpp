/// Every link on every page leads somewhere, and one can walk from the first chapter to the last and back to the front page.
#include "tests/project/links.h"

#include <fstream>

/// The root of the sources, as seen from the working directory of the tests.
#ifndef SOURCE_DIR
#define SOURCE_DIR "."
#endif

namespace {

void write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

}  // namespace

TEST_CASE("an anchor is what GitHub makes of the heading") {
  CHECK(anchor_of("What it costs") == "what-it-costs");
  CHECK(anchor_of("Each scene: 10 s, 1/60 s") == "each-scene-10-s-160-s");
  CHECK(anchor_of("β is a part per step") == "β-is-a-part-per-step");
  CHECK(anchor_of("`Row::solve`, a `snake_case` and a half-step") == "rowsolve-a-snake_case-and-a-half-step");
  CHECK(anchor_of("Fast – and right?") == "fast--and-right");
  CHECK(anchor_of("See [the row](row.h)") == "see-the-row");
  const std::string page = "# One\n\n## Two\n\n```sh\n# no heading\n```\n## Two\n####### seven\n#hash\n";
  CHECK(anchors_in(page) == std::set<std::string>{"one", "two", "two-1"});
}

TEST_CASE("links are found over ends of lines, in links and with brackets, but not in code") {
  CHECK(targets_in("a [link\nover two](x.md) and [![picture](p.png)](y.md), [wiki](https://a.org/b_(c)).") ==
        std::vector<std::string>{"x.md", "p.png", "y.md", "https://a.org/b_(c)"});
  CHECK(targets_in("`[a](b)` and\n```cpp\nauto f = [&](int i) { return i; };\n```\n[c](d)") ==
        std::vector<std::string>{"d"});
}

TEST_CASE("what leads nowhere is found: a file, a heading here and there, a picture, an address") {
  const Scratch scratch;
  write(scratch / "docs/there.md", "# There\n\n## A place\n");
  write(scratch / "picture.png", "");
  const fs::path page = scratch / "docs/page.md";
  const auto wrong = [&](const std::string& text) {
    write(page, text);
    return wrong_links(page).size();
  };
  const std::string sound =
      "# Here\n[a](there.md) [b](there.md#a-place) [c](#here) ![d](../picture.png) [e](..) "
      "[f](https://example.org/x#y)\n";
  CHECK(wrong(sound) == 0);
  for (const std::string broken :
       {"[a](their.md)", "[a](There.md)", "[b](there.md#a-plaice)", "[b](there.md#A-place)", "[c](#hear)",
        "![d](../pictures.png)", "[![d](picture.png)](there.md)", "[g](../picture.png#there)", "[h]()",
        "[i](https://example)", "[j](htp://example.org)"}) {
    INFO(broken);
    CHECK(wrong(sound + broken) == 1);
  }
}

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
