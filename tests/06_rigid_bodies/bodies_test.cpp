// Chapter 6: many bodies. The wide drift does what the step for one body does, in the same bits for every
// width of vector, and takes no more than three times the machine's own floor, from ten bodies to a million.
#include <cstring>
#include <nutshell/bodies.hpp>
#include <nutshell/lab/run.hpp>
#include <nutshell/rotation_methods.hpp>
#include "check.hpp"

#define SHARED                                                                                \
    using ::nutshell::wide::Axes, ::nutshell::wide::ConstAxes, ::nutshell::wide::FourVectors, \
        ::nutshell::wide::BodyArrays
#define KERNEL "../chapters/06_rigid_bodies/kernels/bodies.cpp"
#include "three_widths.hpp"

using namespace nutshell;

namespace {

constexpr double dt = 1. / 60;

/// Bodies in disorder, asymmetric, one of them at rest.
Bodies heap(std::size_t n) {
    Bodies all(n);
    double value = 0.1;
    const auto next = [&] { return value = 3.9 * value * (1 - value); };  // chaos that needs no library
    const auto vector = [&] { return Vector3(next() - 0.5, next() - 0.5, next() - 0.5); };
    for (std::size_t i = 0; i < n; ++i) {
        const Vector3 part = vector() + Vector3::Constant(0.7);
        Body body{0.1 + next(), Vector3::Constant(part.sum()) - part, vector(), vector()};
        body.orientation.coeffs() = Eigen::Vector4d(next(), next() - 0.6, next(), 0.1).normalized();
        body.angular_momentum = i == 1 ? Vector3(Vector3::Zero()) : Vector3(10 * vector());
        all.set(i, body);
    }
    return checked(all);
}

std::vector<double> numbers(const Bodies& all) {
    std::vector<double> list;
    for (const auto* array :
         {&all.position.x, &all.position.y, &all.position.z, &all.momentum.x, &all.momentum.y,
          &all.momentum.z, &all.orientation.x, &all.orientation.y, &all.orientation.z, &all.orientation.w,
          &all.angular_momentum.x, &all.angular_momentum.z})
        list.insert(list.end(), array->begin(), array->end());
    return list;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

template <class Drift, class Push>
std::vector<double> moved_by(const Drift& drift_loop, const Push& push_loop, Bodies all) {
    for (int i = 0; i < 20; ++i) {
        drift_loop(all.size(), all.arrays(), dt);
        push_loop(all.size(), all.momentum.axes(), all.angular_momentum.axes(), dt);
    }
    return numbers(all);
}

}  // namespace

TEST_CASE("The wide drift is the Magnus step of one body, for all, to round-off") {
    const std::size_t n = 37;
    Bodies all = heap(n);
    std::vector<Body> alone;
    for (std::size_t i = 0; i < n; ++i) alone.push_back(all[i]);
    for (int step = 0; step < 100; ++step) {
        drift(all, dt);
        for (Body& body : alone) drift_by<magnus_rotation>(body, dt);
    }
    for (std::size_t i = 0; i < n; ++i) {
        CHECK(all[i].position == alone[i].position);
        CHECK(all[i].angular_momentum == alone[i].angular_momentum);
        // 100 steps of a few epsilon
        CHECK(angle_between(all[i].orientation, alone[i].orientation) < 2e-13);
        CHECK(all[i].orientation.norm() == Approx(1).epsilon(1e-15));
    }
    CHECK(angle_between(all[1].orientation, heap(n)[1].orientation) < 1e-15);  // at rest
}

TEST_CASE("The wide drift is fourth order, and right for 20 turns a second about a principal axis") {
    const Body start = heap(5)[3];
    const FreeTop exact(start.inertia, start.orientation, start.angular_momentum);
    Convergence c;
    for (const int steps : {60, 120, 240}) {
        Bodies one(1);
        one.set(0, start);
        for (int i = 0; i < steps; ++i) drift(one, 2.0 / steps);
        c.dt.push_back(2.0 / steps), c.error.push_back(angle_between(one[0].orientation, exact.pose(2)));
    }
    CHECK_THAT(c, HasOrder(4, 0.2));
    Bodies fast(1);
    fast.set(0, spinning(Body{1, {1, 2, 2.5}}, {0, 0, 40 * pi}));
    for (int i = 0; i < 3000; ++i) drift(fast, dt);
    CHECK(angle_between(fast[0].orientation, Quaternion::Identity()) < 1e-9);  // 1000 whole turns
}

TEST_CASE("A kick of many bodies is a kick of each") {
    Bodies all = heap(9);
    const Bodies before = all, other = heap(11);
    kick(all, {other.position.axes(), other.momentum.axes()}, dt);
    for (std::size_t i = 0; i < 9; ++i) {
        Body body = before[i];
        kick(body, Wrench{other[i].position, other[i].momentum}, dt);
        CHECK(all[i].momentum == body.momentum);
        CHECK(all[i].angular_momentum == body.angular_momentum);
    }
}

TEST_CASE("Many bodies: the same bits with and without AVX2, for every length") {
    for (const std::size_t n : std::vector<std::size_t>{1, 2, 3, 4, 5, 7, 8, 15, 16, 17, 33, 100, 257}) {
        const Bodies all = heap(n);
        const auto library =
            moved_by(static_cast<void (*)(std::size_t, const wide::BodyArrays&, double)>(wide::drift),
                     wide::push, all);
        INFO(n << " bodies");
        for (const double number : library) REQUIRE(std::isfinite(number));
        CHECK(same_bits(
            library, moved_by(without_avx2::nutshell::wide::drift, without_avx2::nutshell::wide::push, all)));
#if defined(__x86_64__) || defined(__i386__)
        if (__builtin_cpu_supports("avx2"))
            CHECK(same_bits(
                library, moved_by(with_avx2::nutshell::wide::drift, with_avx2::nutshell::wide::push, all)));
#endif
    }
}

TEST_CASE("A million bodies move at three times the machine's floor at most") {
    const auto n = static_cast<std::size_t>(GENERATE(10, 100, 1000, 10'000, 100'000, 1'000'000));
    Bodies all = free_boxes(n), streamed = free_boxes(n);
    const std::vector<double> in(256, 1.5);
    std::vector<double> out(256);
    double best = 1e9;
    for (int attempt = 0; attempt < 8 && best > 3; ++attempt) {
        const double drifting = lab::time_of([&] { drift(all, dt); }, 2);
        const double streaming = lab::time_of([&] { wide::stream_bodies(n, streamed.arrays()); }, 2);
        const double arithmetic = lab::time_of(
            [&] {
                for (std::size_t done = 0; done < n; done += 256)
                    wide::arithmetic_bodies(std::min<std::size_t>(256, n - done), in.data(), out.data(), dt);
                lab::keep(out[0]);
            },
            2);
        best = std::min(best, drifting / std::max(streaming, arithmetic));
    }
    INFO(n << " bodies");
    CHECK(best <= 3);
}

TEST_CASE("Bodies that cannot be are named") {
    Bodies all = heap(4);
    all.inertia.x[2] = 100;
    CHECK_THROWS_WITH(checked(all), ContainsSubstring("body 2") && ContainsSubstring("two others"));
    all = heap(4);
    all.momentum.resize(3);
    CHECK_THROWS_WITH(checked(all), ContainsSubstring("4 masses"));
    CHECK_NOTHROW(checked(free_boxes(10)));
}
