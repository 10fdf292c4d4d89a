#include "pushback/tools/classroom/mine/library.h"

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/process.h"
#include "pushback/tools/classroom/attempt.h"
#include "pushback/tools/classroom/kit.h"

namespace pushback {

namespace fs = std::filesystem;

namespace {

using Command = std::vector<std::string>;

constexpr const char* as_library = R"(
namespace mine {}
using namespace mine;
extern "C" pushback::StepSolver* make_solver(const pushback::StepSolver* like) {
  return like ? new MySolver(static_cast<const MySolver&>(*like)) : new MySolver;
}
)";

/// The first error; what is below it often follows from it.
std::string first_error(const std::string& text) {
  for (const std::string& line : lines_of(text))
    if (const std::size_t at = line.find("error: "); at != line.npos) return line.substr(at);
  return last_line(text);
}

}  // namespace

std::string make_library(const std::string& text, const fs::path& folder, const fs::path& library, CompiledAs as,
                         const Sandbox* sandbox) {
  const ScratchFolder scratch;
  const fs::path source = scratch.path / "solver.cpp", object = scratch.path / "solver.o",
                 made = scratch.path / "made.so", headers = kit().folder / "headers.h";
  write_text_file(source, text + as_library);
  for (const auto& entry : fs::directory_iterator(folder))  // into what the sandbox can read
    if (entry.path().extension() == ".h") fs::copy_file(entry.path(), scratch.path / entry.path().filename());
  Command compile = kit().words_of("compile.txt");
  const Command link{compile[0], "-shared", "-o", made, object};
  if (as == CompiledAs::chapter) {  // the headers are parsed anew then
    std::istringstream flags(CHAPTER_FLAGS);
    for (std::string flag; flags >> flag;) compile.push_back(flag);
  }
  const Command more{"-w", "-I" + scratch.path.string(), "-include", headers, "-c", source, "-o", object};
  compile.insert(compile.end(), more.begin(), more.end());
  std::vector<fs::path> readable{headers};
  for (const char* parsed : {"headers.h.gch", "headers.h.pch"})
    if (fs::exists(kit().folder / parsed)) readable.push_back(kit().folder / parsed);
  for (const Command& command : {compile, link}) {
    const Ended ended = run_program(sandbox ? sandbox->around(command, scratch.path, readable) : command, 120);
    if (ended.status != 0) return "it does not compile as a library: " + first_error(ended.err);
  }
  if (!fs::is_regular_file(fs::symlink_status(made))) return "it does not compile as a library: there is none";
  fs::copy_file(made, library, fs::copy_options::overwrite_existing);
  return "";
}

std::string last_line(const std::string& text) {
  std::string last = "it said nothing";
  for (const std::string& line : lines_of(text))
    if (!line.empty()) last = line;
  return last;
}

fs::path program_beside(const std::string& name) {
  return fs::canonical("/proc/self/exe").parent_path() / name;
}

}  // namespace pushback
