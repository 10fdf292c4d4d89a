#include "pushback/tools/classroom/mine/edits.h"

#include <sstream>
#include <stdexcept>

namespace pushback {

std::vector<EditedLoop> edited_loops(const std::string& edits, const std::string& loop) {
  std::vector<EditedLoop> loops;
  std::string out, in;
  const auto replace = [&] {
    if (out.empty()) return;
    std::string& text = loops.back().text;
    const std::size_t at = text.find(out);
    if (at == text.npos)
      throw std::runtime_error("'" + loops.back().name + "': the loop does not have these lines: " + out);
    text.replace(at, out.size(), in);
    out = in = "";
  };
  std::istringstream lines(edits);
  for (std::string line; std::getline(lines, line);) {
    const std::string rest = line.size() > 2 ? line.substr(2) : "";
    if (line.starts_with("== ")) {
      replace();
      loops.push_back({line.substr(3), "", loop});
    } else if (loops.empty()) {
      continue;
    } else if (line.starts_with("> ")) {
      std::string& hint = loops.back().hint;
      hint += (hint.empty() ? "" : " ") + rest;
    } else if (line.starts_with("- ")) {
      if (!in.empty()) replace();
      out += rest + "\n";
    } else if (line.starts_with("+")) {
      in += rest + "\n";
    }
  }
  replace();
  return loops;
}

}  // namespace pushback
