#include "pushback/tools/classroom/budget.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/magic.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace pushback {

namespace fs = std::filesystem;

namespace {

/// A file of /proc; empty where the process has just ended, or is none of ours.
std::string text_of(const std::string& file) {
  const int handle = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (handle < 0) return "";
  std::array<char, 4096> text{};
  const ssize_t size = read(handle, text.data(), text.size());
  close(handle);
  return {text.data(), static_cast<std::size_t>(std::max<ssize_t>(0, size))};
}

/// Bytes in lines such as "VmRSS:    1832 kB"; 0 where there is none.
std::int64_t bytes_in(const std::string& text, const std::string& name) {
  const std::size_t at = ("\n" + text).find("\n" + name + ":");
  if (at == std::string::npos) return 0;
  const std::size_t from = std::min(text.find_first_of("0123456789", at), text.size());
  std::int64_t kilobytes = 0;
  std::from_chars(text.data() + from, text.data() + text.size(), kilobytes);
  return kilobytes * 1024;
}

struct Process {
  int id = 0, parent = 0, threads = 0;
  long user_ticks = 0, system_ticks = 0;  ///< of the processor
  int depth = 0;                          ///< below the program that is watched
};

std::vector<Process> all_processes() {
  std::vector<Process> all;
  std::error_code ended;
  for (const auto& entry : fs::directory_iterator("/proc", ended)) {
    const std::string name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    const std::string text = text_of(entry.path() / "stat");
    const std::size_t after_name = text.rfind(')');  // the name may have brackets and spaces in it
    if (after_name == std::string::npos) continue;
    Process process{std::stoi(name)};
    std::size_t at = after_name + 1;
    for (int field = 3; at < text.size() && field <= 20; ++field) {
      at = std::min(text.find_first_not_of(' ', at), text.size());
      if (field == 4) std::from_chars(text.data() + at, text.data() + text.size(), process.parent);
      if (field == 14) std::from_chars(text.data() + at, text.data() + text.size(), process.user_ticks);
      if (field == 15) std::from_chars(text.data() + at, text.data() + text.size(), process.system_ticks);
      if (field == 20) std::from_chars(text.data() + at, text.data() + text.size(), process.threads);
      at = std::min(text.find(' ', at), text.size());
    }
    all.push_back(process);
  }
  return all;
}

/// Those that `program` has started, and those that these have started. Who outlives his parent becomes a child of the first
/// process in the sandbox.
std::vector<Process> below(int program) {
  const std::vector<Process> all = all_processes();
  std::vector<Process> found{{program}};
  constexpr std::size_t far_too_many = 500;  // nobody is to count for long what grows faster than that
  for (std::size_t i = 0; i < found.size() && found.size() < far_too_many; ++i)
    for (Process process : all) {
      if (process.parent != found[i].id) continue;
      process.depth = found[i].depth + 1;
      found.push_back(process);
    }
  found.erase(found.begin());
  return found;
}

/// What a process holds. A page that several hold is counted in full for each, or, which takes longer, in parts.
std::int64_t memory_of(const Process& process, bool in_parts) {
  const std::string folder = fmt::format("/proc/{}/", process.id), status = text_of(folder + "status");
  const std::int64_t tables = bytes_in(status, "VmPTE");
  if (const std::string rollup = in_parts ? text_of(folder + "smaps_rollup") : ""; !rollup.empty())
    return tables + bytes_in(rollup, "Pss") + bytes_in(rollup, "SwapPss");
  return tables + bytes_in(status, "VmRSS") + bytes_in(status, "VmSwap");
}

/// Files that are memory, as a process in the sandbox sees them; each takes a page at least.
std::int64_t memory_of_files(const Process& process) {
  std::int64_t bytes = 0;
  for (const char* folder : {"tmp", "dev/shm"}) {
    struct statfs found{};
    if (statfs(fmt::format("/proc/{}/root/{}", process.id, folder).c_str(), &found) != 0 || found.f_type != TMPFS_MAGIC)
      continue;
    bytes += static_cast<std::int64_t>(found.f_blocks - found.f_bfree) * found.f_bsize +
             static_cast<std::int64_t>(found.f_files - found.f_ffree - 1) * 4096;  // but for the folder itself
  }
  return bytes;
}

}  // namespace

std::chrono::milliseconds Watch::look(int program) {
  const auto begin = std::chrono::steady_clock::now();
  const std::vector<Process> started = below(program);
  std::vector<Process> counted = started;
  constexpr int wrapping = 2;  // bubblewrap outside, and inside as the first process
  if (sandboxed_) std::erase_if(counted, [](const Process& process) { return process.depth <= wrapping; });
  int processes = 0;
  for (const Process& process : counted) {
    processes += std::max(1, process.threads);
    const double seconds =
        static_cast<double>(process.user_ticks + process.system_ticks) / static_cast<double>(sysconf(_SC_CLK_TCK));
    processor_seconds_ = std::max(processor_seconds_, seconds);
  }
  if (processes > budget_.processes) {
    exceeded_ = fmt::format("more than {} processes and threads", budget_.processes);
  } else if (!counted.empty()) {
    const std::int64_t most = std::int64_t{budget_.megabytes} << 20,
                       files = sandboxed_ ? memory_of_files(counted.front()) : 0;
    const auto used = [&](bool in_parts) {
      std::int64_t sum = files;
      for (const Process& process : counted) sum += memory_of(process, in_parts);
      return sum;
    };
    if (used(false) > most && used(true) > most)
      exceeded_ = fmt::format("more than {} MB of memory, its children{} included", budget_.megabytes,
                              sandboxed_ ? " and files in /tmp" : "");
  }
  if (!exceeded_.empty())
    for (const Process& process : started)
      if (!sandboxed_ || process.depth == wrapping) kill(process.id, SIGKILL);
  // At most a tenth of a processor goes into looking.
  const auto took = std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - begin);
  return std::max(std::chrono::milliseconds(10), 10 * took);
}

}  // namespace pushback
