// The machine's own faults: a full disk, a folder that cannot be written to, a missing tool.
#pragma once
#include <filesystem>
#include <stdexcept>
#include <string>

namespace nutshell::judge {

/// What is neither the learner's fault nor the course's. It ends the program with exit status 3.
struct MachineFault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// If a tool's words say that the machine let it down, those words. Empty if not.
std::string fault_in(const std::string& said);

/// While it lives no other process gets past this line for the same folder. The lock goes with the process.
class Lock {
  public:
    /// Waits for its turn and says that it waits. @throws MachineFault if the folder cannot be written to
    explicit Lock(const std::filesystem::path& folder);
    ~Lock();
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;

  private:
    int file_;
};

}  // namespace nutshell::judge
