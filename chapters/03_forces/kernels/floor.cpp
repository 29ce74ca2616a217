#include <cmath>
#include <nutshell/clones.hpp>
#include <nutshell/wide_floor.hpp>

namespace nutshell::wide {

NUTSHELL_WIDE void stream_anchored(std::size_t n, Axes x, Axes v, const double* mass,
                                   ConstAxes anchor) {
    INDEPENDENT
    for (std::size_t i = 0; i < n; ++i) {
        v.x[i] += mass[i], v.y[i] += mass[i], v.z[i] += mass[i];
        x.x[i] += anchor.x[i], x.y[i] += anchor.y[i], x.z[i] += anchor.z[i];
    }
}

NUTSHELL_WIDE void stream_net(std::size_t n, Axes x, Axes v, const double* mass) {
    INDEPENDENT
    for (std::size_t i = 0; i < n; ++i) {
        v.x[i] += mass[i], v.y[i] += mass[i], v.z[i] += mass[i];
        x.x[i] += mass[i], x.y[i] += mass[i], x.z[i] += mass[i];
    }
}

// In the three below one number q stands in for every number that a step loads; constants that
// differ keep the compiler from computing anything once for all three axes. Two additions per
// turn make one number to store out of three.

NUTSHELL_WIDE void arithmetic_anchored(std::size_t n, const double* in, double* out,
                                       const Medium& medium, double stiffness, double dt) {
    const auto [gx, gy, gz, drag] = medium;
    const double ax = 1.1, ay = 1.2, az = 1.3, dx = drag, dy = 2 * drag, dz = 3 * drag;
    INDEPENDENT
    for (std::size_t i = 0; i < n; ++i) {
        const double q = in[i], change = dt / q;
        const double vx = q + change * (q * gx - dx * q + stiffness * (ax - q));
        const double vy = q + change * (q * gy - dy * q + stiffness * (ay - q));
        const double vz = q + change * (q * gz - dz * q + stiffness * (az - q));
        out[i] = (q + vx * dt) + (q + vy * dt) + (q + vz * dt);
    }
}

NUTSHELL_WIDE void arithmetic_spring(std::size_t n, const double* in, double* out,
                                     double rest_length, double stiffness) {
    const double ax = 2.1, ay = 2.2, az = 2.3, fx = 0.1, fy = 0.2, fz = 0.3;
    INDEPENDENT
    for (std::size_t i = 0; i < n; ++i) {
        const double q = in[i], dx = q - ax, dy = q - ay, dz = q - az;
        const double pull =
            stiffness * (1 - rest_length / std::sqrt(dx * dx + dy * dy + dz * dz + 1e-300));
        const double px = pull * dx, py = pull * dy, pz = pull * dz;
        out[i] = (q + (px - fx)) + (q + (py - fy)) + (q + (pz - fz));
    }
}

NUTSHELL_WIDE void arithmetic_move(std::size_t n, const double* in, double* out,
                                   const Medium& medium, double dt) {
    const auto [gx, gy, gz, drag] = medium;
    const double fx = 0.1, fy = 0.2, fz = 0.3, dx = drag, dy = 2 * drag, dz = 3 * drag;
    INDEPENDENT
    for (std::size_t i = 0; i < n; ++i) {
        const double q = in[i], change = dt / q;
        const double vx = q + change * (q * gx - dx * q + fx);
        const double vy = q + change * (q * gy - dy * q + fy);
        const double vz = q + change * (q * gz - dz * q + fz);
        out[i] = (q + vx * dt) + (q + vy * dt) + (q + vz * dt);
    }
}

}  // namespace nutshell::wide
