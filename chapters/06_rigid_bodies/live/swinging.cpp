// A heavy rod on a pivot by each method, the exact one as a ghost; the mark is Verlet's limit.
#include <nutshell/live/run.hpp>
#include <nutshell/pendulum_scenes.hpp>
#include <nutshell/rigid_methods.hpp>
#include <nutshell/sentence.hpp>
#include "../lever_drawings.hpp"

namespace nutshell {

namespace {

constexpr std::tuple on_a_pivot{methods::euler, methods::semi_implicit_euler, methods::verlet,
                                methods::yoshida4, methods::lie_rk4};

class LiveSwinging : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override { return live::choices_of(on_a_pivot); }
    std::vector<live::Slider> sliders() const override {
        const double limit = pendulum_verlet_limit(compound_pendulum(1).omega());
        const bool kicked = chosen_ == 1 || chosen_ == 2;  // theory has it for these two
        return {{.name = "step dt",
                 .unit = "s",
                 .least = 0.005,
                 .most = 0.7,
                 .start = 0.05,
                 .mark = kicked ? limit : 0,
                 .mark_words = kicked ? "2/ω = " + digits(std::round(1e4 * limit) / 1e4) +
                                            " s, the limit of small swings"
                                      : ""},
                {.name = "let go at",
                 .unit = "°",
                 .least = 1,
                 .most = 179,
                 .start = 90,
                 .logarithmic = false}};
    }
    std::vector<live::State> states() const override {
        return {{.key = methods::euler.key(),
                 .words = phrase("{}, 20 steps a second", methods::euler),
                 .setting = {0, {0.05, 90}},
                 .time = 1.5},
                {.key = methods::verlet.key(),
                 .words = phrase("{}, 20 steps a second", methods::verlet),
                 .setting = {2, {0.05, 90}},
                 .time = 1.5,
                 .drawn = true},
                {.key = "limit",
                 .words = phrase("{} past its limit", methods::verlet),
                 .setting = {2, {0.527, 2}},
                 .time = 12}};
    }
    void begin(const live::Setting& setting) override {
        chosen_ = setting.choice, dt_ = setting.values.at(0);
        require_positive(dt_, "the step dt [s]");
        const double angle = setting.values.at(1) * pi / 180;
        require(angle > 0 && angle < pi, "let go at: the angle must be between 0 and 180°");
        scene_ = compound_pendulum(angle);
        run_ = live::Run<Pinned>(on_a_pivot, chosen_, scene_);
        path_ = {end_of(scene_.start)};
        most_ = 0;
    }
    double time() const override { return run_.time; }
    double step_size() const override { return dt_; }
    double pace() const override { return 0.5; }
    void step() override {
        run_.step(dt_);
        path_.push_back(end_of(run_.newest));
        if (path_.size() > 120) path_.erase(path_.begin());
        most_ = std::max(most_, scene_.energy(run_.newest));
    }
    std::string ended() const override {
        if (std::isfinite(most_) && most_ < 200) return {};
        return "It flew apart: it has " +
               digits(std::round(most_ / scene_.energy(scene_.start))) +
               " times the energy it began with.";
    }
    pic::Drawing drawing(double) const override {
        pic::Drawing drawing;
        drawing.stage({{0, 0, 0}, 1.3}).no_ground();
        add_nail(drawing, {0, 0, 0});
        add_heavy_rod(drawing, {0, 0, -0.05}, scene_.exact(time()).orientation, 1,
                      pic::palette::ink, pic::Look::ghost);
        if (path_.size() > 1)
            drawing.add(pic::Trail{
                .points = path_, .colour = colour(), .width = 3, .opacity_at_start = 0});
        for (const Vector3& place : path_)
            drawing.add(pic::Ball{.centre = place, .radius = 0.014, .colour = colour()});
        add_heavy_rod(drawing, {0, 0, 0}, run_.newest.orientation, 1, colour());
        return drawing;
    }
    pic::Size size() const override { return {420, 420}; }
    pic::Camera camera(pic::Size size) const override {
        pic::Drawing room;
        room.add(pic::Ball{.radius = 1.08});
        return pic::fit(room, {0.1, 0.05, 1}, size, {.margin = 0.02});
    }
    std::vector<live::Number> numbers() const override {
        using Trace = live::Number::Trace;
        return {{"off", 180 / pi * scene_.error(run_.newest, time()), "°", Trace::linear},
                {"energy over its start",
                 scene_.energy(run_.newest) / scene_.energy(scene_.start), "", Trace::linear}};
    }
    std::vector<double> state() const override {
        const Pinned& body = run_.newest;
        return {body.orientation.z(), body.orientation.w(), body.angular_momentum.z()};
    }
    /// The start is a sine and a cosine; beyond the limit their last digit grows with the swing.
    /// Yoshida's limit of small swings is 1.5734/ω: far beyond it the rod tumbles, each digit is
    /// lost, and there is nothing to compare.
    double page_tolerance() const override {
        return chosen_ == 3 && dt_ * compound_pendulum(1).omega() > 1.5734 ? 10 : 1e-8;
    }

  private:
    static Vector3 end_of(const Pinned& body) {
        return rotate(body.orientation, Vector3(0, -1, 0));
    }
    pic::Colour colour() const {
        return pic::hex(shades_of(choices().at(std::size_t(chosen_)).look.family));
    }
    Pendulum scene_ = compound_pendulum(1);
    live::Run<Pinned> run_;
    std::vector<Vector3> path_;
    int chosen_ = 0;
    double dt_ = 0.05, most_ = 0;
};

const live::Entry entry{"swinging",
                        [] { return std::unique_ptr<live::Figure>(new LiveSwinging); }};

}  // namespace

}  // namespace nutshell
