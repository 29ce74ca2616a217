#include "cage.hpp"
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <cerrno>
#include <cstddef>
#include <vector>

namespace nutshell::judge {

namespace {

using Filter = std::vector<sock_filter>;

constexpr sock_filter load(std::size_t offset) {
    return {BPF_LD | BPF_W | BPF_ABS, 0, 0, static_cast<unsigned>(offset)};
}
constexpr sock_filter answer(unsigned what) {
    return {BPF_RET | BPF_K, 0, 0, what};
}
constexpr sock_filter unless_equal(std::size_t value, unsigned char skip) {
    return {BPF_JMP | BPF_JEQ | BPF_K, 0, skip, static_cast<unsigned>(value)};
}
constexpr unsigned refused = SECCOMP_RET_ERRNO | EPERM;
constexpr std::size_t number = offsetof(seccomp_data, nr), first = offsetof(seccomp_data, args);

/// This call is refused.
void refuse(Filter& filter, long call) {
    filter.insert(filter.end(), {unless_equal(static_cast<std::size_t>(call), 1), answer(refused)});
}
/// This call is refused unless its first argument is `own` (compared in its low half: it is a process id).
void refuse_unless(Filter& filter, long call, pid_t own) {
    filter.insert(filter.end(), {unless_equal(static_cast<std::size_t>(call), 4), load(first),
                                 unless_equal(static_cast<std::size_t>(own), 1), answer(SECCOMP_RET_ALLOW),
                                 answer(refused)});
}

}  // namespace

void close_cage() {
    const pid_t own = getpid();
    Filter filter{load(number)};
    refuse_unless(filter, __NR_kill, own);
    refuse_unless(filter, __NR_tgkill, own);  // raise() and abort()
    for (const long call : {__NR_tkill, __NR_rt_sigqueueinfo, __NR_rt_tgsigqueueinfo, __NR_pidfd_send_signal,
                            __NR_ptrace, __NR_process_vm_writev, __NR_setsid})
        refuse(filter, call);
#ifdef __NR_fork
    refuse(filter, __NR_fork);
    refuse(filter, __NR_vfork);
#endif
    // threads are welcome, processes are not; clone3 hides its flags, so libraries are sent to clone
    filter.insert(filter.end(), {unless_equal(__NR_clone3, 1), answer(SECCOMP_RET_ERRNO | ENOSYS)});
    filter.insert(filter.end(), {unless_equal(__NR_clone, 3),
                                 load(first),
                                 {BPF_JMP | BPF_JSET | BPF_K, 1, 0, CLONE_THREAD},
                                 answer(refused)});
    filter.push_back(answer(SECCOMP_RET_ALLOW));
    const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0) prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program);
}

}  // namespace nutshell::judge
