// The one table of looks: colour says the family, mark and dash the member, and all of it can be told apart.
#include <nutshell/chart/style.hpp>

#include <array>
#include <map>

#include "check.hpp"

using namespace nutshell;
using namespace nutshell::chart;

namespace {

constexpr std::array methods{"Euler",
                             "semi-implicit Euler",
                             "Verlet",
                             "Yoshida 4",
                             "Kahan-Li 8",
                             "explicit midpoint",
                             "RK4",
                             "Dormand-Prince 5(4)",
                             "implicit Euler",
                             "implicit midpoint",
                             "exponential kick",
                             "exponential Verlet",
                             "exact propagator",
                             "Bullet",
                             "ODE",
                             "MuJoCo",
                             "Boost.odeint"};

using Light = std::array<double, 3>;  // linear red, green, blue

Light light_of(const std::string& colour) {
    Light result{};
    for (std::size_t k = 0; k < 3; ++k) {
        const double c = std::stoi(colour.substr(1 + 2 * k, 2), nullptr, 16) / 255.0;
        result[k] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    }
    return result;
}

/// Contrast of WCAG 2: 4.5 is asked of text.
double contrast(const std::string& a, const std::string& b) {
    const auto luminance = [](const Light& c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; };
    const double la = luminance(light_of(a)), lb = luminance(light_of(b));
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

using Matrix = std::array<Light, 3>;
constexpr Matrix everyone{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
// What is left of a colour for eyes without red, green or blue receptors (Machado, Oliveira and Fernandes
// 2009, severity 1).
constexpr Matrix without_red{
    {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
constexpr Matrix without_green{
    {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};

constexpr Matrix without_blue{
    {{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}};

/// CIE L*a*b* of a colour as these eyes see it.
Light seen(const std::string& colour, const Matrix& eyes) {
    const Light c = light_of(colour);
    Light s{};
    for (std::size_t i = 0; i < 3; ++i) s[i] = eyes[i][0] * c[0] + eyes[i][1] * c[1] + eyes[i][2] * c[2];
    const auto f = [](double t) {
        return t > 0.008856 ? std::cbrt(t) : 7.787 * std::max(t, 0.0) + 16.0 / 116;
    };
    const double x = f((0.4124 * s[0] + 0.3576 * s[1] + 0.1805 * s[2]) / 0.9505);
    const double y = f(0.2126 * s[0] + 0.7152 * s[1] + 0.0722 * s[2]);
    const double z = f((0.0193 * s[0] + 0.1192 * s[1] + 0.9505 * s[2]) / 1.089);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

}  // namespace

TEST_CASE("colour is the family, mark and dash are the member") {
    std::map<Family, std::string> colours;
    for (const char* a : methods) {
        const Style style = style_of(a);
        CHECK(is_method(a));
        CHECK_FALSE(style.hollow);
        const auto [known, fresh] = colours.emplace(style.family, style.light);
        CHECK(known->second == style.light);
        for (const char* b : methods) {
            const Style other = style_of(b);
            INFO(a << ", " << b);
            if (std::string(a) != b && style.family == other.family) {
                CHECK(style.mark != other.mark);
                CHECK(style.dash != other.dash);
            }
        }
    }
    CHECK(colours.size() == 7);
    CHECK(style_of("Verlet").family == Family::symplectic);
    CHECK(style_of("RK4").family == Family::runge_kutta);
    CHECK(style_of("implicit midpoint").family == Family::implicit);
    CHECK(style_of("Bullet").family == Family::peer);
}

TEST_CASE("hyphens and case do not matter, an addition makes a variant") {
    CHECK(style_of("Dormand\u2013Prince 5(4)").family == Family::runge_kutta);
    CHECK(style_of("kahan\u2010li 8").mark == style_of("Kahan-Li 8").mark);
    for (const char* variant : {"Verlet, naive", "Verlet (naive)", "Verlet: naive"}) {
        const Style style = style_of(variant), base = style_of("Verlet");
        CHECK(is_method(variant));
        CHECK(style.light == base.light);
        CHECK(style.mark == base.mark);
        CHECK(style.hollow);
        CHECK(style.dash != base.dash);
    }
    CHECK_FALSE(is_method("Verlets"));
    CHECK(style_of("").family == Family::plain);
}

TEST_CASE("what is no method looks like none, and each of several differently") {
    CHECK_FALSE(is_method("60 Hz"));
    for (int i = 0; i < 12; ++i) {
        CHECK(style_of("60 Hz", i).family == Family::plain);
        for (int k = 0; k < i; ++k) {
            const Style a = style_of("60 Hz", i), b = style_of("60 Hz", k);
            CHECK((a.mark != b.mark || a.hollow != b.hollow));
        }
    }
}

TEST_CASE("names can be read in their colours, on light paper and dark") {
    const auto readable = [](const Style& style) {
        CHECK(contrast(style.light, "#FFFFFF") >= 4.5);
        CHECK(contrast(style.dark, "#15181C") >= 4.5);
    };
    for (const char* name : methods) readable(style_of(name));
    for (int i = 0; i < 6; ++i) readable(style_of("plain", i));
}

TEST_CASE("families stay apart for eyes that do not see red, green or blue") {
    constexpr std::array families{"Euler", "Verlet", "RK4", "implicit Euler", "exponential kick",
                                  "exact", "Bullet"};
    for (const Matrix& eyes : {everyone, without_red, without_green, without_blue})
        for (const char* a : families)
            for (const char* b : families) {
                if (std::string(a) >= b) continue;
                INFO(a << ", " << b);
                for (const auto colour : {&Style::light, &Style::dark}) {
                    const Light p = seen(style_of(a).*colour, eyes), q = seen(style_of(b).*colour, eyes);
                    CHECK(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) > 10);  // 2.3 is just noticeable
                }
            }
}
