#include "pushback/tools/classroom/mine/played.h"

#include <fmt/format.h>

#include <cstring>
#include <sstream>

#include "pushback/chapters/19_accuracy_and_time/motion.h"
#include "pushback/common/basics/files.h"
#include "pushback/common/basics/input.h"
#include "pushback/common/basics/process.h"
#include "pushback/tools/classroom/kit.h"
#include "pushback/tools/classroom/mine/chapters.h"
#include "pushback/tools/classroom/sandbox.h"

namespace pushback {

namespace fs = std::filesystem;

namespace {

/// Behind the reader's text.
constexpr const char* as_library = R"(
namespace mine {}
using namespace mine;
extern "C" pushback::StepSolver* make_solver(const pushback::StepSolver* like) {
  return like ? new MySolver(static_cast<const MySolver&>(*like)) : new MySolver;
}
)";

std::string last_line(const std::string& text) {
  std::string last = "it printed no reason";
  for (const std::string& line : lines_of(text))
    if (!line.empty()) last = line;
  return last;
}

/// The first error, because later ones often follow from it.
std::string first_error(const std::string& text) {
  for (const std::string& line : lines_of(text))
    if (const std::size_t at = line.find("error: "); at != line.npos) return line.substr(at);
  return last_line(text);
}

/// The program of this name, in the folder of this one.
std::string built_program(const std::string& name) {
  const fs::path program = fs::canonical("/proc/self/exe").parent_path() / name;
  if (!fs::exists(program)) throw std::runtime_error("a program is needed that is not built: " + program.string());
  return program;
}

fs::path made_library(const MyFolder& mine, const ScratchFolder& scratch, CompiledAs as) {
  const fs::path library = scratch.path / "solver.so";
  const std::string wrong = make_library(mine.text(), fs::absolute(mine.path()), library, as);
  if (!wrong.empty()) throw std::runtime_error(wrong + ". ./course mine 00 shows the compiler's full message");
  return library;
}

/// A program that refuses what it is asked says so in its own words.
void refuse(const Ended& ended) {
  if (ended.status != 2) return;
  std::string words = ended.err;
  while (words.ends_with('\n')) words.pop_back();
  throw InvalidInput(words);
}

}  // namespace

std::string make_library(const std::string& text, const fs::path& folder, const fs::path& library, CompiledAs as) {
  const ScratchFolder scratch;
  const fs::path source = scratch.path / "solver.cpp", headers = kit().folder / "headers.h";
  write_text_file(source, text + as_library);
  Command compile = kit().words_of("compile.txt");
  if (as == CompiledAs::chapter) {  // the headers are parsed again then
    std::istringstream flags(CHAPTER_FLAGS);
    for (std::string flag; flags >> flag;) compile.push_back(flag);
  }
  const Ended ended = run_program(
      compile + Command{"-w", "-I" + folder.string(), "-include", headers, "-shared", source, "-o", library}, 120);
  return ended.status == 0 ? "" : "it does not compile as a library: " + first_error(ended.err);
}

std::string draw_mine(int chapter, const fs::path& library, const fs::path& to, bool all_scenes) {
  const std::string name = folder_of(chapter);
  const ScratchFolder scratch;
  // Results computed apart from the scenes have no variant of the reader's. Soft shadows need more passes than a comparison by
  // eye does.
  Command draw{built_program(name), "--mine", library, "--out", scratch.path, "--no-study", "--passes", "4"};
  if (!all_scenes) draw.emplace_back("--first-scene");
  const Ended ended = run_program(draw, 600);
  if (ended.status != 0) return fmt::format("{} did not finish with your solver: {}", name, last_line(ended.err));
  fs::remove_all(to);
  fs::copy(scratch.path / name, to, fs::copy_options::recursive);
  return "";
}

bool play_hard_cases(const MyFolder& mine, const std::vector<std::string>& names) {
  const fs::path to = fs::absolute(mine.path()) / "hard_cases";
  const ScratchFolder scratch;
  const Command play =
      Command{built_program("hard_cases_table"), "--stages", "00,01,02,03,04,05,06,07,08", "--out", scratch.path} +
      names;
  refuse(run_program(play + Command{"--list"}, 60));
  const Command with_mine{"--mine", made_library(mine, scratch, CompiledAs::exercise)};
  if (names.empty()) fmt::print("All cases are played. This takes about a minute.\n");
  std::fflush(stdout);
  // The table has links to the chapters' pages.
  const Ended ended = run_program(Command{"env", "-C", kit().sources} + play + with_mine, 3600);
  const fs::path made = scratch.path / "hard_cases" / "part";
  if (!fs::exists(made / "overview.png"))
    throw std::runtime_error("no table was made: " +
                             (ended.signal != 0 ? strsignal(ended.signal) : last_line(ended.err)));
  // The table's last line names a file that is moved now.
  for (const std::string& line : lines_of(ended.out))
    if (line.find(scratch.path.string()) == line.npos) fmt::print("{}\n", line);
  std::fflush(stdout);
  fmt::print(stderr, "{}", ended.err);
  if (ended.err.find("no end within") != ended.err.npos)
    fmt::print(
        stderr,
        "A case is given up after 30 s of wall-clock time. If the machine was busy, run this case again on its own.\n");
  fs::remove_all(to);
  fs::copy(made, to, fs::copy_options::recursive);
  return ended.status == 0;
}

void study_with_mine(const MyFolder& mine, const std::vector<std::string>& asked) {
  const fs::path to = fs::absolute(mine.path()) / "study";
  const ScratchFolder scratch;
  std::vector<std::string> motions;
  for (const std::string& name : asked) motions.push_back(motion_named(name).name);
  for (const Motion& motion : all_motions())
    if (asked.empty() && motion.pins.empty()) motions.push_back(motion.name);
  built_program("motion_mine");
  const Command study{
      built_program("study"), "--quick", "--mine", made_library(mine, scratch, CompiledAs::chapter), "--out",
      scratch.path,           "--only"};
  fmt::print("Every solver plays {} motions of the study, in all quick settings.\n", motions.size());
  std::fflush(stdout);
  const Ended ended = run_program(study + motions, 1800);
  const fs::path made = scratch.path / "19_accuracy_and_time";
  if (ended.status != 0 || !fs::exists(made / "work_precision.png")) {
    const std::string said = last_line(ended.err), before = "failed: ";  // the call of a motion, with all settings
    const std::size_t at = said.rfind(before);
    throw std::runtime_error("no diagrams were made: " + (at == said.npos ? said : said.substr(at + before.size())));
  }
  fs::remove_all(to);
  fs::create_directories(to);
  for (const char* file : {"work_precision.png", "others.md", "study.csv", "machine.md"})
    fs::copy(made / file, to / file);
}

}  // namespace pushback
