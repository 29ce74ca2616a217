#include <unistd.h>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <nutshell/write_file.hpp>
#include <stdexcept>

namespace nutshell {

void write_file(const std::filesystem::path& path, std::string_view text) {
    const auto fail = [&](const std::string& what, int reason) {
        throw std::runtime_error("cannot " + what + ": " + std::strerror(reason) +
                                 ". Choose another folder with --out, or make room");
    };
    std::error_code problem;
    if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), problem);
    if (problem) fail("make the folder " + path.parent_path().string(), problem.value());
    const std::filesystem::path half = path.string() + ".part" + std::to_string(getpid());
    std::FILE* file = std::fopen(half.c_str(), "wb");
    if (!file) fail("write " + path.string(), errno);
    const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
    const int reason = errno;
    const bool closed = std::fclose(file) == 0;
    if (!written || !closed) {
        std::filesystem::remove(half, problem);
        fail("write " + path.string(), written ? errno : reason);
    }
    std::filesystem::rename(half, path, problem);
    if (problem) {
        const int code = problem.value();
        std::filesystem::remove(half, problem);
        fail("write " + path.string(), code);
    }
}

}  // namespace nutshell
