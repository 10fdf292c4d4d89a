/// ./course hard-cases --peers: the hard cases under other engines, as a file, a page and a picture.
#include <algorithm>
#include <filesystem>
#include <thread>

#include "pushback/common/basics/files.h"
#include "pushback/common/experiment/kept_picture.h"
#include "pushback/common/experiment/program.h"
#include "pushback/tools/measure/adapters/adapter.h"
#include "pushback/tools/measure/hard_cases/apart.h"
#include "pushback/tools/measure/hard_cases/peers.h"
#include "pushback/tools/measure/hard_cases/table_picture.h"
#include "pushback/tools/measure/results/chosen.h"

using namespace pushback;

namespace fs = std::filesystem;

namespace {

void print_row(const Table& table, std::size_t row) {
  std::string marks;
  for (std::size_t column = 0; column < table.stages.size(); ++column) {
    marks += table.passed(row, column) ? "✓" : !table.at(row, column).possible() ? "—" : "✗";
    const std::string word = in_a_word(table.at(row, column).broken);
    marks += fmt::format(" {}{}{}; ", worst_number(table, row, column), word.empty() ? "" : " ", word);
  }
  fmt::print("{:<24}{}\n", table.cases[row].name, marks);
  std::fflush(stdout);
}

/// What is made of peers.csv and of the table of ours.
void show(const Table& peers, const fs::path& folder, bool images) {
  const Table table = beside_peers(read_table_csv(read_text_file("renders/hard_cases/table.csv")), peers);
  write_text_file(folder / "peers.md", peers_md(table, folder));
  if (images) keep_picture(folder / "peers.png", draw_overview(table));
  fmt::print("\n{}\n", (folder / (images ? "peers.png" : "peers.md")).string());
}

/// Those settings of which one of the two has been played, in the order of all.
std::vector<Stage> in_either(const std::vector<Stage>& one, const std::vector<Stage>& other) {
  const auto has = [](const std::vector<Stage>& list, const Stage& stage) {
    return std::any_of(list.begin(), list.end(), [&](const Stage& in) { return in.name == stage.name; });
  };
  std::vector<Stage> found = peer_stages();
  std::erase_if(found, [&](const Stage& stage) { return !has(one, stage) && !has(other, stage); });
  return found;
}

/// Of which the engine is not built. Throws InvalidInput where it was asked for by its name, or where none is left.
void leave_out_missing(std::vector<Stage>& columns, bool by_name) {
  std::string missing;
  std::erase_if(columns, [&](const Stage& stage) {
    if (fs::exists(stage.apart.front())) return false;
    missing = fmt::format("'{}' needs {}, which is not built: its engine is missing", stage.name, stage.apart.front());
    if (by_name) throw InvalidInput(missing);
    fmt::print("left out: {}\n", missing);
    return true;
  });
  if (columns.empty()) throw InvalidInput(missing);
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> names, settings;
  std::string out = "renders", adapter;
  GivingUp giving_up{.seconds = 900, .times = std::numeric_limits<int>::max()};
  int jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  int starts = peer_starts;
  bool no_images = false, redraw = false, keep = false, list = false;
  CommandLine line("Every hard case under other engines, each as it comes and tuned, beside ours.", "hard_cases_peers");
  line.option("NAME", names, "Only these cases");
  line.option("--settings", settings, "Only these settings, separated by commas").split_at_commas();
  line.option("--adapter", adapter,
              "A program that hands cases to another engine: its settings, in the place of all others");
  line.option("--out", out, "Folder in which the folder hard_cases is made; what is not all goes to hard_cases/part")
      .shows_default();
  line.option("--jobs", jobs, "So many processes at a time").between(1, 256).shows_default();
  line.option("--starts", starts, "At most so many starts of the cases at a knife's edge").between(1, peer_starts);
  line.option("--at-most", giving_up.seconds, "Each case is given up after so long, s")
      .between(0.1, 36000.0)
      .shows_default();
  line.flag("--renew", keep, "The others stay as they are in hard_cases/peers.csv; only those named are played anew");
  line.flag("--no-images", no_images, "Only peers.csv and peers.md");
  line.flag("--redraw", redraw, "Nothing is played: peers.md and peers.png of what is in hard_cases/peers.csv");
  line.flag("--list", list, "List the settings, and do nothing");
  return line.run(argc, argv, [&] {
    require_between("--at-most", static_cast<Real>(giving_up.seconds), Real(0.1), 36000);  // the range lets nan pass
    const fs::path folder = fs::path(out) / "hard_cases", kept = folder / "peers.csv";
    if (redraw) return show(read_table_csv(read_text_file(kept), peer_stages()), folder, !no_images);
    const fs::path programs = fs::canonical("/proc/self/exe").parent_path();
    std::vector<Stage> all = peer_stages(programs);
    if (!adapter.empty()) {
      if (keep) throw InvalidInput("--renew is for the engines of hard_cases/peers.csv, not for --adapter");
      setenv("PUSHBACK_ADAPTER", fs::absolute(adapter).c_str(), 1);  // where its program looks for it
      all = peer_stages(programs, the_adapter().settings());
    }
    std::vector<HardCase> cases = chosen("case", hard_cases(), names);
    std::vector<Stage> columns = chosen("setting", all, settings);
    if (list) {
      for (const Stage& stage : columns) fmt::print("{:<16}{}\n", stage.name, stage.what);
      return;
    }
    leave_out_missing(columns, !settings.empty());
    for (HardCase& c : cases) c.starts = std::min(c.starts, starts);
    const bool whole =
        adapter.empty() && cases.size() == hard_cases().size() && settings.empty() && starts == peer_starts;
    std::string before;
    if (keep) before = read_text_file(kept);
    const fs::path into = whole || keep ? folder : folder / "part";
    make_writable_folder(into);
    std::size_t printed = 0;
    Table table = play(
        std::move(cases), std::move(columns), jobs,
        [&](const Table& so_far, std::size_t rows, std::size_t) {
          for (; printed < rows; ++printed) print_row(so_far, printed);
        },
        giving_up);
    if (keep) {
      const Table old = read_table_csv(before, peer_stages());
      table = renewed(old, table, in_either(old.stages, table.stages));
    }
    write_text_file(into / "peers.csv", table_csv(table));
    if (whole || keep) show(table, into, !no_images);
  });
}
