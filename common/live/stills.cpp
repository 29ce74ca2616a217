#include "nutshell/live/stills.hpp"

#include <nutshell/picture/save.hpp>

namespace nutshell::live {

namespace {

pic::Shot shot(Figure& figure, const Setting& setting, double time, const std::string& title) {
    go_to(figure, setting, time);
    pic::Drawing drawing = figure.drawing(1);
    if (!title.empty()) drawing.title(title);
    return {drawing, figure.camera(figure.size()), figure.size()};
}

}  // namespace

pic::Sheet still(Figure& figure, const std::vector<State>& states) {
    pic::Sheet sheet;
    for (const State& state : states) {
        for (const double instant : state.instants)
            sheet.shots.push_back(shot(figure, state.setting, instant, lab::rounded(instant) + " s"));
        if (state.instants.empty())
            sheet.shots.push_back(
                shot(figure, state.setting, state.time, states.size() > 1 ? state.words : ""));
    }
    return sheet;
}

void draw_stills(lab::Report& report) {
    for (const Entry* entry : entries()) {
        const std::unique_ptr<Figure> figure = entry->make();
        std::vector<State> drawn;
        std::string keys;
        for (const State& state : figure->states()) {
            if (drawn.empty() || state.drawn) drawn.push_back(state);
            keys += (keys.empty() ? "" : " ") + state.key;
        }
        const pic::Note note{.command = report.command(),
                             .scene = entry->name,
                             .method = drawn.front().words,
                             .dt = {},
                             .numbers = {},
                             .states = keys};
        pic::save(report.path(std::string(entry->name) + ".png"), note,
                  [&]() -> pic::Sheet { return still(*figure, drawn); });
    }
}

}  // namespace nutshell::live
