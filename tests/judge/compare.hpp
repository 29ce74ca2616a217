// Numbers of an answer beside those of the truth.
#pragma once
#include <string>
#include <vector>
#include "record.hpp"

namespace nutshell::judge {

using Values = std::vector<double>;

/// An answer passes when every output is within this of the reference, relative to the largest term that
/// enters it.
inline constexpr double tolerance = 1e-9;
/// Mistakes of one exercise must differ by this from the truth and from each other.
inline constexpr double telling = 1e-4;

/// How far `yours` is from `right`, in units of the output's scale; infinite if one is not finite where the
/// other is, or if there are not as many.
double apart(const exercises::Output& output, const Values& right, const Values& yours);
/// The largest such difference of two records whose outputs are those of `reference`.
double difference(const exercises::Record& reference, const exercises::Record& a, const exercises::Record& b);

/// Whether an answer is right.
bool agrees(const exercises::Record& reference, const std::vector<Values>& yours);

bool finite(const Values& values);
double distance(const Values& a, const Values& b);  ///< Euclidean
/// "1.25" or "(1, 2.5, -3)", with as many digits as tell them apart from `other`; of many numbers the nine
/// where they first differ from `other`.
/// @param matrix  nine numbers by columns: three rows, the second and third on lines of their own
std::string shown(const Values& values, const Values& other = {}, bool matrix = false);
std::string digits(double value, const char* format = "%.9g");

}  // namespace nutshell::judge
