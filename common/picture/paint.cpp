#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include "grid.hpp"
#include "pieces.hpp"
#include "projection.hpp"
#include "ribbon.hpp"
#include "studio.hpp"

namespace nutshell::picture {

namespace {

using Eigen::Matrix4d, Eigen::Vector2d, Eigen::Vector3d, Eigen::Vector3f, Eigen::Vector4d;

/// The work on one picture.
class Painter {
  public:
    Painter(Studio& studio, const Drawing& drawing, const Camera& camera, Size size, const Quality& quality)
        : studio_(studio),
          drawing_(drawing),
          size_(size),
          quality_(quality),
          samples_(size.width * quality.samples, size.height * quality.samples),
          view_(camera, double(size.width) / size.height),
          frame_(frame_of(drawing, camera)),
          eye_(frame_(camera.eye)),
          sun_(drawing.sun()),
          up_(drawing.ground().normal),
          ground_height_(drawing.ground().height / frame_.unit - up_.dot(frame_.origin) / frame_.unit),
          pieces_(drawing, frame_, view_, 2 * view_.tangent / samples_.y()),
          projection_(fit_depths()),
          sun_view_(sun_view(pieces_.casters(), sun_)) {}

    /// @param use_target makes the frame to be drawn on the current one
    void draw_on(const std::function<void()>& use_target) {
        const gl::ShadowMap shadows(quality_.shadow_map);
        const Triangles& list = pieces_.triangles();
        const gl::Buffer things(list.vertices.data(), list.vertices.size() * sizeof(Vertex), {3, 3},
                                list.indices);
        glDisable(GL_BLEND);
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_LEQUAL);
        paint_shadow_map(shadows, things);
        use_target();
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        shadows.bind();
        paint_sky();
        if (drawing_.ground().visible) {
            paint_ground();
            paint_trails(true);
        }
        paint_glow();
        things.use();
        paint_solids();
        paint_trails(false);
        things.use();
        paint_ghosts();
    }

  private:
    /// Nearest and farthest depth that matter: things, and the ground as far as it can be told from the sky.
    Projection fit_depths() const {
        auto [nearest, farthest] = depths_of(drawing_.extents(), frame_, view_, eye_);
        const double focus = eye_.norm();
        farthest = std::max(farthest, focus + 1);
        if (drawing_.ground().visible) {
            nearest = std::min(nearest, std::abs(up_.dot(eye_) - ground_height_));
            farthest = std::max(farthest, focus + 2 * ground_reach());
        }
        return projection(view_, eye_, std::clamp(0.6 * nearest, 2e-3 * focus, focus), farthest);
    }

    Vector3f light(const Colour& colour) const { return linear(colour, drawing_.theme()); }

    double ground_reach() const { return 40 + 4 * eye_.norm(); }

    void paint_shadow_map(const gl::ShadowMap& shadows, const gl::Buffer& things) const {
        shadows.use();
        glClear(GL_DEPTH_BUFFER_BIT);
        Matrix4d to_clip = Matrix4d::Identity();
        to_clip.diagonal() << 2, 2, 2, 1;
        to_clip.topRightCorner<3, 1>().setConstant(-1);
        studio_.depth.use();
        studio_.depth.set("view_projection", Eigen::Matrix4f((to_clip * sun_view_.matrix).cast<float>()));
        things.use();
        for (const Piece& piece : pieces_.all()) {
            if (!piece.shadow) continue;
            studio_.depth.set("model", piece.model);
            draw_triangles(piece, piece.shadow_run);
        }
    }

    void set_light(const gl::Program& program) const {
        const double texel = std::max(sun_view_.sides.x(), sun_view_.sides.y()) / quality_.shadow_map;
        const double step = std::max(1.3 * texel, 0.0022);  // softness: a share of the drawing's radius
        program.set("view_projection", Eigen::Matrix4f(projection_.matrix.cast<float>()));
        program.set("shadow_view", Eigen::Matrix4f(sun_view_.matrix.cast<float>()));
        program.set("shadow_step",
                    Eigen::Vector2f(float(step / sun_view_.sides.x()), float(step / sun_view_.sides.y())));
        program.set("shadow_lift", 2.2 * step);
        program.set("shadow_map", 0);
        program.set("sun", Vector3f(sun_.cast<float>()));
        program.set("up", Vector3f(up_.cast<float>()));
    }

    void paint_sky() const {
        // the horizon's height on the picture, 0 at its bottom and 1 at its top
        const double slope = -view_.back.dot(up_) / std::max(1e-6, view_.up.dot(up_));
        const double horizon =
            drawing_.ground().visible ? std::clamp(0.5 - 0.5 * slope / view_.tangent, -2.0, 2.0) : 0.0;
        glDisable(GL_DEPTH_TEST);
        studio_.sky.use();
        studio_.sky.set("top", light(drawing_.sky().top));
        studio_.sky.set("horizon", light(drawing_.sky().horizon));
        studio_.sky.set("horizon_height", std::min(horizon, 0.9));
        const gl::Buffer nothing(nullptr, 0, {});
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glEnable(GL_DEPTH_TEST);
    }

    void paint_ground() const {
        const GridAxes grid = grid_axes(drawing_.ground());
        const double spacing = grid_spacing(drawing_.ground(), frame_.unit);
        const Vector3d focus = up_ * ground_height_;  // below the drawing's middle
        std::vector<Vertex> square;
        const double reach = ground_reach();
        for (const auto& [u, v] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}}) {
            const Vector3d corner = focus + reach * (u * grid.u + v * grid.v);
            square.push_back({corner.cast<float>(), up_.cast<float>()});
        }
        const auto offset = [&](const Vector3d& axis) {
            return float(std::fmod(axis.dot(frame_.origin) / spacing, 10.0));
        };
        const gl::Buffer buffer(square.data(), square.size() * sizeof(Vertex), {3, 3});
        const gl::Program& program = studio_.ground;
        program.use();
        set_light(program);
        program.set("model", Eigen::Matrix4f(Eigen::Matrix4f::Identity()));
        program.set("normal_matrix", Eigen::Matrix3f(Eigen::Matrix3f::Identity()));
        program.set("colour", light(palette::ground));
        program.set("horizon", light(drawing_.sky().horizon));
        program.set("focus", Vector3f(focus.cast<float>()));
        program.set("grid_u", Vector3f(grid.u.cast<float>()));
        program.set("grid_v", Vector3f(grid.v.cast<float>()));
        program.set("grid_offset", Eigen::Vector2f(offset(grid.u), offset(grid.v)));
        program.set("samples", double(quality_.samples));
        program.set("ink", drawing_.theme() == Theme::dark ? Vector3f(1.75F, 1.75F, 1.75F)
                                                           : Vector3f(0.60F, 0.63F, 0.68F));
        program.set("squares", frame_.unit / spacing);
        glDrawArrays(GL_TRIANGLES, 0, 6);
    }

    void draw(const Piece& piece) const {
        studio_.solid.set("model", piece.model);
        studio_.solid.set("normal_matrix", piece.normal_matrix);
        studio_.solid.set("colour", piece.colour);
        studio_.solid.set("kind", piece.ghost ? 1 : piece.shines ? 2 : 0);
        studio_.solid.set("closed", piece.closed ? 1 : 0);
        draw_triangles(piece, piece.run);
    }

    static void draw_triangles(const Piece& piece, Run run) {
        if (piece.closed) glEnable(GL_CULL_FACE);
        glDrawElements(GL_TRIANGLES, run.count, GL_UNSIGNED_INT,
                       reinterpret_cast<const void*>(std::size_t(run.first) * sizeof(std::uint32_t)));
        glDisable(GL_CULL_FACE);
    }

    /// Behind everything else: what stands before it or near it covers it.
    void paint_glow() const {
        const double reach = 3.2;  // radii
        glEnable(GL_BLEND);
        glDisable(GL_DEPTH_TEST);
        studio_.glow.use();
        for (const Piece& piece : pieces_.all()) {
            if (!piece.shines) continue;
            std::vector<RibbonVertex> square;
            for (const auto& [x, y] : {std::pair{-1.0F, -1.0F}, {1.0F, -1.0F}, {-1.0F, 1.0F}, {1.0F, 1.0F}}) {
                const Vector3d offset =
                    reach * piece.extent.radius * (double(x) * view_.right + double(y) * view_.up);
                const Vector3f& c = piece.colour;
                square.push_back({to_clip(piece.extent.centre + offset).cast<float>(),
                                  {x, y},
                                  {c.x(), c.y(), c.z(), 0.9F}});
            }
            const gl::Buffer buffer(square.data(), square.size() * sizeof(RibbonVertex), {4, 2, 4});
            glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
        }
        glEnable(GL_DEPTH_TEST);
        glDisable(GL_BLEND);
    }

    void paint_solids() const {
        studio_.solid.use();
        set_light(studio_.solid);
        studio_.solid.set("eye", Vector3f(eye_.cast<float>()));
        for (const Piece* solid : sorted_by_distance(false)) draw(*solid);  // what is hidden costs little
    }

    /// The solids or the ghosts, nearest first.
    std::vector<const Piece*> sorted_by_distance(bool ghosts) const {
        std::vector<const Piece*> found;
        for (const Piece& piece : pieces_.all()) {
            if (piece.ghost == ghosts) found.push_back(&piece);
        }
        std::stable_sort(found.begin(), found.end(), [&](const Piece* a, const Piece* b) {
            return (a->extent.centre - eye_).squaredNorm() < (b->extent.centre - eye_).squaredNorm();
        });
        return found;
    }

    /// From far to near, each first into the depths alone, so that only its nearest face is seen.
    void paint_ghosts() const {
        std::vector<const Piece*> ghosts = sorted_by_distance(true);
        std::reverse(ghosts.begin(), ghosts.end());
        studio_.solid.use();
        set_light(studio_.solid);
        studio_.solid.set("eye", Vector3f(eye_.cast<float>()));
        for (const Piece* ghost : ghosts) {
            glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
            draw(*ghost);
            glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
            glEnable(GL_BLEND);
            draw(*ghost);
            glDisable(GL_BLEND);
        }
    }

    Vector4d to_clip(const Vector3d& point) const { return projection_.matrix * point.homogeneous(); }

    /// The trails, or their shadows on the ground.
    void paint_trails(bool shadows) const {
        const double pixel = samples_.x() / 960;
        glEnable(GL_BLEND);
        glDepthMask(GL_FALSE);
        studio_.trail.use();
        for (const Trail& trail : drawing_.trails()) {
            if (shadows && !trail.shadow) continue;
            const double width = trail.width * pixel * (shadows ? 0.8 : 1);
            studio_.trail.set("half_width", width / 2);
            studio_.trail.set("dash", trail.dashed ? 3.6 * width : 0.0);
            studio_.trail.set("gap", trail.dashed ? 2.6 * width : 0.0);
            const Vector3f colour = light(shadows ? palette::shadow : trail.colour);
            for (const auto& run : visible_runs(trail, shadows)) {
                const std::vector<RibbonVertex> strip = ribbon(run, colour, width / 2, samples_);
                if (strip.empty()) continue;
                const gl::Buffer buffer(strip.data(), strip.size() * sizeof(RibbonVertex), {4, 2, 4});
                glDrawArrays(GL_TRIANGLE_STRIP, 0, GLsizei(strip.size()));
            }
        }
        glDepthMask(GL_TRUE);
        glDisable(GL_BLEND);
    }

    /// A trail's points in clip coordinates, cut where it leaves the space in front of the eye.
    std::vector<std::vector<RibbonPoint>> visible_runs(const Trail& trail, bool shadow) const {
        const double lift =
            2e-3;  // share of the way to the eye, so that a line on a surface is not swallowed
        const double start = trail.opacity_at_start < 0 ? trail.opacity : trail.opacity_at_start;
        const double fall = up_.dot(sun_);
        std::vector<std::pair<Vector3d, double>> points;
        for (std::size_t i = 0; i < trail.points.size(); ++i) {
            Vector3d p = frame_(trail.points[i]);
            const double share = double(i) / double(trail.points.size() - 1);
            double opacity = start + share * (trail.opacity - start);
            if (shadow) {
                const double height = up_.dot(p) - ground_height_;
                opacity = height > -1e-6 && fall > 0.05 ? 0.28 * opacity : 0;
                p -= sun_ * height / std::max(fall, 0.05);
            }
            points.emplace_back(p + lift * (eye_ - p), opacity);
        }
        return cut_runs(points, projection_.matrix, 1.01 * projection_.near);
    }

    Studio& studio_;
    const Drawing& drawing_;
    const Size size_;
    const Quality quality_;
    const Vector2d samples_;
    const View view_;
    const Frame frame_;
    const Vector3d eye_, sun_, up_;
    const double ground_height_;
    const Pieces pieces_;
    const Projection projection_;
    const SunView sun_view_;
};

}  // namespace

void draw(Studio& studio, const Drawing& drawing, const Camera& camera, Size size, const Quality& quality,
          const std::function<void()>& use_target) {
    Painter(studio, drawing, camera, size, quality).draw_on(use_target);
}

}  // namespace nutshell::picture
