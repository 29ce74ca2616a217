// Exercise 2.6: a parcel whose velocity is measured from the mean of the rocket's velocities
// before and after.
#pragma once
#include <nutshell/revised_newton.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct Midway {
    static constexpr const char *id = "2.6", *function = "midway";
    static constexpr auto subject = NUTSHELL_CALL(midway);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const Vector3 exhaust{-40, 7, 23}, rain{12, -31, 5.5};
        for (const auto& [mass, dm, w] : {std::tuple{2.5, -0.8, exhaust},
                                          {2.5, 0.6, exhaust},
                                          {6.0, -0.8, exhaust},
                                          {2.5, -0.8, rain}}) {
            paper.input("mass", mass, "dm", dm, "w", w);
            const Vector3 relative = answer(mass, dm, w);
            paper.output("the velocity relative to the one before [m/s]", relative, w);
        }
    }

#ifndef NUTSHELL_SHEET
    static About<Midway> about() {
        return {
            .title = "A parcel midway",
            .hints = {"While the parcel leaves, the rocket's velocity changes. How much? Write "
                      "down the momentum before and after.",
                      "Call the change of the rocket's velocity c. The parcel moves at the old "
                      "velocity plus half of c plus w. Momentum before equals momentum after: "
                      "solve for c.",
                      "c is w dm over the mean of the masses before and after. What the function "
                      "returns is w plus half of c: bring it over one fraction line."},
            .picture = "rocket.svg",
            .mistakes =
                {{"measured from the speed before", "classic: first order",
                  "A rocket of few parcels is too fast: 6 % with fifteen of them.",
                  "You return w as it is: that is the parcel measured from the velocity "
                  "before. The mean has moved on by half the change.",
                  [](double, double, const Vector3& w) -> Vector3 { return w; }},
                 {"measured from the speed after", "classic: first order",
                  "A rocket of few parcels is too slow.",
                  "You measure the parcel from the velocity after. The mean lies halfway "
                  "between before and after.",
                  [](double mass, double dm, const Vector3& w) -> Vector3 {
                      return w * ((mass + dm) / mass);
                  }},
                 {"upside down", "classic: a fraction",
                  "The rocket is faster still than with parcels from the speed before.",
                  "Your fraction stands on its head: the parcel that a losing rocket "
                  "throws is slower than w seen from before, not faster.",
                  [](double mass, double dm, const Vector3& w) -> Vector3 {
                      return w * ((mass + dm / 2) / (mass + dm));
                  }},
                 {"gain taken for loss", "classic: a sign",
                  "The more is thrown at once, the more the rocket gains.",
                  "You take dm from the mass. dm is what the body gains; a rocket's is "
                  "negative already.",
                  [](double mass, double dm, const Vector3& w) -> Vector3 {
                      return w * ((mass - dm) / (mass - dm / 2));
                  }},
                 {"the mean mass over the mass before", "classic: a fraction",
                  "A rocket of few parcels is too fast.",
                  "You have w times the mean mass over the mass before, or w + w dm/(2 m), which "
                  "is "
                  "the same. Below the line stands the mean mass, above it the mass after.",
                  [](double mass, double dm, const Vector3& w) -> Vector3 {
                      return w * ((mass + dm / 2) / mass);
                  }},
                 {"the mass before over the mean mass", "classic: a fraction",
                  "The rocket is faster than with parcels from the speed before.",
                  "Below the line you are right: the mean mass. Above it belongs the mass after "
                  "the exchange, not the one before.",
                  [](double mass, double dm, const Vector3& w) -> Vector3 {
                      return w * (mass / (mass + dm / 2));
                  }},
                 {"half the change made with w itself", "classic",
                  "Nearly right for small parcels.",
                  "You add half of the change that w would make. But the change is made by the "
                  "velocity that is sought: it stands on both sides, solve for it.",
                  [](double mass, double dm, const Vector3& w) -> Vector3 {
                      return w + w * (dm / (2 * (mass + dm)));
                  }},
                 {"half of the parcel's share", "classic", "Nearly right for small parcels.",
                  "You take half of dm over the mass the other way. Write down the velocity of "
                  "the body half way, and solve for the one relative to the body before.",
                  [](double mass, double dm, const Vector3& w) -> Vector3 {
                      return w * (1 - dm / (2 * mass));
                  }},
                 {"half of w", "classic", "A rocket gets half of its speed.",
                  "Half way is about the body's change of velocity, not about half of w.",
                  [](double mass, double dm, const Vector3& w) -> Vector3 {
                      return w / 2 + 0 * (mass + dm) * w;
                  }}},
            .alternatives = {{"by the change of velocity",
                              [](double mass, double dm, const Vector3& w) -> Vector3 {
                                  const Vector3 change =
                                      w * dm / (mass + dm / 2);  // of the body's velocity
                                  return w + change / 2;
                              }}},
        };
    }
#endif
};

inline const bool midway_entered = enter<Midway>();

}  // namespace nutshell::exercises
