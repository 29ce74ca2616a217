// The same input gives the same bits: from g++ and clang, at every optimisation level. Only + - * / and sqrt
// are used by these runs. The values were printed once by this program (g++ 12, -O2) and are compared exactly
// ever since.
#include <cstdio>
#include <nutshell/lab/run.hpp>
#include <nutshell/newton_methods.hpp>
#include <nutshell/newton_scenes.hpp>
#include "check.hpp"

using namespace nutshell;

namespace {

/// A scene whose step is a decimal literal, so that no libm value enters.
struct Orbit : Planet {
    Orbit() { duration = 12; }
};

std::string bits(const PointMass& s) {
    char text[200];
    std::snprintf(text, sizeof text, "%a %a %a %a", s.position.x(), s.position.y(), s.velocity.x(),
                  s.velocity.y());
    return text;
}

}  // namespace

TEST_CASE("the same bits from every compiler") {
    CHECK(bits(lab::run(Orbit{}, methods::euler, 1500)) ==
          "-0x1.2978e52955579p+1 0x1.94de1a940cf8fp-1 -0x1.aa4dbbc03f3aep-2 -0x1.fa4887b1b764fp-3");
    CHECK(bits(lab::run(Orbit{}, methods::semi_implicit_euler, 1500)) ==
          "-0x1.41cd759627e9bp-3 -0x1.76cad68da3c8ep-1 0x1.32351d33f2ecep+0 0x1.ec8e6270fdb7bp-2");
    CHECK(bits(lab::run(Orbit{}, methods::verlet, 1500)) ==
          "-0x1.453ea2b78339p-3 -0x1.6f773ab52b7cdp-1 0x1.388ee07fa02f4p+0 0x1.ebc7a35ddb599p-2");
    CHECK(bits(lab::run(ThrownBall{}, methods::verlet, 180)) ==
          "0x1.e000000000015p+4 0x1.b5c28f5c2912bp-1 0x1.4p+3 -0x1.cdc28f5c28f4ap+3");
}
