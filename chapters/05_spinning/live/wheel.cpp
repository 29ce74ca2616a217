// A wheel at a steady speed, by each method, with the exact one as a ghost behind it.
#include <nutshell/live/run.hpp>
#include <nutshell/sentence.hpp>
#include <nutshell/spinning_methods.hpp>
#include "../drawings.hpp"

namespace nutshell {

namespace {

class LiveWheel : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override {
        return {{"printed",
                 "as printed, rows put right",
                 {Family::explicit_one_step, Mark::triangle_down}},
                live::choice_of(methods::first_order_unit),
                live::choice_of(methods::exponential_map),
                live::choice_of(methods::rk4_pose)};
    }
    std::vector<live::Slider> sliders() const override {
        return {{.name = "turn in one step", .unit = "°", .least = 1, .most = 360, .start = 12}};
    }
    std::vector<live::State> states() const override {
        return {{.key = "first_order",
                 .words = "first order, 120° a step",
                 .setting = {1, {120}},
                 .time = 0.1,
                 .instants = {0, 1.0 / 60, 2.0 / 60, 3.0 / 60, 4.0 / 60, 5.0 / 60}},
                {.key = methods::exponential_map.key(),
                 .words = phrase("{}, 120° a step", methods::exponential_map),
                 .setting = {2, {120}},
                 .time = 0.1},
                {.key = "growing",
                 .words = "as printed, 12° a step",
                 .setting = {0, {12}},
                 .time = 1},
                {.key = methods::rk4_pose.key(),
                 .words = phrase("{} beyond its limit", methods::rk4_pose),
                 .setting = {3, {330}},
                 .time = 0.2}};
    }
    void begin(const live::Setting& setting) override {
        choice_ = setting.choice;
        scene_ = SpinningWheel{};
        scene_.rate = setting.values.at(0) * pi / 180 * 60;  // steps of 1/60 s
        require_positive(scene_.rate, "turn in one step");
        q_ = scene_.start, steps_ = 0;
    }
    double time() const override { return static_cast<double>(steps_) * step_size(); }
    double step_size() const override { return 1.0 / 60; }
    double pace() const override { return std::min(0.5, 2 * pi / scene_.rate); }
    void step() override {
        const double t = time(), dt = step_size();
        q_ = choice_ == 0   ? first_order(q_, scene_, t, dt)
             : choice_ == 1 ? first_order_unit(q_, scene_, t, dt)
             : choice_ == 2 ? exponential_map(q_, scene_, t, dt)
                            : rk4_pose(q_, scene_, t, dt);
        ++steps_;
    }
    std::string ended() const override {
        if (q_.norm() < 3) return {};
        return "The 4-vector is three times too long: its matrix is no rotation any more.";
    }
    pic::Drawing drawing(double) const override {
        pic::Drawing drawing;
        drawing.stage({{0, 0, 0}, 1.35}).no_ground();
        const Vector3 behind(0, 0,
                             -0.12);  // the true wheel: its rim pale, its painted spoke black
        add_wheel(drawing, scene_.exact(time()), behind, 1, 0, pic::palette::ink, false,
                  pic::Look::ghost);
        drawing.add(pic::Rod{.from = behind,
                             .to = behind + rotate(scene_.exact(time()), Vector3::UnitY()),
                             .radius = 0.03,
                             .colour = pic::palette::ink});
        const double size = std::min(2.0, q_.squaredNorm());
        add_wheel(drawing, q_.normalized(), {0, 0, 0}, size, 8, colour(), true);
        return drawing;
    }
    pic::Size size() const override { return {420, 420}; }
    pic::Camera camera(pic::Size size) const override {
        pic::Drawing room;
        room.add(pic::Ball{.radius = 1.1});
        return pic::fit(room, {0.25, 0.15, 1}, size, {.margin = 0.02});
    }
    std::vector<live::Number> numbers() const override {
        using Trace = live::Number::Trace;
        return {{"turns", scene_.rate * time() / (2 * pi), ""},
                {"off", 180 / pi * scene_.error(q_, time()), "°", Trace::linear},
                {"length of the 4-vector", q_.norm(), "", Trace::linear}};
    }
    std::vector<double> state() const override { return {q_.x(), q_.y(), q_.z(), q_.w()}; }

  private:
    pic::Colour colour() const {
        return choice_ < 2    ? pic::palette::explicit_euler
               : choice_ == 2 ? pic::palette::exponential
                              : pic::palette::runge_kutta;
    }
    SpinningWheel scene_;
    Quaternion q_ = four_vector({0, 0, 0}, 1);
    int choice_ = 1;
    long steps_ = 0;
};

const live::Entry entry{"wheel", [] { return std::unique_ptr<live::Figure>(new LiveWheel); }};

}  // namespace

}  // namespace nutshell
