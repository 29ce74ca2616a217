// Numbers within a distance, and numbers by chance that are the same on every machine.
#pragma once
#include <cstdint>
#include <nutshell/vector.hpp>
#include "check.hpp"

/// CHECK(x == near(value, within)): not farther than `within` from `value`; prints both.
struct Near {
    double value, within;
};
inline Near near(double value, double within) {
    return {value, within};
}
inline bool operator==(double x, const Near& n) {
    return std::abs(x - n.value) <= n.within;
}
inline std::ostream& operator<<(std::ostream& out, const Near& n) {
    return out << n.value << " +- " << n.within;
}

/// splitmix64: the same numbers from every compiler.
class Chance {
  public:
    explicit Chance(std::uint64_t seed) : state_(seed) {}
    double operator()(double from, double to) {
        state_ += 0x9e3779b97f4a7c15ull;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        return from + (to - from) * static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
    }
    nutshell::Vector3 vector(double size) {
        const double x = (*this)(-size, size), y = (*this)(-size, size), z = (*this)(-size, size);
        return {x, y, z};
    }
    nutshell::Vector3 direction() {
        for (;;) {
            const nutshell::Vector3 v = vector(1);
            if (v.squaredNorm() > 0.01 && v.squaredNorm() <= 1) return v.normalized();
        }
    }

  private:
    std::uint64_t state_;
};
