#include "ribbon.hpp"

#include <cmath>

namespace nutshell::picture {

namespace {

using Eigen::Vector2d, Eigen::Vector4d;

struct Flat {
    Vector2d at;  ///< [pixels]
    double depth, w, opacity;
};

}  // namespace

std::vector<std::vector<RibbonPoint>> cut_runs(const std::vector<std::pair<Eigen::Vector3d, double>>& points,
                                               const Eigen::Matrix4d& to_clip, double nearest) {
    std::vector<std::vector<RibbonPoint>> runs(1);
    Vector4d before;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vector4d clip = to_clip * points[i].first.homogeneous();
        const bool inside = clip.w() > nearest;
        if (i > 0 && inside != (before.w() > nearest)) {
            const double share = (nearest - before.w()) / (clip.w() - before.w());
            if (inside) runs.emplace_back();
            runs.back().push_back({before + share * (clip - before), points[i].second});
        }
        if (inside) runs.back().push_back({clip, points[i].second});
        before = clip;
    }
    return runs;
}

std::vector<RibbonVertex> ribbon(const std::vector<RibbonPoint>& points, const Eigen::Vector3f& colour,
                                 double half_width, const Vector2d& size) {
    const double closest = 0.5;  // points nearer than this to the last one say nothing new [pixels]
    const double feather = 1;    // extra width for the soft edge [pixels]
    std::vector<Flat> flat;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vector4d& c = points[i].clip;
        const Vector2d at = (c.head<2>() / c.w()).cwiseProduct(size / 2);
        const bool last = i + 1 == points.size();
        if (!flat.empty() && (at - flat.back().at).norm() < (last ? 1e-3 : closest)) continue;
        flat.push_back({at, c.z() / c.w(), c.w(), points[i].opacity});
    }
    std::vector<RibbonVertex> strip;
    if (flat.size() < 2) return strip;
    const double reach = half_width + feather;
    auto put = [&](const Flat& point, const Vector2d& offset, double across, double along) {
        const Vector2d ndc = (point.at + offset).cwiseQuotient(size / 2);
        const Vector4d clip(ndc.x() * point.w, ndc.y() * point.w, point.depth * point.w, point.w);
        strip.push_back({clip.cast<float>(),
                         {float(across), float(along)},
                         {colour.x(), colour.y(), colour.z(), float(point.opacity)}});
    };
    auto put_pair = [&](const Flat& point, const Vector2d& offset, double along) {
        put(point, offset * reach, reach, along);
        put(point, -offset * reach, -reach, along);
    };
    auto normal = [&](std::size_t i) {  // of the piece from i to i + 1
        const Vector2d d = (flat[i + 1].at - flat[i].at).normalized();
        return Vector2d(-d.y(), d.x());
    };
    double along = 0;
    put_pair(flat[0], normal(0), 0);
    for (std::size_t i = 1; i < flat.size(); ++i) {
        along += (flat[i].at - flat[i - 1].at).norm();
        if (i + 1 == flat.size()) {
            put_pair(flat[i], normal(i - 1), along);
            break;
        }
        const Vector2d before = normal(i - 1), after = normal(i);
        const double half_cosine_squared = (1 + before.dot(after)) / 2;
        if (half_cosine_squared > 0.3) {  // a mitre; at sharper turns it would be a spike
            put_pair(flat[i], (before + after).normalized() / std::sqrt(half_cosine_squared), along);
        } else {
            put_pair(flat[i], before, along);
            put_pair(flat[i], after, along);
        }
    }
    return strip;
}

}  // namespace nutshell::picture
