#include "process.hpp"
#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
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
#include <stdexcept>

namespace nutshell::judge {

namespace {

using Clock = std::chrono::steady_clock;

struct Pipe {
    int read = -1, write = -1;
    Pipe() {
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) != 0)
            throw std::runtime_error(std::string("cannot make a pipe: ") + std::strerror(errno));
        read = ends[0], write = ends[1];
    }
    ~Pipe() {
        close(read);
        close_write();
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    void close_write() {
        if (write >= 0) close(write);
        write = -1;
    }
};

void limit(int which, rlim_t value, rlim_t grace = 0) {
    const rlimit both{value, value + grace};
    setrlimit(static_cast<__rlimit_resource>(which), &both);
}

[[noreturn]] void become(const std::vector<char*>& words, const Limits& limits, int out, int err, int extra) {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    signal(SIGPIPE, SIG_DFL);
    signal(SIGINT, SIG_DFL);
    const int nothing = open("/dev/null", O_RDONLY);
    // first out of the way of 0..3, then into place
    const int safe_extra = fcntl(extra, F_DUPFD_CLOEXEC, 100), safe_out = fcntl(out, F_DUPFD_CLOEXEC, 100),
              safe_err = fcntl(err, F_DUPFD_CLOEXEC, 100);
    dup2(nothing, 0);
    dup2(safe_out, 1);
    dup2(safe_err, 2);
    dup2(safe_extra, pipe_number);
    for (int other = pipe_number + 1; other < 64; ++other) close(other);
    setenv("LC_ALL", "C", 1);  // a compiler's messages in the one form that explain() reads
    // Last, for they are meant for the program to come: with sanitizers this one is far beyond them.
    limit(RLIMIT_CORE, 0);
    if (limits.cpu_seconds) limit(RLIMIT_CPU, limits.cpu_seconds, 1);  // SIGXCPU, and a second later SIGKILL
    if (limits.memory) limit(RLIMIT_AS, limits.memory);
    execvp(words[0], words.data());
    _exit(127);
}

}  // namespace

Ran run(const std::vector<std::string>& words, const Limits& limits) {
    std::vector<char*> arguments;
    for (const auto& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);

    Ran ran;
    Pipe out, err, extra;
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("cannot start " + words[0] + ": " + std::strerror(errno));
    if (child == 0) become(arguments, limits, out.write, err.write, extra.write);
    setpgid(child, child);  // both sides set it: whoever is first
    out.close_write(), err.close_write(), extra.close_write();

    struct Stream {
        int file;
        std::string* kept;
        std::size_t most, seen = 0;
        bool open = true;
    };
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
            Stream& stream = streams[i];
            if (!stream.open || !(polled[i].revents & (POLLIN | POLLHUP))) continue;
            const auto count = read(stream.file, buffer.data(), buffer.size());
            if (count <= 0) {
                stream.open = false;
                continue;
            }
            any = true;
            const auto bytes = static_cast<std::size_t>(count);
            stream.seen += bytes;
            stream.kept->append(buffer.data(),
                                std::min(bytes, stream.most - std::min(stream.most, stream.kept->size())));
            if (stream.seen > 16 * stream.most && !killed) {
                ran.printed_too_much = true;
                stop();
            }
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
    ran.seconds = static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
                  1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
    if (WIFEXITED(status))
        ran.exit_code = WEXITSTATUS(status);
    else
        ran.signal = WTERMSIG(status);
    if (ran.signal == SIGXCPU) ran.out_of_time = true;
    return ran;
}

Lock::Lock(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    file_ = open((folder / "lock").c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666);
    if (file_ >= 0) flock(file_, LOCK_EX);
}

Lock::~Lock() {
    if (file_ >= 0) close(file_);
}

}  // namespace nutshell::judge
