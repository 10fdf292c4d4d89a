#include "pushback/tools/classroom/mine/drawing.h"

#include <fmt/format.h>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/process.h"
#include "pushback/tools/classroom/attempt.h"
#include "pushback/tools/classroom/kit.h"
#include "pushback/tools/classroom/mine/chapters.h"

namespace pushback {

namespace fs = std::filesystem;

namespace {

using Command = std::vector<std::string>;

/// What an experiment loads: common/experiment/loaded_solver.h.
constexpr const char* as_library = R"(
namespace mine {}
using namespace mine;
extern "C" pushback::StepSolver* make_solver(const pushback::StepSolver* like) {
  return like ? new MySolver(static_cast<const MySolver&>(*like)) : new MySolver;
}
)";

std::string last_line(const std::string& text) {
  const std::vector<std::string> lines = lines_of(text);
  return lines.empty() ? "it said nothing" : lines.back();
}

}  // namespace

std::string draw_mine(int chapter, const std::string& text, const fs::path& folder, const fs::path& to, bool film) {
  const std::string name = folder_of(chapter);
  const fs::path program = fs::canonical("/proc/self/exe").parent_path() / name;
  if (!fs::exists(program)) return fmt::format("the program that draws it is not built: {}", program.string());
  const ScratchFolder scratch;
  const fs::path source = scratch.path / "solver.cpp", object = scratch.path / "solver.o",
                 library = scratch.path / "solver.so";
  write_text_file(source, text + as_library);
  Command compile = kit().words_of("compile.txt");
  const Command link{compile[0], "-shared", "-o", library, object};
  const Command more{"-w", "-I" + folder.string(), "-include", kit().folder / "headers.h", "-c", source, "-o", object};
  compile.insert(compile.end(), more.begin(), more.end());
  for (const Command& command : {compile, link}) {
    const Ended ended = run_program(command, 120);
    if (ended.status != 0) return "it does not compile as a library: " + last_line(ended.err);
  }
  // Of a picture that one waits for: what is worked out beside the scenes has no variant of the reader's, and soft shadows
  // need more passes than the eye needs to compare.
  Command draw{program, "--mine", library, "--out", scratch.path, "--no-study", "--passes", "4"};
  if (film) draw.push_back("--film");
  const Ended ended = run_program(draw, 600);
  if (ended.status != 0) return fmt::format("{} came to no end with your solver: {}", name, last_line(ended.err));
  fs::remove_all(to);
  fs::copy(scratch.path / name, to, fs::copy_options::recursive);
  return "";
}

}  // namespace pushback
