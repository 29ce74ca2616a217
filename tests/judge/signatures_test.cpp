// What the numbers alone tell: tried on exercises made up here.
#include "../check.hpp"
#include "diagnosis.hpp"
#include "exercise.hpp"
#include "rooms.hpp"

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

/// A turned body with a spin: its angular momentum, its tensor and where it points, in world axes.
struct Turned {
    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        for (const double angle : {0.7, 2.1}) {
            const Quaternion q(Eigen::AngleAxisd(angle, Vector3(1, -2, 0.5).normalized()));
            paper.input("turned by", angle);
            paper.frame(q);
            paper.output("the result", answer(q, Vector3(0.9, -1.4, 0.7)), 2.0);
        }
    }
};

Vector3 to_world(const Quaternion& q, const Vector3& v) {
    return q * v;
}
Matrix3 tensor(const Quaternion& q) {
    const Matrix3 r = q.toRotationMatrix();
    return r * Vector3(0.4, 1.1, 2.3).asDiagonal() * r.transpose();
}

}  // namespace

TEST_CASE("A right vector in the wrong axes is called so") {
    const auto told = [](const auto& answer) { return diagnosed<Turned>(to_world, answer).name; };
    CHECK(told([](const Quaternion&, const Vector3& v) { return v; }) == "wrong frame: body axes");
    CHECK(told([](const Quaternion& q, const Vector3& v) -> Vector3 { return q * (q * v); }) ==
          "wrong frame: world axes");
    CHECK(told([](const Quaternion& q, const Vector3& v) -> Vector3 { return q.conjugate() * v; }) ==
          "turned the wrong way");
    CHECK(told([](const Quaternion& q, const Vector3& v) -> Vector3 { return (q * v).reverse(); }) ==
          "components exchanged");
    CHECK(told([](const Quaternion& q, const Vector3& v) -> Vector3 { return 3 * (q * v); }) ==
          "wrong factor");
    CHECK(diagnosed<Turned>(to_world, to_world).right);
}

TEST_CASE("A right tensor or matrix in the wrong axes, and its transpose") {
    const auto right = [](const Quaternion& q, const Vector3&) { return tensor(q); };
    CHECK(diagnosed<Turned>(right, [](const Quaternion&, const Vector3&) {
              return tensor(Quaternion::Identity());
          }).name == "wrong frame: body axes");
    CHECK(diagnosed<Turned>(right, [](const Quaternion& q, const Vector3&) {
              return tensor(q.conjugate());
          }).name == "turned the wrong way");
    const auto matrix = [](const Quaternion& q, const Vector3&) { return q.toRotationMatrix(); };
    CHECK(diagnosed<Turned>(matrix, [](const Quaternion& q, const Vector3&) -> Matrix3 {
              return q.toRotationMatrix().transpose();
          }).name == "the transpose");
}

TEST_CASE("Quaternions: q and -q are the same rotation, and their own slips have names") {
    const auto right = [](const Quaternion& q, const Vector3&) { return q; };
    CHECK(diagnosed<Turned>(right, [](const Quaternion& q, const Vector3&) {
              return Quaternion(-q.w(), -q.x(), -q.y(), -q.z());
          }).right);
    CHECK(diagnosed<Turned>(right, [](const Quaternion& q, const Vector3&) { return q.conjugate(); }).name ==
          "the inverse rotation");
    CHECK(diagnosed<Turned>(right, [](const Quaternion& q, const Vector3&) {
              return Quaternion(q.x(), q.y(), q.z(), q.w());
          }).name == "the quaternion's numbers in another order");
}

namespace {

/// A state that is changed by a push, for several masses and steps.
struct Pushed {
    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const Vector3 start(1.2, -0.7, 2.1), push(3, -2, 0.8);
        for (const auto& [mass, dt] : {std::pair{2.5, 0.1}, {0.4, 0.1}, {2.5, 0.3}}) {
            paper.input("mass", mass, "dt", dt);
            Vector3 v = start;
            answer(v, push, mass, dt);
            paper.changed("the velocity [m/s]", v, start, Vector3(push / mass * dt));
        }
    }
};

void pushed(Vector3& v, const Vector3& push, double mass, double dt) {
    v += push / mass * dt;
}

}  // namespace

TEST_CASE("Changes: none, the wrong sign, an argument that is not used or enters with a wrong power") {
    const auto told = [](const auto& answer) { return diagnosed<Pushed>(pushed, answer).name; };
    CHECK(told([](Vector3 v, const Vector3& push, double mass, double dt) { pushed(v, push, mass, dt); }) ==
          "nothing changes");
    CHECK(told([](Vector3& v, const Vector3& push, double mass, double dt) { v -= push / mass * dt; }) ==
          "wrong sign");
    CHECK(told([](Vector3& v, const Vector3& push, double, double dt) { v += push * dt; }) ==
          "a wrong power of mass");
    CHECK(told([](Vector3& v, const Vector3& push, double mass, double dt) { v += push / mass * dt * dt; }) ==
          "a wrong power of dt");
    CHECK(told([](Vector3& v, const Vector3& push, double mass, double) { v += push / mass * 0.15 + v; }) ==
          "dt makes no difference");
    CHECK(told([](Vector3& v, const Vector3& push, double mass, double dt) {
              v.x() += push.x() / mass * dt, v.y() -= 2 * push.y();
          }) == "wrong formula");
}

namespace {

/// A number that hangs on a vector and on a size of all orders of magnitude.
struct OfAllSizes {
    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        for (const double x : {-0.8, 0.6})
            for (const double y : {-0.7, 1.1, 0.4})
                for (const double size : {1e-12, 0.3, 2.0, 1e160}) {
                    const Vector3 v(x, y, 0.9);
                    paper.input("v", v, "size", size);
                    paper.output("the result", answer(v, size), 2.0);
                }
    }
};

double right_one(const Vector3& v, double size) {
    return v.sum() + size / (1 + size);
}

}  // namespace

TEST_CASE(
    "Where an answer is wrong: by the sign of a component, at both ends of a size; never beside the absurd") {
    const auto told = [](const auto& answer) { return diagnosed<OfAllSizes>(right_one, answer).name; };
    CHECK(told([](const Vector3& v, double size) { return right_one(v.cwiseMax(-0.75), size); }) ==
          "wrong where v.x is negative");
    CHECK(told([](const Vector3& v, double size) {
              return size < 1e-6 || size > 1e6 ? 0.0 : right_one(v, size);
          }) == "wrong where size is very small or very large");
    CHECK(told([](const Vector3& v, double size) { return size > 1e6 ? right_one(v, size) : 0.3; }) ==
          "wrong formula");
}

namespace {

/// One step from 1 towards e^t, and its run to the end.
struct Growing {
    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const double h = paper.step(0.1);
        paper.input("start", 1.0, "h", h);
        paper.output("one step", answer(1.0, h), 1.0);
        double x = 1;
        for (int n = 0; n < std::lround(1 / h); ++n) x = answer(x, h);
        paper.run("the end", x, std::exp(1), 1.0);
    }
};

}  // namespace

TEST_CASE("A step in which dt does not enter is as wrong for a short step as for a long one") {
    Exercise nameless;
    nameless.order = 1;
    const auto right = [](double x, double h) { return x + h * x; };
    std::vector<Values> yours;
    for (const auto& output :
         record_of(exercises::asked<Growing>([](double x, double) { return x + 0.3; })).outputs)
        yours.push_back(output.values);
    CHECK(diagnose(nameless, record_of(exercises::asked<Growing>(right)), yours).name ==
          "as wrong for a short step as for a long one");
}

namespace {

/// Two numbers, each with each.
struct OfTwoNumbers {
    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        for (const double a : {-2.0, -1.1, 0.5, 1.0, 3.1})
            for (const double b : {0.3, 0.9, 2.2}) {
                paper.input("a", a, "b", b);
                paper.output("the result", answer(a, b), 6.0);
            }
    }
};

double sum_of(double a, double b) {
    return a + b;
}

}  // namespace

TEST_CASE("What the inputs have in common for which an answer is wrong, unless chance would do") {
    const auto told = [](const auto& answer) { return diagnosed<OfTwoNumbers>(sum_of, answer).name; };
    CHECK(told([](double a, double b) { return a < 0 && b > 0.5 ? b : a + b; }) ==
          "wrong only where a is negative");
    CHECK(told([](double a, double b) { return a * a + b; }) == "right only where a is one");
    CHECK(told([](double a, double b) { return std::abs(a) < 2 * b ? a + b : std::sin(a - b); }) ==
          "wrong where a over b is large");
    CHECK(told([](double a, double b) { return b > 2 && a != 0.5 && a < 2 ? a : a + b; }) == "wrong formula");
}
