#include <nutshell/chart/style.hpp>
#include <nutshell/palette.hpp>

#include <array>

namespace nutshell::chart {
namespace {

// Steps from deep to light for what is counted or graded ("30 Hz", "60 Hz"), each with its own mark and dash.
constexpr std::array plain_colours{Shades{"#2D2466", "#DCD3FF"}, Shades{"#4F3A9E", "#BDA9FF"},
                                   Shades{"#7A52C7", "#9C82F5"}};
constexpr std::array plain_marks{Mark::circle,  Mark::square,        Mark::triangle,
                                 Mark::diamond, Mark::triangle_down, Mark::star};
constexpr std::array plain_dashes{"", "9 4", "3 3", "14 4", "12 3 3 3", "5 3"};

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

}  // namespace nutshell::chart
