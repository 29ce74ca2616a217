// The bouncing ball by each of the ways to bounce, with the exact one as a ghost; time runs to the
// right.
#include <nutshell/bouncing_methods.hpp>
#include <nutshell/live/run.hpp>
#include <nutshell/sentence.hpp>
#include "../drawings.hpp"

namespace nutshell {

namespace {

class LiveBounce : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override {
        return live::choices_of(bouncing_methods);
    }
    std::vector<live::Slider> sliders() const override {
        return {{.name = "steps a second",
                 .unit = "",
                 .least = 10,
                 .most = 1000,
                 .start = 60,
                 .whole = true},
                {.name = "restitution",
                 .unit = "",
                 .least = 0.3,
                 .most = 1,
                 .start = 0.9,
                 .logarithmic = false}};
    }
    std::vector<live::State> states() const override {
        return {{.key = "steps",
                 .words = phrase("{}, 60 steps a second", methods::bounce_steps),
                 .setting = {1, {60, 0.9}},
                 .time = 3},
                {.key = "events",
                 .words = "from impact to impact",
                 .setting = {0, {60, 0.9}},
                 .time = 3},
                {.key = "printed",
                 .words = "the printed floor",
                 .setting = {3, {60, 0.9}},
                 .time = 3},
                {.key = "pushed",
                 .words = phrase("{}, elastic", methods::bounce_pushed),
                 .setting = {2, {60, 1}},
                 .time = 3}};
    }
    void begin(const live::Setting& setting) override {
        setting_ = setting;
        choice_ = setting.choice;
        dt_ = 1 / setting.values.at(0);
        require_positive(dt_, "the step of a second's steps");
        scene_ = BouncingBall{};
        scene_.restitution = checked_restitution(setting.values.at(1));
        body_ = scene_.start, steps_ = 0;
        path_ = {body_.position.y()};
    }
    double time() const override { return static_cast<double>(steps_) * dt_; }
    double step_size() const override { return dt_; }
    void step() override {
        const double t = time();
        if (choice_ == 0) body_ = bounce_by_events(scene_, body_, dt_);
        if (choice_ == 1) body_ = methods::bounce_steps.start(scene_)(body_, scene_, t, dt_);
        if (choice_ == 2) body_ = methods::bounce_pushed.start(scene_)(body_, scene_, t, dt_);
        if (choice_ == 3) body_ = methods::bounce_printed.start(scene_)(body_, scene_, t, dt_);
        ++steps_;
        path_.push_back(body_.position.y());
        if (time() > scene_.duration) begin(setting_);  // it starts again
    }
    pic::Drawing drawing(double) const override {
        pic::Drawing drawing;
        drawing.stage({{1.6, 0.7, 0}, 2}).ground({.height = 0, .spacing = 0.5});
        const double from = std::max(0.0, time() - width);
        pic::Trail exact{.points = {}, .colour = pic::palette::ink, .dashed = true, .width = 3};
        const double shown = time() - from;
        if (shown > 0) {
            for (int i = 0; i <= 300; ++i) {
                const double t = from + shown * i / 300;
                exact.points.push_back({t - from, scene_.exact(t).position.y(), 0});
            }
            drawing.add(exact);
            pic::Trail ours{.points = {}, .colour = colour(), .width = 5};
            for (std::size_t i = 0; i < path_.size(); ++i) {
                const double t = static_cast<double>(i) * dt_;
                if (t >= from) ours.points.push_back({t - from, path_[i], 0.01});
            }
            if (ours.points.size() > 1) drawing.add(ours);
        }
        drawing.add(pic::Ball{.centre = {shown, scene_.exact(time()).position.y(), -0.02},
                              .radius = scene_.ball.radius,
                              .colour = pic::palette::ink,
                              .look = pic::Look::ghost});
        drawing.add(pic::Ball{.centre = {shown, body_.position.y(), 0},
                              .radius = scene_.ball.radius,
                              .colour = colour()});
        return drawing;
    }
    pic::Size size() const override { return {960, 400}; }
    pic::Camera camera(pic::Size size) const override {
        return camera_on({-0.05, 0, 0}, {3.15, 1.2, 0}, {0, 0.12, 1}, size);
    }
    std::vector<live::Number> numbers() const override {
        using Trace = live::Number::Trace;
        const double height = body_.position.y() - scene_.ball.radius;
        const double energy = scene_.g * height + kinetic_energy(body_);
        return {{"height", height, "m"},
                {"off", 100 * scene_.error(body_, time()), "cm", Trace::linear},
                {"energy / start", energy / (scene_.g * scene_.drop()), "", Trace::linear}};
    }
    std::vector<double> state() const override {
        return {body_.position.y(), body_.momentum.y()};
    }

  private:
    static constexpr double width = 3;  // seconds in the picture, a metre each
    pic::Colour colour() const {
        return choice_ == 0   ? pic::palette::exponential
               : choice_ == 1 ? pic::palette::symplectic
               : choice_ == 2 ? pic::palette::runge_kutta
                              : pic::palette::explicit_euler;
    }
    BouncingBall scene_;
    Particle body_;
    std::vector<double> path_;
    double dt_ = 1 / 60.0;
    live::Setting setting_;
    int choice_ = 0;
    long steps_ = 0;
};

const live::Entry entry{"bounce", [] { return std::unique_ptr<live::Figure>(new LiveBounce); }};

}  // namespace

}  // namespace nutshell
