// What the judge knows of an exercise, and what an answer gave: data without physics.
#pragma once
#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace nutshell::exercises {

class Paper;

/// What was asked, as it is shown, and its numbers by name.
struct Input {
    std::string words;
    std::vector<std::pair<std::string, std::vector<double>>> values;
    int level;  ///< 0, 1, 2: asked with steps of h, h/2, h/4
};

/// One compared value of an answer.
struct Output {
    std::string name;
    std::size_t input;  ///< which input it belongs to
    int level;          ///< that of its input
    std::vector<double> values;
    double scale;               ///< the largest term that enters it: it must be right to 1e-9 of this
    std::vector<double> start;  ///< what the value is changed from; empty if it is new
    std::vector<double> exact;  ///< of a run: what it tends to as the step goes to zero
    bool quaternion = false;    ///< a rotation: q and -q are the same
    std::vector<double> frame;  ///< body to world, a matrix by columns, where the question has a body
    bool matrix = false;        ///< nine numbers that are a matrix, by columns
};
/// All that an answer gave for the questions of an exercise.
struct Record {
    std::vector<Input> inputs;
    std::vector<Output> outputs;
};

/// A right or wrong answer that is compiled into the judge.
using Attempt = std::function<void(Paper&)>;

struct Mistake {
    std::string name;      ///< a few words, as the verdict calls it: "kicks before it drifts"
    std::string origin;    ///< an erratum's id ("E04"), or where the slip is met: "classic", "game loops"
    std::string symptom;   ///< what a player would see
    std::string sentence;  ///< why it is wrong and where to look, in one or two sentences
    Attempt attempt;
};

struct Alternative {
    std::string name;
    Attempt attempt;
};

/// A mutant of the reference's body that is as right as the body itself, and why.
struct Survivor {
    std::string mutant;  ///< as `judge gates N.M` names it: "< to <= (1st)"
    std::string reason;
};

/// What the judge knows of an exercise besides its questions.
struct Exercise {
    std::string id, function;
    std::string title;
    std::array<std::string, 3> hints;
    int order = 0;
    std::string picture;
    std::string beyond;
    std::vector<Mistake> mistakes;
    std::vector<Alternative> alternatives;
    std::vector<Survivor> survivors;
    Attempt reference;
};

}  // namespace nutshell::exercises
