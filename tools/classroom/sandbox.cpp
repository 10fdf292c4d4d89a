#include "pushback/tools/classroom/sandbox.h"

#include <fmt/format.h>

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

}  // namespace

Sandbox::Sandbox() {
  const fs::path& source = kit().sources;
  for (const char* part : {"common", "chapters"}) {
    for (const auto& entry : fs::recursive_directory_iterator(source / part)) {
      if (entry.path().extension() != ".h") continue;
      const fs::path copy = headers_.path / "pushback" / fs::relative(entry.path(), source);
      fs::create_directories(copy.parent_path());
      fs::copy_file(entry.path(), copy);
    }
  }
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
  made = made + Command{"--unshare-all", "--die-with-parent", "--new-session", "--cap-drop", "ALL"};
  made = made + Command{"--clearenv", "--setenv", "PATH", "/usr/bin"};
  made = made + Command{"--ro-bind", "/usr", "/usr", "--proc", "/proc", "--dev", "/dev"};
  for (const char* memory : {"/dev/shm", "/tmp"}) made = made + Command{"--size", most_bytes, "--tmpfs", memory};
  for (const char* link : {"bin", "lib", "lib64"})
    made = made + Command{"--symlink", fmt::format("usr/{}", link), fmt::format("/{}", link)};
  made =
      made + Command{"--ro-bind-try", "/etc/alternatives", "/etc/alternatives"};  // where Debian's /usr/bin/c++ leads
  made = made + Command{"--ro-bind", headers_.path, kit().headers, may_be == Folder::writable ? "--bind" : "--ro-bind",
                        folder,      folder,        "--chdir",     folder};
  for (const fs::path& readable_path : readable) made = made + Command{"--ro-bind", readable_path, readable_path};
  // What root owns in /proc/sys is root's to write, even without any rights: root inside is root outside to it.
  return made + Command{"--remount-ro", "/proc", "--remount-ro", "/dev", "--remount-ro", "/", "--"} + command;
}

}  // namespace pushback
