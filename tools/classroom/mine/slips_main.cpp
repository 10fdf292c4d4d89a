/// Generates code of a chapter's known mistakes, which is its plain loop once for each of them, in a separate namespace.
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

void make(const std::string& number, const std::string& edits, const std::string& loop, std::ostream& made) {
  made << "#include \"pushback/tools/classroom/mine/slips.h\"\n\n";
  std::string listed;
  int count = 0;
  for (const auto& [name, hint, text] : pushback::edited_loops(edits, loop)) {
    const std::string its = "slip_" + std::to_string(count++) + "_of_" + number;
    made << pushback::renamed(text, "namespace pushback::" + its + " {", "}", "FlatSolver") << "\n";
    listed += "    {" + std::to_string(std::stoi(number)) + ", R\"(" + name + ")\", R\"(" + hint +
              ")\", whole_solver<" + its + "::FlatSolver>()},\n";
  }
  made << "namespace pushback {\n\nstd::vector<Slip> slips_of_" << number << "() {\n  return {\n"
       << listed << "  };\n}\n\n}  // namespace pushback\n";
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc < 5) throw std::runtime_error("make_slips NN edits.txt made.cpp flat.h flat.cpp");
    std::string loop;
    for (int file = 4; file < argc; ++file) loop += text_of(argv[file]);
    std::ofstream made(argv[3]);
    make(argv[1], text_of(argv[2]), loop, made);
    return made.flush() ? 0 : 1;
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "%s\n", problem.what());
    return 1;
  }
}
