// Chapter 7 · A row of dominoes: impacts, friction and rest at once.
#pragma once
#include <nutshell/rest_scenes.hpp>

namespace nutshell {

// [domino_row]
/// Pieces of 1 kg, 0.5 m high and 8 cm thick, stand in a row along x. The first one leans by
/// `lean` over its lower front edge, past its balance, and is let go.
struct DominoRow {
    std::string name = "domino_row";
    int pieces = 20;
    double spacing = 0.25;        // from one to the next [m]
    double lean = 12 * pi / 180;  // [rad]; it balances at atan(thickness/height) = 9.1 degrees
    Box piece{{0.04, 0.25, 0.12}};
    double duration = 4;  // [s]
    Switches switches = {4};
    Need need{0.05, "", "the wave's speed to 5 %: it arrives with the music"};

    double thickness() const { return 2 * piece.half.x(); }
    double height() const { return 2 * piece.half.y(); }

    World start() const {
        World world;
        world.walls = {Plane{}};
        for (int i = 0; i < pieces; ++i) {
            Body body = solid_box(1, piece, {i * spacing, piece.half.y(), 0});
            if (i == 0) {
                const Vector3 edge(piece.half.x(), 0, 0);  // it stands on
                body.orientation = quaternion_about(Vector3::UnitZ(), -lean);
                body.position = edge + rotate(body.orientation, body.position - edge);
            }
            world.add(body, piece);
        }
        return world;
    }
    /// How far a piece leans forwards [rad].
    static double lean_of(const Body& body) {
        const Vector3 up = rotate(body.orientation, Vector3::UnitY());
        return std::atan2(up.x(), up.y());
    }
    /// The lean at which a piece touches the next [rad]: its upper edge has crossed the gap.
    double touches_at() const { return std::asin((spacing - thickness()) / height()); }
    /// How fast the first piece turns [rad/s] when it leans by `angle` [rad] and touches nothing
    /// yet. Closed form: it turns about its edge, and the height its centre has lost is energy.
    double exact_rate(double angle) const {
        const auto centre = [&](double a) {
            return piece.half.y() * std::cos(a) + piece.half.x() * std::sin(a);
        };
        const double about_edge =
            (height() * height() + thickness() * thickness()) / 3;  // [m^2]: per mass
        return std::sqrt(2 * earth_gravity * (centre(lean) - centre(angle)) / about_edge);
    }
};
// [/domino_row]

// [wave]
/// When each piece of a row came to lean by half of what it takes to touch the next [s]; negative
/// where it has not.
class DominoWave {
  public:
    explicit DominoWave(const DominoRow& row)
        : row_(row), at_(static_cast<std::size_t>(row.pieces), -1), before_(at_.size(), 0) {}
    /// Looks at the world at time t [s], each step. Between two looks, lean is taken as even.
    void look(const World& world, double t) {
        const double mark = row_.touches_at() / 2;
        for (std::size_t i = 0; i < at_.size(); ++i) {
            const double now = DominoRow::lean_of(world.bodies[i]);
            if (at_[i] < 0 && now >= mark)
                at_[i] =
                    now > before_[i] ? t - (t - last_) * (now - mark) / (now - before_[i]) : t;
            before_[i] = now;
        }
        last_ = t;
    }
    const std::vector<double>& times() const { return at_; }
    bool all_fell() const { return at_.back() >= 0; }
    /// Speed of the wave over the second half of the row, where it is steady [m/s]; 0 if it
    /// stopped.
    double speed() const {
        if (!all_fell()) return 0;
        const std::size_t last = at_.size() - 1, middle = last / 2;
        return static_cast<double>(last - middle) * row_.spacing / (at_[last] - at_[middle]);
    }

  private:
    DominoRow row_;
    std::vector<double> at_, before_;
    double last_ = 0;
};
// [/wave]

}  // namespace nutshell
