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

std::string renamed(const std::string& loop, const std::string& space_begins, const std::string& space_ends,
                    const std::string& solver) {
  std::string text;
  std::istringstream lines(loop);
  for (std::string line; std::getline(lines, line);) {
    if (line.ends_with("/flat.h\"")) continue;  // of which the text is here
    if (line.starts_with("namespace pushback")) line = space_begins;
    if (line.starts_with("}  // namespace pushback")) line = space_ends;
    for (const std::string name : {"FlatSolver", "NaiveOnce"})
      for (std::size_t at = 0; (at = line.find(name, at)) != line.npos; at += solver.size())
        line.replace(at, name.size(), solver);
    text += line + "\n";
  }
  return text;
}

}  // namespace pushback
