#include "little_book.hpp"

#include <sys/wait.h>

#include <unistd.h>
#include <atomic>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace book_test {
namespace fs = std::filesystem;

std::string read_text(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in) throw std::runtime_error("cannot read " + path.string());
    return text.str();
}

void write_text(const fs::path& path, const std::string& text) {
    fs::create_directories(path.parent_path());
    std::ofstream out(path, std::ios::binary);
    out << text;
    if (!out.flush()) throw std::runtime_error("cannot write " + path.string());
}

Said run(const std::string& command) {
    FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    if (!pipe) throw std::runtime_error("cannot run " + command);
    std::string text;
    char buffer[4096];
    for (std::size_t n; (n = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) text.append(buffer, n);
    const int status = pclose(pipe);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text};
}

namespace {

// One white pixel.
const unsigned char pixel[] = {
    0x89, 'P',  'N',  'G',  '\r', '\n', 0x1a, '\n', 0,    0,    0,    13,   'I',  'H',  'D',  'R',  0,
    0,    0,    1,    0,    0,    0,    1,    8,    0,    0,    0,    0,    0x3a, 0x7e, 0x9b, 0x55, 0,
    0,    0,    10,   'I',  'D',  'A',  'T',  0x78, 0x9c, 0x63, 0xf8, 0x0f, 0x00, 0x01, 0x01, 0x01, 0x00,
    0x1b, 0xb6, 0xee, 0x56, 0,    0,    0,    0,    'I',  'E',  'N',  'D',  0xae, 0x42, 0x60, 0x82};

const char* const source = R"(#pragma once

// [step]
/// One step.
inline int step(int x) {
    // exercise 1.1
    return x + 1;
    // end 1.1
}
// [/step]

// [other]
/// Another.
inline int other(int x) {
    // exercise 1.2
    return x - 1;
    // end 1.2
}
// [/other]

// [labelled]
/// Eq. (1.b) solved for x.
inline int labelled();
// [/labelled]

// [open]
inline int never_closed();
)";

const char* const numbers = R"(# command: a test
name,value,unit
turn,-0.0010345678901234567,rad
steps,16000,
share,0.0123,
"odd, name",2.5,m/s^2
nothing,nan,
)";

const char* const chart =
    R"(<svg xmlns='http://www.w3.org/2000/svg' class='chart' id='chart-NAME-1' viewBox='0 0 64 44'>
<style>#chart-NAME-1 text{fill:var(--ink)}</style><text x='1' y='9'>NAME</text></svg>
)";

std::string named(std::string text, const std::string& name) {
    for (std::size_t at; (at = text.find("NAME")) != std::string::npos;) text.replace(at, 4, name);
    return text;
}

}  // namespace

LittleBook::LittleBook() {
    static std::atomic<int> count{0};
    folder_ = fs::temp_directory_path() /
              ("little book_" + std::to_string(getpid()) + "_" + std::to_string(++count));
    write("pages/errata.csv",
          "id,where,printed,correct,severity,lives\n"
          "E05,eq. 11,$F = 0$,\"$F = 1$, exactly\",inaccurate,page: 01_first#eq:11star\n");
    write("src/code.hpp", source);
    write("results/01_first/numbers.csv", numbers);
    write("results/01_first/one.svg", named(chart, "one"));
    write("results/01_first/two.svg", named(chart, "two"));
    write("results/01_first/planet.png", std::string(reinterpret_cast<const char*>(pixel), sizeof pixel));
    write("results/01_first/planet.txt",
          "drawn: 1 x 1\ncommand: bin/01_first --out results/01_first\nmethod: Verlet\n");
    write("results/01_first/gone.txt", "drawn: 1 x 1\ncommand: ./course run 1\n");
    write("results/01_first/dark.txt", "not drawn: no OpenGL here\ncommand: ./course run 1\n");
}

LittleBook::~LittleBook() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

void LittleBook::write(const std::string& file, const std::string& text) const {
    write_text(folder_ / file, text);
}

Said LittleBook::weave() const {
    const std::string f = "'" + folder_.string();
    return run("'" PROJECT_DIR "/book/build.sh' --pages " + f + "/pages' --results " + f +
               "/results' --root " + f + "' --out " + f + "/out'");
}

std::string LittleBook::page(const std::string& name) const {
    return file(name + ".html");
}

std::string LittleBook::file(const std::string& name) const {
    return read_text(folder_ / "out" / name);
}

}  // namespace book_test
