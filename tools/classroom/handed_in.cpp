#include "pushback/tools/classroom/handed_in.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <utility>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/input.h"
#include "pushback/common/basics/process.h"

namespace pushback {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t most_bytes = 1'000'000;  // of a file
constexpr std::size_t most_entries = 1000;        // of an archive
constexpr std::size_t most_headers = 50;          // beside a solver
constexpr std::size_t deepest = 3;                // top folder, exercises, file

using Command = std::vector<std::string>;

/// The ending of an archive; empty: it is none.
std::string_view ending_of(const std::string& name) {
  for (const std::string_view ending : {".zip", ".tar", ".tar.gz", ".tgz", ".tar.xz", ".tar.bz2"})
    if (name.ends_with(ending) && name.size() > ending.size()) return ending;
  return {};
}

/// unzip takes the names it is asked for as patterns.
std::string as_pattern(const std::string& name) {
  std::string pattern;
  for (const char c : name)
    pattern +=
        std::string_view("[*?-\\").find(c) == std::string_view::npos ? std::string(1, c) : fmt::format("[{}]", c);
  return pattern;
}

struct Unreadable {
  std::string why;
};

struct Entry {
  std::string name;
  bool is_file;
};

/// Reads one archive by `tar` or `unzip`, which write nothing but text to us.
class Archive {
 public:
  Archive(const fs::path& file, const Sandbox* sandbox)
      : file_(fs::canonical(file)), zip_(ending_of(file.filename().string()) == ".zip"), sandbox_(sandbox) {}

  std::vector<Entry> entries() const {
    const std::string path = file_.string();
    const auto names = lines_of(zip_ ? said({"unzip", "-Z1", path})
                                     : said({"tar", "--force-local", "--quoting-style=escape", "-tf", path}));
    auto types = lines_of(zip_ ? said({"unzip", "-Z", "-s", path})
                               : said({"tar", "--force-local", "--quoting-style=escape", "-tvf", path}));
    if (zip_) types.erase(types.begin(), types.begin() + std::min<std::ptrdiff_t>(2, std::ssize(types)));  // its head
    if (names.size() > most_entries)
      throw Unreadable{fmt::format("it has {} entries, at most {} are taken", names.size(), most_entries)};
    if (types.size() < names.size()) throw Unreadable{"its list of files makes no sense"};
    std::vector<Entry> all;
    for (std::size_t i = 0; i < names.size(); ++i) {
      for (const fs::path& part : fs::path(names[i]))
        if (part == ".." || part == "/" || names[i].find('\\') != std::string::npos)
          throw Unreadable{fmt::format("'{}' in it leads out of its folder, or has a \\ in its name", names[i])};
      all.push_back({names[i], types[i][0] == '-' || types[i][0] == '?'});
    }
    return all;
  }

  std::string text_of(const std::string& name) const {
    if (zip_) return said({"unzip", "-P", "none", "-p", file_, as_pattern(name)});  // or it would ask for a password
    return said({"tar", "--force-local", "-xOf", file_, "--", name});
  }

 private:
  std::string said(const Command& words) const {
    Command command{"prlimit", "--core=0", "--cpu=20", fmt::format("--fsize={}", most_bytes), "--as=1073741824"};
    command.insert(command.end(), words.begin(), words.end());
    const ScratchFolder scratch;
    if (sandbox_) command = sandbox_->around(command, scratch.path, {file_});
    const Ended ended = run_program(command, 30);
    if (ended.status == 0) return ended.out;
    if (ended.status == 127)
      throw InvalidInput(
          fmt::format("'{}' cannot be read without {}: is the package installed?", file_.string(), words[0]));
    if (ended.signal == SIGXFSZ || ended.status == 128 + SIGXFSZ || ended.out.size() >= most_bytes)
      throw Unreadable{"a file in it, or its list of files, is larger than 1 MB"};
    throw Unreadable{said_of(ended.err, words[0])};
  }
  /// The first line that says more than which file it is.
  std::string said_of(const std::string& complaint, const std::string& program) const {
    for (std::string line : lines_of(complaint)) {
      for (std::size_t at; (at = line.find(file_.string())) != std::string::npos;)
        line.erase(at, file_.string().size());
      line.erase(0, line.find_first_not_of("[]:,; "));
      if (line.find(' ') != std::string::npos) return fmt::format("it cannot be read ({}: {})", program, line);
    }
    return "it takes too long or too much memory to read";
  }
  fs::path file_;
  bool zip_;
  const Sandbox* sandbox_;
};

std::size_t depth_of(const std::string& name) {
  const fs::path path = fs::path(name).lexically_normal();
  return static_cast<std::size_t>(std::distance(path.begin(), path.end()));
}

bool is_header(const fs::path& file) {
  return file.extension() == ".h" && file.filename() != ".h";
}

/// Leaves the files of these exercises in `folder`.
void unpack(const Archive& archive, const std::vector<const Exercise*>& exercises, const fs::path& folder) {
  const std::vector<Entry> entries = archive.entries();
  bool solver = false;
  for (const Exercise* exercise : exercises) {
    if (exercise->whole() && std::exchange(solver, true)) continue;  // one for all chapters
    const std::string wanted = file_of(*exercise);
    std::vector<std::string> found;
    for (const Entry& entry : entries)
      if (entry.is_file && fs::path(entry.name).filename() == wanted && depth_of(entry.name) <= deepest)
        found.push_back(entry.name);
    if (found.size() > 1) throw Unreadable{fmt::format("there are {} files {} in it", found.size(), wanted)};
    if (found.empty()) continue;
    write_text_file(folder / wanted, archive.text_of(found[0]));
    if (!exercise->whole()) continue;
    std::size_t count = 0;
    for (const Entry& entry : entries) {
      const fs::path name(entry.name);
      if (!entry.is_file || entry.name == found[0] || !is_header(name) ||
          name.parent_path() != fs::path(found[0]).parent_path())
        continue;
      if (++count > most_headers)
        throw Unreadable{fmt::format("more than {} headers are beside solver.h", most_headers)};
      write_text_file(folder / name.filename(), archive.text_of(entry.name));
    }
  }
}

/// Copies solver.h and the headers beside it, as far as they are files of less than 1 MB and no links.
bool copy_solver(const fs::path& from, const fs::path& to) {
  const auto taken = [](const fs::path& file) {
    return fs::is_regular_file(fs::symlink_status(file)) && fs::file_size(file) < most_bytes;
  };
  if (fs::is_symlink(from) || !taken(from / "solver.h")) return false;
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(from))
    if (is_header(entry.path()) && taken(entry.path()) && ++count <= most_headers + 1)
      write_text_file(to / entry.path().filename(), read_text_file(entry.path()));
  write_text_file(to / "solver.h", read_text_file(from / "solver.h"));
  return true;
}

}  // namespace

std::string file_of(const Exercise& exercise) {
  return exercise.whole() ? "solver.h" : exercise.name + ".h";
}

std::string students_name(const fs::path& given) {
  if (fs::is_directory(given)) return fs::canonical(given).filename().string();
  const std::string name = given.filename().string();
  const std::string_view ending = ending_of(name);
  if (!fs::is_regular_file(given) || ending.empty())
    throw InvalidInput(
        fmt::format("'{}' is no folder, and no archive (.zip, .tar, .tar.gz, .tgz, .tar.xz, .tar.bz2): one for each "
                    "student is needed",
                    given.string()));
  return name.substr(0, name.size() - ending.size());
}

HandedIn::HandedIn(const fs::path& given, const std::vector<const Exercise*>& exercises, const Sandbox* sandbox)
    : folder_(given) {
  if (!fs::is_directory(given)) {
    folder_ = unpacked_.emplace().path;
    try {
      unpack(Archive(given, sandbox), exercises, folder_);
    } catch (const Unreadable& problem) {
      problem_ = problem.why;
    }
  }
  const bool wanted = std::any_of(exercises.begin(), exercises.end(), [](const Exercise* one) { return one->whole(); });
  if (wanted && !copy_solver(folder_ / "mine", solver_.emplace().path) && !copy_solver(folder_, solver_->path))
    solver_.reset();
}

std::optional<fs::path> HandedIn::file(const Exercise& exercise) const {
  if (exercise.whole()) return solver_ ? std::optional(solver_->path / "solver.h") : std::nullopt;
  for (const fs::path& file : {folder_ / (exercise.name + ".h"), folder_ / "exercises" / (exercise.name + ".h")})
    if (fs::is_regular_file(fs::symlink_status(file)) && !fs::is_symlink(file.parent_path()) &&
        fs::file_size(file) < most_bytes)
      return file;
  return std::nullopt;
}

}  // namespace pushback
