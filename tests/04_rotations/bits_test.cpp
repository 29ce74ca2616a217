// The same bits from g++ and clang, and from the wide loops in every width. No libm function enters here.
#include <cstdio>
#include <cstring>
#include <nutshell/wide_turns.hpp>
#include "group.hpp"

#define SHARED                                                                                \
    using ::nutshell::wide::Axes, ::nutshell::wide::ConstAxes, ::nutshell::wide::FourVectors, \
        ::nutshell::wide::Matrices
#define KERNEL "../chapters/04_rotations/kernels/turns.cpp"
#include "three_widths.hpp"

using namespace nutshell;

namespace {

constexpr std::size_t count = 37;

struct Run {
    std::vector<double> numbers = std::vector<double>(18 * count);
    Run() {
        unsigned state = 7;
        for (double& x : numbers) {
            state = state * 1664525u + 1013904223u;
            x = static_cast<double>(state >> 8) / (1 << 23) - 1;
        }
    }
    double* row(std::size_t i) { return numbers.data() + i * count; }
    wide::Axes axes(std::size_t i) { return {row(i), row(i + 1), row(i + 2)}; }
    wide::FourVectors fours(std::size_t i) { return {row(i), row(i + 1), row(i + 2), row(i + 3)}; }
    wide::Matrices matrices(std::size_t i) {
        wide::Matrices m;
        for (std::size_t k = 0; k < 9; ++k) m[k] = row(i + k);
        return m;
    }
    /// Everything, one after the other, by the loops handed in.
    template <class Matrix, class Four, class Compose, class Unit, class Matrices>
    Run by(const Matrix& matrix, const Four& four, const Compose& compose, const Unit& unit,
           const Matrices& compose_matrices) {
        const double m[9] = {0.3, -0.2, 0.7, 0.1, 0.9, -0.4, 0.25, 0.6, -0.8}, q[4] = {0.1, -0.5, 0.3, 0.8};
        matrix(count, axes(3), axes(0), m);
        four(count, axes(6), axes(0), q);
        compose(count, fours(8), fours(2));
        unit(count, fours(12), fours(4));
        compose_matrices(count, matrices(9), matrices(0));
        return *this;
    }
};

}  // namespace

TEST_CASE("small turns, products and matrices give the same bits from every compiler") {
    Quaternion q = four_vector({0.5, -0.5, 0.5}, 0.5);
    for (int n = 0; n < 1000; ++n) q = small_turn(q, {0.01, -0.02, 0.03});
    const Vector3 p = rotate(product(q, q), {1, 2, 3}), r = rotation_matrix(q) * Vector3(1, 2, 3);
    char text[300];
    std::snprintf(text, sizeof text, "%a %a %a %a | %a %a %a | %a %a %a", q.x(), q.y(), q.z(), q.w(), p.x(),
                  p.y(), p.z(), r.x(), r.y(), r.z());
    CHECK(std::string(text) ==
          "0x1.d39dced7f0d2p-2 -0x1.fabdb2207232cp-2 0x1.ac7deb8f6f6f7p-2 0x1.380eadfcfb2d8p-1 | "
          "0x1.9132069bc8c22p+0 -0x1.19ce375c76854p+1 -0x1.4b3e50a7139b2p+1 | "
          "-0x1.36af4ad490158p+1 -0x1.31c573fb4ba27p+1 0x1.8cc2ec93fb37fp+0");
}

TEST_CASE("the wide loops of chapter 4 give the same bits in every width") {
    const Run library = Run().by(wide::turn_by_matrix, wide::turn_by_four_vector, wide::compose_four_vectors,
                                 wide::compose_unit_four_vectors, wide::compose_matrices);
    namespace plain = without_avx2::nutshell::wide;
    const Run narrow =
        Run().by(plain::turn_by_matrix, plain::turn_by_four_vector, plain::compose_four_vectors,
                 plain::compose_unit_four_vectors, plain::compose_matrices);
    const std::size_t bytes = library.numbers.size() * sizeof(double);
    CHECK(std::memcmp(library.numbers.data(), narrow.numbers.data(), bytes) == 0);
#if defined(__x86_64__) || defined(__i386__)
    if (__builtin_cpu_supports("avx2")) {
        namespace wider = with_avx2::nutshell::wide;
        const Run wide_run =
            Run().by(wider::turn_by_matrix, wider::turn_by_four_vector, wider::compose_four_vectors,
                     wider::compose_unit_four_vectors, wider::compose_matrices);
        CHECK(std::memcmp(library.numbers.data(), wide_run.numbers.data(), bytes) == 0);
    }
#endif
}
