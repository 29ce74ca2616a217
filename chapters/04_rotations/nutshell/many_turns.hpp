// The same small turn, a million times over: as a matrix and as a 4-vector, in float and in
// double, made straight again or not. What is left of a rotation then.
#pragma once
#include <Eigen/SVD>
#include <nutshell/rotations.hpp>
#include <string>
#include <vector>

namespace nutshell {

// [wear]
/// What is wrong with a pose after many turns.
struct Wear {
    double stretch = 0;  ///< |R^T R - 1|, all nine entries squared and added: 0 for a rotation
    double volume = 1;   ///< det R: what the body's volume is multiplied by
    double angle = 0;    ///< [rad] between the nearest rotation and the true one
};
// [/wear]

/// The wear of a matrix that should be the rotation `exact`.
inline Wear wear_of(const Matrix3& r, const Quaternion& exact) {
    const Eigen::JacobiSVD<Matrix3> svd(r, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Matrix3 nearest = svd.matrixU() * svd.matrixV().transpose();
    return {(r.transpose() * r - Matrix3::Identity()).norm(), r.determinant(),
            angle_between(Quaternion(nearest), exact)};
}

/// The wear of a 4-vector: that of its matrix, (28*) as it stands.
inline Wear wear_of(const Quaternion& q, const Quaternion& exact) {
    const Matrix3 r = rotation_matrix(q);
    return {(r.transpose() * r - Matrix3::Identity()).norm(), r.determinant(),
            angle_between(q, exact)};
}

namespace printed {

/// The source's class Rotation, listing C5, arithmetic for arithmetic: all in float, 1 - cos by
/// subtraction, no case for the angle 0, and the transpose of (23)-(26): it turns by -v. Errata
/// E51, E52, E53, E80. (Its 0/0 is the erratum: sanitizers are asked to let it pass.)
__attribute__((no_sanitize("float-divide-by-zero"))) inline Eigen::Matrix3f rotation(
    const Eigen::Vector3f& v) {
    const float theta = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    const float s = std::sin(theta), c = std::cos(theta), t = 1 - c;
    const float x = v[0] / theta, y = v[1] / theta, z = v[2] / theta;
    Eigen::Matrix3f m;
    m << t * x * x + c, t * x * y + s * z, t * x * z - s * y,  //
        t * x * y - s * z, t * y * y + c, t * y * z + s * x,   //
        t * x * z + s * y, t * y * z - s * x, t * z * z + c;
    return m;
}

/// The source's product of two matrices, its sums in its order.
inline Eigen::Matrix3f product(const Eigen::Matrix3f& a, const Eigen::Matrix3f& b) {
    Eigen::Matrix3f c = Eigen::Matrix3f::Zero();
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k) c(i, j) += a(i, k) * b(k, j);
    return c;
}

}  // namespace printed

// [keepers]
/// The ways to keep an orientation over many turns.
enum class Keeper {
    printed_matrix,           ///< float, the printed Rotation, its sense of turning corrected
    float_matrix,             ///< float, each step's matrix rounded from double
    float_four_vector,        ///< float, not normalised
    float_four_vector_unit,   ///< float, made as long as one after each turn
    double_matrix,            ///< double
    double_four_vector,       ///< double, not normalised
    double_four_vector_unit,  ///< double, made as long as one after each turn
};
inline constexpr std::array keepers{
    Keeper::printed_matrix,         Keeper::float_matrix,  Keeper::float_four_vector,
    Keeper::float_four_vector_unit, Keeper::double_matrix, Keeper::double_four_vector,
    Keeper::double_four_vector_unit};
// [/keepers]

inline std::string name_of(Keeper keeper) {
    switch (keeper) {
        case Keeper::printed_matrix:
            return "matrix, float, as printed";
        case Keeper::float_matrix:
            return "matrix, float";
        case Keeper::float_four_vector:
            return "4-vector, float";
        case Keeper::float_four_vector_unit:
            return "4-vector, float, normalised";
        case Keeper::double_matrix:
            return "matrix, double";
        case Keeper::double_four_vector:
            return "4-vector, double";
        default:
            return "4-vector, double, normalised";
    }
}

// [many_turns]
/// `turns` equal turns of `angle` [rad] about `axis`, one after another.
struct ManyTurns {
    Vector3 axis{1, 2, 3};
    double angle = 0.008;  // [rad]: one turn of the source's program at 1 rad/s
    long turns = 1'000'000;

    /// After n turns; accurate to 1e-16 of the angle turned.
    Quaternion exact(long n) const {
        return quaternion_about(axis, std::remainder(angle * static_cast<double>(n), 4 * pi));
    }
};
// [/many_turns]

namespace many_turns_parts {

/// pose = step pose, n times, and after each one straighten(pose).
template <class Pose, class Straighten>
Pose repeated(const Pose& step, Pose pose, long n, const Straighten& straighten) {
    for (long i = 0; i < n; ++i) {
        pose = Pose(step * pose);
        straighten(pose);
    }
    return pose;
}

/// The printed class's step, in the sense of ours: it turns by -v (E51).
inline Eigen::Matrix3f printed_step(const ManyTurns& scene) {
    const Vector3 v = -scene.angle * direction_of(scene.axis);
    return printed::rotation(v.cast<float>());
}

template <class Scalar>
Wear four_vector_wear(const ManyTurns& scene, bool unit) {
    using Q = Eigen::Quaternion<Scalar>;
    const Q step = quaternion_about(scene.axis, scene.angle).template cast<Scalar>();
    const Q pose = unit ? repeated(step, Q::Identity(), scene.turns, [](Q& q) { q.normalize(); })
                        : repeated(step, Q::Identity(), scene.turns, [](Q&) {});
    return wear_of(pose.template cast<double>(), scene.exact(scene.turns));
}

template <class Scalar>
Wear matrix_wear(const ManyTurns& scene) {
    using M = Eigen::Matrix<Scalar, 3, 3>;
    const M step = rotation_about(scene.axis, scene.angle).template cast<Scalar>();
    const M pose = repeated(step, M(M::Identity()), scene.turns, [](M&) {});
    return wear_of(Matrix3(pose.template cast<double>()), scene.exact(scene.turns));
}

}  // namespace many_turns_parts

/// Runs the scene one way and says what is left.
inline Wear wear(const ManyTurns& scene, Keeper keeper) {
    using namespace many_turns_parts;
    if (keeper == Keeper::float_matrix) return matrix_wear<float>(scene);
    if (keeper == Keeper::double_matrix) return matrix_wear<double>(scene);
    if (keeper == Keeper::float_four_vector) return four_vector_wear<float>(scene, false);
    if (keeper == Keeper::float_four_vector_unit) return four_vector_wear<float>(scene, true);
    if (keeper == Keeper::double_four_vector) return four_vector_wear<double>(scene, false);
    if (keeper == Keeper::double_four_vector_unit) return four_vector_wear<double>(scene, true);
    const Eigen::Matrix3f step = printed_step(scene);
    Eigen::Matrix3f pose = Eigen::Matrix3f::Identity();
    for (long i = 0; i < scene.turns; ++i) pose = printed::product(step, pose);
    return wear_of(Matrix3(pose.cast<double>()), scene.exact(scene.turns));
}

/// What the rounding of the step does by itself: the step of a float keeper (one that is never
/// made straight), but its million turns made in double.
inline Wear wear_by_step_alone(const ManyTurns& scene, Keeper keeper) {
    using namespace many_turns_parts;
    const Quaternion exact = scene.exact(scene.turns);
    if (keeper == Keeper::float_four_vector) {
        const Eigen::Quaternionf step = quaternion_about(scene.axis, scene.angle).cast<float>();
        return wear_of(repeated(step.cast<double>(), four_vector({0, 0, 0}, 1), scene.turns,
                                [](Quaternion&) {}),
                       exact);
    }
    const Eigen::Matrix3f step = keeper == Keeper::printed_matrix
                                     ? printed_step(scene)
                                     : rotation_about(scene.axis, scene.angle).cast<float>();
    return wear_of(repeated(Matrix3(step.cast<double>()), Matrix3(Matrix3::Identity()),
                            scene.turns, [](Matrix3&) {}),
                   exact);
}

}  // namespace nutshell
