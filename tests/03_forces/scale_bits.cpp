// The wide loops compute the same bits for every width of vector: the library's own (the widest this
// processor has), plain code without AVX2, and code that must use AVX2. And one pass over memory gives the
// bits of the three verbs.
#include <cstring>
#include <nutshell/chain_scenes.hpp>
#include <nutshell/lab/run.hpp>
#include "check.hpp"
#include "one_pass.hpp"

#define SHARED                                                                           \
    using ::nutshell::wide::Axes, ::nutshell::wide::ConstAxes, ::nutshell::wide::Medium, \
        ::nutshell::wide::most_step
#define KERNEL "../chapters/03_forces/kernels/wide.cpp"
#include "three_widths.hpp"

using namespace nutshell;

namespace {

/// N particles in disorder, with every kind of number; some springs of length zero.
struct Heap {
    Particles all;
    Vector3Array anchors, forces;
    explicit Heap(std::size_t n) : all(n), anchors(n), forces(n) {
        double value = 0.1;
        const auto next = [&] { return value = 3.9 * value * (1 - value); };  // chaos that needs no library
        for (auto* array : {&all.position, &all.velocity, &anchors, &forces})
            for (auto* axis : {&array->x, &array->y, &array->z})
                for (double& number : *axis) number = 4 * next() - 2;
        for (double& mass : all.mass) mass = 0.1 + next();
        for (std::size_t i = 1; i < n; i += 11) all.position.set(i, all.position[i - 1]);
    }
    std::vector<double> numbers() const {
        std::vector<double> list;
        for (const auto* array : {&all.position, &all.velocity, &forces})
            for (const auto* axis : {&array->x, &array->y, &array->z})
                list.insert(list.end(), axis->begin(), axis->end());
        return list;
    }
};

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

bool same_bits(const Particles& a, const Particles& b) {
    return same_bits(a.position.x, b.position.x) && same_bits(a.position.y, b.position.y) &&
           same_bits(a.position.z, b.position.z) && same_bits(a.velocity.x, b.velocity.x) &&
           same_bits(a.velocity.y, b.velocity.y) && same_bits(a.velocity.z, b.velocity.z);
}

const wide::Medium medium{0.3, -9.81, 0.2, 0.7};
constexpr double dt = 0.01;

// Runs every loop once; W is one of the three copies.
#define EVERY_LOOP(W, heap)                                                                         \
    [](Heap h) {                                                                                    \
        const std::size_t N = h.all.size();                                                         \
        const wide::Axes x = h.all.position.axes(), v = h.all.velocity.axes(), f = h.forces.axes(), \
                         a = h.anchors.axes();                                                      \
        const double* m = h.all.mass.data();                                                        \
        W::weight_and_drag(N, f, v, m, medium);                                                     \
        W::anchored_springs(N, f, x, a, 30);                                                        \
        W::springs_in_row(N, 1, x, f, 0.5, 40);                                                     \
        W::springs_in_row(N, 2, x, f, 1.5, 40);                                                     \
        W::springs_between(N / 2, x, x.from(N - N / 2), f, f.from(N - N / 2), 0.7, 20);             \
        W::kick(N, v, f, m, dt);                                                                    \
        W::drift(N, x, v, dt);                                                                      \
        W::anchored_step(N, x, v, m, a, 30, medium, dt);                                            \
        W::chain_step(N, x, v, m, 0.5, 40, medium, true, false, dt);                                \
        return h.numbers();                                                                         \
    }(heap)

}  // namespace

TEST_CASE("The wide loops give the same bits with and without AVX2, for every length") {
    for (const std::size_t n : std::vector<std::size_t>{1, 2, 3, 4, 5, 7, 8, 15, 16, 17, 31, 33, 100, 255,
                                                        256, 257, 511, 513, 1000}) {
        const Heap heap(n);
        const auto library = EVERY_LOOP(wide, heap), plain = EVERY_LOOP(without_avx2::nutshell::wide, heap);
        INFO(n << " particles");
        for (const double number : library) REQUIRE(std::isfinite(number));
        CHECK(same_bits(library, plain));
#if defined(__x86_64__) || defined(__i386__)
        if (__builtin_cpu_supports("avx2"))
            CHECK(same_bits(library, EVERY_LOOP(with_avx2::nutshell::wide, heap)));
#endif
    }
}

TEST_CASE("One pass over memory gives the bits of force, kick, drift: anchored particles") {
    for (const std::size_t n : std::vector<std::size_t>{1, 10, 257, 1000}) {
        const AnchoredParticles scene = anchored_particles(n);
        CHECK(same_bits(lab::run(scene, one_pass, 100), lab::run(scene, methods::semi_implicit_euler, 100)));
    }
}

TEST_CASE("One pass over memory gives the bits of force, kick, drift: chains, whatever is held") {
    for (const std::size_t n : std::vector<std::size_t>{1, 2, 255, 256, 257, 600}) {
        for (const bool free : {false, true}) {
            SpringNet net = chain(n, 0.1, {300, 0.1}, {0, 0, 0}, {0.1 * static_cast<double>(n), 0, 0}, free);
            net.drag = 0.05, net.duration = 0.5;
            CHECK(same_bits(lab::run(net, one_pass, 100), lab::run(net, methods::semi_implicit_euler, 100)));
            net.held = {n / 2};  // one in the middle: the general way
            CHECK(same_bits(lab::run(net, one_pass, 100), lab::run(net, methods::semi_implicit_euler, 100)));
            net.held = {};
            CHECK(same_bits(lab::run(net, one_pass, 100), lab::run(net, methods::semi_implicit_euler, 100)));
        }
    }
}

TEST_CASE("One pass over memory gives the bits of force, kick, drift: cloths") {
    for (const auto weave : {Weave::structural, Weave::with_shear, Weave::with_shear_and_bend})
        for (const std::size_t n : std::vector<std::size_t>{2, 3, 16, 33}) {
            SpringNet net = cloth(n, 1, 0.3, 30, weave);
            net.drag = 0.01, net.duration = 0.5;
            net.held = {0, n - 1};
            CHECK(same_bits(lab::run(net, one_pass, 200), lab::run(net, methods::semi_implicit_euler, 200)));
        }
}
