// The chain of ten masses whose limits chapter 3 predicts: it hangs at rest, and past its limit it
// shakes itself apart. The pointer pulls it.
#include <nutshell/sentence.hpp>
#include "net.hpp"

namespace nutshell {

namespace {

constexpr double mass = 0.02, stiffness = 50;  // [kg], [N/m]

SpringNet hanging() {
    SpringNet net = chain(10, mass, {stiffness, 0.1}, {0, 0, 0}, {1.1, 0, 0});
    return braked(std::move(net), 0.03, 20);
}

class LiveChain : public LiveNet {
  public:
    LiveChain()
        : LiveNet(hanging(), chain_frequency(10, mass, stiffness), 1.5, 0.12, {0, 1, 0}) {}
    std::vector<live::State> states() const override {
        const double limit = 1e3 * limit_of(2);
        return {{.key = "below",
                 .words = phrase("{} at 0.95 of its limit", methods::verlet),
                 .setting = {2, {0.95 * limit}},
                 .time = 0.3},
                {.key = "above",
                 .words = phrase("{} at 1.05 of its limit", methods::verlet),
                 .setting = {2, {1.05 * limit}},
                 .time = 0.9}};
    }
    pic::Drawing drawing(double) const override {
        pic::Drawing drawing;
        drawing.stage({{0.55, 0.6, 0}, 0.9});
        drawing.ground({.spacing = 0.2});
        const auto at = [&](std::size_t i) -> Vector3 { return now().position[i] + lift_; };
        const std::size_t last = now().size() - 1;
        for (const std::size_t end : {std::size_t(0), last})
            drawing.add(pic::Rod{.from = {at(end).x(), 0, 0}, .to = at(end), .radius = 0.018});
        for (std::size_t i = 0; i < last; ++i)
            drawing.add(pic::Rod{.from = at(i), .to = at(i + 1), .radius = 0.008});
        for (std::size_t i = 1; i < last; ++i)
            drawing.add(
                pic::Ball{.centre = at(i), .radius = 0.032, .colour = pic::palette::symplectic});
        return drawing;
    }
    pic::Camera camera(pic::Size size) const override {
        pic::Drawing all;
        all.add(pic::Trail{.points = {{-0.2, 0, 0}, {1.3, 0, 0}, {0.5, 1.25, 0}}});
        return pic::fit(all, {0.12, 0.16, 1}, size, {.margin = 0.04});
    }
};

const live::Entry entry{"chain_limit",
                        [] { return std::unique_ptr<live::Figure>(new LiveChain); }};

}  // namespace

}  // namespace nutshell
