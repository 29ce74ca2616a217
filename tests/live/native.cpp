// native: every state of every figure of one chapter, after 1000 steps: one line of JSON each, for the page
// to be compared with. Linked with the chapter's figures.
#include <cstdio>
#include <nutshell/live/figure.hpp>

int main() {
    using namespace nutshell::live;
    const auto list = [](const std::vector<double>& values) {
        for (std::size_t i = 0; i < values.size(); ++i) std::printf("%s%.17g", i ? "," : "", values[i]);
    };
    for (const Entry* entry : entries()) {
        const auto figure = entry->make();
        const auto choices = figure->choices();
        for (const State& state : figure->states()) {
            for (int choice = 0; choice < std::max(1, int(choices.size())); ++choice) {
                Setting setting = state.setting;
                setting.choice = choice;
                figure->begin(setting);
                for (int n = 0; n < 1000 && figure->ended().empty(); ++n) figure->step();
                std::printf("{\"figure\":\"%s\",\"state\":\"%s\",\"choice\":%d,\"values\":[", entry->name,
                            state.key.c_str(), choice);
                list(setting.values);
                std::printf("],\"numbers\":[");
                list(figure->state());
                std::printf("]}\n");
            }
        }
    }
}
