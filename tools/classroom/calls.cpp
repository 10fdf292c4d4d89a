#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/syscall.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "pushback/tools/classroom/sandbox.h"

namespace pushback {

namespace {

constexpr std::uint32_t own_architecture =
#if defined(__aarch64__)
    AUDIT_ARCH_AARCH64;
#else
    AUDIT_ARCH_X86_64;  // on other processors nothing runs in a sandbox, and grade says so
#endif

sock_filter step(int code, std::uint32_t value, int if_so = 0, int if_not = 0) {
  return {static_cast<std::uint16_t>(code), static_cast<std::uint8_t>(if_so), static_cast<std::uint8_t>(if_not), value};
}
sock_filter load(std::size_t offset) {
  return step(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset));
}
sock_filter end(std::uint32_t with) {
  return step(BPF_RET | BPF_K, with);
}
sock_filter refuse(std::uint32_t error) {
  return end(SECCOMP_RET_ERRNO | error);
}
/// The next step is for a value that passes the test. Others skip it.
sock_filter if_it(int test, std::uint32_t value) {
  return step(BPF_JMP | test | BPF_K, value, 0, 1);
}

}  // namespace

std::string refused_calls(bool one_process) {
  std::vector<long> memory{SYS_memfd_create, SYS_shmget, SYS_msgget, SYS_semget, SYS_mq_open};  // of no process
  std::vector<long> others{SYS_ptrace, SYS_process_vm_readv, SYS_process_vm_writev, SYS_perf_event_open};
  const std::vector<long> sandboxes{SYS_unshare, SYS_setns, SYS_mount, SYS_umount2, SYS_pivot_root, SYS_chroot};
  const std::vector<long> once_open{SYS_bpf,     SYS_userfaultfd, SYS_io_uring_setup,
                                    SYS_add_key, SYS_request_key, SYS_keyctl};
#ifdef SYS_memfd_secret
  memory.push_back(SYS_memfd_secret);
#endif
#ifdef SYS_fork
  if (one_process) others.insert(others.end(), {SYS_fork, SYS_vfork});
#endif
  // Calls of another kind of processor have other numbers, and so do the calls of x32, from 2^30 on.
  std::vector<sock_filter> steps{
      load(offsetof(seccomp_data, arch)), step(BPF_JMP | BPF_JEQ | BPF_K, own_architecture, 1, 0),
      end(SECCOMP_RET_KILL_PROCESS),      load(offsetof(seccomp_data, nr)),
      if_it(BPF_JGE, 1u << 30),           refuse(ENOSYS)};
  for (const auto& calls : {memory, others, sandboxes, once_open})
    for (const long call : calls)
      steps.insert(steps.end(), {if_it(BPF_JEQ, static_cast<std::uint32_t>(call)), refuse(EPERM)});
  // The flags of clone3 are in memory, where a filter cannot look: without clone3, the C library calls clone.
  steps.insert(steps.end(),
               {if_it(BPF_JEQ, SYS_clone3), refuse(ENOSYS), step(BPF_JMP | BPF_JEQ | BPF_K, SYS_clone, 1, 0),
                end(SECCOMP_RET_ALLOW), load(offsetof(seccomp_data, args))});
  if (one_process) steps.insert(steps.end(), {if_it(BPF_JSET, CLONE_THREAD), end(SECCOMP_RET_ALLOW), refuse(EPERM)});
  else steps.insert(steps.end(), {if_it(BPF_JSET, CLONE_NEWUSER), refuse(EPERM), end(SECCOMP_RET_ALLOW)});
  return {reinterpret_cast<const char*>(steps.data()), steps.size() * sizeof(sock_filter)};
}

}  // namespace pushback
