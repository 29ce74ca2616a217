// Compares what an answer gave with what is right, and says in plain words what is wrong.
#pragma once
#include <optional>
#include <string>
#include <vector>
#include "record.hpp"

namespace nutshell::judge {

/// An answer passes when every output is within this of the reference, relative to the largest term that
/// enters it.
inline constexpr double tolerance = 1e-9;
/// Mistakes of one exercise must differ by this from the truth and from each other.
inline constexpr double telling = 1e-4;

/// The largest difference of two records, relative to the scales of `reference`; infinite if one is not
/// finite where the other is, or if they have not the same outputs.
double difference(const exercises::Record& reference, const exercises::Record& a, const exercises::Record& b);
/// `reference` with its values replaced by those of an answer, as far as these go.
exercises::Record with_values(exercises::Record reference, const std::vector<std::vector<double>>& values);

struct Diagnosis {
    bool right = false;
    std::string name;                ///< "dt twice", "wrong sign": a few words for a table
    std::vector<std::string> words;  ///< sentences, the most telling first
    std::string origin;              ///< of a known mistake
    std::string seen;                ///< the input that shows it first
    std::string output, yours, expected;
};

/// @param yours  values by output, all of them
/// @param other_states  whether questions about states of other types were asked
Diagnosis diagnose(const exercises::Exercise& exercise, const exercises::Record& reference,
                   const std::vector<std::vector<double>>& yours, bool other_states = true);

}  // namespace nutshell::judge
