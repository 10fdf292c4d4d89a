/// System calls that bubblewrap leaves open, and that no limit of a process covers.
#pragma once

#include <string>

namespace pushback {

/// A program for the kernel (seccomp), as bubblewrap takes it. It refuses memory that belongs to no process, looking into other
/// processes, and sandboxes within the sandbox. With `one_process`, it also refuses to start another process, so that the
/// limit of one process's memory is the limit of all. Threads may start.
std::string refused_calls(bool one_process);

}  // namespace pushback
