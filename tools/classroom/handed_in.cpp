#include "pushback/tools/classroom/handed_in.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <csignal>
#include <map>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/input.h"
#include "pushback/common/basics/process.h"

namespace pushback {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t most_bytes = 1'000'000;  // of a file
constexpr std::size_t most_headers = 50;          // next to a solver
constexpr int deepest = 3;                        // top folder, exercises, file

/// The ending of an archive, or empty if it is none.
std::string_view ending_of(const std::string& name) {
  for (const std::string_view ending : {".zip", ".tar", ".tar.gz", ".tgz", ".tar.xz", ".tar.bz2"})
    if (name.ends_with(ending) && name.size() > ending.size()) return ending;
  return {};
}

/// Called with the archive and the folder that gets its headers. It says why it takes nothing. It unpacks into /tmp first: in the
/// sandbox that holds 64 MB, whatever the archive says of its size.
constexpr const char* unpack = R"(
set -u
refuse() { echo "$1"; exit 99; }
names=$2/names
case $1 in
  *.zip) tool=unzip; unzip -Z1 "$1" >"$names" ;;
  *) tool=tar; tar --force-local -tf "$1" >"$names" ;;
esac || exit
[ $(wc -l <"$names") -le 1000 ] || refuse "it has $(wc -l <"$names") entries, at most 1000 are taken"
! grep -qE '^/|(^|/)\.\.(/|$)|\\' "$names" || refuse "a name in it leads out of its folder, or has a \\ in it"
grep -q '\.h$' "$names" || exit 0
in=$(mktemp -d) && trap 'rm -rf "$in"' EXIT && cd "$in" || exit
case $tool in
  unzip) unzip -qq -P none "$1" '*.h' ;;
  tar) tar --force-local --no-same-owner --no-same-permissions -xf "$1" --wildcards '*.h' ;;
esac || exit
chmod -R a+rwX . && cp -R . "$2/in"
)";

/// The problem of the archive, or empty if there is none.
std::string unpacked(const fs::path& archive, const fs::path& to, const Sandbox* sandbox) {
  const fs::path file = fs::canonical(archive);
  Command command{"prlimit",         "--core=0", "--cpu=20", fmt::format("--fsize={}", most_bytes),
                  "--as=1073741824", "sh",       "-c",       unpack,
                  "unpack",          file,       to};
  if (sandbox) command = sandbox->around(command, to, {file});
  const Ended ended = run_program(command, 30);
  if (ended.status == 127)
    throw InvalidInput(fmt::format("'{}' cannot be unpacked: are tar and unzip installed?", visible(archive)));
  const bool too_large = ended.signal == SIGXFSZ || ended.status == 128 + SIGXFSZ;
  if (ended.status == 0) return "";
  if (ended.status == 99) return visible(lines_of(ended.out).front());
  if (too_large) return "a file in it, or its list of files, is larger than 1 MB";
  return ended.out_of_time ? "it takes too long to read" : "it cannot be read";
}

struct Unreadable {
  std::string why;
};

/// The files of less than 1 MB at most two folders deep, relative to the folder. Follows no links.
std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> all;
  const auto options = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator it(folder, options), end; it != end; ++it) {
    if (it.depth() + 1 == deepest) it.disable_recursion_pending();
    if (fs::is_regular_file(it->symlink_status()) && it->file_size() < most_bytes)
      all.push_back(it->path().lexically_relative(folder));
  }
  return all;
}

/// The file of this name in the fewest folders, or empty if there is none.
fs::path found_in(const std::vector<fs::path>& files, const std::string& wanted) {
  std::map<std::ptrdiff_t, std::vector<fs::path>> found;  // by depth
  for (const fs::path& file : files)
    if (file.filename() == wanted) found[std::distance(file.begin(), file.end())].push_back(file);
  if (found.empty()) return {};
  const std::vector<fs::path>& nearest = found.begin()->second;
  if (nearest.size() > 1) throw Unreadable{fmt::format("there are {} files {} in it", nearest.size(), wanted)};
  return nearest[0];
}

}  // namespace

std::string visible(const std::string& text) {
  bool is_utf8 = true;  // with nothing in it that is not seen
  try {
    for (const char32_t letter : fs::path(text).u32string())
      if ((letter >= 0x80 && letter < 0xa0) || (letter >= 0x2028 && letter <= 0x202e) ||
          (letter >= 0x2066 && letter <= 0x2069))
        is_utf8 = false;
  } catch (const fs::filesystem_error&) {
    is_utf8 = false;
  }
  std::string shown;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f || (byte >= 0x80 && !is_utf8)) shown += fmt::format("\\x{:02x}", byte);
    else shown += c;
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
  const ScratchFolder scratch;
  const bool is_folder = fs::is_directory(given);
  if (!is_folder) problem_ = unpacked(given, scratch.path, sandbox);
  if (!problem_.empty()) return;
  try {
    if (is_folder) take(given, exercises);
    else if (fs::is_directory(scratch.path / "in")) take(scratch.path / "in", exercises);
  } catch (const Unreadable& problem) {
    problem_ = problem.why;
  }
}

void HandedIn::take(const fs::path& folder, const std::vector<const Exercise*>& exercises) {
  const std::vector<fs::path> files = files_in(folder);
  for (const Exercise* exercise : exercises) {
    const fs::path found = found_in(files, file_of(*exercise));
    if (found.empty()) continue;
    const fs::path& to = exercise->whole() ? solver_.path : files_.path;
    std::size_t headers = 0;
    for (const fs::path& file : files) {
      const bool beside = exercise->whole() && file.extension() == ".h" && file.parent_path() == found.parent_path();
      if (file != found && !beside) continue;
      if (++headers > most_headers + 1)
        throw Unreadable{fmt::format("there are more than {} headers next to solver.h", most_headers)};
      write_text_file(to / file.filename(), read_text_file(folder / file));
    }
  }
}

std::optional<fs::path> HandedIn::file(const Exercise& exercise) const {
  const fs::path file = (exercise.whole() ? solver_ : files_).path / file_of(exercise);
  return fs::exists(file) ? std::optional(file) : std::nullopt;
}

std::string HandedIn::contents() const {
  std::vector<std::string> all;
  for (const fs::path& folder : {files_.path, solver_.path})
    for (const auto& entry : fs::directory_iterator(folder))
      all.push_back(entry.path().filename().string() + "\n" + read_text_file(entry.path()));
  std::sort(all.begin(), all.end());
  return fmt::format("{}", fmt::join(all, "\n"));
}

}  // namespace pushback
