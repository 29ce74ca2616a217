// A body that only drag slows, by several methods: its velocity against the steps made, one step a
// second.
#include "../slowing.hpp"
#include <nutshell/forces_methods.hpp>
#include <nutshell/live/run.hpp>
#include <nutshell/sentence.hpp>
#include <nutshell/stability_limits.hpp>
#include <nutshell/stale_drag.hpp>

namespace nutshell {

namespace pic = picture;

namespace {

constexpr std::tuple slowed_by_drag{methods::euler, mistakes::stale_euler, methods::rk4,
                                    methods::implicit_euler, methods::exponential_kick};

class LiveSlowing : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override {
        return live::choices_of(slowed_by_drag);
    }
    std::vector<live::Slider> sliders() const override {
        const double limit = limit_of(chosen_);
        return {{.name = "ν dt",
                 .least = 0.05,
                 .most = 4,
                 .start = 0.5,
                 .logarithmic = false,
                 .mark = limit,
                 .mark_words = "limit " + digits(std::round(1000 * limit) / 1000)}};
    }
    std::vector<live::State> states() const override {
        return {{.key = "small",
                 .words = phrase("{}, ν dt = 0.5", methods::euler),
                 .setting = {0, {0.5}},
                 .time = 10},
                {.key = "turned",
                 .words = "1.5: turned round in every step",
                 .setting = {0, {1.5}},
                 .time = 10,
                 .drawn = true},
                {.key = "faster",
                 .words = "2.5: faster and faster",
                 .setting = {0, {2.5}},
                 .time = 2},
                {.key = "stale",
                 .words = "1.1, drag of the step before",
                 .setting = {1, {1.1}},
                 .time = 10,
                 .drawn = true},
                {.key = "exponential",
                 .words = phrase("{}, 2.5", methods::exponential_kick),
                 .setting = {4, {2.5}},
                 .time = 10}};
    }

    void begin(const live::Setting& setting) override {
        chosen_ = setting.choice;
        scene_ = SlowedByDrag{};
        scene_.drag = setting.values.at(0);
        require_positive(scene_.drag, "nu dt");
        run_ = live::Run<PointMass>(slowed_by_drag, chosen_, scene_);
        speeds_ = {scene_.start.velocity.x()};
    }
    double time() const override { return run_.time; }
    double step_size() const override { return 1; }
    double pace() const override { return 4; }
    void step() override {
        run_.step(1);
        speeds_.push_back(speed());
    }
    std::string ended() const override {
        if (!(std::abs(speed()) < 3))
            return "It flew apart after " + digits(double(run_.steps)) +
                   " steps, made faster and faster by drag.";
        if (run_.steps < 400) return {};
        return "Four hundred steps, and it is still slower than three times its start.";
    }

    pic::Drawing drawing(double part) const override {
        const pic::Colour colour =
            pic::hex(shades_of(choices().at(std::size_t(chosen_)).look.family));
        pic::Drawing drawing;
        drawing.stage({{length / 2 * stretch, 0, 0}, 2.9});
        drawing.no_ground();
        const double now = std::max(0.0, time() - (1 - part) * (run_.steps > 0)),
                     from = std::max(0.0, now - length);  // the paper moves on
        const auto at = [&](double n, double v) { return Vector3(stretch * (n - from), v, 0); };
        drawing.add(pic::Trail{.points = {at(from, 0), at(from + length, 0)},
                               .colour = pic::palette::ink,
                               .width = 1,
                               .opacity = 0.6});
        drawing.add(pic::Label{.at = at(from, 1.75), .text = "velocity"});
        drawing.add(pic::Label{.at = at(from + length - 1.2, -0.3), .text = "steps →"});
        std::vector<Vector3> exact, computed;
        for (int i = 0; i <= 200; ++i) {
            const double n = from + length * i / 200;
            exact.push_back(at(n, scene_.exact_speed(n)));
        }
        drawing.add(pic::Trail{
            .points = exact, .colour = pic::palette::exact, .dashed = true, .width = 3});
        for (std::size_t i = 0; i < speeds_.size(); ++i) {
            const double n = static_cast<double>(i);
            if (n < from || n > now + 1e-9) continue;
            computed.push_back(at(n, speeds_[i]));
            drawing.add(pic::Ball{.centre = computed.back(), .radius = 0.06, .colour = colour});
        }
        if (run_.steps > 0) {
            const double before = speeds_[speeds_.size() - 2];
            computed.push_back(at(now, before + part * (speed() - before)));
        }
        if (computed.size() > 1)
            drawing.add(pic::Trail{.points = computed, .colour = colour, .width = 3});
        drawing.add(pic::Ball{.centre = computed.back(), .radius = 0.1, .colour = colour});
        return drawing;
    }
    pic::Size size() const override { return {480, 400}; }
    pic::Camera camera(pic::Size size) const override {
        pic::Drawing all;
        all.add(pic::Trail{.points = {{-0.15, -1.9, 0}, {stretch * length + 0.15, 2, 0}}});
        return pic::fit(all, {0, 0.05, 1}, size, {.margin = 0.03, .field_of_view = 0.3});
    }
    std::vector<live::Number> numbers() const override {
        using Trace = live::Number::Trace;
        return {{"steps", time(), ""},
                {"velocity over its start", speed(), "", Trace::linear},
                {"exact", scene_.exact_speed(time()), ""}};
    }
    std::vector<double> state() const override {
        return {run_.newest.position.x(), run_.newest.velocity.x()};
    }
    /// exp in one step of the exponential kick, a thousand of them; implicit Euler solves its
    /// equation by a few rounds of the same numbers.
    double page_tolerance() const override { return chosen_ == 4 ? 1e-12 : 0; }

  private:
    static constexpr double length = 10, stretch = 0.46;  // steps that are seen, metres for each

    double speed() const { return run_.newest.velocity.x(); }
    /// The largest nu dt that the method bears; 0: it bears every one.
    static double limit_of(int method) {
        static const double rk4 = general_limit(StabilityFunction::rk4, 0, 1);
        return method == 0 ? euler_limit(0, 1) : method == 1 ? 1 : method == 2 ? rk4 : 0;
    }
    SlowedByDrag scene_;
    live::Run<PointMass> run_;
    std::vector<double> speeds_;
    int chosen_ = 0;
};

const live::Entry entry{"slowing", [] { return std::unique_ptr<live::Figure>(new LiveSlowing); }};

}  // namespace

}  // namespace nutshell
