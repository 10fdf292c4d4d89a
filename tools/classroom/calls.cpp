#include "pushback/tools/classroom/calls.h"

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/syscall.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pushback {

namespace {

constexpr std::array refused{// Memory that stands in no process's account and in no folder.
                             SYS_memfd_create, SYS_shmget, SYS_msgget, SYS_semget, SYS_mq_open,
#ifdef SYS_memfd_secret
                             SYS_memfd_secret,
#endif
                             // Other processes.
                             SYS_ptrace, SYS_process_vm_readv, SYS_process_vm_writev, SYS_perf_event_open,
                             // Sandboxes in the sandbox, with folders of their own.
                             SYS_unshare, SYS_setns, SYS_mount, SYS_umount2, SYS_pivot_root, SYS_chroot,
                             // What has opened doors in the kernel before, and no answer needs.
                             SYS_bpf, SYS_userfaultfd, SYS_io_uring_setup, SYS_add_key, SYS_request_key, SYS_keyctl};

[[maybe_unused]] constexpr std::uint32_t own_architecture =
#if defined(__aarch64__)
    AUDIT_ARCH_AARCH64;
#else
    AUDIT_ARCH_X86_64;
#endif

sock_filter step(int code, std::uint32_t value, int if_so = 0, int if_not = 0) {
  return {static_cast<std::uint16_t>(code), static_cast<std::uint8_t>(if_so), static_cast<std::uint8_t>(if_not), value};
}

}  // namespace

std::string filter_of_calls() {
  const auto load = [](std::size_t offset) {
    return step(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset));
  };
  const auto end = [](std::uint32_t with) { return step(BPF_RET | BPF_K, with); };
  const auto refuse = [&](int error) { return end(SECCOMP_RET_ERRNO | static_cast<std::uint32_t>(error)); };
  const auto unless = [](int test, std::uint32_t value) { return step(BPF_JMP | test | BPF_K, value, 0, 1); };
  // Calls of another kind of processor have other numbers; so have those of x32, from 2^30 on.
  std::vector<sock_filter> steps{
      load(offsetof(seccomp_data, arch)), step(BPF_JMP | BPF_JEQ | BPF_K, own_architecture, 1, 0),
      end(SECCOMP_RET_KILL_PROCESS),      load(offsetof(seccomp_data, nr)),
      unless(BPF_JGE, 1u << 30),          refuse(ENOSYS)};
  for (const long call : refused) {
    steps.push_back(unless(BPF_JEQ, static_cast<std::uint32_t>(call)));
    steps.push_back(refuse(EPERM));
  }
  // Its flags stand in memory, where a filter cannot look; who is told that there is no such call takes clone.
  steps.push_back(unless(BPF_JEQ, SYS_clone3));
  steps.push_back(refuse(ENOSYS));
  steps.push_back(step(BPF_JMP | BPF_JEQ | BPF_K, SYS_clone, 0, 3));
  steps.push_back(load(offsetof(seccomp_data, args)));
  steps.push_back(unless(BPF_JSET, CLONE_NEWUSER));
  steps.push_back(refuse(EPERM));
  steps.push_back(end(SECCOMP_RET_ALLOW));
  return {reinterpret_cast<const char*>(steps.data()), steps.size() * sizeof(sock_filter)};
}

}  // namespace pushback
