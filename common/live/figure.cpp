#include "nutshell/live/figure.hpp"

#include <algorithm>
#include <cstring>

namespace nutshell::live {

namespace {

std::vector<const Entry*>& all() {
    static std::vector<const Entry*> list;
    return list;
}

}  // namespace

Entry::Entry(const char* its_name, Make its_make) : name(its_name), make(its_make) {
    const auto before = [](const Entry* a, const Entry* b) { return std::strcmp(a->name, b->name) < 0; };
    all().insert(std::upper_bound(all().begin(), all().end(), this, before), this);
}

std::vector<const Entry*> entries() {
    return all();
}

Setting first_setting(const Figure& figure) {
    Setting setting;
    for (const Slider& slider : figure.sliders()) setting.values.push_back(slider.start);
    return setting;
}

void go_to(Figure& figure, const Setting& setting, double time) {
    figure.begin(setting);
    while (figure.ended().empty() && figure.time() + figure.step_size() / 2 < time) figure.step();
}

}  // namespace nutshell::live
