// The throw of chapter 1 at three frame rates at once: as many steps a second as the slider says,
// twice and four times as many. Half the step, half the error.
#include <array>
#include <nutshell/live/run.hpp>
#include <nutshell/newton_methods.hpp>
#include <nutshell/newton_scenes.hpp>
#include <nutshell/sentence.hpp>

namespace nutshell {

namespace pic = picture;

namespace {

class LiveThrow : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override {
        return live::choices_of(newton_methods);
    }
    std::vector<live::Slider> sliders() const override {
        const double enough = euler_step_within(scene_.need.tolerance, gravity, scene_.duration);
        const bool exact = law() == Kicked::half_and_half;
        return {{.name = "steps a second",
                 .least = 4,
                 .most = 500,
                 .start = 4,
                 .mark = exact ? 0 : 1 / enough,
                 .mark_words = "off by one pixel",
                 .whole = true}};
    }
    std::vector<live::State> states() const override {
        return {{.key = methods::euler.key(),
                 .words = methods::euler.name,
                 .setting = {0, {4}},
                 .time = 3},
                {.key = methods::semi_implicit_euler.key(),
                 .words = methods::semi_implicit_euler.name,
                 .setting = {1, {4}},
                 .time = 3},
                {.key = methods::verlet.key(),
                 .words = methods::verlet.name,
                 .setting = {2, {4}},
                 .time = 3},
                {.key = "sixty",
                 .words = phrase("{} at 60 Hz", methods::euler),
                 .setting = {0, {60}},
                 .time = 3}};
    }

    void begin(const live::Setting& setting) override {
        rate_ = std::round(setting.values.at(0)), method_ = setting.choice;
        require_positive(rate_, "steps a second");
        for (std::size_t i = 0; i < runs_.size(); ++i) {
            runs_[i] = live::Run<PointMass>(newton_methods, method_, scene_);
            paths_[i] = {scene_.start.position};
        }
        marks_ = {0};
    }
    double time() const override { return runs_[0].time; }
    double step_size() const override {
        const double left = scene_.duration - time();
        return left > 1e-9 ? std::min(1 / rate_, left) : 1 / rate_;
    }
    void step() override {
        const double dt = step_size();
        for (std::size_t i = 0, parts = 1; i < runs_.size(); ++i, parts *= 2)
            for (std::size_t k = 0; k < parts; ++k) {
                runs_[i].step(dt / static_cast<double>(parts));
                paths_[i].push_back(runs_[i].newest.position);
            }
        // an image at every step, or every quarter of a second
        if (time() > marks_.back() + 0.2499) marks_.push_back(time());
    }
    std::string ended() const override {
        if (time() < scene_.duration - 1e-9) return {};
        const double up = off(0).y();
        if (std::abs(up) < 1e-9)
            return phrase("Three seconds, and no error: {} is exact here.", methods::verlet);
        return "After three seconds it is " + digits(std::round(1000 * std::abs(up)) / 10) +
               " cm too " + (up > 0 ? "high" : "low") + ".";
    }

    pic::Drawing drawing(double part) const override {
        const pic::Colour colour =
            method_ == 0 ? pic::palette::explicit_euler : pic::palette::symplectic;
        pic::Drawing drawing;
        drawing.stage({{15, 5, 0}, 17});
        drawing.ground({.height = -0.45, .spacing = 5});
        std::vector<Vector3> exact;
        for (int n = 0; n <= 100; ++n)
            exact.push_back(scene_.exact(scene_.duration * n / 100).position);
        drawing.add(pic::Trail{
            .points = exact, .colour = pic::palette::exact, .dashed = true, .width = 3});
        for (std::size_t i = runs_.size(); i-- > 0;) {
            std::vector<Vector3> path = paths_[i];
            const Vector3 here = i == 0 ? runs_[i].position(part) : runs_[i].newest.position;
            path.push_back(here);
            drawing.add(pic::Trail{.points = path,
                                   .colour = colour,
                                   .width = i == 0 ? 4.0 : 2.0,
                                   .opacity = i == 0 ? 1 : 0.6});
            drawing.add(pic::Ball{.centre = here,
                                  .radius = i == 0 ? 0.45 : 0.3,
                                  .colour = colour,
                                  .contact_shadow = true});
            if (time() > 0)
                drawing.add(pic::Label{
                    .at = here + Vector3(0.8, 0, 0),
                    .text = digits(rate_ * (1 << i)) + (i == 0 ? " steps a second" : ""),
                    .colour = colour});
        }
        for (const double t : marks_) {
            const auto n = static_cast<std::size_t>(std::lround(t * rate_));
            const Vector3 computed = paths_[0][std::min(n, paths_[0].size() - 1)],
                          truth = scene_.exact(t).position;
            drawing.add(pic::Ball{.centre = truth,
                                  .radius = 0.45,
                                  .colour = pic::palette::exact,
                                  .look = pic::Look::ghost});
            drawing.add(pic::Trail{.points = {truth, computed}, .colour = colour, .width = 1.6});
            drawing.add(pic::Ball{
                .centre = computed, .radius = 0.45, .colour = colour, .contact_shadow = true});
        }
        return drawing;
    }
    pic::Camera camera(pic::Size size) const override {
        pic::Drawing all;
        all.add(pic::Trail{.points = {{0, -3, 0}, {39, -3, 0}, {15, 15.5, 0}}});
        return pic::fit(all, {0.12, 0.18, 1}, size, {.margin = 0.06});
    }
    std::vector<live::Number> numbers() const override {
        using Trace = live::Number::Trace;
        const Vector3 law_says = throw_error(law(), gravity, scene_.duration, 1 / rate_);
        return {{"time", time(), "s"},
                {digits(rate_) + " steps a second: too high by", 100 * off(0).y(), "cm",
                 Trace::linear},
                {digits(2 * rate_) + " steps", 100 * off(1).y(), "cm"},
                {digits(4 * rate_) + " steps", 100 * off(2).y(), "cm"},
                {"predicted for 3 s", 100 * law_says.y(), "cm"}};
    }
    std::vector<double> state() const override {
        std::vector<double> all;
        for (const auto& run : runs_)
            for (const Vector3& v : {run.newest.position, run.newest.velocity})
                all.insert(all.end(), {v.x(), v.y(), v.z()});
        return all;
    }

  private:
    Kicked law() const { return static_cast<Kicked>(method_); }
    Vector3 off(std::size_t i) const {
        return runs_[i].newest.position - scene_.exact(runs_[i].time).position;
    }
    ThrownBall scene_;
    int method_ = 0;
    double rate_ = 4;
    std::array<live::Run<PointMass>, 3> runs_;
    std::array<std::vector<Vector3>, 3> paths_;
    std::vector<double> marks_;
};

const live::Entry entry{"throw", [] { return std::unique_ptr<live::Figure>(new LiveThrow); }};

}  // namespace

}  // namespace nutshell
