#include "nutshell/picture/camera.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "view.hpp"

namespace nutshell::picture {

using Eigen::Vector3d;

void check(const Camera& camera) {
    auto refuse = [](const char* why) {
        throw std::invalid_argument(std::string("picture: the camera ") + why);
    };
    if (!camera.eye.allFinite()) refuse("has an eye that is not finite");
    if (!camera.target.allFinite()) refuse("has a target that is not finite");
    if (!camera.up.allFinite() || camera.up.norm() == 0)
        refuse("has an up that is not finite or of length zero");
    const Vector3d view = camera.target - camera.eye;
    if (view.norm() == 0) refuse("has its eye at its target");
    if (view.normalized().cross(camera.up.normalized()).norm() < 1e-9) refuse("looks along its up");
    if (!(camera.field_of_view > 0 && camera.field_of_view < std::numbers::pi)) {
        refuse("has a field of view outside 0 to pi");
    }
}

View::View(const Camera& camera, double aspect_ratio)
    : eye(camera.eye), tangent(std::tan(camera.field_of_view / 2)), aspect(aspect_ratio) {
    back = (camera.eye - camera.target).normalized();
    right = camera.up.cross(back).normalized();
    up = back.cross(right);
}

Vector3d View::to_camera(const Vector3d& point) const {
    const Vector3d d = point - eye;
    return {right.dot(d), up.dot(d), back.dot(d)};
}

Vector3d project(const Camera& camera, Size size, const Vector3d& point) {
    const View view(camera, double(size.width) / size.height);
    const Vector3d p = view.to_camera(point);
    if (p.z() == 0) return {size.width / 2.0, size.height / 2.0, 0};  // beside the eye: on no picture
    const double half_height = size.height / 2.0, scale = half_height / (view.tangent * -p.z());
    return {size.width / 2.0 + scale * p.x(), half_height - scale * p.y(), -p.z()};
}

namespace {

/// The drawing's extents, and where their shadows fall if that is no farther below than the drawing is large.
std::vector<Extent> seen_extents(const Drawing& drawing) {
    std::vector<Extent> all = drawing.extents();
    const Vector3d up = drawing.ground().normal, sun = drawing.sun();
    if (!drawing.ground().visible || up.dot(sun) < 0.2 || all.empty()) return all;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Extent& extent : all) {
        low = std::min(low, up.dot(extent.centre) - extent.radius);
        high = std::max(high, up.dot(extent.centre) + extent.radius);
    }
    const double ground = drawing.ground().height;
    const std::size_t things = all.size();
    if (low - ground > high - low) return all;
    for (std::size_t i = 0; i < things; ++i) {
        const double height = up.dot(all[i].centre) - ground;
        if (!all[i].shadow || height < 0) continue;
        all.push_back({all[i].centre - sun * height / up.dot(sun), all[i].radius});
    }
    return all;
}

}  // namespace

/// With the camera's axes fixed, a point (x, y, z) lies left of the right edge while x + z t <= ex + ez t,
/// where (ex, ey, ez) is the eye and t the edge's tangent; so each edge is one bound, met by the farthest
/// point.
Camera fit(const Drawing& drawing, const Vector3d& from, Size size, const Fit& how) {
    if (!from.allFinite() || from.norm() == 0) {
        throw std::invalid_argument("picture: fit needs a finite direction that is not zero");
    }
    const std::vector<Extent> extents = seen_extents(drawing);
    if (extents.empty()) throw std::invalid_argument("picture: fit needs a drawing with something in it");
    const Vector3d middle = extents.front().centre;
    Camera camera{middle + from, middle, how.field_of_view, how.up};
    check(camera);
    const double aspect = double(size.width) / size.height;
    const View view(camera, aspect);

    const double words = 0.07;  // share of the height that a line of words takes
    const double across = view.tangent * aspect * (1 - 2 * how.margin);
    const double above = view.tangent * (1 - 2 * (how.margin + (drawing.title().empty() ? 0 : words)));
    const double below = view.tangent * (1 - 2 * (how.margin + (drawing.caption().empty() ? 0 : words)));
    const double nothing = -std::numeric_limits<double>::infinity();
    double right = nothing, left = nothing, top = nothing, bottom = nothing, nearest = nothing;
    for (const Extent& extent : extents) {
        const Vector3d p = view.to_camera(extent.centre);
        auto bound = [&](double x, double t) { return x + p.z() * t + extent.radius * std::hypot(1.0, t); };
        right = std::max(right, bound(p.x(), across));
        left = std::max(left, bound(-p.x(), across));
        top = std::max(top, bound(p.y(), above));
        bottom = std::max(bottom, bound(-p.y(), below));
        nearest = std::max(nearest, p.z() + extent.radius);
    }
    const double room = std::max({(right + left) / (2 * across), (top + bottom) / (above + below)});
    const double z = room > nearest ? room : nearest + from.norm();  // a single point has no size to fit
    const double x = (right - left) / 2;
    const double y =
        (top - z * above + z * below - bottom) / 2;  // as far from the top edge as from the bottom edge
    camera.eye = view.eye + x * view.right + y * view.up + z * view.back;
    double farthest = 0;
    for (const Extent& extent : extents) farthest = std::max(farthest, z - view.to_camera(extent.centre).z());
    camera.target = camera.eye - view.back * ((z - nearest + farthest) / 2);
    return camera;
}

}  // namespace nutshell::picture
