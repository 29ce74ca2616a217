// Chapter 3 · A scene as a general-purpose method sees it: y' = f(t, y), with y one flat list
// of numbers.
#pragma once
#include <nutshell/newton.hpp>
#include <utility>

namespace nutshell {

// [flow]
/// Position [m] and velocity [m/s] of a point mass, one after the other.
using FlatPoint = Eigen::Matrix<double, 6, 1>;

inline FlatPoint flat(const PointMass& body) {
    FlatPoint y;
    y << body.position, body.velocity;
    return y;
}

/// The body `like`, but where y says. Its mass does not flow.
inline PointMass unflat(const FlatPoint& y, PointMass like) {
    like.position = y.head<3>();
    like.velocity = y.tail<3>();
    return like;
}

/// How the flat state changes per second: position by the velocity, velocity by force [N] over
/// mass.
inline FlatPoint rate(const PointMass& body, const Vector3& force) {
    FlatPoint y;
    y << body.velocity, force / body.mass;
    return y;
}

/// A scene turned into a flow; itself a scene, whose state is flat and whose push is y'. Works
/// for every state that has flat, unflat and rate.
template <class Scene>
struct Flow {
    using Flat = decltype(flat(std::declval<Scene>().start));
    Scene of;  ///< the scene that flows
    std::string name = of.name;
    double duration = of.duration;
    Flat start = flat(of.start);

    explicit Flow(const Scene& scene) : of(scene) {}
    Flat operator()(const Flat& y, double t) const {
        const auto state = unflat(y, of.start);
        return rate(state, of(state, t));
    }
    double error(const Flat& y, double t) const { return of.error(unflat(y, of.start), t); }
};
// [/flow]

}  // namespace nutshell
