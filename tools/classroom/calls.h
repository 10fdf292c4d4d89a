/// The system calls that a student's program and its compiler may not make.
#pragma once

#include <string>

namespace pushback {

/// Whether they can be told apart on this kind of processor.
#if defined(__x86_64__) || defined(__aarch64__)
inline constexpr bool has_filter = true;
#else
inline constexpr bool has_filter = false;
#endif

/// A program for the kernel (seccomp), as bubblewrap takes it.
std::string filter_of_calls();

}  // namespace pushback
