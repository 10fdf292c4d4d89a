/// ./course hard-cases: every case under every stage, as files and as a picture; or these again from table.csv.
#include <unistd.h>

#include <algorithm>
#include <thread>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/shard.h"
#include "pushback/common/experiment/kept_picture.h"
#include "pushback/common/experiment/program.h"
#include "pushback/tools/measure/hard_cases/apart.h"
#include "pushback/tools/measure/hard_cases/table.h"
#include "pushback/tools/measure/hard_cases/table_picture.h"
#include "pushback/tools/measure/results/chosen.h"
#include "pushback/tools/measure/results/origin.h"

using namespace pushback;

namespace {

/// Marks, and the last stage's worst number.
void print_row(const Table& table, std::size_t row) {
  std::string marks;
  for (std::size_t column = 0; column < table.stages.size(); ++column) marks += table.passed(row, column) ? "✓" : "✗";
  const std::size_t last = table.stages.size() - 1;
  const auto rescued = rescuer(table, row);
  fmt::print("{:<24}{}  {}: {}, {:.3f} ms a step{}\n", table.cases[row].name, marks, table.stages[last].name,
             worst_number(table, row, last), table.at(row, last).ms_per_step,
             rescued ? fmt::format("; rescued by {}", table.stages[*rescued].name) : "");
}
/// Every number of every stage that has been played.
void print_numbers(const Table& table, std::size_t row) {
  for (std::size_t column = 0; column < table.stages.size(); ++column) {
    if (!table.played(row, column)) continue;
    const Outcome& outcome = table.at(row, column);
    fmt::print("  {} {:<28}", table.passed(row, column) ? "✓" : "✗", table.stages[column].name);
    for (std::size_t i = 0; i < outcome.numbers.size(); ++i) {
      const Criterion& c = table.cases[row].criteria[i];
      fmt::print("{} {} (≤ {}); ", c.what, in_short(outcome.largest[i], c.limit, c.unit), c.limit_with_unit());
    }
    const std::string starts = passed_of_starts(outcome);
    fmt::print("{}{}{:.3f} ms{}{}\n", starts, starts.empty() ? "" : "; ", outcome.ms_per_step,
               outcome.broken.empty() ? "" : "; ", outcome.broken);
  }
}

/// What is made of table.csv.
void show(const Table& table, const std::filesystem::path& folder, bool images) {
  write_text_file(folder / "table.md", table_md(table, folder));
  if (images) keep_picture(folder / "overview.png", draw_overview(table));
  fmt::print("\n{}\n", (folder / (images ? "overview.png" : "table.md")).string());
}

/// The parts, put together: the same files as if all had been played here.
void join(std::size_t parts, const std::filesystem::path& folder, bool images) {
  const auto folders = folders_of_parts(folder, parts, "origin.txt", Holds::numbers);
  constexpr int fields = 2;  // a thing is a pair of case and stage
  const Table table = read_table_csv(joined(texts_of_parts(folders, "table.csv"), fields));
  write_text_file(folder / "table.csv", table_csv(table));
  write_text_file(folder / "times.csv", joined(texts_of_parts(folders, "times.csv"), fields));
  show(table, folder, images);
}

/// Of a solver of one's own, beside the others; false where it came to no end somewhere.
bool sum_up(const Table& table) {
  for (std::size_t column = 0; column < table.stages.size(); ++column) {
    fmt::print("{}{} {}", column == 0 ? "pass, of " + std::to_string(table.cases.size()) + ": " : ", ",
               table.stages[column].name, table.passes(column));
  }
  fmt::print("\n");
  std::fflush(stdout);
  bool ended = true;
  for (std::size_t pair = 0; pair < table.outcomes.size(); ++pair) {
    const Outcome& outcome = table.outcomes[pair];
    if (outcome.ended) continue;
    ended = false;
    fmt::print(stderr, "{}: {}: {}\n", table.stages[pair % table.stages.size()].name,
               table.cases[pair / table.stages.size()].name, outcome.broken);
  }
  return ended;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> names, stage_names;
  std::string out = "renders", shard_text = "1/1", mine;
  GivingUp giving_up;
  std::size_t parts = 0;
  int jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  int starts = many_starts;
  bool quick = false, no_images = false, list = false, redraw = false;
  bool alone = false, ended = true;
  CommandLine line("Every hard case under every stage of the solver: which feature keeps which case stable?",
                   "hard_cases_table");
  line.option("NAME", names, "Only these cases, by their names or a part of them");
  line.option("--stages", stage_names, "Only these stages, by their names or a part of them, separated by commas")
      .split_at_commas();
  line.flag("--quick", quick, "Only the chapters' stages, without the stages that came after");
  line.option("--out", out,
              "Folder in which the folder hard_cases is made; what is not the whole table goes to hard_cases/part")
      .shows_default();
  line.option("--jobs", jobs, "So many threads; the results do not depend on it").between(1, 256).shows_default();
  line.option("--starts", starts,
              "At most so many starts of the cases at a knife's edge; with fewer than 30 not the whole table")
      .between(1, many_starts)
      .shows_default();
  line.option("--shard", shard_text, "2/5: the second of five parts, for a machine of its own, into shard_2_of_5");
  line.option("--join", parts,
              "5: nothing is played; the whole of the five parts that were played with the same options")
      .between(2, 1000);
  line.flag("--no-images", no_images, "Only table.csv, table.md and times.csv");
  line.flag("--redraw", redraw, "Nothing is played: table.md and overview.png of what is in hard_cases/table.csv");
  line.option(
      "--mine", mine,
      "A solver as a shared object, as one more column 'mine'; each of its cases is played by a process of its own");
  line.option("--at-most", giving_up.seconds,
              "Each of those is given up after so long, s; after three, no other is begun")
      .between(0.1, 3600.0)
      .shows_default();
  line.flag("--alone", alone, "The column 'mine' and no other, in this process, and no table.md");
  line.flag("--list", list, "List the cases and the stages, and do nothing");
  const int status = line.run(argc, argv, [&] {
    require_between("--at-most", static_cast<Real>(giving_up.seconds), Real(0.1), 3600);  // the range lets nan pass
    if (alone && mine.empty()) throw InvalidInput("--alone is of --mine LIBRARY, which is missing");
    if (redraw) {
      const std::filesystem::path folder = std::filesystem::path(out) / "hard_cases";
      show(read_table_csv(read_text_file(folder / "table.csv")), folder, !no_images);
      return;
    }
    std::vector<HardCase> cases = chosen("case", hard_cases(), names);
    for (HardCase& c : cases) c.starts = std::min(c.starts, starts);
    std::vector<Stage> all = table_stages();
    if (quick) all.erase(all.begin() + chapter_stages, all.end());
    std::vector<Stage> columns = chosen("stage", all, stage_names);
    if (!mine.empty()) {
      if (alone) columns.clear();
      columns.push_back(stage_of_library(mine));
      if (alone) columns.back().apart.clear();
    }
    if (list) {
      for (const HardCase& c : cases) fmt::print("{:<24}{}: {}\n", c.name, c.title, c.stresses);
      fmt::print("\n");
      for (const Stage& stage : columns) fmt::print("{:<24}{}\n", stage.name, stage.what);
      return;
    }
    const bool whole = cases.size() == hard_cases().size() && columns.size() == table_stages().size() &&
                       starts == many_starts && mine.empty();
    std::filesystem::path folder = std::filesystem::path(out) / "hard_cases" / (whole ? "" : "part");
    if (parts > 0) return join(parts, folder, !no_images);
    const Shard shard = shard_of(shard_text);
    if (shard.of > cases.size() * columns.size())
      throw InvalidInput(
          fmt::format("--shard is '{}': there are {} cases under {} stages, and each part needs one pair", shard_text,
                      cases.size(), columns.size()));
    if (!shard.whole()) folder /= shard.folder();
    make_writable_folder(folder);
    const bool all_numbers = !whole && (mine.empty() || cases.size() <= 3);
    std::size_t printed = 0;
    const bool terminal = isatty(fileno(stdout)) == 1;
    const auto progress = [&](const Table& so_far, std::size_t rows, std::size_t done) {
      if (terminal) fmt::print("\r\033[K");
      for (; printed < rows; ++printed) {
        if (shard.whole()) print_row(so_far, printed);
        else fmt::print("{}\n", so_far.cases[printed].name);
        if (all_numbers || !shard.whole()) print_numbers(so_far, printed);
      }
      if (terminal && done < so_far.outcomes.size()) fmt::print("{} of {}", done, so_far.outcomes.size());
      std::fflush(stdout);
    };
    const Table table = play(std::move(cases), std::move(columns), jobs, progress, giving_up, shard);
    write_text_file(folder / "table.csv", table_csv(table));
    write_text_file(folder / "times.csv", times_csv(table));
    if (!shard.whole()) write_text_file(folder / "origin.txt", origin_text(origin_here()));
    if (shard.whole() && !alone) show(table, folder, !no_images);
    if (!mine.empty() && !alone) ended = sum_up(table);
  });
  return status == 0 && !ended ? 1 : status;
}
