// Signatures of directions and of time: wrong axes, exchanged components, a wrong order in the step.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nutshell/vector.hpp>
#include "signatures.hpp"

namespace nutshell::judge {

using exercises::Output;

namespace {

using Map3 = Eigen::Map<const Matrix3>;

Values values_of(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
    return {matrix.data(), matrix.data() + matrix.size()};
}

/// What a slip of axes makes of a right value; empty where it does not apply.
using Slip = Values (*)(const Output&);
struct NamedSlip {
    const char *name, *sentence;
    Slip slip;
};

Values turned(const Output& output, int times) {
    if (output.frame.empty()) return {};
    Matrix3 turn = Matrix3::Identity();
    const Matrix3 once =
        times < 0 ? Matrix3(Map3(output.frame.data()).transpose()) : Matrix3(Map3(output.frame.data()));
    for (int i = 0; i < std::abs(times); ++i) turn = turn * once;
    if (output.values.size() == 3) return values_of(turn * Eigen::Map<const Vector3>(output.values.data()));
    if (output.values.size() == 9) return values_of(turn * Map3(output.values.data()) * turn.transpose());
    return {};
}

constexpr NamedSlip slips[] = {
    {"wrong frame: body axes",
     "It is right, but in the wrong axes: its components are along the body's own axes where those of the "
     "world belong, or it was turned by the inverse of the orientation once too often.",
     [](const Output& output) { return turned(output, -1); }},
    {"wrong frame: world axes",
     "It is right, but in the wrong axes: it was turned by the orientation once too often, or its components "
     "are along the world's axes where those of the body belong.",
     [](const Output& output) { return turned(output, 1); }},
    {"turned the wrong way",
     "It is turned the wrong way: by the inverse of the orientation where the orientation belongs, or the "
     "other way round.",
     [](const Output& output) { return turned(output, -2); }},
    {"turned the wrong way",
     "It is turned the wrong way: by the orientation where its inverse belongs, or the other way round.",
     [](const Output& output) { return turned(output, 2); }},
    {"the transpose",
     "It is the transpose of the right matrix; of a rotation that is its inverse. Rows and columns are "
     "exchanged, or the rotation goes the other way.",
     [](const Output& output) {
         return output.values.size() == 9 ? values_of(Map3(output.values.data()).transpose()) : Values{};
     }},
    {"the inverse rotation",
     "It is the inverse of the right rotation: the vector part has the wrong sign. Is the angle or the axis "
     "turned round, or one orientation taken relative to the other the wrong way?",
     [](const Output& output) {
         const Values& q = output.values;
         return output.quaternion ? Values{-q[0], -q[1], -q[2], q[3]} : Values{};
     }},
    {"the quaternion's numbers in another order",
     "The four numbers are right and their order is not: Eigen's constructor takes w first, its coeffs() "
     "give it last.",
     [](const Output& output) {
         const Values& q = output.values;
         return output.quaternion ? Values{q[3], q[0], q[1], q[2]} : Values{};
     }},
    {"the quaternion's numbers in another order",
     "The four numbers are right and their order is not: Eigen's constructor takes w first, its coeffs() "
     "give it last.",
     [](const Output& output) {
         const Values& q = output.values;
         return output.quaternion ? Values{q[1], q[2], q[3], q[0]} : Values{};
     }},
};

/// Whether this slip explains every wrong output that it could meet, and all that is wrong.
bool explains(const Evidence& evidence, Slip slip) {
    return std::all_of(evidence.wrong.begin(), evidence.wrong.end(), [&](std::size_t i) {
        const Output& output = evidence.reference.outputs[i];
        const Values would_be = slip(output);
        return !would_be.empty() && apart(output, would_be, evidence.yours[i]) <= 1e-8;
    });
}

/// The least power of dt with which the difference of single steps from the right ones shrinks.
std::optional<double> local_power(const Evidence& evidence) {
    const auto& inputs = evidence.reference.inputs;
    const auto& outputs = evidence.reference.outputs;
    std::map<std::pair<std::string, std::size_t>, std::array<double, 3>>
        all;  // by name and place in its level
    std::array<std::size_t, 3> first_input{};
    for (std::size_t i = inputs.size(); i-- > 0;) first_input[static_cast<std::size_t>(inputs[i].level)] = i;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const Output& output = outputs[i];
        if (!output.exact.empty() || !finite(evidence.yours[i])) continue;
        const auto level = static_cast<std::size_t>(output.level);
        auto& at =
            all.try_emplace({output.name, output.input - first_input[level]}, std::array{-1., -1., -1.})
                .first->second;
        at[level] = distance(evidence.yours[i], output.values) / output.scale;
    }
    std::optional<double> least;
    for (const auto& [key, at] : all) {
        if (!(at[1] > tolerance && at[2] > tolerance)) continue;
        const double power = std::log2(at[1] / at[2]);
        if (!least || power < *least) least = power;
    }
    return least;
}

}  // namespace

std::optional<Finding> wrong_frame(const Evidence& evidence) {
    for (const auto& [name, sentence, slip] : slips)
        if (explains(evidence, slip)) return {{name, {sentence}}};
    return std::nullopt;
}

std::optional<Finding> exchanged_components(const Evidence& evidence) {
    constexpr std::array<std::array<std::size_t, 3>, 5> orders{
        {{1, 0, 2}, {2, 1, 0}, {0, 2, 1}, {1, 2, 0}, {2, 0, 1}}};
    const auto all = [&](const auto& as) {
        return std::all_of(evidence.wrong.begin(), evidence.wrong.end(), [&](std::size_t i) {
            const Output& output = evidence.reference.outputs[i];
            return output.values.size() == 3 &&
                   apart(output, as(output.values), evidence.yours[i]) <= tolerance;
        });
    };
    for (const auto& order : orders)
        if (all([&](const Values& v) { return Values{v[order[0]], v[order[1]], v[order[2]]}; }))
            return {{"components exchanged",
                     {std::string("The numbers are right, but stand in the wrong places: yours are (") +
                      "xyz"[order[0]] + ", " + "xyz"[order[1]] + ", " + "xyz"[order[2]] + ")."}}};
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (all([&](Values v) { return v[axis] = -v[axis], v; }))
            return {{std::string("the wrong sign of ") + "xyz" [axis], {
                         std::string("Only the ") + "xyz"[axis] +
                             " component is wrong: it has the wrong sign."
                     }}};
    return std::nullopt;
}

std::optional<Finding> wrong_order(const Evidence& evidence) {
    const int order = evidence.exercise.order;
    if (order == 0) return std::nullopt;
    const auto& outputs = evidence.reference.outputs;
    std::array<double, 3> error{-1, -1, -1}, right{};
    std::string what;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const auto level = static_cast<std::size_t>(outputs[i].level);
        if (outputs[i].exact.empty() || !finite(evidence.yours[i]) || error[level] >= 0) continue;
        error[level] = distance(evidence.yours[i], outputs[i].exact);
        right[level] = distance(outputs[i].values, outputs[i].exact);
        what = without_unit(outputs[i].name);
    }
    if (error[0] < 0 || error[1] < 0 || error[2] < 0) return std::nullopt;
    const auto three = [](const std::array<double, 3>& all) {
        return digits(all[0], "%.2g") + ", " + digits(all[1], "%.2g") + ", " + digits(all[2], "%.2g");
    };
    const std::string table = "Distance of " + what +
                              " from the exact one, for steps of h, h/2, h/4: yours " + three(error) +
                              "; the right method's " + three(right) + ".";
    if (const auto local = local_power(evidence); local && *local < 0.5)
        return {{"as wrong for a short step as for a long one",
                 {"One step differs from the right one by about as much however short it is: is dt missing "
                  "somewhere, or something changed that no step should change? " +
                  table}}};
    const double seen = std::log2(error[1] / error[2]);
    if (error[2] > 0.75 * error[0] || seen < 0.5)
        return {{"wrong formula",
                 {"The error does not shrink with the step: this is a wrong formula, not a coarse step. " +
                  table}}};
    if (seen < order - 0.4)
        return {{"wrong order",
                 {"The error shrinks, but like dt^" + digits(seen, "%.1f") + " where this method has dt^" +
                  std::to_string(order) +
                  ": the formula is right in the limit, but something is taken at the wrong time or place in "
                  "the step, or with the wrong weight. " +
                  table}}};
    if (const auto local = local_power(evidence); local && *local < order + 0.6)
        return {{"wrong order",
                 {"One step differs from the right one by an amount that goes like dt^" +
                  digits(std::round(*local), "%.0f") + "; for a method of order " + std::to_string(order) +
                  " it must be dt^" + std::to_string(order + 1) +
                  " at most. Something is taken at the wrong time or place in the step, and not every force "
                  "shows it."}}};
    return {
        {"another scheme",
         {"The error shrinks as fast as it should, so this is a right method, but not the one asked for. " +
          table}}};
}

}  // namespace nutshell::judge
