#include "pushback/tools/measure/hard_cases/table.h"

#include <unistd.h>

#include <algorithm>
#include <thread>

#include "pushback/common/basics/files.h"
#include "pushback/common/experiment/kept_picture.h"
#include "pushback/tools/measure/results/chosen.h"

namespace pushback {

namespace fs = std::filesystem;

namespace {

struct Options {
  std::vector<std::string> names, stages;
  std::string out = "renders";
  int jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  int starts = many_starts;
  bool no_images = false, list = false, redraw = false, renew = false;
};

/// Marks, and the last stage's worst number.
void print_row(const Table& table, std::size_t row) {
  std::string marks;
  for (std::size_t column = 0; column < table.stages.size(); ++column)
    marks += table.passed(row, column) ? "✓" : table.at(row, column).possible() ? "✗" : "—";
  const std::size_t last = table.stages.size() - 1;
  const auto rescued = table.chapters > 0 ? rescuer(table, row) : std::nullopt;
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

/// Of solvers of one's own, beside the others; false where one came to no end somewhere.
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

/// Leaves out stages whose program is not built. Throws InvalidInput if they were asked for by name, or if none is left.
void leave_out_missing(std::vector<Stage>& columns, bool by_name) {
  std::string missing;
  std::erase_if(columns, [&](const Stage& stage) {
    if (stage.apart.empty() || fs::exists(stage.apart.front())) return false;
    missing = fmt::format("'{}' needs {}, which is not built: its engine is missing", stage.name, stage.apart.front());
    if (by_name) throw InvalidInput(missing);
    fmt::print("left out: {}\n", missing);
    return true;
  });
  if (columns.empty()) throw InvalidInput(missing);
}

class TableRun {
 public:
  TableRun(const Options& options, TableKind kind)
      : options_(options), kind_(std::move(kind)), home_(fs::path(options.out) / kind_.folder) {}

  /// False if a stage that was entered came to no end somewhere.
  bool operator()() {
    if (options_.redraw) return show(read(home_), home_);
    std::vector<HardCase> cases = chosen("case", hard_cases(), options_.names);
    for (HardCase& c : cases) c.starts = std::min(c.starts, options_.starts);
    std::vector<Stage> columns = chosen("stage", kind_.stages, options_.stages);
    const bool whole = kind_.whole && cases.size() == hard_cases().size() && columns.size() == kind_.stages.size() &&
                       options_.starts == many_starts;
    columns.insert(columns.end(), kind_.further.begin(), kind_.further.end());
    if (options_.list) return list(cases, columns);
    const fs::path folder = whole || options_.renew ? home_ : home_ / "part";
    leave_out_missing(columns, !options_.stages.empty());
    std::optional<Table> before;
    if (options_.renew) before = read(home_);
    make_writable_folder(folder);
    const bool all_numbers = !whole && (kind_.further.empty() || cases.size() <= 3);
    Table table = played(std::move(cases), std::move(columns), all_numbers);
    if (before) table = renewed(table, *before);
    write_text_file(folder / (kind_.file + ".csv"), table_csv(table));
    write_text_file(folder / kind_.times, times_csv(table));
    show(table, folder);
    return kind_.further.empty() || sum_up(table);
  }

 private:
  /// All cases under the stages that either table has: what `now` has, and else what `before` has.
  Table renewed(const Table& now, const Table& before) const {
    std::vector<Stage> stages = kind_.stages;
    std::vector<std::string> names = names_of(now.stages);
    for (const Stage& stage : before.stages) names.push_back(stage.name);
    std::erase_if(stages, [&](const Stage& one) { return std::ranges::find(names, one.name) == names.end(); });
    return assembled(hard_cases(), std::move(stages), {&now, &before});
  }

  Table read(const fs::path& folder) const {
    return read_table_csv(read_text_file(folder / (kind_.file + ".csv")), kind_.stages);
  }

  /// Writes what is made of the table.
  bool show(const Table& table, const fs::path& folder) const {
    const Table shown = kind_.shown(table);
    const bool pictured = !options_.no_images && !kind_.picture.empty();
    const fs::path page = folder / (kind_.file + ".md"), picture = folder / (kind_.picture + ".png");
    write_text_file(page, kind_.page(shown, folder));
    if (pictured) keep_picture(picture, draw_overview(shown));
    fmt::print("\n{}\n", (pictured ? picture : page).string());
    return true;
  }

  static bool list(const std::vector<HardCase>& cases, const std::vector<Stage>& columns) {
    for (const HardCase& c : cases) fmt::print("{:<24}{}: {}\n", c.name, c.title, c.stresses);
    fmt::print("\n");
    for (const Stage& stage : columns) fmt::print("{:<24}{}\n", stage.name, stage.what);
    return true;
  }

  Table played(std::vector<HardCase> cases, std::vector<Stage> columns, bool all_numbers) const {
    std::size_t printed = 0;
    const bool terminal = isatty(fileno(stdout)) == 1;
    const auto progress = [&](const Table& so_far, std::size_t rows, std::size_t done) {
      if (terminal) fmt::print("\r\033[K");
      for (; printed < rows; ++printed) {
        print_row(so_far, printed);
        if (all_numbers) print_numbers(so_far, printed);
      }
      if (terminal && done < so_far.outcomes.size()) fmt::print("{} of {}", done, so_far.outcomes.size());
      std::fflush(stdout);
    };
    return play(std::move(cases), std::move(columns), options_.jobs, progress, kind_.giving_up);
  }

  const Options& options_;
  TableKind kind_;
  fs::path home_;
};

}  // namespace

int table_program(int argc, const char* const* argv, CommandLine& line, const std::function<TableKind()>& kind_of) {
  Options options;
  double patience = 0;
  line.option("NAME", options.names, "Only these cases, by their names or a part of them");
  line.option("--stages", options.stages, "Only these columns, by their names or a part of them, separated by commas")
      .split_at_commas();
  line.option("--out", options.out,
              "The folder in which the folder of the table is made; a part of the table goes to its subfolder part")
      .shows_default();
  line.option("--jobs", options.jobs, "Number of threads; the results do not depend on it")
      .between(1, 256)
      .shows_default();
  line.option("--starts", options.starts,
              "Largest number of starts of the cases at a knife's edge; fewer than 30 make only a part of the table")
      .between(1, many_starts)
      .shows_default();
  const auto at_most =
      line.option("--at-most", patience, "Time after which a case that is played in its own process is given up, s")
          .between(0.1, 36000.0);
  line.flag("--renew", options.renew,
            "Play only the named pairs, and keep all others as they are in the whole table's CSV file");
  line.flag("--no-images", options.no_images, "Draw no picture");
  line.flag("--redraw", options.redraw,
            "Play nothing, and make the page and the picture from the whole table's CSV file");
  line.flag("--list", options.list, "List the cases and the columns, and do nothing");
  bool ended = true;
  const int status = line.run(argc, argv, [&] {
    TableKind kind = kind_of();
    if (at_most.given()) {
      require_between("--at-most", static_cast<Real>(patience), Real(0.1), 36000);  // the range lets nan pass
      kind.giving_up.seconds = patience;
    }
    if (options.renew && !kind.whole) throw InvalidInput("--renew is for columns of the whole table");
    ended = TableRun(options, std::move(kind))();
  });
  return status == 0 && !ended ? 1 : status;
}

}  // namespace pushback
