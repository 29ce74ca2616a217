// What the numbers of a wrong answer tell of the slip behind them. Each of these looks for one kind of slip
// in all answers together, and is silent unless it explains all that is wrong.
#pragma once
#include <optional>
#include "compare.hpp"

namespace nutshell::judge {

/// The answers of one learner to one exercise, beside the truth.
struct Evidence {
    const exercises::Exercise& exercise;
    const exercises::Record& reference;
    const std::vector<Values>& yours;  ///< as many as there are outputs
    std::vector<std::size_t> wrong;    ///< outputs that are wrong; one at least
};

struct Finding {
    std::string name;  ///< a few words for the table
    std::vector<std::string> words;
    std::optional<std::size_t> show = {};  ///< the output that shows it best; else the first that is wrong
};

std::optional<Finding> wrong_size(const Evidence& evidence);
std::optional<Finding> not_finite(const Evidence& evidence);    ///< from the first wrong output on
std::optional<Finding> nearly_right(const Evidence& evidence);  ///< to some digits only
/// What should change, or comes from an argument, is still as it was handed in.
std::optional<Finding> nothing_changed(const Evidence& evidence);
/// Zero, or no change, where there should be some, and some where there should be none.
std::optional<Finding> something_and_nothing_exchanged(const Evidence& evidence);
std::optional<Finding> made_of_length_one(const Evidence& evidence);
std::optional<Finding> right_direction(const Evidence& evidence);
std::optional<Finding> exchanged_outputs(const Evidence& evidence);
std::optional<Finding> wrong_sign_somewhere(const Evidence& evidence);
std::optional<Finding> wrong_frame(const Evidence& evidence);
std::optional<Finding> exchanged_components(const Evidence& evidence);
std::optional<Finding> ignored_argument(const Evidence& evidence);
std::optional<Finding> one_factor(const Evidence& evidence);  ///< of the values, or of their change
std::optional<Finding> one_offset(const Evidence& evidence);
/// Right for all inputs but those where an argument is zero, negative, small or large.
std::optional<Finding> wrong_somewhere(const Evidence& evidence);
/// Wrong, or right, only for inputs whose numbers have something in common.
std::optional<Finding> special_inputs(const Evidence& evidence);
/// From the runs at h, h/2 and h/4: does the error against the exact solution shrink, and how fast?
std::optional<Finding> wrong_order(const Evidence& evidence);

/// Beside a formula that is not known: where it is right, and along or across which argument it is wrong.
std::vector<std::string> where_and_along(const Evidence& evidence);
/// All answers of the first name that is wrong, runs left out: their places.
std::vector<std::size_t> of_first_wrong_name(const Evidence& evidence);
/// What may be said beside any of them: which outputs, components and inputs are right.
std::vector<std::string> what_is_right(const Evidence& evidence, bool explained);

std::string without_unit(const std::string& name);
std::string capital(std::string text);

}  // namespace nutshell::judge
