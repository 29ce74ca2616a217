// Diagrams: bodies, springs, ropes and arrows as a physics book draws them, at the places and with the
// lengths that a program computed. One self-contained SVG like a chart: light and dark, wide and a phone's.
//
//     Diagram d;
//     d.title = "Two forces on a mass on a spring";
//     d.wall({0, -0.3}, {0, 0.3});
//     d.spring({0, 0}, {1.4, 0});
//     d.ball({1.5, 0}, 0.1, "m");
//     d.arrow({1.5, 0}, {-0.6, 0}, Quantity::force, "F = −k (l − l₀)");
//     d.dimension({0, -0.4}, {1.5, -0.4}, "l = 1.5 m");
//     write_svg(d, "out/03_forces/spring_forces.svg");
//
// Coordinates are the caller's, x to the right and y upwards, the same unit in both. The length of an arrow
// is the caller's too: a force is drawn at so many metres a newton, and the subtitle says how many.
#pragma once
#include <filesystem>
#include <nutshell/palette.hpp>
#include <string>
#include <vector>

namespace nutshell::chart {

struct Place {
    double x = 0, y = 0;
};

/// What an arrow stands for: its colour, the same on every diagram and picture.
enum class Quantity { force, velocity, momentum, torque, angular_velocity, angular_momentum, plain };

/// Fill in with its verbs; a later thing lies over an earlier one, arrows over bodies, words over all.
struct Diagram {
    enum class Line { body, ghost, spring, rope, rod, path, dashed, axis };
    struct Shape {
        Line line;
        std::vector<Place> points;  ///< a circle's centre where `radius` > 0
        bool closed = false;
        double radius = 0;
    };
    struct Arrow {
        Quantity quantity;
        std::vector<Place> shaft;  ///< two points, or an arc
        std::string label;
        bool head = true;
    };
    struct Wall {
        Place from, to;  ///< hatched on its right, seen from `from` to `to`
    };
    struct Dimension {
        Place from, to;
        std::string text;
    };
    struct Word {
        Place at;
        std::string text;
        double away = 0;  ///< in units of the picture: a name stands beside its body
    };
    struct Dot {
        Place at;
        bool centre = true;  ///< of mass: a quartered disc; else a contact: a small ring
    };

    std::string title = {}, subtitle = {};
    int width = 640;
    int height = 320;                         ///< most, without the title; a diagram wider than high is lower
    std::string name = {}, description = {};  ///< as of a Chart
    std::vector<Shape> shapes = {};
    std::vector<Wall> walls = {};
    std::vector<Arrow> arrows = {};
    std::vector<Dimension> dimensions = {};
    std::vector<Dot> dots = {};
    std::vector<Word> words = {};

    Diagram& ball(Place centre, double radius, std::string label = {});
    /// Turned by `angle` [rad], anticlockwise.
    Diagram& box(Place centre, double width, double height, double angle = 0, std::string label = {});
    Diagram& polygon(std::vector<Place> corners);
    /// The last body, or the last rope, once more as a ghost: where it was, or should be. Call before the
    /// next one.
    Diagram& as_ghost();
    Diagram& centre(Place at);  ///< of mass
    /// Two arrows from `origin`, the first at `angle` [rad]: a frame of reference, or a body's own axes.
    Diagram& axes(Place origin, double angle, double length, std::string first = "x",
                  std::string second = "y");
    /// Coils between straight ends; `width` across them.
    Diagram& spring(Place from, Place to, int coils = 8, double width = 0);
    /// Taut, or hanging through by `sag` in its middle.
    Diagram& rope(Place from, Place to, double sag = 0);
    Diagram& rod(Place from, Place to);
    Diagram& path(std::vector<Place> points);    ///< where something went
    Diagram& dashed(std::vector<Place> points);  ///< a line that is not there: a lever arm, a plane
    Diagram& wall(Place from, Place to);         ///< fixed: hatched on its right, seen from `from` to `to`
    Diagram& arrow(Place from, Place along, Quantity quantity, std::string label = {});
    /// An arrow bent round `centre`, from one angle to another [rad], anticlockwise where `to` is greater:
    /// torque, ω.
    Diagram& arc(Place centre, double radius, double from, double to, Quantity quantity,
                 std::string label = {});
    /// An angle between two directions [rad], without a head.
    Diagram& angle(Place centre, double radius, double from, double to, std::string label);
    /// A point of contact and its normal, drawn with this length.
    Diagram& contact(Place at, Place normal, std::string label = "n");
    Diagram& dimension(Place from, Place to, std::string text);
    Diagram& note(Place at, std::string text);
};

/// Several diagrams in one frame of coordinates: side by side at one scale, on a phone one below the other.
struct Diagrams {
    std::string title = {}, subtitle = {};
    std::vector<Diagram> panels = {};  ///< their titles are small headings
    int width = 760;
    std::string name = {}, description = {};
};

/// The picture as text. @throws std::invalid_argument without a title, without anything to draw, or if a
/// place is not finite
std::string svg(const Diagram& diagram);
std::string svg(const Diagrams& diagrams);
/// Writes the picture, whole or not at all. @throws like `svg`, and std::runtime_error if the file cannot be
/// written
void write_svg(const Diagram& diagram, const std::filesystem::path& path);
void write_svg(const Diagrams& diagrams, const std::filesystem::path& path);

}  // namespace nutshell::chart
