// A damped spring as a pen on a strip of paper draws it: what drag in the kick costs, and where it breaks.
#include <nutshell/forces_methods.hpp>
#include <nutshell/forces_scenes.hpp>
#include <nutshell/live/run.hpp>
#include <nutshell/sentence.hpp>
#include <nutshell/stability_limits.hpp>

namespace nutshell {

namespace pic = picture;

namespace {

constexpr std::tuple on_a_damped_spring{methods::semi_implicit_euler, methods::verlet,
                                        methods::verlet_re_evaluated, methods::exponential_verlet,
                                        methods::rk4};

class LiveDamped : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override {
        return live::choices_of(on_a_damped_spring);
    }
    std::vector<live::Slider> sliders() const override {
        const double limit = limit_of(chosen_);
        return {{.name = "step dt",
                 .unit = "s",
                 .least = 0.01,
                 .most = 1,
                 .start = 0.125,
                 .mark = limit,
                 .mark_words = "limit " + digits(std::round(1e4 * limit) / 1e4) + " s"},
                {.name = "damping ratio ζ", .least = 0.02, .most = 5, .start = 0.1}};
    }
    std::vector<live::State> states() const override {
        return {{.key = "in_the_kick",
                 .words = "drag in the kick",
                 .setting = {1, {0.125, 0.1}},
                 .time = 3},
                {.key = "exponential",
                 .words = "exponential half-kicks",
                 .setting = {3, {0.125, 0.1}},
                 .time = 3,
                 .drawn = true},
                {.key = "bay",
                 .words = phrase("{} with much drag", methods::verlet),
                 .setting = {2, {0.25, 2}},
                 .time = 3}};
    }

    void begin(const live::Setting& setting) override {
        chosen_ = setting.choice, dt_ = setting.values.at(0);
        require_positive(dt_, "the step dt [s]");
        require_positive(setting.values.at(1), "the damping ratio");
        scene_ = MassOnSpring::with_damping(setting.values.at(1));
        run_ = live::Run<PointMass>(on_a_damped_spring, chosen_, scene_);
        points_ = {scene_.start.position};
        worst_ = 0;
    }
    double time() const override { return run_.time; }
    double step_size() const override { return dt_; }
    double pace() const override { return 0.6; }
    void step() override {
        run_.step(dt_);
        points_.push_back(run_.newest.position + Vector3(0, 0, 0));
        worst_ = std::max(worst_, scene_.error(run_.newest, run_.time));
    }
    std::string ended() const override {
        if (!(std::abs(run_.newest.position.x()) < 4))
            return "It flew apart after " + digits(double(run_.steps)) + " steps.";
        if (time() < length - 1e-9) return {};
        if (scene_.energy(run_.newest) > scene_.energy(scene_.start))
            return "Three periods, and it has more energy than it began with, in spite of the "
                   "drag. It flies apart.";
        return "Three periods; it was never more than " + digits(std::round(1000 * worst_) / 10) +
               " cm off.";
    }

    pic::Drawing drawing(double part) const override {
        const pic::Colour colour =
            pic::hex(shades_of(choices().at(std::size_t(chosen_)).look.family));
        pic::Drawing drawing;
        drawing.stage({{2.4, 0, 0}, 2.8});
        drawing.no_ground();
        const auto at = [](double t, double x) { return Vector3(stretch * t, x, 0); };
        std::vector<Vector3> exact, computed;
        for (int n = 0; n <= 300; ++n)
            exact.push_back(at(length * n / 300, scene_.exact(length * n / 300).position.x()));
        drawing.add(pic::Trail{
            .points = exact, .colour = pic::palette::exact, .dashed = true, .width = 3});
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const double t = static_cast<double>(i) * dt_;
            computed.push_back(at(t, points_[i].x()));
            if (dt_ < 0.04) continue;
            const Vector3 truth = at(t, scene_.exact(t).position.x());
            drawing.add(pic::Ball{.centre = truth,
                                  .radius = 0.07,
                                  .colour = pic::palette::exact,
                                  .look = pic::Look::ghost});
            drawing.add(
                pic::Trail{.points = {truth, computed.back()}, .colour = colour, .width = 1.6});
            if (i + 1 < points_.size())
                drawing.add(
                    pic::Ball{.centre = computed.back(), .radius = 0.07, .colour = colour});
        }
        computed.back() =
            at(time() - (1 - part) * dt_ * (run_.steps > 0), run_.position(part).x());
        if (computed.size() > 1)
            drawing.add(pic::Trail{.points = computed, .colour = colour, .width = 3});
        drawing.add(pic::Ball{.centre = computed.back(), .radius = 0.1, .colour = colour});
        return drawing;
    }
    pic::Size size() const override { return {720, 400}; }
    pic::Camera camera(pic::Size size) const override {
        pic::Drawing all;
        all.add(pic::Trail{.points = {{-0.1, -1.15, 0}, {stretch * length + 0.1, 1.25, 0}}});
        return pic::fit(all, {0, 0.05, 1}, size, {.margin = 0.06, .field_of_view = 0.3});
    }
    std::vector<live::Number> numbers() const override {
        using Trace = live::Number::Trace;
        return {{"time", time(), "s"},
                {"off by", 100 * scene_.error(run_.newest, time()), "cm", Trace::linear},
                {"most so far", 100 * worst_, "cm"},
                {"energy", scene_.energy(run_.newest), "J", Trace::logarithmic}};
    }
    std::vector<double> state() const override {
        return {run_.newest.position.x(), run_.newest.velocity.x()};
    }
    double page_tolerance() const override { return 1e-12; }  // exp in the drag

  private:
    static constexpr double length = 3, stretch = 1.6;  // [s], metres of paper for each second

    /// From theory [s]; 0 where there is no closed form.
    double limit_of(int method) const {
        const double omega = scene_.omega(), rate = scene_.damping_rate();
        if (method == 0) return semi_implicit_limit(omega, rate);
        if (method == 2) return verlet_re_evaluated_limit(omega, rate);
        if (method == 3) return exponential_verlet_limit(omega);
        if (method == 4) return general_limit(StabilityFunction::rk4, omega, rate);
        return 0;
    }
    MassOnSpring scene_ = MassOnSpring::with_damping(0.1);
    live::Run<PointMass> run_;
    std::vector<Vector3> points_;
    int chosen_ = 1;
    double dt_ = 0.125, worst_ = 0;
};

const live::Entry entry{"damped_spring",
                        [] { return std::unique_ptr<live::Figure>(new LiveDamped); }};

}  // namespace

}  // namespace nutshell
