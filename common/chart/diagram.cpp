// The verbs of a diagram: each adds what it is made of, in the caller's coordinates.
#include <nutshell/chart/diagram.hpp>

#include <cmath>
#include <numbers>
#include <utility>

namespace nutshell::chart {
namespace {

constexpr double beside = 14;  // from the middle of a small body to its name, in units of the picture

Place towards(Place from, Place along, double part) {
    return {from.x + part * along.x, from.y + part * along.y};
}

std::vector<Place> bent(Place centre, double radius, double from, double to) {
    const int pieces = 2 + static_cast<int>(std::abs(to - from) * 16);
    std::vector<Place> points;
    for (int i = 0; i <= pieces; ++i) {
        const double angle = from + (to - from) * i / pieces;
        points.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
    }
    return points;
}

}  // namespace

Diagram& Diagram::ball(Place at, double radius, std::string label) {
    shapes.push_back({Line::body, {at}, true, radius});
    if (!label.empty()) words.push_back({at, std::move(label), beside});
    return *this;
}

Diagram& Diagram::box(Place at, double across, double up, double turned, std::string label) {
    const double c = std::cos(turned), s = std::sin(turned);
    std::vector<Place> corners;
    for (const auto& [u, v] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})
        corners.push_back({at.x + c * u * across - s * v * up, at.y + s * u * across + c * v * up});
    if (!label.empty()) words.push_back({at, std::move(label), beside});
    return polygon(std::move(corners));
}

Diagram& Diagram::polygon(std::vector<Place> corners) {
    shapes.push_back({Line::body, std::move(corners), true});
    return *this;
}

Diagram& Diagram::as_ghost() {
    if (!shapes.empty()) shapes.back().line = Line::ghost;
    return *this;
}

Diagram& Diagram::centre(Place at) {
    dots.push_back({at, true});
    return *this;
}

Diagram& Diagram::axes(Place origin, double turned, double length, std::string first, std::string second) {
    arrow(origin, {length * std::cos(turned), length * std::sin(turned)}, Quantity::plain, std::move(first));
    return arrow(origin, {-length * std::sin(turned), length * std::cos(turned)}, Quantity::plain,
                 std::move(second));
}

Diagram& Diagram::spring(Place from, Place to, int coils, double across) {
    const Place along{to.x - from.x, to.y - from.y};
    const double length = std::hypot(along.x, along.y);
    if (across <= 0) across = 0.14 * length;
    const Place side{-along.y / length * across / 2, along.x / length * across / 2};
    std::vector<Place> points{from, towards(from, along, 0.12)};
    const int turns = 2 * coils;
    for (int i = 0; i < turns; ++i) {
        const Place on = towards(from, along, 0.12 + 0.76 * (i + 0.5) / turns);
        points.push_back(towards(on, side, i % 2 == 0 ? 1 : -1));
    }
    points.push_back(towards(from, along, 0.88)), points.push_back(to);
    shapes.push_back({Line::spring, std::move(points)});
    return *this;
}

Diagram& Diagram::rope(Place from, Place to, double sag) {
    std::vector<Place> points{from};
    for (int i = 1; i < 24 && sag != 0; ++i) {  // a parabola
        const double t = i / 24.0;
        points.push_back(
            {from.x + t * (to.x - from.x), from.y + t * (to.y - from.y) - 4 * sag * t * (1 - t)});
    }
    points.push_back(to);
    shapes.push_back({Line::rope, std::move(points)});
    return *this;
}

Diagram& Diagram::rod(Place from, Place to) {
    shapes.push_back({Line::rod, {from, to}});
    return *this;
}

Diagram& Diagram::path(std::vector<Place> points) {
    shapes.push_back({Line::path, std::move(points)});
    return *this;
}

Diagram& Diagram::dashed(std::vector<Place> points) {
    shapes.push_back({Line::dashed, std::move(points)});
    return *this;
}

Diagram& Diagram::wall(Place from, Place to) {
    walls.push_back({from, to});
    return *this;
}

Diagram& Diagram::arrow(Place from, Place along, Quantity quantity, std::string label) {
    arrows.push_back({quantity, {from, towards(from, along, 1)}, std::move(label)});
    return *this;
}

Diagram& Diagram::arc(Place at, double radius, double from, double to, Quantity quantity, std::string label) {
    arrows.push_back({quantity, bent(at, radius, from, to), std::move(label)});
    return *this;
}

Diagram& Diagram::angle(Place at, double radius, double from, double to, std::string label) {
    arrows.push_back({Quantity::plain, bent(at, radius, from, to), std::move(label), false});
    return *this;
}

Diagram& Diagram::contact(Place at, Place normal, std::string label) {
    dots.push_back({at, false});
    return arrow(at, normal, Quantity::plain, std::move(label));
}

Diagram& Diagram::dimension(Place from, Place to, std::string text) {
    dimensions.push_back({from, to, std::move(text)});
    return *this;
}

Diagram& Diagram::note(Place at, std::string text) {
    words.push_back({at, std::move(text), 0});
    return *this;
}

}  // namespace nutshell::chart
