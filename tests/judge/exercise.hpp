// What an exercise is made of. HOWTO.md beside this file says how to write one.
//
// A file of an exercise is compiled twice. In the sheet (NUTSHELL_SHEET defined) it sees the learner's header
// and holds the questions only: Paper writes raw numbers to a pipe. In the judge it sees the reference's
// header, and its words, mistakes and alternatives too: Paper keeps every number with its name, its input and
// its scale.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <nutshell/unanswered.hpp>
#include <nutshell/vector.hpp>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>
#ifndef NUTSHELL_SHEET
#include "record.hpp"
#endif

/// A function, template or not, as a value that can be handed to ask().
#define NUTSHELL_CALL(function) [](auto&&... in) { return function(std::forward<decltype(in)>(in)...); }

namespace nutshell::exercises {

/// All numbers of a value: of a number, an Eigen vector, matrix or quaternion, or a std::vector of them.
inline void append(std::vector<double>& all, double value) {
    all.push_back(value);
}
template <class Derived>
void append(std::vector<double>& all, const Eigen::DenseBase<Derived>& value) {
    const auto matrix = value.derived().eval();
    for (Eigen::Index column = 0; column < matrix.cols(); ++column)
        for (Eigen::Index row = 0; row < matrix.rows(); ++row)
            all.push_back(static_cast<double>(matrix(row, column)));
}
inline void append(std::vector<double>& all, const Quaternion& value) {
    append(all, value.coeffs());
}
template <class Value>
void append(std::vector<double>& all, const std::vector<Value>& values) {
    for (const Value& value : values) append(all, value);
}
template <class... Values>
std::vector<double> numbers(const Values&... values) {
    std::vector<double> all;
    (append(all, values), ...);
    return all;
}

#ifdef NUTSHELL_SHEET
void send(const std::vector<double>& values);  // to the judge; in sheet.cpp
#endif

/// Where the questions of an exercise put what they ask and what they get.
class Paper {
  public:
    /// Says what comes next, as names and values in turn: paper.input("dt", dt, "body", "a thrown ball").
    template <class... NamesAndValues>
    void input([[maybe_unused]] const NamesAndValues&... parts) {
#ifndef NUTSHELL_SHEET
        begin_input();
        (describe(parts), ...);
#endif
    }

    /// The body that this input is about is turned so (body to world: a quaternion or a matrix). The judge
    /// then knows a right vector, tensor or rotation in the wrong axes.
    template <class Rotation>
    void frame([[maybe_unused]] const Rotation& body_to_world) {
#ifndef NUTSHELL_SHEET
        frame_ = numbers(Matrix3(body_to_world));
#endif
    }

    /// One value to compare. It must agree to 1e-9 of the largest number among `terms`: name each term that
    /// enters it.
    template <class Value, class Term, class... Terms>
    void output(const char* name, const Value& value, [[maybe_unused]] const Term& term,
                [[maybe_unused]] const Terms&... terms) {
        give(
            name, value, [&] { return numbers(term, terms...); }, Nothing{}, Nothing{});
    }

    /// The same of a value that the answer changes from `start`, which is one of the terms: the judge then
    /// knows a wrong change, and none.
    template <class Value, class Start, class... Terms>
    void changed(const char* name, const Value& value, const Start& start,
                 [[maybe_unused]] const Terms&... terms) {
        give(
            name, value, [&] { return numbers(start, terms...); }, start, Nothing{});
    }

    /// The same of the end of a run over a fixed time with steps of step(): `exact` is what it converges to.
    /// From runs at h, h/2 and h/4 the judge tells a wrong formula from a wrong scheme.
    template <class Value, class Exact, class Term, class... Terms>
    void run(const char* name, const Value& value, const Exact& exact, [[maybe_unused]] const Term& term,
             [[maybe_unused]] const Terms&... terms) {
        give(
            name, value, [&] { return numbers(term, terms...); }, Nothing{}, exact);
    }

    /// `h` in the first round of questions, then h/2, then h/4. An exercise that never calls it is asked
    /// once.
    double step(double h) {
        stepped_ = true;
        return std::ldexp(h, -level_);
    }
    /// Asks everything: at h, and if the questions have a step, at h/2 and h/4; or once more at h.
    template <class Questions, class Answer>
    void ask(const Answer& answer) {
        for (level_ = 0; level_ < (stepped_ ? 3 : 1); ++level_) Questions::ask(*this, answer);
    }
    template <class Questions, class Answer>
    void ask_once_more(const Answer& answer) {
        level_ = 0;
        Questions::ask(*this, answer);
    }

    /// False when questions that go beyond what the function must do are left out (see HOWTO, "beyond").
    bool asks_beyond() const {
        return beyond_;
    }
    void leave_out_beyond() {
        beyond_ = false;
    }

#ifndef NUTSHELL_SHEET
    const Record& record() const {
        return record_;
    }
#endif

  private:
    using Nothing = std::vector<double>;

    template <class Value, class Terms, class Start, class Exact>
    void give([[maybe_unused]] const char* name, const Value& value, [[maybe_unused]] const Terms& terms,
              [[maybe_unused]] const Start& start, [[maybe_unused]] const Exact& exact) {
#ifdef NUTSHELL_SHEET
        send(numbers(value));
#else
        keep(name, numbers(value), terms(), numbers(start), numbers(exact), std::is_same_v<Value, Quaternion>,
             std::is_same_v<Value, Matrix3>);
#endif
    }

    int level_ = 0;
    bool stepped_ = false, beyond_ = true;
#ifndef NUTSHELL_SHEET
    void begin_input();
    void describe(const char* name_or_words);
    void describe(double value);
    void describe(const std::vector<double>& values, bool matrix = false);
    template <class Derived>
    void describe(const Eigen::DenseBase<Derived>& value) {
        describe(numbers(value), Derived::RowsAtCompileTime == 3 && Derived::ColsAtCompileTime == 3);
    }
    void describe(const Quaternion& value) {
        describe(numbers(value));
    }
    void keep(const char* name, std::vector<double> values, const std::vector<double>& terms,
              std::vector<double> start, std::vector<double> exact, bool quaternion, bool matrix);
    Record record_;
    std::vector<double> frame_;
    std::string name_;  ///< of the value that comes next
#endif
};

#ifdef NUTSHELL_SHEET

bool enter(const char* id, void (*ask)(Paper&, bool once_more));  // in sheet.cpp

/// The last line of an exercise's file: inline const bool name_entered = enter<Name>();
template <class Questions>
bool enter() {
    return enter(Questions::id, [](Paper& paper, bool once_more) {
        if (once_more)
            paper.ask_once_more<Questions>(Questions::subject);
        else
            paper.ask<Questions>(Questions::subject);
    });
}

#else

bool enter(Exercise exercise);  // in rooms.cpp

template <class Questions, class Answer>
Attempt asked(Answer answer) {
    return [answer](Paper& paper) { paper.ask<Questions>(answer); };
}

/// What an exercise says of itself: the words and the answers that are known, right and wrong.
template <class Questions>
struct About {
    /// A mistake: {name, origin, symptom, sentence, the wrong answer}; see Mistake.
    struct Wrong : Mistake {
        template <class Answer>
        Wrong(std::string called, std::string from, std::string seen, std::string why, Answer answer)
            : Mistake{std::move(called), std::move(from), std::move(seen), std::move(why),
                      asked<Questions>(answer)} {}
    };
    /// Another right answer: {a few words, the answer}.
    struct Right : Alternative {
        template <class Answer>
        Right(std::string called, Answer answer) : Alternative{std::move(called), asked<Questions>(answer)} {}
    };

    std::string title;                 ///< a few words
    std::array<std::string, 3> hints;  ///< from a nudge to nearly there; none holds a line of the solution
    int order = 0;                     ///< of the right answer's runs; 0 if it has none
    std::string picture = {};          ///< a file of out/NN_name/ that shows what matters here, or empty
    std::string beyond = {};           ///< said of an answer for which the questions beyond do not compile
    std::vector<Wrong> mistakes;
    std::vector<Right> alternatives;
    std::vector<Survivor> survivors = {};
};

/// The last line of an exercise's file: inline const bool name_entered = enter<Name>();
template <class Questions>
bool enter() {
    auto about = Questions::about();
    return enter({.id = Questions::id,
                  .function = Questions::function,
                  .title = about.title,
                  .hints = about.hints,
                  .order = about.order,
                  .picture = about.picture,
                  .beyond = about.beyond,
                  .mistakes = {about.mistakes.begin(), about.mistakes.end()},
                  .alternatives = {about.alternatives.begin(), about.alternatives.end()},
                  .survivors = about.survivors,
                  .reference = asked<Questions>(Questions::subject)});
}

#endif

}  // namespace nutshell::exercises
