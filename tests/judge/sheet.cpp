// The sheet: a learner's answers as a program of their own. It answers the questions of one exercise and
// writes raw numbers to a pipe. It holds no reference and no verdict. The judge compiles it on the learner's
// header:
//   NUTSHELL_SHEET      is defined: exercise files show their questions only
//   NUTSHELL_EXERCISES  names a file that includes the exercises to be asked
// usage: sheet EXERCISE FD, or for a debugger: sheet EXERCISE debug OUTPUTS
#include NUTSHELL_EXERCISES
#include <fcntl.h>
#include <unistd.h>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>

namespace nutshell::exercises {

namespace {

int pipe_to_judge = -1;
char again = 'v';          // the letter of the numbers
std::uint64_t secret = 0;  // what the judge gave main: records without it are not the sheet's

void write_all(const void* data, std::size_t size) {
    if (pipe_to_judge < 0) return;  // under a debugger nobody listens
    for (const char* at = static_cast<const char*>(data); size > 0;) {
        const auto count = write(pipe_to_judge, at, size);
        if (count <= 0) _exit(3);
        at += count, size -= static_cast<std::size_t>(count);
    }
}

/// One record: a letter, the secret, the length of what follows, and that.
/// v: numbers of one output   w: the same, asked once more   u: the body of exercise ... is not answered
/// x: an exception says ...   e: the end
void record(char letter, const void* data, std::size_t size) {
    const auto length = static_cast<std::uint32_t>(size);
    std::vector<char> bytes(1 + sizeof secret + sizeof length + size);
    bytes[0] = letter;
    std::memcpy(&bytes[1], &secret, sizeof secret);
    std::memcpy(&bytes[1 + sizeof secret], &length, sizeof length);
    if (size) std::memcpy(&bytes[1 + sizeof secret + sizeof length], data, size);
    write_all(bytes.data(), bytes.size());
}

struct Entry {
    const char* id;
    void (*ask)(Paper&, bool once_more);
};
std::vector<Entry>& entries() {
    static std::vector<Entry> all;
    return all;
}

}  // namespace

/// A debugger stops here, before the input that fails.
extern "C" __attribute__((noinline)) void failing_input_is_next() {
    asm volatile("");
}

static long outputs_until_failure = -1;

void send(const std::vector<double>& values) {
    if (--outputs_until_failure == 0) failing_input_is_next();
    record(again, values.data(), values.size() * sizeof(double));
}

bool enter(const char* id, void (*ask)(Paper&, bool once_more)) {
    entries().push_back({id, ask});
    return true;
}

static int answer_sheet(const char* id) {
    for (const Entry& entry : entries()) {
        if (std::strcmp(entry.id, id) != 0) continue;
        try {
            Paper paper;
            entry.ask(paper, false);
            again = 'w';
            entry.ask(paper, true);
        } catch (const Unanswered& body) {
            record('u', body.exercise, std::strlen(body.exercise));
        } catch (const std::exception& problem) {
            record('x', problem.what(), std::strlen(problem.what()));
        } catch (...) {
            record('x', "something that is no std::exception", 35);
        }
        record('e', nullptr, 0);
        return 0;
    }
    return 2;
}

}  // namespace nutshell::exercises

int main(int argc, char** argv) {
    using namespace nutshell::exercises;
    if (argc == 4) {  // sheet EXERCISE debug OUTPUTS: those that are right before the failing input
        outputs_until_failure = std::atol(argv[3]);
        if (outputs_until_failure == 0) failing_input_is_next();
        return answer_sheet(argv[1]);
    }
    if (argc != 3) return 2;
    const int given = std::atoi(argv[2]);
    pipe_to_judge = fcntl(given, F_DUPFD_CLOEXEC, 200);  // out of the way of an answer's own files
    close(given);
    write_all("r", 1);  // ready: only now the judge hands over the secret
    if (read(0, &secret, sizeof secret) != sizeof secret) return 2;
    return answer_sheet(argv[1]);
}
