// The Magnus step of rotation_methods.hpp, number by number, so that a loop over it is wide.
#include <nutshell/clones.hpp>
#include <nutshell/wide_bodies.hpp>

namespace nutshell::wide {

namespace {

#define ALWAYS_INLINE [[gnu::always_inline]] inline

struct Three {
    double x, y, z;
};
struct Four {
    double x, y, z, w;
};

ALWAYS_INLINE Three operator+(const Three& a, const Three& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
ALWAYS_INLINE Three operator*(double s, const Three& a) {
    return {s * a.x, s * a.y, s * a.z};
}
ALWAYS_INLINE Three times(const Three& a, const Three& b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}
ALWAYS_INLINE Three cross(const Three& a, const Three& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
ALWAYS_INLINE double square(const Three& a) {
    return a.x * a.x + a.y * a.y + a.z * a.z;
}
ALWAYS_INLINE Four product(const Four& b, const Four& a) {
    return {b.w * a.x + a.w * b.x + (b.y * a.z - b.z * a.y),
            b.w * a.y + a.w * b.y + (b.z * a.x - b.x * a.z),
            b.w * a.z + a.w * b.z + (b.x * a.y - b.y * a.x),
            b.w * a.w - (b.x * a.x + b.y * a.y + b.z * a.z)};
}
ALWAYS_INLINE Three rotate(const Four& q, const Three& p) {
    const Three u{q.x, q.y, q.z}, t = 2 * cross(u, p);
    return p + q.w * t + cross(u, t);
}

/// Exp(a): the series for half of the turn, which is then done twice.
ALWAYS_INLINE Four exponential(const Three& a) {
    const double x = square(a) / 16, x2 = x * x, x4 = x2 * x2;
    const double c =
        (1 - x * (1. / 2)) + x2 * (1. / 24 - x * (1. / 720)) +
        x4 * ((1. / 40320 - x * (1. / 3628800)) + x2 * (1. / 479001600 - x * (1. / 87178291200)));
    const double s = (1 - x * (1. / 6)) + x2 * (1. / 120 - x * (1. / 5040)) +
                     x4 * ((1. / 362880 - x * (1. / 39916800)) +
                           x2 * (1. / 6227020800 - x * (1. / 1307674368000)));
    const Three u = (0.25 * s) * a;
    const Three twice = (2 * c) * u;
    return {twice.x, twice.y, twice.z, c * c - square(u)};
}

/// The pose after dt, of a body with moments I, pose q and angular momentum L.
ALWAYS_INLINE Four turned(const Three& I, const Four& q, const Three& L, double dt) {
    const double trim = 1.5 - 0.5 * (q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
    const Four start{trim * q.x, trim * q.y, trim * q.z, trim * q.w};
    const double per_square = 1 / (square(L) + 1e-300);  // a body at rest: times zero
    const Three J{1 / I.x, 1 / I.y, 1 / I.z};
    const Three c{J.z - J.y, J.x - J.z, J.y - J.x};
    const auto rate = [&c](const Three& M) __attribute__((always_inline)) {
        return Three{c.x * M.y * M.z, c.y * M.z * M.x, c.z * M.x * M.y};
    };
    const Three M0 = rotate({-start.x, -start.y, -start.z, start.w}, L);
    const Three k1 = rate(M0), k2 = rate(M0 + (dt / 2) * k1), k3 = rate(M0 + (dt / 2) * k2),
                k4 = rate(M0 + dt * k3);
    Three M1 = M0 + (dt / 6) * (k1 + 2 * (k2 + k3) + k4);
    M1 = (1.5 - 0.5 * square(M1) * per_square) * M1;
    const Three middle = 0.5 * (M0 + M1) + (dt / 8) * (k1 + (-1.) * rate(M1));
    const Three w0 = times(J, M0), wm = times(J, middle), w1 = times(J, M1);
    const Four turn = exponential((dt / 6) * (w0 + 4 * wm + w1) + (dt * dt / 12) * cross(w0, w1));
    const Three missing = (per_square / 2) * cross(rotate(turn, M1), M0);
    return product(start, product({missing.x, missing.y, missing.z, 1}, turn));
}

}  // namespace

NUTSHELL_WIDE void push(std::size_t n, Axes momentum, ConstAxes force, double dt) {
    INDEPENDENT
    for (std::size_t i = 0; i < n; ++i) {
        momentum.x[i] += force.x[i] * dt;
        momentum.y[i] += force.y[i] * dt;
        momentum.z[i] += force.z[i] * dt;
    }
}

NUTSHELL_WIDE void drift(std::size_t n, const BodyArrays& bodies, double dt) {
    const auto [mass, I, p, K, q, L] = bodies;
    INDEPENDENT
    for (std::size_t i = 0; i < n; ++i) {
        const Four next = turned({I.x[i], I.y[i], I.z[i]}, {q.x[i], q.y[i], q.z[i], q.w[i]},
                                 {L.x[i], L.y[i], L.z[i]}, dt);
        q.x[i] = next.x, q.y[i] = next.y, q.z[i] = next.z, q.w[i] = next.w;
        p.x[i] += K.x[i] / mass[i] * dt;
        p.y[i] += K.y[i] / mass[i] * dt;
        p.z[i] += K.z[i] / mass[i] * dt;
    }
}

NUTSHELL_WIDE void stream_bodies(std::size_t n, const BodyArrays& bodies) {
    const auto [mass, I, p, K, q, L] = bodies;
    INDEPENDENT
    for (std::size_t i = 0; i < n; ++i) {
        q.x[i] += I.x[i], q.y[i] += I.y[i], q.z[i] += I.z[i], q.w[i] += mass[i];
        p.x[i] += K.x[i] + L.x[i], p.y[i] += K.y[i] + L.y[i], p.z[i] += K.z[i] + L.z[i];
    }
}

// One number stands in for every number a body loads; what is added to it keeps the compiler from
// computing anything once for all axes.
NUTSHELL_WIDE void arithmetic_bodies(std::size_t n, const double* in, double* out, double dt) {
    INDEPENDENT
    for (std::size_t i = 0; i < n; ++i) {
        const double a = in[i];
        const Four next = turned({a, a + 0.1, a + 0.2}, {0.1 * a, 0.2 * a, 0.3 * a, 0.4 * a},
                                 {a - 1.1, a - 0.3, a - 0.7}, dt);
        const double px = a + (a + 0.3) / (a + 0.4) * dt, py = a + (a + 0.5) / (a + 0.6) * dt,
                     pz = a + (a + 0.7) / (a + 0.8) * dt;
        out[i] = next.x + next.y + next.z + next.w + px + py + pz;
    }
}

}  // namespace nutshell::wide
