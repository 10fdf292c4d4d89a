#include "pushback/tools/classroom/package.h"

#include <fmt/format.h>

#include <algorithm>
#include <regex>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/input.h"
#include "pushback/tools/classroom/kit.h"
#include "pushback/tools/classroom/student_files.h"

namespace pushback {

namespace fs = std::filesystem;

namespace {

/// The command that checks an exercise, before and after its name.
struct Call {
  std::string program, in;
  std::string of(const std::string& exercise) const { return fmt::format("{} {}{}", program, exercise, in); }
};

const Call installed{"pushback-exercise", ""};

/// A student may put `folder` anywhere, so only its name is known, not its path.
Call in_a_copy(const fs::path& folder) {
  const std::string path = fmt::format("PATH/TO/{}", fs::absolute(folder / "").parent_path().filename().string());
  return {"./course exercise", fmt::format(" --in {}", path.find(' ') == std::string::npos ? path : quoted(path))};
}

/// Links lead out of the folder: their words stay.
std::string without_links(const std::string& text) {
  static const std::regex link("\\[([^\\]]*)\\]\\([^)]*\\)");
  return std::regex_replace(text, link, "$1");
}

/// A task as a file next to the file with the gap.
std::string handed_out(const Exercise& exercise, const Call& call) {
  static const std::regex file("`exercises/");
  std::string text = std::regex_replace(without_links(read_text_file(task_of(exercise))), file, "`");
  const std::string typed = Call{"./course exercise", ""}.of(short_name(exercise)),
                    instead = call.of(short_name(exercise));
  for (std::size_t at = 0; (at = text.find(typed, at)) != std::string::npos; at += instead.size())
    text.replace(at, typed.size(), instead);
  if (exercise.own()) return text;
  return text + fmt::format(
                    "\nThe page of the chapter: `{0}` in a copy of Pushback, `share/pushback/pages/{0}` in the "
                    "folder that Pushback is\ninstalled in.\n",
                    page_of(exercise).string());
}

std::string how_to(const std::vector<const Exercise*>& exercises, const fs::path& folder) {
  std::string text =
      "# Exercises\n\nFor each exercise there is a task (`.md`) and a file with a gap (`.h`). Read the task, write the "
      "lines between\n`// TODO` and `// TODO ends`, save, and check the file. The page of the chapter explains the "
      "idea and its equation.\n\n| exercise | task | your file | page of the chapter |\n| --- | --- | --- | --- |\n";
  std::string first;
  for (const Exercise* exercise : exercises) {
    text += fmt::format("| {0} | [{1}.md]({1}.md) | [{1}.h]({1}.h) | {2} |\n", short_name(*exercise), exercise->name,
                        exercise->own() ? "none; your teacher has the checks" : page_of(*exercise).string());
    if (first.empty() && !exercise->own()) first = short_name(*exercise);
  }
  if (first.empty()) return text;
  return text +
         fmt::format(R"(
The pages are in a copy of Pushback, and in `share/pushback/pages` of the folder that Pushback is installed in.

If Pushback is installed, check an exercise in this folder by the command below{}:

    {}{}

`--hint` shows one more hint each time. `--watch` checks the file again at each save, until Ctrl-C. `--reset` restores the
original file and keeps yours next to it. `pushback-exercise` is in `bin` of the folder that Pushback is installed in. If the
shell does not find it, write this folder before it. A build checks every file that you have changed:

    cmake -B build -G Ninja
    cmake --build build

The verdict is at the end of the output. The build fails as long as an answer is wrong. If CMake does not find Pushback, tell it
once where it is installed: `cmake -B build -DCMAKE_PREFIX_PATH=FOLDER`. Hand in this folder under your own name and without
`build`.
)",
                     kit().prefix.empty()
                         ? ". In a copy of Pushback, use the second one, where PATH/TO is the path to this folder"
                         : "",
                     installed.of(first), kit().prefix.empty() ? "\n    " + in_a_copy(folder).of(first) : "");
}

std::string build_file() {
  const std::string hint = kit().prefix.empty() ? "" : fmt::format(" HINTS {}", quoted(kit().prefix / "bin"));
  return fmt::format(R"(cmake_minimum_required(VERSION 3.25)
project(exercises LANGUAGES NONE)
find_program(PUSHBACK_EXERCISE pushback-exercise{})
if(NOT PUSHBACK_EXERCISE)
  message(FATAL_ERROR "pushback-exercise was not found. It is part of an installed Pushback. Give its folder by cmake -B build -DCMAKE_PREFIX_PATH=FOLDER")
endif()
add_custom_target(verdicts ALL COMMAND ${{PUSHBACK_EXERCISE}} --all --in ${{CMAKE_SOURCE_DIR}}
  COMMENT "Compile and check your files" USES_TERMINAL VERBATIM)
)",
                     hint);
}

}  // namespace

std::vector<const Exercise*> chosen(const std::vector<Exercise>& all, const std::vector<std::string>& with,
                                    const std::vector<std::string>& without) {
  std::vector<const Exercise*> exercises;
  const auto is_in = [&](const Exercise& one) {
    return std::find(exercises.begin(), exercises.end(), &one) != exercises.end();
  };
  for (const std::string& word : with)
    if (const Exercise& one = exercise_named(all, word); !is_in(one)) exercises.push_back(&one);
  for (const Exercise& one : all)
    if (with.empty()) exercises.push_back(&one);
  for (const std::string& word : without) std::erase(exercises, &exercise_named(all, word));
  if (exercises.empty()) throw InvalidInput("--without removes all exercises: at least one is needed");
  return exercises;
}

void write_own_folder(const fs::path& folder, const std::vector<const Exercise*>& exercises) {
  if (fs::exists(folder) && !(fs::is_directory(folder) && fs::is_empty(folder)))
    throw InvalidInput(fmt::format("'{}' is not empty: a new folder is needed", folder.string()));
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure)
    throw InvalidInput(fmt::format("'{}' cannot be created: {}. A folder that can be written to is needed",
                                   folder.string(), failure.message()));
  const Call call = kit().prefix.empty() ? in_a_copy(folder) : installed;
  for (const Exercise* exercise : exercises) {
    write_text_file(folder / (exercise->name + ".md"), handed_out(*exercise, call));
    write_text_file(folder / (exercise->name + ".h"), gap_of(*exercise, exercise->name + ".md"));
  }
  write_text_file(folder / "CMakeLists.txt", build_file());
  write_text_file(folder / "README.md", how_to(exercises, folder));
}

}  // namespace pushback
