#include <cmath>
#include <nutshell/clones.hpp>
#include <nutshell/wide_turns.hpp>

namespace nutshell::wide {

NUTSHELL_WIDE void turn_by_matrix(std::size_t n, Axes out, ConstAxes in, const double* m) {
    const double xx = m[0], xy = m[1], xz = m[2], yx = m[3], yy = m[4], yz = m[5], zx = m[6],
                 zy = m[7], zz = m[8];
    INDEPENDENT
    for (std::size_t i = 0; i < n; ++i) {
        const double x = in.x[i], y = in.y[i], z = in.z[i];
        out.x[i] = xx * x + xy * y + xz * z;
        out.y[i] = yx * x + yy * y + yz * z;
        out.z[i] = zx * x + zy * y + zz * z;
    }
}

NUTSHELL_WIDE void turn_by_four_vector(std::size_t n, Axes out, ConstAxes in, const double* q) {
    const double ux = q[0], uy = q[1], uz = q[2], w = q[3];
    INDEPENDENT
    for (std::size_t i = 0; i < n; ++i) {
        const double x = in.x[i], y = in.y[i], z = in.z[i];
        const double tx = 2 * (uy * z - uz * y), ty = 2 * (uz * x - ux * z),
                     tz = 2 * (ux * y - uy * x);
        out.x[i] = x + w * tx + (uy * tz - uz * ty);
        out.y[i] = y + w * ty + (uz * tx - ux * tz);
        out.z[i] = z + w * tz + (ux * ty - uy * tx);
    }
}

NUTSHELL_WIDE void stream_points(std::size_t n, Axes out, ConstAxes in) {
    const double one = 1;
    INDEPENDENT
    for (std::size_t i = 0; i < n; ++i) {
        out.x[i] = in.x[i] + one, out.y[i] = in.y[i] + one, out.z[i] = in.z[i] + one;
    }
}

NUTSHELL_WIDE void compose_four_vectors(std::size_t n, FourVectors q, FourVectors b) {
    INDEPENDENT
    for (std::size_t i = 0; i < n; ++i) {
        const double x = q.x[i], y = q.y[i], z = q.z[i], w = q.w[i];
        const double bx = b.x[i], by = b.y[i], bz = b.z[i], bw = b.w[i];
        q.x[i] = bw * x + w * bx + (by * z - bz * y);
        q.y[i] = bw * y + w * by + (bz * x - bx * z);
        q.z[i] = bw * z + w * bz + (bx * y - by * x);
        q.w[i] = bw * w - (bx * x + by * y + bz * z);
    }
}

NUTSHELL_WIDE void compose_unit_four_vectors(std::size_t n, FourVectors q, FourVectors b) {
    INDEPENDENT
    for (std::size_t i = 0; i < n; ++i) {
        const double x = q.x[i], y = q.y[i], z = q.z[i], w = q.w[i];
        const double bx = b.x[i], by = b.y[i], bz = b.z[i], bw = b.w[i];
        const double px = bw * x + w * bx + (by * z - bz * y);
        const double py = bw * y + w * by + (bz * x - bx * z);
        const double pz = bw * z + w * bz + (bx * y - by * x);
        const double pw = bw * w - (bx * x + by * y + bz * z);
        const double shrink = 1 / std::sqrt(px * px + py * py + pz * pz + pw * pw);
        q.x[i] = shrink * px, q.y[i] = shrink * py, q.z[i] = shrink * pz, q.w[i] = shrink * pw;
    }
}

NUTSHELL_WIDE void stream_four_vectors(std::size_t n, FourVectors q, FourVectors b) {
    INDEPENDENT
    for (std::size_t i = 0; i < n; ++i) {
        q.x[i] += b.x[i], q.y[i] += b.y[i], q.z[i] += b.z[i], q.w[i] += b.w[i];
    }
}

NUTSHELL_WIDE void compose_matrices(std::size_t n, const Matrices& pose, const Matrices& turn) {
    // by name: a loop over arrays of pointers would not become wide
    double *xx = pose[0], *xy = pose[1], *xz = pose[2], *yx = pose[3], *yy = pose[4],
           *yz = pose[5], *zx = pose[6], *zy = pose[7], *zz = pose[8];
    const double *txx = turn[0], *txy = turn[1], *txz = turn[2], *tyx = turn[3], *tyy = turn[4],
                 *tyz = turn[5], *tzx = turn[6], *tzy = turn[7], *tzz = turn[8];
    INDEPENDENT
    for (std::size_t i = 0; i < n; ++i) {
        const double a = xx[i], b = xy[i], c = xz[i], d = yx[i], e = yy[i], f = yz[i], g = zx[i],
                     h = zy[i], k = zz[i];
        xx[i] = txx[i] * a + txy[i] * d + txz[i] * g;
        xy[i] = txx[i] * b + txy[i] * e + txz[i] * h;
        xz[i] = txx[i] * c + txy[i] * f + txz[i] * k;
        yx[i] = tyx[i] * a + tyy[i] * d + tyz[i] * g;
        yy[i] = tyx[i] * b + tyy[i] * e + tyz[i] * h;
        yz[i] = tyx[i] * c + tyy[i] * f + tyz[i] * k;
        zx[i] = tzx[i] * a + tzy[i] * d + tzz[i] * g;
        zy[i] = tzx[i] * b + tzy[i] * e + tzz[i] * h;
        zz[i] = tzx[i] * c + tzy[i] * f + tzz[i] * k;
    }
}

}  // namespace nutshell::wide
