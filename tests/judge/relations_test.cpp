// What the numbers tell of what stands in another's place, and how it is shown; slips of the pen.
#include "../check.hpp"
#include "diagnosis.hpp"
#include "exercise.hpp"
#include "learner.hpp"
#include "rooms.hpp"
#include "slips.hpp"

using namespace nutshell;
using namespace nutshell::judge;
using exercises::Exercise;
using exercises::Paper;

namespace {

/// How an answer fares in an exercise that has no name and knows no mistakes.
template <class Questions, class Right, class Answer>
Diagnosis diagnosed(Right right, Answer answer) {
    const auto given = record_of(exercises::asked<Questions>(answer));
    std::vector<Values> yours;
    for (const auto& output : given.outputs) yours.push_back(output.values);
    const Exercise nameless;
    return diagnose(nameless, record_of(exercises::asked<Questions>(right)), yours);
}

}  // namespace

namespace {

/// A vector and a number from a vector and a limit, beyond which nothing comes.
struct Limited {
    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        for (const Vector3& v : {Vector3(0.7, -1.2, 0.4), Vector3(-1.9, 0.3, 1.1), Vector3(0.2, 0.5, -0.6)})
            for (const double angle : {0.4, 1.1, 2.6}) {
                paper.input("v", v, "angle", angle);
                const std::pair<Vector3, Vector3> given = answer(v, angle);
                paper.output("the one", given.first, 2.0);
                paper.output("the other", given.second, 2.0);
            }
    }
};

std::pair<Vector3, Vector3> limited(const Vector3& v, double angle) {
    return {angle > 2 ? Vector3(0, 0, 0) : Vector3(std::cos(angle) * Vector3(v.y(), v.x(), v.z())),
            0.3 * Vector3(v.y(), v.z(), angle)};
}

}  // namespace

TEST_CASE("What comes back, what is exchanged, what is right but for its size or its sign") {
    using Two = std::pair<Vector3, Vector3>;
    const auto told = [](const auto& answer) { return diagnosed<Limited>(limited, answer).name; };
    CHECK(told([](const Vector3& v, double angle) {
              return Two{v, limited(v, angle).second};
          }) == "v comes back unchanged");
    CHECK(told([](const Vector3& v, double angle) {
              return Two{angle > 2 ? v : Vector3(0, 0, 0), limited(v, angle).second};
          }) == "the condition the wrong way round");
    CHECK(told([](const Vector3& v, double angle) {
              const auto [one, other] = limited(v, angle);
              return Two{other, one};
          }) == "two results exchanged");
    CHECK(told([](const Vector3& v, double angle) {
              return Two{limited(v, angle).first, limited(v, angle).second.normalized()};
          }) == "made of length one");
    CHECK(told([](const Vector3& v, double angle) {
              return Two{limited(v, angle).first / std::cos(angle), limited(v, angle).second};
          }) == "the cosine of angle left out or too much");
    CHECK(told([](const Vector3& v, double angle) {
              return Two{limited(v, angle).first, (v.norm() + angle) * limited(v, angle).second};
          }) == "right direction, wrong size");
    CHECK(told([](const Vector3& v, double angle) {
              return Two{(v.x() < 0 ? -1 : 1) * limited(v, angle).first, limited(v, angle).second};
          }) == "a wrong sign for some inputs");
    const auto words = diagnosed<Limited>(limited, [](const Vector3& v, double angle) {
                           return Two{limited(v, angle).first, limited(v, angle).second + angle * angle * v};
                       }).words;
    CHECK(words ==
          std::vector<std::string>{"Right: the one. Wrong: the other.", "Only its part along v is wrong."});
}

TEST_CASE("A mistake that is known is known with another sign or size too") {
    const auto right = [](const Vector3& v, double angle) { return v.x() + angle; };
    struct Sum {
        static void ask(Paper& paper, const std::function<double(const Vector3&, double)>& answer) {
            for (const double x : {0.7, -1.4})
                for (const double angle : {0.3, 1.2}) {
                    paper.input("x", x, "angle", angle);
                    paper.output("the sum", answer(Vector3(x, 0, 0), angle), 2.0);
                }
        }
    };
    using Function = std::function<double(const Vector3&, double)>;
    Exercise knows;
    const Function wrong = [](const Vector3& v, double angle) { return v.x() * angle; };
    knows.mistakes.push_back({"multiplied", "", "", "", [=](Paper& paper) { Sum::ask(paper, wrong); }});
    const auto told = [&](const Function& answer) {
        Paper of_right, of_yours;
        Sum::ask(of_right, right), Sum::ask(of_yours, answer);
        std::vector<Values> yours;
        for (const auto& output : of_yours.record().outputs) yours.push_back(output.values);
        const Diagnosis diagnosis = diagnose(knows, of_right.record(), yours);
        return diagnosis.name + ": " + diagnosis.words.back();
    };
    CHECK(told([](const Vector3& v, double angle) { return -v.x() * angle; }) ==
          "multiplied: Besides, it has the wrong sign.");
    CHECK(told([](const Vector3& v, double angle) { return 3 * v.x() * angle; }) ==
          "multiplied: Besides, it is 3 times as large.");
}

TEST_CASE("A matrix is shown in rows, a long list from where it first differs") {
    CHECK(shown({1, 2, 3, 4, 5, 6, 7, 8, 9}, {}, true) ==
          "(1, 4, 7)\n                (2, 5, 8)\n                (3, 6, 9)");
    Values many(20, 1), other = many;
    other[12] = 2;
    CHECK(shown(many, other) == "(..., 1, 1, 1, 1, 1, 1, 1, 1, 1, ...), from number 11 of 20");
    CHECK(shown(other, many) == "(..., 1, 1, 2, 1, 1, 1, 1, 1, 1, ...), from number 11 of 20");
}

TEST_CASE("A slip of the pen is named in its own line; a longer search is given up") {
    const Learner learner("slips");
    const auto told = [&](Number number, const std::string& body) {
        learner.answer(number, body);
        return one_slip_away(learner.rooms, chapter_of(learner.rooms, number), number).value_or("");
    };
    CHECK_THAT(
        told({0, 7},
             "    const double c = std::cos(angle), s = std::sin(angle);\n"
             "    return {c * z.real() + s * z.imag(), s * z.real() + c * z.imag()};"),
        ContainsSubstring("in the line  return {c * z.real() + s * z.imag(), s * z.real() + c * z.imag()};"
                          "  : a sign in it is the wrong one"));
    CHECK_THAT(told({0, 5},
                    "    const double middle = (a + b) / 2;\n    double area = 0 * middle;\n"
                    "    for (int i = 0; i < strips; ++i)\n"
                    "        area += f(a + (i + 0.25) * (b - a) / strips) * (b - a) / strips;\n"
                    "    return area;"),
               ContainsSubstring(
                   "(i + 0.25) * (b - a) / strips) * (b - a) / strips;  : `0.25` is not what belongs"));
    CHECK(told({0, 5}, "    return std::tan(a * b) + strips * f(a);") == "");
}
