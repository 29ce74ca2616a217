#include "product.hpp"
#include <csignal>
#include <cstring>
#include <utility>
#include "text.hpp"

namespace nutshell::judge {

namespace fs = std::filesystem;

namespace {

/// Written when the making began.
fs::path note(const Product& product) {
    return product.file.string() + ".command";
}

}  // namespace

bool Product::is_fresh() const {
    std::error_code problem;
    const auto made = fs::last_write_time(note(*this), problem);
    if (problem || !fs::exists(file) || read_text(note(*this)) != joined(command, "\n")) return false;
    for (const fs::path& source : sources()) {
        const auto changed = fs::last_write_time(source, problem);
        if (problem || changed >= made) return false;
    }
    return true;
}

Ran Product::make() const {
    std::error_code ignored;
    fs::remove(file, ignored);
    write_text(note(*this), joined(command, "\n"));  // before: what is saved meanwhile makes it stale again
    Ran ran = run(command, limits);
    if (const std::string fault = fault_in(ran.err); ran.exit_code != 0 && !fault.empty())
        throw MachineFault("the compiler was let down by the machine: " + fault);
    if (ran.out_of_time && ran.signal != SIGXCPU)
        throw MachineFault(
            "the compiler was given too little of the machine's time, and stopped. Is something else "
            "at work here? Then check again");
    if (ran.signal != 0 && !ran.out_of_time && !ran.printed_too_much)
        throw MachineFault(std::string("the compiler was ended by a signal (") + strsignal(ran.signal) +
                           "): that is no fault of an answer. Check again");
    return ran;
}

std::vector<fs::path> Product::sources() const {
    const fs::path list = file.string() + ".d";
    if (!fs::exists(list)) return {list};  // unknown: not fresh
    std::vector<fs::path> all;
    for (const auto& word : command)  // what is linked; the file itself is none of it
        if (const fs::path linked = word;
            linked != file && (linked.extension() == ".o" || linked.extension() == ".a"))
            all.push_back(linked);
    std::string text = replaced(read_text(list), "\\\n", " "), word;
    for (std::size_t i = text.find(": ") + 1; i < text.size(); ++i) {
        if (text[i] == '\\' && i + 1 < text.size())
            word += text[++i];
        else if (text[i] != ' ' && text[i] != '\n')
            word += text[i];
        else if (!word.empty())
            all.emplace_back(std::exchange(word, ""));
    }
    return all;
}

}  // namespace nutshell::judge
