// What the text of a wrong answer tells by itself: slips of C++ that no formula can explain.
#pragma once
#include <optional>
#include <string>
#include <utility>
#include "sheets.hpp"

namespace nutshell::judge {

using Clue = std::pair<std::string, std::string>;  ///< a few words for the table; the sentence

/// A division of two whole numbers that does not come out even: 1 / 2 is 0.
std::optional<Clue> whole_division(const std::string& body);
/// A number put into an int although it has a fraction, by the compiler's notes on a body of this source.
std::optional<Clue> lost_fraction(const std::vector<Warning>& warnings, const Marked& source);
/// A comma that throws a value away, such as that of 0,5.
std::optional<Clue> comma_between(const std::vector<Warning>& warnings, const Marked& source);
/// Answers that change from one asking to the next.
std::optional<Clue> two_answers(const SheetAnswer& answer);

}  // namespace nutshell::judge
