#include <nutshell/chart/style.hpp>
#include <nutshell/palette.hpp>

#include <algorithm>
#include <array>
#include <cctype>

namespace nutshell::chart {
namespace {

struct Member {
    const char* name;  // lower case, plain hyphens
    Family family;
    Mark mark;
    const char* dash;
};

// The one table of the course. First member of a family: a solid line.
constexpr std::array members{
    Member{"euler", Family::explicit_one_step, Mark::circle, ""},
    Member{"printed step", Family::explicit_one_step, Mark::triangle_down, "8 3"},
    Member{"explicit step", Family::explicit_one_step, Mark::square, "3 3"},
    Member{"verlet", Family::symplectic, Mark::square, ""},
    Member{"semi-implicit euler", Family::symplectic, Mark::triangle, "9 4"},
    Member{"yoshida 4", Family::symplectic, Mark::diamond, "14 4"},
    Member{"kahan-li 8", Family::symplectic, Mark::star, "12 3 3 3"},
    Member{"logarithmic leapfrog", Family::symplectic, Mark::plus, "5 3"},
    Member{"kick-free-kick", Family::symplectic, Mark::triangle_down, "3 3"},
    Member{"rk4", Family::runge_kutta, Mark::circle, ""},
    Member{"explicit midpoint", Family::runge_kutta, Mark::triangle, "9 4"},
    Member{"dormand-prince 5(4)", Family::runge_kutta, Mark::diamond, "14 4"},
    Member{"implicit midpoint", Family::implicit, Mark::square, ""},
    Member{"implicit euler", Family::implicit, Mark::triangle_down, "9 4"},
    Member{"exponential verlet", Family::exponential, Mark::square, ""},
    Member{"exponential kick", Family::exponential, Mark::circle, "9 4"},
    Member{"exponential yoshida 4", Family::exponential, Mark::diamond, "14 4"},
    Member{"exponential map", Family::exponential, Mark::triangle, "5 3"},
    Member{"exponential midpoint", Family::exponential, Mark::triangle_down, "12 3 3 3"},
    Member{"magnus 4", Family::exponential, Mark::star, "3 3"},
    Member{"exact", Family::exact, Mark::circle, ""},
    Member{"exact propagator", Family::exact, Mark::diamond, "9 4"},
    Member{"theory", Family::reference, Mark::circle, "5 4"},
    Member{"floor", Family::reference, Mark::square, "2 3"},
    Member{"reference", Family::reference, Mark::triangle, "12 3 3 3"},
    Member{"boost.odeint", Family::peer, Mark::circle, ""},
    Member{"boost.odeint rk4", Family::peer, Mark::circle, "9 4"},
    Member{"boost.odeint dopri5", Family::peer, Mark::diamond, ""},
    Member{"boost.odeint rkf78", Family::peer, Mark::star, "12 3 3 3"},
    Member{"boost.odeint symplectic nystr\u00f6m", Family::peer, Mark::plus, "3 3"},
    Member{"bullet", Family::peer, Mark::square, "9 4"},
    Member{"ode", Family::peer, Mark::triangle, "14 4"},
    Member{"mujoco", Family::peer, Mark::diamond, "5 3"},
};

// Steps from deep to light for what is counted or graded ("30 Hz", "60 Hz"), each with its own mark and dash.
constexpr std::array plain_colours{Shades{"#2D2466", "#DCD3FF"}, Shades{"#4F3A9E", "#BDA9FF"},
                                   Shades{"#7A52C7", "#9C82F5"}};
constexpr std::array plain_marks{Mark::circle,  Mark::square,        Mark::triangle,
                                 Mark::diamond, Mark::triangle_down, Mark::star};
constexpr std::array plain_dashes{"", "9 4", "3 3", "14 4", "12 3 3 3", "5 3"};

std::string plain_letters(std::string_view name) {
    std::string result;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const std::string_view three = name.substr(i, 3);
        if (three == "\u2013" || three == "\u2010" || three == "\u2011") {  // en dash and the two hyphens
            result += '-', i += 2;
        } else {
            result += static_cast<char>(std::tolower(static_cast<unsigned char>(name[i])));
        }
    }
    return result;
}

const Member* find(std::string_view name) {
    for (const Member& member : members)
        if (name == member.name) return &member;
    return nullptr;
}

// "verlet, naive", "verlet (naive)", "boost.odeint: rk4" -> "verlet", "verlet", "boost.odeint"
std::string_view before_its_addition(std::string_view name) {
    return name.substr(0, std::min({name.find(", "), name.find(" ("), name.find(": ")}));
}

}  // namespace

Style style_of(const Look& look) {
    const auto [light, dark] = shades_of(look.family);
    return {look.family, look.mark, look.hollow, light, dark, look.dash};
}

Style plain_style(int number) {
    const auto n = static_cast<std::size_t>(number < 0 ? 0 : number);
    const auto [light, dark] = plain_colours[n % plain_colours.size()];
    return {Family::plain, plain_marks[n % plain_marks.size()],  n / plain_marks.size() % 2 == 1, light,
            dark,          plain_dashes[n % plain_dashes.size()]};
}

bool is_method(std::string_view name) {
    const std::string letters = plain_letters(name);
    return find(letters) || find(before_its_addition(letters));
}

Style style_of(std::string_view name, int plain_number) {
    const std::string letters = plain_letters(name);
    const Member* member = find(letters);
    const bool variant = !member;
    if (variant) member = find(before_its_addition(letters));
    if (member) {
        const auto [light, dark] = shades_of(member->family);
        return {member->family, member->mark, variant, light, dark, variant ? "1.5 3" : member->dash};
    }
    return plain_style(plain_number);
}

}  // namespace nutshell::chart
