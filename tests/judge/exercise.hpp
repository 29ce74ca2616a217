// What an exercise is made of. HOWTO.md beside this file says how to write one.
//
// A file of an exercise is compiled twice. In the sheet (NUTSHELL_SHEET defined) it sees the learner's header
// and holds the questions only: Paper writes raw numbers to a pipe. In the judge it sees the reference's
// header, and its words, mistakes and alternatives too: Paper keeps every number with its name, its input and
// its scale.
#pragma once
#include <algorithm>
#include <cmath>
#include <nutshell/unanswered.hpp>
#include <nutshell/vector.hpp>
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

    /// One value to compare. It must agree to 1e-9 of the largest number among `terms`: name each term that
    /// enters it, first the one the value starts from (the judge then tells a wrong change from a wrong
    /// start).
    template <class Value, class Term, class... Terms>
    void output([[maybe_unused]] const char* name, const Value& value, [[maybe_unused]] const Term& term,
                [[maybe_unused]] const Terms&... terms) {
#ifdef NUTSHELL_SHEET
        send(numbers(value));
#else
        keep(name, numbers(value), numbers(term, terms...), {});
#endif
    }

    /// Like output(), for the end of a run over a fixed time with steps of step(): `exact` is what it
    /// converges to. From runs at h, h/2 and h/4 the judge tells a wrong formula from a wrong scheme.
    template <class Value, class Exact, class Term, class... Terms>
    void run([[maybe_unused]] const char* name, const Value& value, [[maybe_unused]] const Exact& exact,
             [[maybe_unused]] const Term& term, [[maybe_unused]] const Terms&... terms) {
#ifdef NUTSHELL_SHEET
        send(numbers(value));
#else
        keep(name, numbers(value), numbers(term, terms...), numbers(exact));
#endif
    }

    /// `h` in the first round of questions, then h/2, then h/4. An exercise that never calls it is asked
    /// once.
    double step(double h) {
        stepped_ = true;
        return std::ldexp(h, -level_);
    }
    bool stepped() const {
        return stepped_;
    }
    void next_level() {
        ++level_;
    }
    /// False when questions about states of other types are to be left out: the learner's step moves one type
    /// only.
    bool other_states() const {
        return other_states_;
    }
    void leave_out_other_states() {
        other_states_ = false;
    }

#ifndef NUTSHELL_SHEET
    const Record& record() const {
        return record_;
    }
#endif

  private:
    int level_ = 0;
    bool stepped_ = false, other_states_ = true;
#ifndef NUTSHELL_SHEET
    void begin_input();
    void describe(const char* name_or_words);
    void describe(double value);
    void describe(const std::vector<double>& values);
    template <class Derived>
    void describe(const Eigen::DenseBase<Derived>& value) {
        describe(numbers(value));
    }
    void describe(const Quaternion& value) {
        describe(numbers(value));
    }
    void keep(const char* name, std::vector<double> values, const std::vector<double>& terms,
              std::vector<double> exact);
    Record record_;
    int described_ = 0;
#endif
};

/// Asks all questions of an exercise: at h, and if its questions have a step, at h/2 and h/4.
template <class Questions, class Answer>
void ask_all(Paper& paper, const Answer& answer) {
    Questions::ask(paper, answer);
    for (int level = 1; level < 3 && paper.stepped(); ++level) {
        paper.next_level();
        Questions::ask(paper, answer);
    }
}

#ifdef NUTSHELL_SHEET

bool enter(const char* id, void (*ask)());  // in sheet.cpp

/// The last line of an exercise's file: inline const bool name_entered = enter<Name>();
template <class Questions>
bool enter() {
    return enter(Questions::id, [] {
        Paper paper;
        ask_all<Questions>(paper, Questions::subject);
    });
}

#else

bool enter(Exercise exercise);  // in rooms.cpp

template <class Questions, class Answer>
Attempt attempt(Answer answer) {
    return [answer](Paper& paper) { ask_all<Questions>(paper, answer); };
}

/// The last line of an exercise's file: inline const bool name_entered = enter<Name>();
template <class Questions>
bool enter() {
    Exercise exercise = Questions::about();
    exercise.id = Questions::id;
    exercise.function = Questions::function;
    exercise.reference = attempt<Questions>(Questions::subject);
    return enter(std::move(exercise));
}

#endif

}  // namespace nutshell::exercises
