// The same input gives the same bits: from g++ and clang, at every optimisation level. Only + - * / and sqrt
// are used by these runs. The values were printed once by this program (g++ 12, -O2) and are compared exactly
// ever since.
#include <cstdio>
#include "near.hpp"

using namespace nutshell;

namespace {

std::string bits(const Particle& s) {
    char text[200];
    std::snprintf(text, sizeof text, "%a %a %a %a %a", s.mass, s.position.x(), s.position.y(), s.momentum.x(),
                  s.momentum.y());
    return text;
}

}  // namespace

TEST_CASE("chapter 2: the same bits from every compiler") {
    CHECK(bits(lab::run(LeakyCart::as_printed(), methods::euler, 600)) ==
          "0x1.fffffffffff3p-1 0x1.15424a004d5aap+7 0x0p+0 0x1.4p+4 0x0p+0");
    CHECK(bits(lab::run(Raindrop{}, methods::verlet, 600)) ==
          "0x1.a36e2eb1c42c6p-15 0x1.3503445c54128p+2 0x1.0464487fd54bep+1 0x1.f75104d551d6ap-16 "
          "-0x1.34988e00df221p-10");
    CHECK(bits(lab::run(Rocket::with_midway(water_rocket()), methods::verlet, 600)) ==
          "0x1.400000000005p+1 0x1.95162b48e72bfp+2 0x1.49c73b39d9486p+4 0x1.b2ffcba64dd5ep+4 "
          "0x1.8c9958297ae05p+6");
    CHECK(bits(lab::run(water_rocket(), methods::semi_implicit_euler, 600)) ==
          "0x1.400000000005p+1 0x1.957c82236b1b4p+2 0x1.49fbd08c52fd3p+4 0x1.b396a5e5bbf29p+4 "
          "0x1.8d55e8f8c4847p+6");
}
