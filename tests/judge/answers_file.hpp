// Answers that learners might give, kept as text beside the tests:
//   == 1.1 | what the judge must say
//   the body's lines
#pragma once
#include <filesystem>
#include "check.hpp"
#include "text.hpp"

namespace nutshell::judge {

struct WrittenAnswer {
    Number number;
    std::string expected, body;
};

inline std::vector<WrittenAnswer> answers_in(const std::filesystem::path& file) {
    std::vector<WrittenAnswer> all;
    for (const auto& line : lines_of(read_text(file))) {
        if (starts_with(line, "#")) continue;
        if (!starts_with(line, "== ")) {
            if (all.empty()) throw std::runtime_error(file.string() + " begins without ==");
            all.back().body += "    " + line + "\n";
            continue;
        }
        const auto bar = line.find('|');
        const auto number = number_of(trimmed(line.substr(3, bar == std::string::npos ? bar : bar - 3)));
        if (!number) throw std::runtime_error(file.string() + ": no exercise in " + line);
        all.push_back({*number, bar == std::string::npos ? "" : trimmed(line.substr(bar + 1)), ""});
    }
    return all;
}

}  // namespace nutshell::judge
