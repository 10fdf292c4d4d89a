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
constexpr std::size_t most_headers = 50;          // next to a solver
constexpr int deepest = 3;                        // top folder, exercises, file

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
          throw Unreadable{
              fmt::format("'{}' in it leads out of its folder, or has a \\ in its name", visible(names[i]))};
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
          fmt::format("'{}' cannot be read without {}: is the package installed?", visible(file_), words[0]));
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
      if (line.find(' ') != std::string::npos) return fmt::format("it cannot be read ({}: {})", program, visible(line));
    }
    return "it takes too long or too much memory to read";
  }
  fs::path file_;
  bool zip_;
  const Sandbox* sandbox_;
};

/// Reads a folder as an Archive reads an archive. Follows no links.
class Folder {
 public:
  explicit Folder(const fs::path& folder) : folder_(folder) {}

  std::vector<Entry> entries() const {
    std::vector<Entry> all;
    const auto options = fs::directory_options::skip_permission_denied;
    for (fs::recursive_directory_iterator it(folder_, options), end; it != end; ++it) {
      if (it.depth() + 1 == deepest) it.disable_recursion_pending();
      if (fs::is_regular_file(it->symlink_status()) && it->file_size() < most_bytes)
        all.push_back({it->path().lexically_relative(folder_), true});
    }
    return all;
  }

  std::string text_of(const std::string& name) const { return read_text_file(folder_ / name); }

 private:
  fs::path folder_;
};

int depth_of(const std::string& name) {
  const fs::path path = fs::path(name).lexically_normal();
  return static_cast<int>(std::distance(path.begin(), path.end()));
}

bool is_header(const fs::path& file) {
  return file.extension() == ".h" && file.filename() != ".h";
}

/// The name of the file, of those in the fewest folders; empty: there is none.
std::string found_in(const std::vector<Entry>& entries, const std::string& wanted) {
  std::vector<std::string> found;
  int depth = deepest;
  for (const Entry& entry : entries) {
    const int its = depth_of(entry.name);
    if (!entry.is_file || fs::path(entry.name).filename() != wanted || its > depth) continue;
    if (its < depth) found.clear();
    depth = its;
    found.push_back(entry.name);
  }
  if (found.size() > 1) throw Unreadable{fmt::format("there are {} files {} in it", found.size(), wanted)};
  return found.empty() ? "" : found[0];
}

/// Leaves the files of these exercises in `folder`, and solver.h with the headers next to it in `solver`.
template <class Source>
void unpack(const Source& source, const std::vector<const Exercise*>& exercises, const fs::path& folder,
            const fs::path& solver) {
  const std::vector<Entry> entries = source.entries();
  bool taken = false;
  for (const Exercise* exercise : exercises) {
    if (exercise->whole() && std::exchange(taken, true)) continue;  // one for all chapters
    const std::string found = found_in(entries, file_of(*exercise));
    if (found.empty()) continue;
    const fs::path& to = exercise->whole() ? solver : folder;
    write_text_file(to / file_of(*exercise), source.text_of(found));
    if (!exercise->whole()) continue;
    std::size_t count = 0;
    for (const Entry& entry : entries) {
      const fs::path name(entry.name);
      if (!entry.is_file || entry.name == found || !is_header(name) ||
          name.parent_path() != fs::path(found).parent_path())
        continue;
      if (++count > most_headers)
        throw Unreadable{fmt::format("more than {} headers are next to solver.h", most_headers)};
      write_text_file(to / name.filename(), source.text_of(entry.name));
    }
  }
}

}  // namespace

std::string visible(const std::string& text) {
  std::string shown;
  for (std::size_t at = 0; at < text.size();) {
    const auto byte = [&](std::size_t i) {
      return static_cast<unsigned char>(at + i < text.size() ? text[at + i] : 0);
    };
    std::size_t length = byte(0) < 0x80   ? 1
                         : byte(0) < 0xc0 ? 0
                         : byte(0) < 0xe0 ? 2
                         : byte(0) < 0xf0 ? 3
                         : byte(0) < 0xf5 ? 4
                                          : 0;
    unsigned letter = length <= 1 ? byte(0) : byte(0) & (0xffu >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) {
      letter = letter << 6 | (byte(i) & 0x3fu);
      if ((byte(i) & 0xc0) != 0x80) length = 0;
    }
    constexpr unsigned least[] = {~0u, 0, 0x80, 0x800, 0x10000};
    const bool is_utf8 = letter >= least[length] && letter <= 0x10ffff && (letter < 0xd800 || letter > 0xdfff);
    const bool controls = letter < 0x20 || (letter >= 0x7f && letter < 0xa0) ||
                          (letter >= 0x2028 && letter <= 0x202e) || (letter >= 0x2066 && letter <= 0x2069);
    const std::size_t taken = is_utf8 ? length : 1;
    if (is_utf8 && !controls) shown += text.substr(at, taken);
    else
      for (std::size_t i = 0; i < taken; ++i) shown += fmt::format("\\x{:02x}", byte(i));
    at += taken;
  }
  return shown;
}

std::string file_of(const Exercise& exercise) {
  return exercise.whole() ? "solver.h" : exercise.name + ".h";
}

std::string students_name(const fs::path& given) {
  if (fs::is_directory(given)) return visible(fs::canonical(given).filename());
  const std::string name = given.filename().string();
  const std::string_view ending = ending_of(name);
  if (!fs::is_regular_file(given) || ending.empty())
    throw InvalidInput(
        fmt::format("'{}' is no folder, and no archive (.zip, .tar, .tar.gz, .tgz, .tar.xz, .tar.bz2): one for each "
                    "student is needed",
                    visible(given)));
  return visible(name.substr(0, name.size() - ending.size()));
}

HandedIn::HandedIn(const fs::path& given, const std::vector<const Exercise*>& exercises, const Sandbox* sandbox) {
  try {
    if (fs::is_directory(given)) unpack(Folder(given), exercises, files_.path, solver_.path);
    else unpack(Archive(given, sandbox), exercises, files_.path, solver_.path);
  } catch (const Unreadable& problem) {
    problem_ = problem.why;
  }
}

std::optional<fs::path> HandedIn::file(const Exercise& exercise) const {
  const fs::path file = (exercise.whole() ? solver_ : files_).path / file_of(exercise);
  return fs::exists(file) ? std::optional(file) : std::nullopt;
}

}  // namespace pushback
