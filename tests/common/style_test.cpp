// Looks of methods: colour says the family, mark and dash the member, and all of it can be told apart.
#include <nutshell/chart/style.hpp>
#include <nutshell/forces_methods.hpp>
#include <nutshell/spinning_methods.hpp>

#include <array>
#include <map>
#include <set>
#include <tuple>

#include "check.hpp"

using namespace nutshell;
using namespace nutshell::chart;

namespace {

constexpr std::array families{
    Family::explicit_one_step, Family::symplectic, Family::runge_kutta, Family::implicit,
    Family::exponential,       Family::exact,      Family::peer};

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
    const auto told_apart = [](const auto& methods) {
        std::set<std::tuple<Family, Mark, std::string, bool>> looks;
        each(methods, [&](const auto& method) {
            INFO(method.name);
            const Style style = style_of(method.look);
            CHECK(style.light == style_of(Look{method.look.family}).light);
            CHECK(looks.emplace(style.family, style.mark, style.dash, style.hollow).second);
        });
    };
    told_apart(forces_methods);
    told_apart(spinning_methods);
    std::set<std::string> colours;
    for (const Family family : families) colours.insert(style_of(Look{family}).light);
    CHECK(colours.size() == families.size());
}

TEST_CASE("a variant has the colour and mark of its method, hollow and finely dashed") {
    const Style style = style_of(variant(methods::verlet.look)), base = style_of(methods::verlet.look);
    CHECK(style.light == base.light);
    CHECK(style.mark == base.mark);
    CHECK(style.hollow);
    CHECK(style.dash != base.dash);
}

TEST_CASE("what is no method looks like none, and each of several differently") {
    for (int i = 0; i < 12; ++i) {
        CHECK(plain_style(i).family == Family::plain);
        for (int k = 0; k < i; ++k) {
            const Style a = plain_style(i), b = plain_style(k);
            CHECK((a.mark != b.mark || a.hollow != b.hollow));
        }
    }
}

TEST_CASE("names can be read in their colours, on light paper and dark") {
    const auto readable = [](const Style& style) {
        CHECK(contrast(style.light, "#FFFFFF") >= 4.5);
        CHECK(contrast(style.dark, "#15181C") >= 4.5);
    };
    for (const Family family : families) readable(style_of(Look{family}));
    for (int i = 0; i < 6; ++i) readable(plain_style(i));
}

TEST_CASE("families stay apart for eyes that do not see red, green or blue") {
    for (const Matrix& eyes : {everyone, without_red, without_green, without_blue})
        for (const Family a : families)
            for (const Family b : families) {
                if (a >= b) continue;
                INFO(int(a) << ", " << int(b));
                for (const auto colour : {&Style::light, &Style::dark}) {
                    const Light p = seen(style_of(Look{a}).*colour, eyes),
                                q = seen(style_of(Look{b}).*colour, eyes);
                    CHECK(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) > 10);  // 2.3 is just noticeable
                }
            }
}
