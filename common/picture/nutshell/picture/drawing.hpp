// What can be drawn: a Drawing is a list of things in the world. World frame: right-handed, y up; lengths in
// metres.
#pragma once
#include <Eigen/Dense>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "nutshell/picture/colour.hpp"

namespace nutshell::picture {

/// A solid thing is lit and casts a shadow; a ghost is translucent and casts none: use it for what is exact.
enum class Look { solid, ghost };

/// A ball.
struct Ball {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< [m]
    double radius = 0.1;                               ///< [m]
    Colour colour = palette::body;
    Look look = Look::solid;
    bool shines = false;  ///< a lamp or a star: drawn in full light, without shade
    /// From the body's frame to the world: then its octants are told apart, and it can be seen to turn.
    std::optional<Eigen::Quaterniond> orientation{};
    /// A shadow only where it nearly touches the ground: for the many images of one body, whose shadows would
    /// look like a second path.
    bool contact_shadow = false;
};

/// A box with slightly rounded edges.
struct Box {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();         ///< from the box's frame to the world
    Eigen::Vector3d half_extents = Eigen::Vector3d::Constant(0.5);  ///< [m]
    Colour colour = palette::gold;
    Look look = Look::solid;
    /// Its faces are told apart, so that its orientation can be seen: those of x dark, of y light, of z in
    /// its colour, and a dot on the three that face along +x, +y, +z.
    bool marked = false;
};

/// A rod: a straight round bar between two points (a pendulum's arm, a chain's link, an axle).
struct Rod {
    Eigen::Vector3d from = Eigen::Vector3d::Zero();  ///< [m]
    Eigen::Vector3d to = Eigen::Vector3d::UnitY();   ///< [m]
    double radius = 0.02;                            ///< [m]
    Colour colour = palette::steel;
    Look look = Look::solid;
};

/// A tube bent through points: a rope, a wire, a coil (see `coil`).
struct Tube {
    std::vector<Eigen::Vector3d> points{};  ///< at least two [m]
    double radius = 0.02;                   ///< [m]
    Colour colour = palette::steel;
    Look look = Look::solid;
};

/// Triangles with a pose: a cloth, a hull, an asset. Both sides are lit.
struct Mesh {
    std::vector<Eigen::Vector3d> points{};                   ///< in the body's frame [m]
    std::vector<std::array<int, 3>> triangles{};             ///< indices into points
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< from the body's frame to the world
    Colour colour = palette::body;
    bool smooth = false;  ///< true: shaded as a curved surface (cloth); false: with flat faces
    Look look = Look::solid;
};

/// Where something went: a line of constant width on the picture.
struct Trail {
    std::vector<Eigen::Vector3d> points{};  ///< [m]
    Colour colour = palette::body;
    bool dashed = false;           ///< dashed for what is exact
    double width = 4;              ///< [pixels of a picture 960 wide]
    double opacity = 1;            ///< at its end, 0 to 1
    double opacity_at_start = -1;  ///< the trail fades in from here; negative: as at its end
    bool shadow = false;           ///< leaves a faint shadow on the ground
};

/// An arrow with its foot at a point: velocity, force, later L and omega. Lengths are world lengths:
/// multiply a velocity by metres-per-(m/s) of your choice, and say it in the caption.
struct Arrow {
    Eigen::Vector3d from = Eigen::Vector3d::Zero();     ///< [m]
    Eigen::Vector3d vector = Eigen::Vector3d::UnitY();  ///< as long as it shall be drawn [m]
    Colour colour = palette::velocity;
    std::string label{};  ///< at its tip; empty: none
    double width = 6;     ///< of its shaft [pixels of a picture 960 wide]
};

/// Three arrows x, y, z in one frame (red, green, blue would clash with the methods': they are inked and
/// named).
struct Axes {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    double length = 1;  ///< [m]
    std::array<std::string, 3> names{"x", "y", "z"};
};

/// Words anchored at a point of the world. They are kept inside the picture and off each other.
struct Label {
    Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< [m]
    std::string text{};                            ///< UTF-8
    Colour colour = palette::ink;
};

/// The ground: a plane with a grid, and at the picture's corner how long one square is.
struct Ground {
    double height = 0;                                  ///< of the plane along its normal [m]
    Eigen::Vector3d normal = Eigen::Vector3d::UnitY();  ///< up from the plane
    double spacing = 0;      ///< of the grid [m]; 0: a round number that suits the drawing
    std::string unit = "m";  ///< metres are written as mm, cm, m or km; any other unit as it is
    bool visible = true;     ///< false: no plane at all
};

/// The light in the air: a plain gradient, so that nothing draws the eye away from the physics.
struct Sky {
    Colour top = palette::air;
    Colour horizon = palette::horizon;
};

/// A point and how far a thing reaches from it: what cameras and shadows are fitted to.
struct Extent {
    Eigen::Vector3d centre;
    double radius;
    bool shadow = false;  ///< casts one on the ground
};

/// The box's eight corners, world frame [m].
std::array<Eigen::Vector3d, 8> corners_of(const Box& box);

/// Everything on one picture. Add things in any order; later trails and labels lie above earlier ones.
class Drawing {
  public:
    // Every add throws std::invalid_argument, naming the field, if a number is not finite, a radius or a
    // half extent is not positive, an index is out of range or there are too few points.
    Drawing& add(const Ball& thing);
    Drawing& add(const Box& thing);
    Drawing& add(const Rod& thing);
    Drawing& add(Tube thing);
    Drawing& add(Mesh thing);
    Drawing& add(Trail thing);
    Drawing& add(Arrow thing);
    Drawing& add(const Axes& thing);
    Drawing& add(Label thing);
    /// The ground is drawn by default; this changes it.
    Drawing& ground(const Ground& ground);
    Drawing& no_ground();
    Drawing& sky(const Sky& sky);
    /// For a drawing that moves: camera, light and grid are fitted to this ball, not to where things are now.
    Drawing& stage(const Extent& ball);
    const std::optional<Extent>& stage() const { return stage_; }
    /// The page it is drawn for; light unless said.
    Drawing& theme(Theme theme);
    Theme theme() const { return theme_; }
    /// Where the sun stands: towards it, any length. By default high on the left, in front.
    Drawing& sun(const Eigen::Vector3d& direction);
    /// A line of bold words at the top left, and one of plain words at the bottom left.
    Drawing& title(std::string text);
    Drawing& caption(std::string text);

    const std::vector<Ball>& balls() const { return balls_; }
    const std::vector<Box>& boxes() const { return boxes_; }
    const std::vector<Rod>& rods() const { return rods_; }
    const std::vector<Tube>& tubes() const { return tubes_; }
    const std::vector<Mesh>& meshes() const { return meshes_; }
    const std::vector<Trail>& trails() const { return trails_; }
    const std::vector<Arrow>& arrows() const { return arrows_; }
    const std::vector<Label>& labels() const { return labels_; }
    const Ground& ground() const { return ground_; }
    const Sky& sky() const { return sky_; }
    const std::string& title() const { return title_; }
    const std::string& caption() const { return caption_; }
    /// Unit vector towards the sun, world frame.
    Eigen::Vector3d sun() const;
    /// What the drawing's things fill (the ground is not one of them).
    std::vector<Extent> extents() const;

  private:
    std::vector<Ball> balls_;
    std::vector<Box> boxes_;
    std::vector<Rod> rods_;
    std::vector<Tube> tubes_;
    std::vector<Mesh> meshes_;
    std::vector<Trail> trails_;
    std::vector<Arrow> arrows_;
    std::vector<Label> labels_;
    Ground ground_;
    Sky sky_;
    std::optional<Eigen::Vector3d> sun_;
    std::optional<Extent> stage_;
    Theme theme_ = Theme::light;
    std::string title_, caption_;
};

/// The points of a coil spring from a to b, for a Tube: straight ends, and turns between them.
/// @param radius of the coil [m]
std::vector<Eigen::Vector3d> coil(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radius,
                                  int turns = 10);

/// A body at many instants, as a stroboscope shows it, with the exact motion as a ghost behind.
struct Stroboscope {
    std::vector<Eigen::Vector3d> computed{};    ///< a ball is drawn at each [m]
    std::vector<Eigen::Vector3d> exact{};       ///< a ghost at each; the same instants, or empty [m]
    std::vector<Eigen::Vector3d> exact_path{};  ///< finer points for the dashed line; empty: exact [m]
    double radius = 0.1;                        ///< [m]
    Colour colour = palette::body;
    bool error_lines = true;  ///< a thin line from each ghost to the ball of the same instant
};

/// Adds the balls (with contact shadows), the line through them, the ghost with its dashed line, and lines
/// from one to the other.
/// @throws std::invalid_argument as Drawing::add does
void add(Drawing& drawing, const Stroboscope& stroboscope);

}  // namespace nutshell::picture
