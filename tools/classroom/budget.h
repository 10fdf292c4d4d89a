/// What a program may use together with all that it starts, watched from outside.
#pragma once

#include <chrono>
#include <string>

namespace pushback {

struct Budget {
  int megabytes;  ///< of memory, and of files in /tmp and /dev/shm of its sandbox
  int processes;  ///< threads count
};

/// The kernel's own limits are of one process each, but for that of the number of processes, and a control group of one's own is
/// there for few users. So we add up, up to a hundred times a second, what the kernel tells of each process below ours,
/// and kill them all when it is too much. In a sandbox the first process of its pid namespace is killed: all others go with it,
/// and none can leave it.
class Watch {
 public:
  Watch(const Budget& budget, bool sandboxed) : budget_(budget), sandboxed_(sandboxed) {}
  /// A `ProcessWatcher` of run_program.
  std::chrono::milliseconds look(int program);
  /// "more than 32 processes"; empty: it has kept to its budget.
  const std::string& exceeded() const { return exceeded_; }
  /// Of that process which has taken the most, when it was last seen.
  double processor_seconds() const { return processor_seconds_; }

 private:
  Budget budget_;
  bool sandboxed_;
  std::string exceeded_;
  double processor_seconds_ = 0;
};

}  // namespace pushback
