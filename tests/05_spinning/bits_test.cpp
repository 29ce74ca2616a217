// The same bits from g++ and clang: the methods of chapter 5 into which no libm function enters.
#include <cstdio>
#include "spin.hpp"

using namespace nutshell;

TEST_CASE("first order and RK4 under a spin of plain arithmetic give the same bits from every compiler") {
    const auto spin = [](const Quaternion& q, double t) -> Vector3 {
        return Vector3(0.9 - t, 1.4 * t, t * t - 0.7) + 0.5 * rotate(q, {0.8, -0.5, 1.1});
    };
    Quaternion divided = four_vector({0.5, -0.5, 0.5}, 0.5), grown = divided, rk = divided;
    for (int n = 0; n < 200; ++n) {
        const double dt = 1.0 / 64, t = n * dt;
        divided = first_order_unit(divided, spin, t, dt);
        grown = first_order(grown, spin, t, dt);
        rk = rk4_pose(rk, spin, t, dt);
    }
    char text[300];
    std::snprintf(text, sizeof text, "%a %a | %a %a | %a %a %a %a", divided.x(), divided.w(), grown.x(),
                  grown.w(), rk.x(), rk.y(), rk.z(), rk.w());
    CHECK(std::string(text) ==
          "-0x1.2e350aace6af7p-1 -0x1.05d05e5199d5ap-2 | -0x1.66d07f3ad4b84p-1 -0x1.2e6ec3fe9f678p-2 | "
          "-0x1.19ae7d7b79bf4p-1 -0x1.87ab95668e94cp-1 0x1.8ea33281fcb7p-3 -0x1.1702f7c01d43bp-2");
}
