#include "machine.hpp"
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#include <cerrno>
#include <cstring>
#include <iostream>
#include "text.hpp"

namespace nutshell::judge {

std::string fault_in(const std::string& said) {
    for (const auto& line : lines_of(said))
        for (const auto* sign :
             {"No space left on device", "Read-only file system", "Disk quota exceeded",
              "cannot create temporary file", "Cannot create temporary file", "error writing to",
              "virtual memory exhausted", "Cannot allocate memory", " signal terminated program"})
            // templates without end, or brackets in brackets without end, are the learner's
            if (contains(line, sign) && !contains(line, "CPU time limit exceeded") &&
                !contains(line, "Segmentation fault"))
                return line;
    return "";
}

Lock::Lock(const std::filesystem::path& folder) {
    std::error_code problem;
    std::filesystem::create_directories(folder, problem);
    file_ = open((folder / "lock").c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666);
    if (file_ < 0) throw MachineFault("cannot write to " + folder.string() + ": " + std::strerror(errno));
    if (flock(file_, LOCK_EX | LOCK_NB) == 0) return;
    std::cerr << "course: another check is at work here: waiting for it\n";
    flock(file_, LOCK_EX);
}

Lock::~Lock() {
    close(file_);
}

}  // namespace nutshell::judge
