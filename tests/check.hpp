// Catch2 v2 (Debian 12) and v3 (newer) look the same from here on, and a check of an order explains itself.
#pragma once
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators_all.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <catch2/matchers/catch_matchers_templated.hpp>
template <class T>
using MatcherOf = Catch::Matchers::MatcherBase<T>;
using Catch::Approx;  // v2 has it in the global namespace already
using Catch::Matchers::ContainsSubstring;
#else
#include <catch2/catch.hpp>
template <class T>
using MatcherOf = Catch::MatcherBase<T>;
inline auto ContainsSubstring(const std::string& text) {
    return Catch::Matchers::Contains(text);
}
#endif
#include <cmath>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

/// Errors at several steps; Catch2 prints it as a table.
struct Convergence {
    std::vector<double> dt, error;
    double order() const {
        double sx = 0, sy = 0, sxx = 0, sxy = 0;
        for (std::size_t i = 0; i < dt.size(); ++i) {
            const double x = std::log(dt[i]), y = std::log(error[i]);
            sx += x, sy += y, sxx += x * x, sxy += x * y;
        }
        const auto n = static_cast<double>(dt.size());
        return (n * sxy - sx * sy) / (n * sxx - sx * sx);
    }
};

inline std::ostream& operator<<(std::ostream& out, const Convergence& c) {
    out << "\n  dt, error, order between neighbours:";
    for (std::size_t i = 0; i < c.dt.size(); ++i) {
        out << "\n  " << c.dt[i] << "  " << c.error[i];
        if (i) out << "  " << std::log(c.error[i - 1] / c.error[i]) / std::log(c.dt[i - 1] / c.dt[i]);
    }
    return out << '\n';
}

/// CHECK_THAT(Convergence{...}, HasOrder(2)): the slope of log error against log dt is 2 within 0.05.
class HasOrder : public MatcherOf<Convergence> {
  public:
    explicit HasOrder(double order, double within = 0.05) : order_(order), within_(within) {}
    bool match(const Convergence& c) const override {
        measured_ = c.order();
        return std::abs(measured_ - order_) <= within_;
    }
    std::string describe() const override {
        std::ostringstream text;
        text << "converges at order " << order_ << " within " << within_ << "; measured " << measured_;
        return text.str();
    }

  private:
    double order_, within_;
    mutable double measured_ = 0;
};
