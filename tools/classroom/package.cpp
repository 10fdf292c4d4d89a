#include "pushback/tools/classroom/package.h"

#include <fmt/format.h>

#include <regex>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/input.h"
#include "pushback/tools/classroom/kit.h"
#include "pushback/tools/classroom/student_files.h"

namespace pushback {

namespace fs = std::filesystem;

namespace {

/// Links lead out of the folder: their words stay.
std::string without_links(const std::string& text) {
  static const std::regex link("\\[([^\\]]*)\\]\\([^)]*\\)");
  return std::regex_replace(text, link, "$1");
}

std::string called(const std::string& text, const std::string& call) {
  static const std::regex here("\\./course exercise");
  return std::regex_replace(text, here, call);
}

}  // namespace

void write_tasks(const fs::path& folder, const std::vector<const Exercise*>& exercises, const std::string& call) {
  if (fs::exists(folder) && !(fs::is_directory(folder) && fs::is_empty(folder)))
    throw InvalidInput(fmt::format("'{}' is not empty: a new folder is needed", folder.string()));
  make_writable_folder(folder);
  for (const Exercise* exercise : exercises) {
    write_text_file(folder / (exercise->name + ".h"), read_text_file(stub_of(*exercise)));
    write_text_file(folder / (exercise->name + ".md"), called(without_links(read_text_file(task_of(*exercise))), call));
  }
}

void write_own_folder(const fs::path& folder, const std::vector<const Exercise*>& exercises) {
  write_tasks(folder, exercises, "pushback-exercise");
  const std::string hint = kit().prefix.empty() ? "" : fmt::format(" HINTS {}", quoted(kit().prefix / "bin"));
  write_text_file(folder / "CMakeLists.txt", fmt::format(R"(cmake_minimum_required(VERSION 3.25)
project(exercises LANGUAGES NONE)
# It comes with Pushback: cmake --install. Where it is not found, say where that is: cmake -B build -DCMAKE_PREFIX_PATH=...
find_program(PUSHBACK_EXERCISE pushback-exercise{} REQUIRED)
add_custom_target(verdicts ALL COMMAND ${{PUSHBACK_EXERCISE}} --all --in ${{CMAKE_SOURCE_DIR}} USES_TERMINAL VERBATIM)
)",
                                                         hint));
  write_text_file(folder / "README.md", R"(# Exercises

For each exercise there is a task (`.md`) and a file in which a few lines are left out (`.h`). Write these lines, then

    cmake -B build -G Ninja
    cmake --build build

compiles every file that you have written in, and says what is right and what is not. A single one, in this folder:

    pushback-exercise 03             compiled and checked
    pushback-exercise 03 --hint      one hint more each time
    pushback-exercise 03 --reset     the file as it was

This program is in the folder `bin` of where Pushback is installed.
)");
}

}  // namespace pushback
