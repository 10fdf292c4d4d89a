/// Makes the known mistakes of a chapter as code: its plain loop once for each of them, in a namespace of its own.
#include <cstdio>
#include <exception>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "pushback/tools/classroom/mine/edits.h"

namespace {

std::string text_of(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(file + " cannot be read");
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
}

}  // namespace

/// slips NN edits.txt flat.h flat.cpp made.cpp
int main(int argc, char** argv) {
  try {
    if (argc != 6) throw std::runtime_error("slips NN edits.txt flat.h flat.cpp made.cpp");
    const std::string number = argv[1], loop = text_of(argv[3]) + text_of(argv[4]);
    std::ofstream made(argv[5]);
    made << "#include \"pushback/tools/classroom/mine/slips_of_loops.h\"\n\n";
    std::string listed;
    int count = 0;
    for (auto& [name, hint, text] : pushback::edited_loops(text_of(argv[2]), loop)) {
      const std::string its = "slip_" + std::to_string(count++) + "_of_" + number;
      replace_all(text, "#pragma once\n", "");
      const std::size_t own = text.find("/flat.h\"");
      const std::size_t begin = text.rfind('\n', own) + 1;
      text.erase(begin, text.find('\n', own) + 1 - begin);
      replace_all(text, "flat_" + number, its);
      made << text << "\n";
      listed += "    {R\"(" + name + ")\", R\"(" + hint + ")\", whole_solver<" + its + "::FlatSolver>()},\n";
    }
    made << "namespace pushback {\n\nstd::vector<SlipOfLoop> slips_of_loop_" << number << "() {\n  return {\n"
         << listed << "  };\n}\n\n}  // namespace pushback\n";
    return made.flush() ? 0 : 1;
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "%s\n", problem.what());
    return 1;
  }
}
