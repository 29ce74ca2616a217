// Compares what an answer gave with what is right, and says in plain words what is wrong.
#pragma once
#include "compare.hpp"

namespace nutshell::judge {

/// `reference` with its values replaced by those of an answer, as far as these go.
exercises::Record with_values(exercises::Record reference, const std::vector<Values>& values);

struct Diagnosis {
    bool right = false;
    std::string name;                ///< "dt twice", "wrong sign": a few words for a table
    std::vector<std::string> words;  ///< sentences, the most telling first
    std::string origin = {};         ///< of a known mistake
    std::string seen;                ///< the input that shows it first
    std::string output, yours, expected;
};

/// @param yours  values by output, all of them
/// @param beyond  whether the questions that go beyond what the function must do were asked
Diagnosis diagnose(const exercises::Exercise& exercise, const exercises::Record& reference,
                   const std::vector<Values>& yours, bool beyond = true);

}  // namespace nutshell::judge
