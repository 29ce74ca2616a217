// Exercise 6.7: moving bodies stuck together, where the source forgets their orbits.
#pragma once
#include <nutshell/joined.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct Joined {
    static constexpr const char *id = "6.7", *function = "joined";
    static constexpr auto subject = NUTSHELL_CALL(joined);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const Body first{1.7,
                         {1.2, 1.9, 2.4},
                         {0.4, -0.7, 0.9},
                         {2.1, 0.8, -1.3},
                         Quaternion(0.4, 0.3, -0.5, 0.7).normalized(),
                         {0.6, 1.4, -0.9}};
        const Body second{0.6,
                          {0.8, 1.1, 0.5},
                          {-0.9, 1.1, 0.7},
                          {-0.7, 1.6, 0.4},
                          Quaternion(0.9, -0.6, 0.2, 0.1).normalized(),
                          {-1.1, 0.3, 0.8}};
        const Body third{2.3,
                         {2.1, 1.5, 1.7},
                         {0.7, -1.2, 0.4},
                         {0.5, -0.9, 1.2},
                         Quaternion(0.2, 0.5, 0.7, -0.4).normalized(),
                         {0.9, -0.6, 1.3}};
        ask_one(paper, answer, {first, second});
        ask_one(paper, answer, {first, third});
        ask_one(paper, answer, {third, second, first, second, third});
    }

  private:
    template <class Answer>
    static void ask_one(Paper& paper, const Answer& answer, const std::vector<Body>& bodies) {
        std::vector<double> masses;
        for (const Body& body : bodies) masses.push_back(body.mass);
        paper.input("the masses of the bodies", masses);
        const Body whole = answer(bodies);
        paper.output("the mass [kg]", whole.mass, 1.0);
        paper.output("the centre [m]", whole.position, 1.0);
        paper.output("the momentum [kg m/s]", whole.momentum, 1.0);
        paper.output("the angular momentum about the centre [kg m^2/s]", whole.angular_momentum,
                     3.0);
        // principal axes may come in any order: the inertia in world axes tells
        const Matrix3 axes = Matrix3(whole.orientation);
        const Matrix3 inertia = axes * whole.inertia.asDiagonal() * axes.transpose();
        paper.output("the inertia in world axes [kg m^2]", inertia, 5.0);
    }

  public:
#ifndef NUTSHELL_SHEET
    /// The whole with no motion, its parts' inertias turned or not.
    static Body at_rest(std::span<const Body> bodies, bool turned = true) {
        std::vector<Part> parts;
        for (const Body& b : bodies)
            parts.push_back({{b.mass, Vector3::Zero(), b.inertia.asDiagonal()},
                             b.position,
                             turned ? Matrix3(b.orientation) : Matrix3(Matrix3::Identity())});
        return body_of(assemble(parts));
    }
    /// Sums over the bodies, each with its way from the common centre.
    template <class Term>
    static Vector3 sum(std::span<const Body> bodies, const Vector3& centre, const Term& term) {
        Vector3 all = Vector3::Zero();
        for (const Body& b : bodies) all += term(b, Vector3(b.position - centre));
        return all;
    }
    static Vector3 all_momentum(std::span<const Body> bodies) {
        return sum(bodies, Vector3::Zero(),
                   [](const Body& b, const Vector3&) -> Vector3 { return b.momentum; });
    }
    static Vector3 all_spin(std::span<const Body> bodies, const Vector3& centre) {
        return sum(bodies, centre, [](const Body& b, const Vector3& d) -> Vector3 {
            return b.angular_momentum + d.cross(b.momentum);
        });
    }
    static About<Joined> about() {
        return {
            .title = "Stuck together",
            .hints = {"Three things add up whatever happens: mass, momentum, and angular "
                      "momentum about one common point.",
                      "A body that flies past the common centre has angular momentum about it "
                      "even if it does not spin. By which lever arm?",
                      "Make parts with solid and in their places, let assemble and body_of make "
                      "the whole; then give it the sum of the momenta, and the sum of the "
                      "spins and orbits about its centre."},
            .picture = "hammer.png",
            .mistakes =
                {{"the orbits forgotten", "E33, E67",
                  "Two skaters who catch each other's hands in passing do not begin to turn.",
                  "You add the spins of the bodies alone. Their momenta at their lever arms "
                  "about the common centre are missing.",
                  [](std::span<const Body> bodies) -> Body {
                      Body whole = at_rest(bodies);
                      whole.momentum = all_momentum(bodies);
                      whole.angular_momentum = sum(bodies, whole.position,
                                                   [](const Body& b, const Vector3&) -> Vector3 {
                                                       return b.angular_momentum;
                                                   });
                      return whole;
                  }},
                 {"the spins forgotten", "classic",
                  "A spinning ball that is caught stops spinning at once.",
                  "You add the orbits alone. What each body spins about its own centre is "
                  "missing.",
                  [](std::span<const Body> bodies) -> Body {
                      Body whole = at_rest(bodies);
                      whole.momentum = all_momentum(bodies);
                      whole.angular_momentum = sum(
                          bodies, whole.position, [](const Body& b, const Vector3& d) -> Vector3 {
                              return d.cross(b.momentum);
                          });
                      return whole;
                  }},
                 {"about the origin", "classic",
                  "Two balls that stick together far from the middle of the level start to spin.",
                  "Your angular momentum is that about the origin of the axes. A Body keeps it "
                  "about its own centre: take away that of the centre's motion.",
                  [](std::span<const Body> bodies) -> Body {
                      Body whole = at_rest(bodies);
                      whole.momentum = all_momentum(bodies);
                      whole.angular_momentum = all_spin(bodies, Vector3::Zero());
                      return whole;
                  }},
                 {"the lever arms exchanged", "classic",
                  "Skaters who catch hands turn the wrong way round each other.",
                  "The orbits have the wrong sign: the lever arm comes first, then the momentum.",
                  [](std::span<const Body> bodies) -> Body {
                      Body whole = at_rest(bodies);
                      whole.momentum = all_momentum(bodies);
                      whole.angular_momentum = sum(
                          bodies, whole.position, [](const Body& b, const Vector3& d) -> Vector3 {
                              return b.angular_momentum + b.momentum.cross(d);
                          });
                      return whole;
                  }},
                 {"the printed minus", "E48: operator- adds",
                  "Bodies far from the origin spin up when they are joined.",
                  "Your lever arms are place plus centre. The listing's operator- adds; the arm "
                  "is the place less the centre.",
                  [](std::span<const Body> bodies) -> Body {
                      Body whole = at_rest(bodies);
                      whole.momentum = all_momentum(bodies);
                      const Vector3 centre = whole.position;
                      whole.angular_momentum = all_spin(bodies, -centre);
                      return whole;
                  }},
                 {"inertias unturned", "E67",
                  "A plank nailed across another turns as if it lay along it.",
                  "You put the parts together as if none of them were turned. solid takes each "
                  "body's rotation matrix too.",
                  [](std::span<const Body> bodies) -> Body {
                      Body whole = at_rest(bodies, false);
                      whole.momentum = all_momentum(bodies);
                      whole.angular_momentum = all_spin(bodies, whole.position);
                      return whole;
                  }},
                 {"no momentum", "classic", "A ball that sticks to a wagon stops it dead.",
                  "The whole stands still: its momentum is the sum of the momenta.",
                  [](std::span<const Body> bodies) -> Body {
                      Body whole = at_rest(bodies);
                      whole.angular_momentum = all_spin(bodies, whole.position);
                      return whole;
                  }},
                 {"the mean of the velocities", "classic",
                  "A fly that sticks to a truck halves its speed.",
                  "You give the whole the plain mean of the velocities. The heavier one counts "
                  "more: it is the momenta that add up.",
                  [](std::span<const Body> bodies) -> Body {
                      Body whole = at_rest(bodies);
                      whole.momentum = whole.mass / static_cast<double>(bodies.size()) *
                                       sum(bodies, Vector3::Zero(),
                                           [](const Body& b, const Vector3&) -> Vector3 {
                                               return b.momentum / b.mass;
                                           });
                      whole.angular_momentum = all_spin(bodies, Vector3::Zero()) -
                                               whole.position.cross(whole.momentum);
                      return whole;
                  }},
                 {"the mean of the spins", "classic",
                  "Two skaters who catch each other's hands in passing do not begin to turn.",
                  "You let the whole spin with the mean of the angular velocities. What is kept "
                  "is the angular momentum, with that of the centres on their ways; the spin "
                  "follows from it.",
                  [](std::span<const Body> bodies) -> Body {
                      Body whole = at_rest(bodies);
                      whole.momentum = all_momentum(bodies);
                      const Vector3 omega =
                          sum(bodies, Vector3::Zero(),
                              [](const Body& b, const Vector3&) { return angular_velocity(b); });
                      return spinning(whole, omega / static_cast<double>(bodies.size()));
                  }},
                 {"velocities for momenta", "classic: a lever of velocity",
                  "Light and heavy things that catch each other turn alike.",
                  "About the common centre each body has its momentum at its lever arm. You take "
                  "its velocity: the mass is missing.",
                  [](std::span<const Body> bodies) -> Body {
                      Body whole = at_rest(bodies);
                      whole.momentum = all_momentum(bodies);
                      whole.angular_momentum = sum(
                          bodies, whole.position, [](const Body& b, const Vector3& d) -> Vector3 {
                              return b.angular_momentum + d.cross(b.momentum / b.mass);
                          });
                      return whole;
                  }}},
            .alternatives = {{"arms from the common centre",
                              [](std::span<const Body> bodies) -> Body {
                                  Body whole = at_rest(bodies);
                                  whole.momentum = all_momentum(bodies);
                                  whole.angular_momentum = all_spin(bodies, whole.position);
                                  return whole;
                              }},
                             {"two at a time",
                              [](std::span<const Body> bodies) -> Body {
                                  Body whole = bodies[0];
                                  for (std::size_t i = 1; i < bodies.size(); ++i)
                                      whole = joined(std::array{whole, bodies[i]});
                                  return whole;
                              }}},
            .survivors = {{"fraction cut off", "the sum of the momenta begins at zero"},
                          {"fraction cut off, 2", "so does that of the angular momenta"},
                          {"statements 5 and 6 swapped", "neither uses the other's result"}},
        };
    }
#endif
};

inline const bool joined_entered = enter<Joined>();

}  // namespace nutshell::exercises
