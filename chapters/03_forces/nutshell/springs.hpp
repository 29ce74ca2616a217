// Chapter 3 · Springs between many particles: a list for anything, and a grid for chains and
// cloths.
#pragma once
#include <nutshell/forces.hpp>
#include <nutshell/particles.hpp>

namespace nutshell {

// [springs]
/// A spring between the particles numbered a and b.
struct Link {
    std::size_t a, b;
    Spring spring;
};

/// A spring from one particle to a point that does not move.
struct Anchor {
    std::size_t particle;
    Vector3 point;  ///< [m], world frame
    Spring spring;
};

/// Any springs between any particles.
struct Springs {
    std::vector<Link> links = {};
    std::vector<Anchor> anchors = {};
};

/// Adds `force` [N] to that of particle i.
inline void add(Vector3Array& forces, std::size_t i, const Vector3& force) {
    forces.x[i] += force.x(), forces.y[i] += force.y(), forces.z[i] += force.z();
}

/// Adds the force of every spring to both its ends, equal and opposite. Eq. (18*).
inline void add_forces(const Springs& springs, const Particles& all, Vector3Array& forces) {
    for (const Link& link : springs.links) {
        const Vector3 on_a =
            spring_force(link.spring, all.position[link.a], all.position[link.b]);
        add(forces, link.a, on_a);
        add(forces, link.b, -on_a);
    }
    for (const Anchor& anchor : springs.anchors)
        add(forces, anchor.particle,
            spring_force(anchor.spring, all.position[anchor.particle], anchor.point));
}
// [/springs]

/// Energy [J] in all springs.
inline double spring_energy(const Springs& springs, const Particles& all) {
    double sum = 0;
    for (const Link& link : springs.links)
        sum += spring_energy(link.spring, all.position[link.a], all.position[link.b]);
    for (const Anchor& anchor : springs.anchors)
        sum += spring_energy(anchor.spring, all.position[anchor.particle], anchor.point);
    return sum;
}

/// Gives the springs back if they fit `particles` particles. @throws std::invalid_argument if a
/// spring joins a particle to itself or one that does not exist, is anchored to a point that is
/// not finite, or could not be simulated at all
inline Springs checked(Springs springs, std::size_t particles) {
    const auto exists = [&](std::size_t i, const std::string& which) {
        require(i < particles, which + " holds particle " + std::to_string(i) +
                                   ", but there are only " + std::to_string(particles) +
                                   ", counted from 0");
    };
    for (std::size_t i = 0; i < springs.links.size(); ++i) {
        const std::string which = "spring " + std::to_string(i);
        const Link& link = springs.links[i];
        exists(link.a, which), exists(link.b, which);
        require(link.a != link.b, which + " joins particle " + std::to_string(link.a) +
                                      " to itself: give it two different ends");
        checked(link.spring);
    }
    for (std::size_t i = 0; i < springs.anchors.size(); ++i) {
        exists(springs.anchors[i].particle, "anchor " + std::to_string(i));
        require_finite(springs.anchors[i].point, "the point of an anchor [m]");
        checked(springs.anchors[i].spring);
    }
    return springs;
}

// [grid_springs]
/// One kind of spring in a grid: from every particle to the one `down` rows on and `right`
/// columns to the right of it, wherever there is one.
struct GridSpring {
    std::size_t down;  ///< rows
    long right;        ///< columns; negative: to the left
    Spring spring;
};

/// Springs between the particles of a grid; the particle in row r and column c has number r *
/// columns + c. A chain is a grid of one row. Who is joined to whom follows from the place, so no
/// list of numbers has to be read.
struct GridSprings {
    std::size_t rows, columns;
    std::vector<GridSpring> kinds;
};

/// Adds the forces of all springs that start in row r: within the row, or between two rows, in
/// one wide loop per kind.
inline void add_row_forces(const GridSprings& grid, std::size_t r, wide::ConstAxes position,
                           wide::Axes forces) {
    for (const auto& [down, right, spring] : grid.kinds) {
        if (r + down >= grid.rows) continue;
        const std::size_t row = r * grid.columns, other = row + down * grid.columns;
        const auto shift = static_cast<std::size_t>(std::abs(right));
        if (down == 0) {
            wide::springs_in_row(grid.columns, shift, position.from(row), forces.from(row),
                                 spring.rest_length, spring.stiffness);
        } else if (shift < grid.columns) {
            const std::size_t a = right < 0 ? row + shift : row,
                              b = right < 0 ? other : other + shift;
            wide::springs_between(grid.columns - shift, position.from(a), position.from(b),
                                  forces.from(a), forces.from(b), spring.rest_length,
                                  spring.stiffness);
        }
    }
}

/// Adds the forces of all springs of the grid.
inline void add_forces(const GridSprings& grid, const Particles& all, Vector3Array& forces) {
    for (std::size_t r = 0; r < grid.rows; ++r)
        add_row_forces(grid, r, all.position.axes(), forces.axes());
}
// [/grid_springs]

/// The same springs as a list.
inline Springs list_of(const GridSprings& grid) {
    Springs list;
    for (std::size_t r = 0; r < grid.rows; ++r)
        for (const auto& [down, right, spring] : grid.kinds)
            for (std::size_t c = 0; c < grid.columns; ++c) {
                const long other = static_cast<long>(c) + right;
                if (r + down >= grid.rows || other < 0 ||
                    other >= static_cast<long>(grid.columns))
                    continue;
                list.links.push_back({r * grid.columns + c,
                                      (r + down) * grid.columns + static_cast<std::size_t>(other),
                                      spring});
            }
    return list;
}

/// Gives the grid back if it fits `particles` particles. @throws std::invalid_argument if it does
/// not, or a kind of spring would join a particle to itself, points backwards within a row or
/// farther than wide::most_step, or could not be simulated at all
inline GridSprings checked(GridSprings grid, std::size_t particles) {
    require(grid.rows * grid.columns == particles,
            "a grid of " + std::to_string(grid.rows) + " x " + std::to_string(grid.columns) +
                " does not fit " + std::to_string(particles) + " particles");
    for (const auto& [down, right, spring] : grid.kinds) {
        require(down != 0 || right != 0,
                "a spring of a grid joins every particle to itself: give it a step down or to "
                "the right");
        require(down != 0 || (right > 0 && right <= static_cast<long>(wide::most_step)),
                "a spring within a row of a grid must step 1 to " +
                    std::to_string(wide::most_step) + " columns to the right, not " +
                    std::to_string(right));
        checked(spring);
    }
    return grid;
}

// [spring_slope]
/// How the force [N] of a spring on its end changes when this end moves a little: times the shift
/// [m]. Along the spring by its stiffness, across it by its tension over its length. Minus the
/// second derivative of the energy [N/m].
inline Matrix3 spring_slope(const Spring& spring, const Vector3& end, const Vector3& other_end) {
    const Vector3 d = end - other_end;
    const double length = d.norm();
    if (length == 0)
        return (spring.rest_length == 0 ? -spring.stiffness : 0) * Matrix3::Identity();
    const Matrix3 along = d * d.transpose() / (length * length);
    const double across = 1 - spring.rest_length / length;
    return -spring.stiffness * (along + across * (Matrix3::Identity() - along));
}
// [/spring_slope]

}  // namespace nutshell
