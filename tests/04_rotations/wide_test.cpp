// The wide loops give what the plain functions give, whatever the number of items.
#include <nutshell/wide_turns.hpp>
#include "group.hpp"

using namespace nutshell;

namespace {

/// Numbers between -1 and 1 that favour nothing, the same in every run.
std::vector<double> numbers(std::size_t n, unsigned state) {
    std::vector<double> all(n);
    for (double& x : all) {
        state = state * 1664525u + 1013904223u;
        x = static_cast<double>(state >> 8) / (1 << 23) - 1;
    }
    return all;
}

struct Points {
    std::vector<double> x, y, z;
    explicit Points(std::size_t n) : x(numbers(n, 1)), y(numbers(n, 2)), z(numbers(n, 3)) {}
    wide::Axes axes() { return {x.data(), y.data(), z.data()}; }
    Vector3 at(std::size_t i) const { return {x[i], y[i], z[i]}; }
};

struct Poses {
    std::vector<double> x, y, z, w;
    Poses(std::size_t n, unsigned seed)
        : x(numbers(n, seed)), y(numbers(n, seed + 1)), z(numbers(n, seed + 2)), w(numbers(n, seed + 3)) {
        for (std::size_t i = 0; i < n; ++i) {
            const Quaternion unit = at(i).normalized();
            x[i] = unit.x(), y[i] = unit.y(), z[i] = unit.z(), w[i] = unit.w();
        }
    }
    wide::FourVectors view() { return {x.data(), y.data(), z.data(), w.data()}; }
    Quaternion at(std::size_t i) const { return four_vector({x[i], y[i], z[i]}, w[i]); }
};

}  // namespace

TEST_CASE("wide loops turn points as rotate does, for any number of points") {
    const Quaternion q = quaternion_about({1, 2, 3}, 2.2);
    const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> r = rotation_matrix(q);
    for (const std::size_t n : std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 7, 8, 33, 1000}) {
        Points in(n), by_matrix(n), by_four_vector(n), streamed(n);
        wide::turn_by_matrix(n, by_matrix.axes(), in.axes(), r.data());
        wide::turn_by_four_vector(n, by_four_vector.axes(), in.axes(), q.coeffs().data());
        wide::stream_points(n, streamed.axes(), in.axes());
        for (std::size_t i = 0; i < n; ++i) {
            CHECK((by_matrix.at(i) - rotate(q, in.at(i))).norm() <= identity);
            CHECK((by_four_vector.at(i) - rotate(q, in.at(i))).norm() <= identity);
            CHECK(streamed.at(i) == in.at(i) + Vector3::Ones());
        }
    }
}

TEST_CASE("wide loops compose as product does, for any number of poses") {
    for (const std::size_t n : std::vector<std::size_t>{0, 1, 3, 4, 9, 257}) {
        const Poses before(n, 11);
        Poses turn(n, 77), plain = before, unit = before, streamed = before;
        wide::stream_four_vectors(n, streamed.view(), turn.view());
        wide::compose_four_vectors(n, plain.view(), turn.view());
        wide::compose_unit_four_vectors(n, unit.view(), turn.view());
        std::array<std::vector<double>, 9> pose_entries, turn_entries;
        wide::Matrices poses, turns;
        for (int e = 0; e < 9; ++e) {
            const auto k = static_cast<std::size_t>(e);
            for (std::size_t i = 0; i < n; ++i) {
                pose_entries[k].push_back(rotation_matrix(before.at(i))(e / 3, e % 3));
                turn_entries[k].push_back(rotation_matrix(turn.at(i))(e / 3, e % 3));
            }
            poses[k] = pose_entries[k].data(), turns[k] = turn_entries[k].data();
        }
        wide::compose_matrices(n, poses, turns);
        for (std::size_t i = 0; i < n; ++i) {
            const Quaternion exact = product(turn.at(i), before.at(i));
            CHECK(streamed.at(i).coeffs() == before.at(i).coeffs() + turn.at(i).coeffs());
            CHECK(apart(plain.at(i), exact) <= identity);
            CHECK(apart(unit.at(i), exact) <= identity);
            CHECK(std::abs(unit.at(i).norm() - 1) <= 2 * epsilon);
            const Matrix3 r = rotation_matrix(exact);
            for (int e = 0; e < 9; ++e)
                CHECK(std::abs(pose_entries[static_cast<std::size_t>(e)][i] - r(e / 3, e % 3)) <= identity);
        }
    }
}
