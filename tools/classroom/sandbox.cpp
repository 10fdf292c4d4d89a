#include "pushback/tools/classroom/sandbox.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <set>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/input.h"
#include "pushback/common/basics/process.h"
#include "pushback/tools/classroom/calls.h"
#include "pushback/tools/classroom/kit.h"

namespace pushback {

namespace fs = std::filesystem;

namespace {

using Command = std::vector<std::string>;

Command operator+(Command first, const Command& then) {
  first.insert(first.end(), then.begin(), then.end());
  return first;
}

/// What a student's program may never exceed, whoever watches it: enough for those who are watched more closely.
constexpr int most_processes = 256;

bool are_root() {
  return geteuid() == 0;
}

/// Root is exempt from the kernel's limit of processes, so whoever is root becomes somebody else in the sandbox, each time
/// another one: the limit is of all that one user runs.
unsigned nobody_else() {
  static std::atomic<unsigned> count = 0;
  constexpr unsigned first = 1u << 29, each = 64;
  return first + static_cast<unsigned>(getpid()) * each + count++ % each;
}

/// Of the user that we are, with threads: a kernel before 5.14 counts them in.
int processes_of_ours() {
  int count = 0;
  std::error_code ended;
  for (const auto& entry : fs::directory_iterator("/proc", ended)) {
    struct stat owner{};
    if (stat(entry.path().c_str(), &owner) != 0 || owner.st_uid != geteuid()) continue;
    std::error_code gone;
    for (auto task = fs::directory_iterator(entry.path() / "task", gone); !gone && task != fs::directory_iterator();
         task.increment(gone))
      ++count;
  }
  return count;
}

/// bubblewrap makes folders that only root may enter on the way to what is bound.
Command ways_to(const std::vector<fs::path>& bound) {
  std::set<fs::path> ways;
  for (const fs::path& path : bound)
    for (fs::path way = path.parent_path(); way != way.root_path(); way = way.parent_path()) ways.insert(way);
  Command made;
  for (const fs::path& way : ways)  // the shorter ones first
    if (way != "/tmp" && *++way.begin() != "usr") made = made + Command{"--perms", "0755", "--dir", way};
  return made;
}

void give_to(unsigned user, const fs::path& folder) {
  if (lchown(folder.c_str(), user, user) != 0) throw std::runtime_error("cannot give away " + folder.string());
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (lchown(entry.path().c_str(), user, user) != 0)
      throw std::runtime_error("cannot give away " + entry.path().string());
}

}  // namespace

Sandbox::Sandbox() {
  fs::permissions(headers_.path, fs::perms::others_read | fs::perms::others_exec, fs::perm_options::add);
  const fs::path& source = kit().sources;
  for (const char* part : {"common", "chapters"}) {
    for (const auto& entry : fs::recursive_directory_iterator(source / part)) {
      if (entry.path().extension() != ".h") continue;
      const fs::path copy = headers_.path / "pushback" / fs::relative(entry.path(), source);
      fs::create_directories(copy.parent_path());
      fs::copy_file(entry.path(), copy);
    }
  }
  for (const auto& entry : fs::recursive_directory_iterator(headers_.path))  // whatever is usual here
    fs::permissions(entry.path(),
                    fs::perms::others_read | (entry.is_directory() ? fs::perms::others_exec : fs::perms::none),
                    fs::perm_options::add);
  write_text_file(filter_.path / "filter", filter_of_calls());
  const ScratchFolder folder;
  const Ended ended = run_program(around({"true"}, folder.path, {}), 10);
  if (ended.status != 0)
    throw InvalidInput(
        fmt::format("there is no sandbox here (bubblewrap: {}): install the package bubblewrap, or say --no-sandbox "
                    "and run what students wrote with all that you may do yourself",
                    ended.status == 127 ? "not installed" : lines_of(ended.err + "no reason given").front()));
}

Command Sandbox::around(Command command, const fs::path& folder, const std::vector<fs::path>& readable,
                        Folder may_be) const {
  constexpr const char* most_bytes = "67108864";
  // bubblewrap is the first process in there: its own environment can be read from /proc/1/environ.
  const char* path = std::getenv("PATH");
  Command made{"env", "-i", fmt::format("PATH={}", path == nullptr ? "/usr/bin" : path)};
  if (has_filter) made = made + Command{"sh", "-c", "exec bwrap --seccomp 9 \"$@\" 9<\"$0\"", filter_.path / "filter"};
  else made.emplace_back("bwrap");
  made = made + Command{"--die-with-parent", "--new-session", "--cap-drop", "ALL"};
  if (are_root())  // whoever it becomes is nobody in a user namespace
    made = made + Command{"--unshare-ipc", "--unshare-pid", "--unshare-net", "--unshare-uts", "--unshare-cgroup-try",
                          "--cap-add",     "CAP_SETUID",    "--cap-add",     "CAP_SETGID"};
  else made.emplace_back("--unshare-all");
  made = made + Command{"--clearenv", "--setenv", "PATH", "/usr/bin"};
  made = made + Command{"--ro-bind", "/usr", "/usr", "--proc", "/proc", "--dev", "/dev"};
  for (const char* memory : {"/dev/shm", "/tmp"})
    made = made + Command{"--perms", "1777", "--size", most_bytes, "--tmpfs", memory};
  for (const char* link : {"bin", "lib", "lib64"})
    made = made + Command{"--symlink", fmt::format("usr/{}", link), fmt::format("/{}", link)};
  const fs::path names = "/etc/alternatives";  // where Debian's /usr/bin/c++ leads
  std::vector<fs::path> bound = readable;
  bound.insert(bound.end(), {folder, kit().headers, names});
  made = made + ways_to(bound) + Command{"--ro-bind-try", names, names};
  made = made + Command{"--ro-bind", headers_.path, kit().headers, may_be == Folder::writable ? "--bind" : "--ro-bind",
                        folder,      folder};
  for (const fs::path& readable_path : readable) made = made + Command{"--ro-bind", readable_path, readable_path};
  made = made + Command{"--remount-ro", "/proc", "--remount-ro", "/dev", "--remount-ro", "/", "--"};
  int processes = most_processes;
  if (are_root()) {
    const unsigned user = nobody_else();
    give_to(user, folder);
    made = made + Command{"setpriv", fmt::format("--reuid={}", user), fmt::format("--regid={}", user), "--clear-groups",
                          "--inh-caps=-all"};
  } else processes += processes_of_ours();
  return made + Command{"env", "-C", folder, "prlimit", fmt::format("--nproc={}", processes)} + command;
}

}  // namespace pushback
