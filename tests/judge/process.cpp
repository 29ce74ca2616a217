#include "process.hpp"
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include "cage.hpp"

namespace nutshell::judge {

namespace {

using Clock = std::chrono::steady_clock;

struct Pipe {
    int read = -1, write = -1;
    Pipe() {
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) != 0)
            throw MachineFault(std::string("cannot make a pipe: ") + std::strerror(errno));
        read = ends[0], write = ends[1];
    }
    ~Pipe() {
        close_end(read);
        close_end(write);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    static void close_end(int& end) {
        if (end >= 0) close(end);
        end = -1;
    }
};

void limit(int which, rlim_t value, rlim_t grace = 0) {
    const rlimit both{value, value + grace};
    setrlimit(static_cast<__rlimit_resource>(which), &both);
}

[[noreturn]] void become(const std::vector<char*>& words, const Limits& limits, int in, int out, int err,
                         int extra, int failed) {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    signal(SIGPIPE, SIG_DFL);
    signal(SIGINT, SIG_DFL);
    // first out of the way of 0..3, then into place
    std::array<int, 4> safe{};
    const std::array<int, 4> ends{in, out, err, extra};
    for (std::size_t i = 0; i < 4; ++i) safe[i] = fcntl(ends[i], F_DUPFD_CLOEXEC, 100);
    const int tell = fcntl(failed, F_DUPFD_CLOEXEC, 100);
    for (std::size_t i = 0; i < 4; ++i) dup2(safe[i], static_cast<int>(i));
    for (int other = pipe_number + 1; other < 64; ++other) close(other);
    setenv("LC_ALL", "C", 1);  // a compiler's messages in the one form that explain() reads
    // Last, for they are meant for the program to come: with sanitizers this one is far beyond them.
    limit(RLIMIT_CORE, 0);
    if (limits.cpu_seconds) limit(RLIMIT_CPU, limits.cpu_seconds, 1);  // SIGXCPU, and a second later SIGKILL
    if (limits.memory) limit(RLIMIT_AS, limits.memory);
    if (limits.caged) close_cage();
    execvp(words[0], words.data());
    const int reason = errno;
    if (write(tell, &reason, sizeof reason) < 0) _exit(126);
    _exit(127);
}

/// Ends what a child of ours started and left behind: it has become a child of ours in its turn.
void end_those_left_behind() {
    const std::string children = "/proc/self/task/" + std::to_string(gettid()) + "/children";
    for (int round = 0; round < 100; ++round) {
        std::ifstream list(children);
        bool any = false;
        for (pid_t left; list >> left; any = true) {
            kill(left, SIGKILL);
            waitpid(left, nullptr, 0);
        }
        if (!any) return;
    }
}

/// What a child writes, kept up to a limit.
struct Stream {
    int file;
    std::string* kept;
    std::size_t most, seen = 0;
    bool open = true;

    /// @return whether anything came
    bool take(std::vector<char>& buffer) {
        const auto count = read(file, buffer.data(), buffer.size());
        if (count <= 0) return open = false;
        const auto bytes = static_cast<std::size_t>(count);
        seen += bytes;
        kept->append(buffer.data(), std::min(bytes, most - std::min(most, kept->size())));
        return true;
    }
};

}  // namespace

Ran run(const std::vector<std::string>& words, const Limits& limits) {
    std::vector<char*> arguments;
    for (const auto& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);

    signal(SIGPIPE, SIG_IGN);  // a program that ends before it is told is seen by what write() gives
    Ran ran;
    Pipe in, out, err, extra, failed;
    if (limits.caged) prctl(PR_SET_CHILD_SUBREAPER, 1);
    const pid_t child = fork();
    if (child < 0) throw MachineFault("cannot start " + words[0] + ": " + std::strerror(errno));
    if (child == 0) become(arguments, limits, in.read, out.write, err.write, extra.write, failed.write);
    setpgid(child, child);  // both sides set it: whoever is first
    for (int* end : {&in.read, &out.write, &err.write, &extra.write, &failed.write}) Pipe::close_end(*end);
    if (limits.reply.empty()) Pipe::close_end(in.write);

    std::array<Stream, 3> streams{{{out.read, &ran.out, limits.printed},
                                   {err.read, &ran.err, limits.printed},
                                   {extra.read, &ran.pipe, 64 * 1024 * 1024}}};
    const auto end = Clock::now() + std::chrono::duration<double>(limits.wall_seconds);
    bool killed = false;
    const auto stop = [&] {
        kill(-child, SIGKILL);
        killed = true;
    };
    std::vector<char> buffer(65536);
    int status = 0;
    rusage used{};
    bool gone = false;
    // until it has gone and its pipes are empty; a grandchild that keeps a pipe open is not waited for
    for (;;) {
        std::array<pollfd, 3> polled{};
        for (std::size_t i = 0; i < 3; ++i) polled[i] = {streams[i].open ? streams[i].file : -1, POLLIN, 0};
        const bool listening = streams[0].open || streams[1].open || streams[2].open;
        poll(polled.data(), polled.size(), gone ? 0 : listening ? 20 : 1);
        bool any = false;
        for (std::size_t i = 0; i < 3; ++i) {
            if (!streams[i].open || !(polled[i].revents & (POLLIN | POLLHUP))) continue;
            any = streams[i].take(buffer) || any;
            if (streams[i].seen > 16 * streams[i].most && !killed) {
                ran.printed_too_much = true;
                stop();
            }
        }
        if (in.write >= 0 && streams[2].seen > 0) {
            if (write(in.write, limits.reply.data(), limits.reply.size()) < 0) stop();
            Pipe::close_end(in.write);
        }
        if (!gone && wait4(child, &status, WNOHANG, &used) == child)
            gone = true;
        else if (gone && !any)
            break;
        if (!gone && !killed && Clock::now() > end) {
            ran.out_of_time = true;
            stop();
        }
    }
    kill(-child, SIGKILL);  // whatever it left behind
    if (limits.caged) end_those_left_behind();
    if (int reason = 0; read(failed.read, &reason, sizeof reason) == sizeof reason)
        throw MachineFault("cannot start " + words[0] + ": " + std::strerror(reason));
    ran.seconds = static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
                  1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
    if (WIFEXITED(status))
        ran.exit_code = WEXITSTATUS(status);
    else
        ran.signal = WTERMSIG(status);
    if (ran.signal == SIGXCPU) ran.out_of_time = true;
    return ran;
}

}  // namespace nutshell::judge
