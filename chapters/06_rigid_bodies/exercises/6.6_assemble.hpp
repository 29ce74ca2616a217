// Exercise 6.6: mass, centre and inertia of a whole, where the source's sum of bodies slips
// thrice.
#pragma once
#include <nutshell/assembly.hpp>
#include <nutshell/rotations.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct Assemble {
    static constexpr const char *id = "6.6", *function = "assemble";
    static constexpr auto subject = NUTSHELL_CALL(assemble);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        Matrix3 lopsided, other;
        lopsided << 2.1, -0.4, 0.3, -0.4, 1.7, 0.5, 0.3, 0.5, 1.2;
        other << 0.9, 0.2, -0.1, 0.2, 1.3, 0.3, -0.1, 0.3, 1.6;
        const Matrix3 a = rotation_matrix(Quaternion(0.4, 0.3, -0.5, 0.7).normalized()),
                      b = rotation_matrix(Quaternion(0.9, -0.6, 0.2, 0.1).normalized());
        const Part first{{1.7, {0.4, -0.7, 0.9}, lopsided}, {1.3, 0.6, -0.8}, a};
        const Part second{{0.6, {-0.5, 0.8, 0.3}, other}, {-0.9, 1.1, 0.7}, b};
        const Part third{{2.3, {0.2, 0.5, -0.6}, lopsided}, {0.7, -1.2, 0.4}, b};
        ask_one(paper, answer, {first, second});
        ask_one(paper, answer, {first, third});
        ask_one(paper, answer, {third, second, first, second, third});
        ask_one(paper, answer, {second});
    }

  private:
    template <class Answer>
    static void ask_one(Paper& paper, const Answer& answer, const std::vector<Part>& parts) {
        std::vector<double> masses;
        for (const Part& part : parts) masses.push_back(part.body.mass);
        paper.input("the masses of the parts", masses);
        const MassProperties whole = answer(parts);
        paper.output("the mass [kg]", whole.mass, 1.0);
        paper.output("the centre [m]", whole.centre, 1.0);
        paper.output("the inertia [kg m^2]", whole.inertia, 5.0);
    }

  public:
#ifndef NUTSHELL_SHEET
    static Vector3 place_of(const Part& part) {
        return part.rotation * part.body.centre + part.place;
    }
    static Vector3 mean(std::span<const Part> parts) {
        Vector3 sum = Vector3::Zero();
        double mass = 0;
        for (const Part& part : parts)
            sum += part.body.mass * place_of(part), mass += part.body.mass;
        return sum / mass;
    }
    static Matrix3 turned(const Part& part) {
        return part.rotation * part.body.inertia * part.rotation.transpose();
    }
    static Matrix3 moved(double mass, const Vector3& d) {
        return mass * (d.dot(d) * Matrix3::Identity() - d * d.transpose());
    }
    /// The whole with a centre and a share of each part's inertia of one's own.
    template <class Own>
    static MassProperties with(std::span<const Part> parts, const Vector3& centre,
                               const Own& own) {
        MassProperties whole;
        whole.centre = centre;
        for (const Part& part : parts) {
            whole.mass += part.body.mass;
            whole.inertia += own(part);
        }
        return whole;
    }
    static About<Assemble> about() {
        return {
            .title = "A whole out of parts",
            .hints = {"Where is a part's centre in the axes of the whole? Its own axes were "
                      "turned, then their origin moved.",
                      "Two rounds: the first for mass and centre. The second needs the centre "
                      "already: each inertia turned into common axes, and moved.",
                      "in_world turns the inertia of a part; parallel_axis moves it by the way "
                      "from the common centre to the part's. Add both, for every part."},
            .picture = "hammer.png",
            .mistakes =
                {{"a plus for a times", "E66", "A hammer spins about a point far outside of it.",
                  "In the centre of mass the second part's mass is added to its place where it "
                  "should multiply it.",
                  [](std::span<const Part> parts) -> MassProperties {
                      Vector3 sum = Vector3::Zero();
                      double mass = 0;
                      for (const Part& part : parts) {
                          const double m = part.body.mass;
                          sum += mass == 0 ? Vector3(m * place_of(part))
                                           : Vector3(place_of(part) + Vector3(m, 0, 0));
                          mass += m;
                      }
                      const Vector3 centre = sum / mass;
                      return with(parts, centre, [&](const Part& part) -> Matrix3 {
                          return turned(part) + moved(part.body.mass, place_of(part) - centre);
                      });
                  }},
                 {"the parts' inertias unturned", "E32, E67",
                  "Two crossed bars are as easy to spin as two side by side.",
                  "You add the inertias as they are in the parts' own axes. Turn each into the "
                  "axes of the whole first.",
                  [](std::span<const Part> parts) -> MassProperties {
                      const Vector3 centre = mean(parts);
                      return with(parts, centre, [&](const Part& part) -> Matrix3 {
                          return part.body.inertia +
                                 moved(part.body.mass, place_of(part) - centre);
                      });
                  }},
                 {"the parts' points unturned", "E68",
                  "The parts of a tilted hammer lie side by side as if nobody had tilted it.",
                  "You put a part's centre in its place without turning it first: place + centre "
                  "instead of place + R centre.",
                  [](std::span<const Part> parts) -> MassProperties {
                      const auto at = [](const Part& part) -> Vector3 {
                          return part.body.centre + part.place;
                      };
                      Vector3 sum = Vector3::Zero();
                      double mass = 0;
                      for (const Part& part : parts)
                          sum += part.body.mass * at(part), mass += part.body.mass;
                      const Vector3 centre = sum / mass;
                      return with(parts, centre, [&](const Part& part) -> Matrix3 {
                          return turned(part) + moved(part.body.mass, at(part) - centre);
                      });
                  }},
                 {"the place taken for the centre", "classic",
                  "A part whose axes start at one end counts as if it were a point there.",
                  "A part's place is where its axes begin; its centre of mass stands elsewhere "
                  "in them: R centre + place.",
                  [](std::span<const Part> parts) -> MassProperties {
                      Vector3 sum = Vector3::Zero();
                      double mass = 0;
                      for (const Part& part : parts)
                          sum += part.body.mass * part.place, mass += part.body.mass;
                      const Vector3 centre = sum / mass;
                      return with(parts, centre, [&](const Part& part) -> Matrix3 {
                          return turned(part) + moved(part.body.mass, part.place - centre);
                      });
                  }},
                 {"the printed brackets", "E32",
                  "A dumbbell with many parts turns as easily as one of its balls.",
                  "You move the last part only: read as it is printed, the sum of (62) ends "
                  "before the added term. Every part has its own.",
                  [](std::span<const Part> parts) -> MassProperties {
                      const Vector3 centre = mean(parts);
                      MassProperties whole = with(parts, centre, turned);
                      const Part& last = parts.back();
                      whole.inertia += moved(last.body.mass, place_of(last) - centre);
                      return whole;
                  }},
                 {"not moved", "classic", "A dumbbell turns as easily as its two balls alone.",
                  "You add the inertias, each about its own centre. About the common centre each "
                  "has more: parallel axes.",
                  [](std::span<const Part> parts) -> MassProperties {
                      return with(parts, mean(parts), turned);
                  }},
                 {"about the origin", "E32: p_total is not defined",
                  "The same hammer is harder to turn on the other side of the level.",
                  "You move the inertias to the origin of the axes. The whole turns about its "
                  "own centre of mass: measure from there.",
                  [](std::span<const Part> parts) -> MassProperties {
                      return with(parts, mean(parts), [&](const Part& part) -> Matrix3 {
                          return turned(part) + moved(part.body.mass, place_of(part));
                      });
                  }},
                 {"the question mark binds last", "E65",
                  "A long dumbbell refuses to spin about its own bar.",
                  "The diagonal of what you add lacks the square of its own component: in the "
                  "listing's dI the ?: binds last.",
                  [](std::span<const Part> parts) -> MassProperties {
                      const Vector3 centre = mean(parts);
                      return with(parts, centre, [&](const Part& part) -> Matrix3 {
                          const Vector3 d = place_of(part) - centre;
                          Matrix3 added = -part.body.mass * d * d.transpose();
                          added.diagonal().setConstant(part.body.mass * d.squaredNorm());
                          return turned(part) + added;
                      });
                  }},
                 {"the middle of the places", "classic",
                  "A hammer balances in the middle of its shaft.",
                  "Your centre is the mean of the places, all counted alike. Weigh each with its "
                  "mass.",
                  [](std::span<const Part> parts) -> MassProperties {
                      Vector3 sum = Vector3::Zero();
                      for (const Part& part : parts) sum += place_of(part);
                      const Vector3 centre = sum / static_cast<double>(parts.size());
                      return with(parts, centre, [&](const Part& part) -> Matrix3 {
                          return turned(part) + moved(part.body.mass, place_of(part) - centre);
                      });
                  }},
                 {"the place turned too", "classic: the bracket",
                  "A hammer's head flies beside its handle.",
                  "You turn the part's place with the part. The place is given in the axes of "
                  "the whole "
                  "already: only the body's own centre is turned.",
                  [](std::span<const Part> parts) -> MassProperties {
                      const auto at = [](const Part& part) -> Vector3 {
                          return part.rotation * (part.body.centre + part.place);
                      };
                      Vector3 sum = Vector3::Zero();
                      double mass = 0;
                      for (const Part& part : parts)
                          sum += part.body.mass * at(part), mass += part.body.mass;
                      const Vector3 centre = sum / mass;
                      return with(parts, centre, [&](const Part& part) -> Matrix3 {
                          return turned(part) + moved(part.body.mass, at(part) - centre);
                      });
                  }},
                 {"the centre so far", "classic: one loop for two",
                  "It matters in which order it is built.",
                  "You measure each part from the centre of those added so far. The common "
                  "centre is known "
                  "after the first loop only: make a second one.",
                  [](std::span<const Part> parts) -> MassProperties {
                      std::size_t k = 0;
                      return with(parts, mean(parts), [&](const Part& part) -> Matrix3 {
                          return turned(part) +
                                 moved(part.body.mass, place_of(part) - mean(parts.first(++k)));
                      });
                  }},
                 {"the first part skipped", "classic: from 1", "A dumbbell has one ball.",
                  "Your loop begins with the second part: in C++ the first one has index 0.",
                  [](std::span<const Part> parts) -> MassProperties {
                      const std::span<const Part> rest = parts.subspan(1);
                      const Vector3 centre = mean(rest);
                      return with(rest, centre, [&](const Part& part) -> Matrix3 {
                          return turned(part) + moved(part.body.mass, place_of(part) - centre);
                      });
                  }},
                 {"the whole mass moved with each part", "classic",
                  "Everything is too hard to turn.",
                  "Moving a part's inertia takes the mass of that part; you take that of the "
                  "whole.",
                  [](std::span<const Part> parts) -> MassProperties {
                      double mass = 0;
                      for (const Part& part : parts) mass += part.body.mass;
                      const Vector3 centre = mean(parts);
                      return with(parts, centre, [&](const Part& part) -> Matrix3 {
                          return turned(part) + moved(mass, place_of(part) - centre);
                      });
                  }},
                 {"moved from the part's place", "classic: place for centre",
                  "A part whose middle lies beside its handle counts as if it lay at the handle.",
                  "You measure how far each inertia moves from the part's place. It was about "
                  "the part's own centre, which lies elsewhere.",
                  [](std::span<const Part> parts) -> MassProperties {
                      const Vector3 centre = mean(parts);
                      return with(parts, centre, [&](const Part& part) -> Matrix3 {
                          return turned(part) + moved(part.body.mass, part.place - centre);
                      });
                  }}},
            .alternatives = {{"about the origin, then moved to the centre",
                              [](std::span<const Part> parts) -> MassProperties {
                                  const Vector3 centre = mean(parts);
                                  MassProperties whole =
                                      with(parts, centre, [&](const Part& p) -> Matrix3 {
                                          return turned(p) + moved(p.body.mass, place_of(p));
                                      });
                                  whole.inertia -= moved(whole.mass, centre);
                                  return whole;
                              }},
                             {"one part after the other",
                              [](std::span<const Part> parts) -> MassProperties {
                                  MassProperties whole;
                                  for (const Part& part : parts) {
                                      const Vector3 place = place_of(part);
                                      const double m = part.body.mass, sum = whole.mass + m;
                                      const Vector3 apart = place - whole.centre;
                                      whole.inertia += turned(part);
                                      if (whole.mass > 0)
                                          whole.inertia += moved(whole.mass * m / sum, apart);
                                      whole.centre += m / sum * apart;
                                      whole.mass = sum;
                                  }
                                  return whole;
                              }}},
            .survivors = {{"statements 1 and 2 swapped", "neither uses the other's result"}},
        };
    }
#endif
};

inline const bool assemble_entered = enter<Assemble>();

}  // namespace nutshell::exercises
