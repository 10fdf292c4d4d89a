#include "pushback/tools/classroom/sandbox.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <set>

#include "pushback/common/basics/input.h"
#include "pushback/common/basics/process.h"
#include "pushback/tools/classroom/kit.h"

namespace pushback {

namespace fs = std::filesystem;

namespace {

/// The kernel's limit of processes counts all that one user runs, and root is exempt from it. So root becomes another user in
/// each sandbox.
unsigned nobody_else() {
  static std::atomic<unsigned> count = 0;
  constexpr unsigned first = 1u << 29, each = 64;
  return first + static_cast<unsigned>(getpid()) * each + count++ % each;
}

void give_to(unsigned user, const fs::path& folder) {
  std::vector<fs::path> all{folder};
  for (const auto& entry : fs::recursive_directory_iterator(folder)) all.push_back(entry.path());
  for (const fs::path& path : all)
    if (lchown(path.c_str(), user, user) != 0) throw std::runtime_error("cannot change the owner of " + path.string());
}

/// bubblewrap would make the folders on the way to what is bound such that only root may enter them.
Command ways_to(const std::vector<fs::path>& bound) {
  std::set<fs::path> ways;
  for (const fs::path& path : bound)
    for (fs::path way = path.parent_path(); way != way.root_path(); way = way.parent_path()) ways.insert(way);
  Command made;
  for (const fs::path& way : ways) made = made + Command{"--perms", "0755", "--dir", way};  // the shorter ones first
  return made;
}

}  // namespace

Sandbox::Sandbox() {
  write_text_file(filters_.path / "tools", refused_calls(false));
  write_text_file(filters_.path / "program", refused_calls(true));
  const ScratchFolder folder;
  const Ended ended = run_program(around({"true"}, folder.path, {}), 10);
  if (ended.status != 0)
    throw InvalidInput(
        fmt::format("there is no sandbox here (bubblewrap: {}): install the package bubblewrap, or say --no-sandbox "
                    "and run the students' code with all of your own rights",
                    ended.status == 127 ? "not installed" : lines_of(ended.err + "no reason given").front()));
}

Command Sandbox::around(const Command& command, const fs::path& folder, const std::vector<fs::path>& readable,
                        Folder may_be) const {
  const bool writable = may_be == Folder::writable, are_root = geteuid() == 0;
  // bubblewrap is the first process in there, and its own environment can be read from /proc/1/environ.
  const char* path = std::getenv("PATH");
  Command made{"env", "-i", fmt::format("PATH={}", path == nullptr ? "/usr/bin" : path)};
  made = made + Command{"sh", "-c", "exec bwrap --seccomp 9 \"$@\" 9<\"$0\"",
                        filters_.path / (writable ? "tools" : "program")};
  made = made + Command{"--die-with-parent", "--new-session", "--cap-drop", "ALL"};
  if (are_root)  // in a user namespace root could not become another user
    made = made + Command{"--unshare-ipc", "--unshare-pid", "--unshare-net", "--unshare-uts", "--unshare-cgroup-try",
                          "--cap-add",     "CAP_SETUID",    "--cap-add",     "CAP_SETGID"};
  else made.emplace_back("--unshare-all");
  made = made + Command{"--clearenv", "--setenv", "PATH", "/usr/bin"};
  made = made + Command{"--ro-bind", "/usr", "/usr", "--proc", "/proc", "--dev", "/dev"};
  if (writable) made = made + Command{"--perms", "1777", "--size", "67108864", "--tmpfs", "/tmp"};
  for (const char* link : {"bin", "lib", "lib64"})
    made = made + Command{"--symlink", fmt::format("usr/{}", link), fmt::format("/{}", link)};
  const fs::path names = "/etc/alternatives";  // where Debian's /usr/bin/c++ leads
  const fs::path headers = kit().headers / "pushback";
  std::vector<fs::path> bound = readable;
  bound.insert(bound.end(), {folder, headers / "common", names});
  made = made + ways_to(bound) + Command{"--ro-bind-try", names, names};
  for (const char* part : {"common", "engine", "chapters"})
    made = made + Command{"--ro-bind", kit().sources / part, headers / part};
  made = made + Command{writable ? "--bind" : "--ro-bind", folder, folder};
  for (const fs::path& file : readable) made = made + Command{"--ro-bind", file, file};
  made = made + Command{"--remount-ro", "/proc", "--remount-ro", "/dev", "--remount-ro", "/", "--"};
  if (are_root) {
    const unsigned user = nobody_else();
    give_to(user, folder);
    made = made + Command{"setpriv", fmt::format("--reuid={}", user), fmt::format("--regid={}", user), "--clear-groups",
                          "--inh-caps=-all"};
  }
  return made + Command{"env", "-C", folder, "prlimit", "--nproc=32"} + command;
}

}  // namespace pushback
