#include "pushback/tools/classroom/kit.h"

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/process.h"

namespace pushback {

namespace fs = std::filesystem;

std::vector<std::string> Kit::words_of(const std::string& file) const {
  std::vector<std::string> words = lines_of(read_text_file(folder / file));
  constexpr std::string_view mark = "@PREFIX@";  // replaced at run time, because the installed folder may be moved
  for (std::string& word : words)
    if (const std::size_t at = word.find(mark); at != std::string::npos) word.replace(at, mark.size(), prefix.string());
  return words;
}

const Kit& kit() {
  static const Kit found = [] {
    const fs::path prefix = fs::canonical("/proc/self/exe").parent_path().parent_path();
    const fs::path installed = prefix / "share/pushback/exercise";
    if (!fs::exists(installed)) return Kit{KIT_FOLDER, HEADERS_FOLDER, SOURCE_FOLDER, {}};
    return Kit{installed, prefix / "include", prefix / "include/pushback", prefix};
  }();
  return found;
}

}  // namespace pushback
