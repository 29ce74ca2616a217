// A drawing's things as pieces of one list of triangles, in the units and about the point that OpenGL works
// in.
#pragma once
#include <Eigen/Dense>
#include <map>
#include <utility>
#include <vector>

#include "geometry.hpp"
#include "nutshell/picture/camera.hpp"
#include "nutshell/picture/drawing.hpp"
#include "view.hpp"

namespace nutshell::picture {

/// Where OpenGL's origin lies and how long its unit is: the drawing's middle and radius. Positions are taken
/// there in double precision, so a drawing looks the same in centimetres, in kilometres, and far from the
/// world's origin.
struct Frame {
    Eigen::Vector3d origin;
    double unit;
    Eigen::Vector3d operator()(const Eigen::Vector3d& point) const { return (point - origin) / unit; }
};
Frame frame_of(const Drawing& drawing, const Camera& camera);

/// The sRGB colour as an amount of light.
Eigen::Vector3f linear(const Colour& colour, Theme theme);

/// Indices of triangles, one after another.
struct Run {
    int first = 0, count = 0;
};

/// One thing: its triangles, where they stand, and how they look.
struct Piece {
    Run run, shadow_run;  ///< in the picture, and in the shadow map, where fewer do
    Eigen::Matrix4f model = Eigen::Matrix4f::Identity();
    Eigen::Matrix3f normal_matrix = Eigen::Matrix3f::Identity();
    Eigen::Vector3f colour;  ///< linear
    bool ghost = false, shines = false, shadow = true;
    bool closed = true;  ///< nobody can see its inside
    Extent extent{};     ///< about which point and how far it reaches, in the frame
};

/// All of a drawing's pieces. @param pixel the angle that one sample of the picture spans [rad]
class Pieces {
  public:
    Pieces(const Drawing& drawing, const Frame& frame, const View& view, double pixel);
    const Triangles& triangles() const { return triangles_; }
    const std::vector<Piece>& all() const { return pieces_; }
    /// What casts shadows, for the shadow map to hold: bounding balls, in the frame.
    const std::vector<Extent>& casters() const { return casters_; }

  private:
    enum class Shape { ball, rod, cone, even_octants, odd_octants };
    Run append(const Triangles& more);
    Run shared(Shape shape, int detail);
    void place(Run run, Run shadow_run, const Eigen::Matrix3d& linear, const Eigen::Vector3d& at,
               const Piece& look);
    void add_bar(Shape shape, const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius,
                 const Piece& look);
    void cast(const Piece& look, const std::vector<Eigen::Vector3d>& points, double radius);
    double depth(const Eigen::Vector3d& at) const;
    int detail(const Eigen::Vector3d& at, double radius) const;
    void add_arrow(const Arrow& arrow);
    void add_ball(const Ball& ball, const Piece& given);
    void add_box(const Box& box, const Piece& given);
    void mark_faces(const Box& box, const Eigen::Vector3d& half);

    const Frame frame_;
    const View view_;
    const double pixel_;
    const Theme theme_;
    Triangles triangles_;
    std::vector<Piece> pieces_;
    std::vector<Extent> casters_;
    std::map<std::pair<Shape, int>, Run> shared_;
};

}  // namespace nutshell::picture
