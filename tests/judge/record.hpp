// What the judge knows of an exercise, and what an answer gave: data without physics.
#pragma once
#include <array>
#include <functional>
#include <string>
#include <vector>

namespace nutshell::exercises {

class Paper;

/// One compared value of an answer.
struct Output {
    std::string name;
    std::size_t input;  ///< which input it belongs to
    int level;          ///< 0, 1, 2: made with steps of h, h/2, h/4
    std::vector<double> values;
    double scale;               ///< the largest term that enters it: it must be right to 1e-9 of this
    std::vector<double> start;  ///< the first term, if it is of the value's size: what the value starts from
    std::vector<double> exact;  ///< what it tends to when the step goes to zero; empty if that was not said
};
/// All that an answer gave for the questions of an exercise.
struct Record {
    std::vector<std::string> inputs;
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

/// What the judge knows of an exercise besides its questions.
struct Exercise {
    std::string id = {}, function = {};  ///< filled in by enter() and from Questions
    std::string title = {};              ///< a few words
    /// From a nudge to nearly there; none holds a line of the solution.
    std::array<std::string, 3> hints = {};
    int order = 0;             ///< the order of convergence of the right answer's runs; 0 if it has none
    std::string picture = {};  ///< a file of out/NN_name/ that shows what matters here, or empty
    std::vector<Mistake> mistakes = {};
    std::vector<Alternative> alternatives = {};
    Attempt reference = {};  ///< filled in by enter()
};

}  // namespace nutshell::exercises
