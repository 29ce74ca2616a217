// A wagon wheel on film: eight equal spokes, or one of them painted.
#include <nutshell/live/figure.hpp>
#include "../drawings.hpp"

namespace nutshell {

namespace {

class LiveWagon : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override {
        return {{"alike", "spokes alike", {Family::implicit, Mark::circle}},
                {"painted", "one spoke painted", {Family::explicit_one_step, Mark::square}}};
    }
    std::vector<live::Slider> sliders() const override {
        return {{.name = "wheel",
                 .unit = "turns/s",
                 .least = 0.1,
                 .most = 6,
                 .start = 2.75,
                 .logarithmic = false,
                 .mark = 3,
                 .mark_words = "stands still"}};
    }
    std::vector<live::State> states() const override {
        return {
            {.key = "alike",
             .words = "2.75 turns a second, spokes alike",
             .setting = {0, {2.75}},
             .time = 5.0 / 24,
             .instants = {0, 1.0 / 24, 2.0 / 24, 3.0 / 24, 4.0 / 24, 5.0 / 24}},
            {.key = "still", .words = "3 turns a second", .setting = {0, {3}}, .time = 1},
            {.key = "painted", .words = "one spoke painted", .setting = {1, {2.75}}, .time = 1}};
    }
    void begin(const live::Setting& setting) override {
        change(setting);
        angle_ = 0, steps_ = 0;
    }
    void change(const live::Setting& setting) override {
        painted_ = setting.choice == 1, rate_ = setting.values.at(0);
        require_positive(rate_, "the wheel's turns a second");
    }
    double time() const override { return static_cast<double>(steps_) * step_size(); }
    double step_size() const override { return 1.0 / 24; }  // of one picture of the film
    double pace() const override { return 0.5; }
    void step() override { angle_ -= 2 * pi * rate_ * step_size(), ++steps_; }
    pic::Drawing drawing(double) const override {
        pic::Drawing drawing;
        drawing.stage({{0, 0, 0}, 1.2}).no_ground();
        add_wheel(drawing, quaternion_about(Vector3::UnitZ(), angle_), {0, 0, 0}, 1, 8,
                  pic::palette::body, painted_);
        return drawing;
    }
    pic::Size size() const override { return {420, 420}; }
    pic::Camera camera(pic::Size size) const override {
        pic::Drawing room;
        room.add(pic::Ball{.radius = 1.06});
        return pic::fit(room, {0.1, 0.1, 1}, size, {.margin = 0.02});
    }
    std::vector<live::Number> numbers() const override {
        const double turn = 2 * pi * rate_ * step_size();
        return {{"wheel", rate_, "turns/s"},
                {"seen", seen_turn(turn, painted_ ? 1 : 8) / step_size() / (2 * pi), "turns/s"}};
    }
    std::vector<double> state() const override { return {angle_, time()}; }

  private:
    bool painted_ = false;
    double rate_ = 2.75, angle_ = 0;
    long steps_ = 0;
};

const live::Entry entry{"wagon", [] { return std::unique_ptr<live::Figure>(new LiveWagon); }};

}  // namespace

}  // namespace nutshell
