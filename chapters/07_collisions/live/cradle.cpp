// Newton's cradle: impacts one after another, and all at once.
#include <nutshell/impact_scenes.hpp>
#include <nutshell/impacts_at_once.hpp>
#include <nutshell/live/figure.hpp>
#include "../drawings.hpp"

namespace nutshell {

namespace {

/// Five balls on strings. Each swings like a spring (small swings): its angle and rate turn by
/// omega dt in each step, exactly; in 16 steps from the top to the bottom.
class LiveCradle : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override {
        return {{"one", "one after another", {Family::symplectic, Mark::square}},
                {"once", "all at once", {Family::explicit_one_step, Mark::circle}}};
    }
    std::vector<live::Slider> sliders() const override {
        return {{.name = "balls that come in",
                 .unit = "",
                 .least = 1,
                 .most = 4,
                 .start = 1,
                 .logarithmic = false,
                 .whole = true},
                {.name = "restitution",
                 .unit = "",
                 .least = 0.5,
                 .most = 1,
                 .start = 1,
                 .logarithmic = false}};
    }
    std::vector<live::State> states() const override {
        return {{.key = "one",
                 .words = "one after another",
                 .setting = {0, {1, 1}},
                 .time = 32 * step_size()},
                {.key = "once",
                 .words = "all at once",
                 .setting = {1, {1, 1}},
                 .time = 32 * step_size(),
                 .drawn = true}};
    }
    void begin(const live::Setting& setting) override {
        choice_ = setting.choice;
        restitution_ = checked_restitution(setting.values.at(1));
        const auto in = std::lround(setting.values.at(0));
        all_.assign(balls, Particle{});
        for (std::size_t i = 0; i < balls && i < static_cast<std::size_t>(in); ++i)
            all_[i].position.x() = -0.6;
        steps_ = 0, impacts_ = 0;
    }
    double time() const override { return static_cast<double>(steps_) * step_size(); }
    double step_size() const override { return 2 * pi / omega / 64; }
    void step() override {
        const double c = std::cos(2 * pi / 64), s = std::sin(2 * pi / 64);
        for (Particle& ball : all_) {  // position: the angle; momentum: its rate over omega
            double &x = ball.position.x(), &v = ball.momentum.x();
            const double turned = c * x + s * v;
            v = c * v - s * x, x = turned;
        }
        ++steps_;
        meet();
    }
    pic::Drawing drawing(double) const override {
        pic::Drawing drawing;
        drawing.stage({{0, 0.5, 0}, 1}).ground({.height = 0, .spacing = 0.5});
        const double top = 1.15;
        drawing.add(pic::Rod{.from = {-0.55, top, 0}, .to = {0.55, top, 0}, .radius = 0.015});
        for (std::size_t i = 0; i < balls; ++i) {
            const double angle = all_[i].position.x();
            const Vector3 pivot((static_cast<double>(i) - 2) * 2 * radius, top, 0);
            const Vector3 centre = pivot + length * Vector3(std::sin(angle), -std::cos(angle), 0);
            drawing.add(pic::Rod{.from = pivot, .to = centre, .radius = 0.006});
            drawing.add(pic::Ball{.centre = centre, .radius = radius, .colour = colour()});
        }
        return drawing;
    }
    pic::Size size() const override { return {600, 400}; }
    pic::Camera camera(pic::Size size) const override {
        return camera_on({-1, 0, 0}, {1, 1.2, 0}, {0, 0.1, 1}, size);
    }
    std::vector<live::Number> numbers() const override {
        using Trace = live::Number::Trace;
        const double degrees = 180 / pi;
        double energy = 0;
        for (const Particle& ball : all_)
            energy += (ball.position.squaredNorm() + ball.momentum.squaredNorm()) / 2;
        return {{"first ball", degrees * all_.front().position.x(), "°", Trace::linear},
                {"last ball", degrees * all_.back().position.x(), "°", Trace::linear},
                {"impacts", static_cast<double>(impacts_), ""},
                {"energy", energy, ""}};
    }
    std::vector<double> state() const override {
        std::vector<double> all;
        for (const Particle& ball : all_)
            all.push_back(ball.position.x()), all.push_back(ball.momentum.x());
        return all;
    }
    double page_tolerance() const override { return 1e-11; }  // sin and cos of the step

  private:
    static constexpr std::size_t balls = 5;
    static constexpr double radius = 0.09, length = 0.95;
    static constexpr double omega = 3.2;    // [1/s], of strings of about a metre
    static constexpr double touch = 1e-9;   // angles this near are one: round-off of the swing
    static constexpr double still = 1e-12;  // speeds of closing in below this are none

    void meet() {
        std::vector<Touch> touches;
        bool closing = false;
        for (std::size_t i = 0; i + 1 < balls; ++i) {
            if (all_[i].position.x() < all_[i + 1].position.x() - touch) continue;
            touches.push_back({i, i + 1, {1, 0, 0}});
            closing = closing || separating_speed(all_[i], all_[i + 1], {1, 0, 0}) < -1e-9;
        }
        if (!closing) return;
        if (choice_ == 0) {
            impacts_ += collide_one_after_another(all_, touches, restitution_, still);
        } else {
            collide_at_once(all_, touches, restitution_);
            impacts_ += static_cast<long>(touches.size());
        }
    }
    pic::Colour colour() const {
        return choice_ == 0 ? pic::palette::symplectic : pic::palette::explicit_euler;
    }
    std::vector<Particle> all_ = std::vector<Particle>(balls);
    double restitution_ = 1;
    int choice_ = 0;
    long steps_ = 0, impacts_ = 0;
};

const live::Entry entry{"cradle", [] { return std::unique_ptr<live::Figure>(new LiveCradle); }};

}  // namespace

}  // namespace nutshell
