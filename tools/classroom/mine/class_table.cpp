#include "pushback/tools/classroom/mine/class_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/input.h"
#include "pushback/common/basics/process.h"
#include "pushback/common/experiment/kept_picture.h"
#include "pushback/tools/classroom/budget.h"
#include "pushback/tools/classroom/handed_in.h"
#include "pushback/tools/classroom/kit.h"
#include "pushback/tools/classroom/mine/chapters.h"
#include "pushback/tools/classroom/mine/current_folder.h"
#include "pushback/tools/classroom/mine/library.h"
#include "pushback/tools/measure/hard_cases/table.h"
#include "pushback/tools/measure/hard_cases/table_picture.h"

namespace pushback {

namespace fs = std::filesystem;

namespace {

using Command = std::vector<std::string>;

constexpr const char* reference = "08 friction cone";  // a column that has to be there
constexpr int longest = 900;                           // s, of a student's cases together

struct Column {
  std::string student;
  std::string problem;  // why there is no table; empty: there is
  std::optional<Table> table;
};

/// The sandbox gives signals back as a shell does.
std::string end_of(const Ended& ended) {
  const int signal = ended.status > 128 ? ended.status - 128 : ended.signal;
  if (signal != 0) return fmt::format("the program was ended by the signal {}", signal);
  if (!ended.err.empty()) return last_line(ended.err);
  return fmt::format("the program ended by itself, with the status {}", ended.status);
}

/// Two columns, the reference and "mine".
Column column_of(const std::string& student, const fs::path& given, const Grading& grading, const Sandbox* sandbox) {
  Column made{student, {}, {}};
  const Exercise whole = exercise_of_chapter(0);
  const HandedIn handed_in(given, {&whole}, sandbox);
  const std::optional<fs::path> file = handed_in.file(whole);
  if (!handed_in.problem().empty() || !file) {
    made.problem = handed_in.problem().empty() ? "there is no solver.h" : handed_in.problem();
    return made;
  }
  const ScratchFolder out;
  const fs::path library = out.path / "solver.so";
  made.problem = make_library(read_text_file(*file), file->parent_path(), library, CompiledAs::exercise, sandbox);
  if (!made.problem.empty()) return made;
  const fs::path program = program_beside("hard_cases_table");
  if (!fs::exists(program)) throw InvalidInput("a program is needed that is not built: " + program.string());
  Command play{"prlimit", "--core=0", "--fsize=67108864", program};
  for (const std::string& word :
       {std::string("--stages"), std::string(reference), std::string("--mine"), library.string(),
        std::string("--no-images"), std::string("--jobs"), std::string("1"), std::string("--out"), out.path.string()})
    play.push_back(word);
  Watch watch({4 * grading.limits.megabytes, grading.limits.processes}, sandbox != nullptr);
  const Ended ended = run_program(sandbox ? sandbox->around(play, out.path, {program}) : play, longest, "",
                                  [&](int process) { return watch.look(process); });
  const fs::path csv = out.path / "hard_cases" / "part" / "table.csv";
  if (!fs::is_regular_file(fs::symlink_status(csv))) {
    made.problem = !watch.exceeded().empty() ? "it took " + watch.exceeded()
                   : ended.out_of_time       ? fmt::format("its cases were not done after {} s", longest)
                                             : "its cases were not played to their end: " + end_of(ended);
    return made;
  }
  std::vector<Stage> stages = table_stages();
  Stage mine = stages.front();  // of which only the name is looked at
  mine.name = "mine";
  stages.push_back(mine);
  try {
    made.table = read_table_csv(read_text_file(csv), stages);
    if (made.table->stages.size() != 2 || made.table->cases.size() != hard_cases().size())
      throw InvalidInput("other cases or columns");
    for (std::size_t i = 0; i < hard_cases().size(); ++i)
      if (made.table->cases[i].name != hard_cases()[i].name) throw InvalidInput("other cases");
  } catch (const InvalidInput&) {
    made.table.reset();
    made.problem = "what it left is no table of these cases";
  }
  return made;
}

/// The project's own columns of the chapters that are a plain loop, as its table has them, then each student's. Of what a
/// student has left only the outcomes are taken: neither limits nor the column beside.
Table joined(const std::vector<Column>& columns) {
  const Table ours = read_table_csv(read_text_file(kit().sources / "renders" / "hard_cases" / "table.csv"));
  std::vector<std::size_t> taken;
  for (std::size_t i = 0; i < ours.stages.size(); ++i)
    if (ours.stages[i].name < "09") taken.push_back(i);
  Table all;
  all.cases = ours.cases;
  for (const std::size_t i : taken) all.stages.push_back(ours.stages[i]);
  all.chapters = all.stages.size();
  all.asks = "Whose solver keeps which hard case stable?";
  all.others = "the class";
  for (const Column& column : columns) {
    if (!column.table) continue;
    all.stages.push_back(column.table->stages[1]);
    all.stages.back().name = column.student;
  }
  for (std::size_t row = 0; row < all.cases.size(); ++row) {
    for (const std::size_t i : taken) all.outcomes.push_back(ours.at(row, i));
    for (const Column& column : columns)
      if (column.table) all.outcomes.push_back(column.table->at(row, 1));
  }
  return all;
}

/// By their names.
std::map<std::string, fs::path> students(const std::vector<fs::path>& given) {
  std::map<std::string, fs::path> all;
  for (const fs::path& one : given) {
    try {
      all.emplace(students_name(one), one);
    } catch (const InvalidInput&) {
      continue;  // grade() has said so
    }
  }
  return all;
}

}  // namespace

void play_class(const Grading& grading) {
  std::optional<Sandbox> sandbox;
  if (grading.sandboxed) sandbox.emplace();
  const std::map<std::string, fs::path> by_name = students(grading.given);
  const std::vector<std::pair<std::string, fs::path>> all_students(by_name.begin(), by_name.end());
  std::vector<Column> columns(all_students.size());
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex failing;
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < columns.size(); i = next++)
        columns[i] = column_of(all_students[i].first, all_students[i].second, grading, sandbox ? &*sandbox : nullptr);
    } catch (...) {
      const std::lock_guard guard(failing);
      failure = std::current_exception();
    }
  };
  std::vector<std::thread> threads;
  for (int i = 0; i < grading.jobs; ++i) threads.emplace_back(work);
  for (std::thread& thread : threads) thread.join();
  if (failure) std::rethrow_exception(failure);

  const Table all = joined(columns);
  if (all.stages.size() > all.chapters) {
    const fs::path folder = fs::absolute(grading.out) / "hard_cases";
    make_writable_folder(folder);
    write_text_file(folder / "table.csv", table_csv(all));
    {
      const CurrentFolder root(kit().sources);  // the table has links to the chapters' pages
      write_text_file(folder / "table.md", table_md(all, folder));
    }
    keep_picture(folder / "overview.png", draw_overview(all));
  }
  fmt::print("hard cases passed, of {}:\n", all.cases.size());
  std::size_t wide = std::string(reference).size();
  for (const Column& column : columns) wide = std::max(wide, column.student.size());
  for (std::size_t column = 0; column < all.stages.size(); ++column) {
    int passed = 0;
    for (std::size_t row = 0; row < all.cases.size(); ++row) passed += all.passed(row, column);
    fmt::print("{:<{}}  {:>3}\n", all.stages[column].name, wide, passed);
  }
  for (const Column& column : columns)
    if (!column.table) fmt::print("{:<{}}    –  {}\n", column.student, wide, visible(column.problem));
}

}  // namespace pushback
