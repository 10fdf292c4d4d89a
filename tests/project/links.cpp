/// Every link on every page leads somewhere.
#include "tests/project/links.h"

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
