// Every loop here runs over arrays that do not overlap, and no turn of a loop needs another: the
// compiler may do as many turns at once as the processor has room for. Square roots, divisions,
// sums and products are the same bits in any width.
#include <cmath>
#include <nutshell/clones.hpp>
#include <nutshell/wide.hpp>

namespace nutshell::wide {

namespace {

constexpr double no_length = 1e-300;  // [m^2]
constexpr std::size_t block =
    256;  // springs worked on at a time: their pulls stay in the nearest cache

struct Pulls {  // room for `most_step` pulls of the block before
    double x[most_step + block], y[most_step + block], z[most_step + block];
};

inline std::size_t least(std::size_t a, std::size_t b) {
    return a < b ? a : b;
}

/// The last `step` pulls of a block of `count` begin the next one.
inline void keep_last(Pulls& pulls, std::size_t step, std::size_t count) {
    for (std::size_t i = most_step - step; i < most_step; ++i) {
        pulls.x[i] = pulls.x[i + count], pulls.y[i] = pulls.y[i + count],
        pulls.z[i] = pulls.z[i + count];
    }
}

// The pull on end a of a spring from a to b is stiffness (1 - rest_length / length) (b - a).
// Where the ends meet the length is zero and the direction unknown: `no_length` keeps the
// division finite, and the pull, a number times zero, is zero. It changes no bit of a spring
// longer than 1e-141 m.
inline void pulls_of(std::size_t n, ConstAxes a, ConstAxes b, double* px, double* py, double* pz,
                     double rest_length, double stiffness) {
    INDEPENDENT
    for (std::size_t i = 0; i < n; ++i) {
        const double dx = b.x[i] - a.x[i], dy = b.y[i] - a.y[i], dz = b.z[i] - a.z[i];
        const double pull =
            stiffness * (1 - rest_length / std::sqrt(dx * dx + dy * dy + dz * dz + no_length));
        px[i] = pull * dx, py[i] = pull * dy, pz[i] = pull * dz;
    }
}

}  // namespace

NUTSHELL_WIDE void drift(std::size_t n, Axes x, ConstAxes v, double dt) {
    INDEPENDENT
    for (std::size_t i = 0; i < n; ++i) {
        x.x[i] += v.x[i] * dt;
        x.y[i] += v.y[i] * dt;
        x.z[i] += v.z[i] * dt;
    }
}

NUTSHELL_WIDE void kick(std::size_t n, Axes v, ConstAxes f, const double* mass, double dt) {
    INDEPENDENT
    for (std::size_t i = 0; i < n; ++i) {
        const double change = dt / mass[i];
        v.x[i] += change * f.x[i];
        v.y[i] += change * f.y[i];
        v.z[i] += change * f.z[i];
    }
}

NUTSHELL_WIDE void weight_and_drag(std::size_t n, Axes f, ConstAxes v, const double* mass,
                                   const Medium& medium) {
    const auto [gx, gy, gz, drag] = medium;
    INDEPENDENT
    for (std::size_t i = 0; i < n; ++i) {
        f.x[i] = mass[i] * gx - drag * v.x[i];
        f.y[i] = mass[i] * gy - drag * v.y[i];
        f.z[i] = mass[i] * gz - drag * v.z[i];
    }
}

NUTSHELL_WIDE void anchored_springs(std::size_t n, Axes f, ConstAxes x, ConstAxes anchor,
                                    double stiffness) {
    INDEPENDENT
    for (std::size_t i = 0; i < n; ++i) {
        f.x[i] += stiffness * (anchor.x[i] - x.x[i]);
        f.y[i] += stiffness * (anchor.y[i] - x.y[i]);
        f.z[i] += stiffness * (anchor.z[i] - x.z[i]);
    }
}

NUTSHELL_WIDE void springs_between(std::size_t n, ConstAxes a, ConstAxes b, Axes fa, Axes fb,
                                   double rest_length, double stiffness) {
    INDEPENDENT
    for (std::size_t i = 0; i < n; ++i) {
        const double dx = b.x[i] - a.x[i], dy = b.y[i] - a.y[i], dz = b.z[i] - a.z[i];
        const double pull =
            stiffness * (1 - rest_length / std::sqrt(dx * dx + dy * dy + dz * dz + no_length));
        fa.x[i] += pull * dx, fa.y[i] += pull * dy, fa.z[i] += pull * dz;
        fb.x[i] -= pull * dx, fb.y[i] -= pull * dy, fb.z[i] -= pull * dz;
    }
}

NUTSHELL_WIDE void springs_in_row(std::size_t n, std::size_t step, ConstAxes x, Axes f,
                                  double rest_length, double stiffness) {
    Pulls pulls;
    double *px = pulls.x + most_step, *py = pulls.y + most_step, *pz = pulls.z + most_step;
    for (std::size_t i = 0; i < step; ++i)
        pulls.x[most_step + i - step] = pulls.y[most_step + i - step] =
            pulls.z[most_step + i - step] = 0;
    for (std::size_t begin = 0; begin < n; begin += block) {
        const std::size_t count = least(block, n - begin),
                          springs = begin + step < n ? least(count, n - step - begin) : 0;
        pulls_of(springs, x.from(begin), x.from(begin + step), px, py, pz, rest_length,
                 stiffness);
        for (std::size_t i = springs; i < count; ++i) px[i] = py[i] = pz[i] = 0;
        const double *qx = px - step, *qy = py - step,
                     *qz = pz - step;  // pulls that end where these start
        const Axes fb = f.from(begin);
        INDEPENDENT
        for (std::size_t i = 0; i < count; ++i) {
            fb.x[i] += px[i] - qx[i];
            fb.y[i] += py[i] - qy[i];
            fb.z[i] += pz[i] - qz[i];
        }
        keep_last(pulls, step, count);
    }
}

NUTSHELL_WIDE void anchored_step(std::size_t n, Axes x, Axes v, const double* mass,
                                 ConstAxes anchor, double stiffness, const Medium& medium,
                                 double dt) {
    const auto [gx, gy, gz, drag] = medium;
    INDEPENDENT
    for (std::size_t i = 0; i < n; ++i) {
        const double change = dt / mass[i];
        const double fx = mass[i] * gx - drag * v.x[i] + stiffness * (anchor.x[i] - x.x[i]);
        const double fy = mass[i] * gy - drag * v.y[i] + stiffness * (anchor.y[i] - x.y[i]);
        const double fz = mass[i] * gz - drag * v.z[i] + stiffness * (anchor.z[i] - x.z[i]);
        x.x[i] += (v.x[i] += change * fx) * dt;
        x.y[i] += (v.y[i] += change * fy) * dt;
        x.z[i] += (v.z[i] += change * fz) * dt;
    }
}

NUTSHELL_WIDE void chain_step(std::size_t n, Axes x, Axes v, const double* mass,
                              double rest_length, double stiffness, const Medium& medium,
                              bool first_held, bool last_held, double dt) {
    const auto [gx, gy, gz, drag] = medium;
    Pulls pulls;
    double *px = pulls.x + most_step, *py = pulls.y + most_step, *pz = pulls.z + most_step;
    px[-1] = py[-1] = pz[-1] = 0;
    for (std::size_t begin = 0; begin < n; begin += block) {
        const std::size_t count = least(block, n - begin), springs = least(count, n - 1 - begin);
        pulls_of(springs, x.from(begin), x.from(begin + 1), px, py, pz, rest_length, stiffness);
        if (springs < count) px[springs] = py[springs] = pz[springs] = 0;
        // Springs of later blocks begin at particles of later blocks: those of this one may move
        // now.
        const std::size_t first = begin == 0 && first_held,
                          last = begin + count == n && last_held ? count - 1 : count;
        const double *qx = px - 1, *qy = py - 1, *qz = pz - 1, *m = mass + begin;
        const Axes xb = x.from(begin), vb = v.from(begin);
        INDEPENDENT
        for (std::size_t i = first; i < last; ++i) {
            const double change = dt / m[i];
            const double fx = m[i] * gx - drag * vb.x[i] + (px[i] - qx[i]);
            const double fy = m[i] * gy - drag * vb.y[i] + (py[i] - qy[i]);
            const double fz = m[i] * gz - drag * vb.z[i] + (pz[i] - qz[i]);
            xb.x[i] += (vb.x[i] += change * fx) * dt;
            xb.y[i] += (vb.y[i] += change * fy) * dt;
            xb.z[i] += (vb.z[i] += change * fz) * dt;
        }
        keep_last(pulls, 1, count);
    }
}

}  // namespace nutshell::wide
