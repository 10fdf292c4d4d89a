#include "pushback/tools/classroom/student_files.h"

#include <fmt/ranges.h>

#include <regex>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/input.h"
#include "pushback/tools/classroom/kit.h"

namespace pushback {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view transfer = "_transfer";

/// Without comments, and without spaces.
std::string code_of(const std::string& text) {
  static const std::regex not_code("//[^\n]*|/\\*[^]*?\\*/|\\s+");
  return std::regex_replace(text, not_code, "");
}

}  // namespace

std::uint64_t hash_of(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return hash;
}

std::string short_name(const Exercise& exercise) {
  if (exercise.own()) return exercise.name;
  return exercise.name.substr(0, 2) + (exercise.transfer() ? "-transfer" : "");
}

const Exercise& exercise_named(const std::vector<Exercise>& all, std::string_view word) {
  std::string asked = fs::path(word).stem().string();
  for (char& c : asked)
    if (c == '-') c = '_';
  for (const Exercise& exercise : all)
    if (exercise.own() && asked == exercise.name) return exercise;
  const bool for_transfer = asked.ends_with(transfer);
  if (for_transfer) asked.resize(asked.size() - transfer.size());
  if (asked.size() == 1) asked = "0" + asked;
  for (const Exercise& exercise : all) {
    const std::string chapter =
        exercise.transfer() ? exercise.name.substr(0, exercise.name.size() - transfer.size()) : exercise.name;
    if (!exercise.own() && exercise.transfer() == for_transfer &&
        (asked == chapter || asked == chapter.substr(0, 2) || asked == chapter.substr(3)))
      return exercise;
  }
  std::vector<std::string> names;
  for (const Exercise& exercise : all) names.push_back(short_name(exercise));
  throw InvalidInput(fmt::format("unknown exercise '{}': one of these is needed: {}", word, fmt::join(names, ", ")));
}

fs::path task_of(const Exercise& exercise) {
  return fs::proximate(kit().sources / exercise.folder / "task.md");
}
fs::path stub_of(const Exercise& exercise) {
  return kit().sources / exercise.folder / "student.h";
}
fs::path page_of(const Exercise& exercise) {
  if (exercise.own()) return {};
  const fs::path chapter = fs::path(exercise.folder).lexically_relative("chapters");
  return fs::path("chapters") / *chapter.begin() / "README.md";
}

std::string gap_of(const Exercise& exercise, const std::string& task) {
  std::string text = read_text_file(stub_of(exercise));
  const std::string usual = exercise.folder + "/task.md";
  if (const std::size_t at = text.find(usual); at != std::string::npos) text.replace(at, usual.size(), task);
  return text;
}

std::size_t line_of_todo(const std::string& text) {
  return 1 +
         static_cast<std::size_t>(std::count(
             text.begin(), text.begin() + static_cast<std::ptrdiff_t>(std::min(text.find("TODO"), text.size())), '\n'));
}

bool untouched(const std::string& text, const std::string& stub) {
  return code_of(text) == code_of(stub);
}

StudentFiles::StudentFiles(const fs::path& folder)
    : WorkFolder(fs::proximate(!folder.empty()        ? folder
                               : kit().prefix.empty() ? kit().sources / "exercises"
                                                      : fs::current_path())) {
  if (fs::exists(path()) ? !fs::is_directory(path()) : !folder.empty())
    throw InvalidInput(fmt::format("{}'{}' {}: a folder that exists is needed. {} --new FOLDER makes one",
                                   folder.empty() ? "" : "--in: ", path().string(),
                                   fs::exists(path()) ? "is no folder" : "does not exist", kit().call()));
}

fs::path StudentFiles::task(const Exercise& exercise) const {
  const fs::path beside = path() / (exercise.name + ".md");
  return fs::exists(beside) ? beside : task_of(exercise);
}

bool StudentFiles::begun(const Exercise& exercise) const {
  return has(exercise) && !untouched(read_text_file(file(exercise)), read_text_file(stub_of(exercise)));
}

std::vector<const Exercise*> StudentFiles::listed(const std::vector<Exercise>& all) const {
  std::vector<const Exercise*> here, every;
  bool tasks = false;
  for (const Exercise& exercise : all) {
    const bool task_here = fs::exists(path() / (exercise.name + ".md"));
    tasks = tasks || task_here;
    every.push_back(&exercise);
    if (task_here || has(exercise)) here.push_back(&exercise);
  }
  return tasks ? here : every;
}

fs::path StudentFiles::reset(const Exercise& exercise) {
  const std::string beside = exercise.name + ".md";
  const std::string gap = fs::exists(path() / beside) ? gap_of(exercise, beside) : read_text_file(stub_of(exercise));
  const fs::path old = begin_anew(file(exercise), gap);
  forget(exercise.name);
  return old;
}

bool StudentFiles::solved(const Exercise& exercise) const {
  return has(exercise) && WorkFolder::solved(exercise.name) == hash_of(code_of(read_text_file(file(exercise))));
}
void StudentFiles::set_solved(const Exercise& exercise) {
  WorkFolder::set_solved(exercise.name, hash_of(code_of(read_text_file(file(exercise)))));
}

}  // namespace pushback
