// A handle that nobody touches, spun about its middle axis: L stands still, omega does not, and
// after four seconds it turns over.
#include <nutshell/live/run.hpp>
#include <nutshell/rigid_methods.hpp>
#include "../top_drawings.hpp"

namespace nutshell {

namespace {

constexpr std::tuple that_turn_it{
    methods::kick_magnus_kick, methods::kick_split_kick, methods::printed_step,
    methods::corrected_step,   methods::engine_step,     methods::engine_step_without_gyroscopic};

class LiveFlip : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override { return live::choices_of(that_turn_it); }
    std::vector<live::Slider> sliders() const override {
        return {{.name = "steps a second", .least = 5, .most = 240, .start = 60, .whole = true}};
    }
    std::vector<live::State> states() const override {
        return {{.key = "truth",
                 .words = "Magnus' step, over the first flip",
                 .setting = {0, {60}},
                 .time = 5,
                 .instants = {0, 3.4, 4.05, 4.7, 7.5}},
                {.key = "printed", .words = "as printed", .setting = {2, {60}}, .time = 5},
                {.key = "corrected",
                 .words = "with a constant ω in each step",
                 .setting = {3, {60}},
                 .time = 8},
                {.key = "missing",
                 .words = "without the gyroscopic term",
                 .setting = {5, {60}},
                 .time = 5},
                {.key = "split", .words = "split turns", .setting = {1, {20}}, .time = 8}};
    }
    void begin(const live::Setting& setting) override {
        choice_ = setting.choice;
        rate_ = std::round(setting.values.at(0));
        require_positive(rate_, "steps a second");
        run_ = live::Run<Pinned>(that_turn_it, choice_, scene_);
        trail_ = {shown_omega()};
    }
    double time() const override { return run_.time; }
    double step_size() const override { return 1 / rate_; }
    void step() override {
        run_.step(step_size());
        trail_.push_back(shown_omega());
        if (trail_.size() > 3000) trail_.erase(trail_.begin(), trail_.begin() + 1000);
    }
    std::string ended() const override {
        if (scene_.energy(run_.newest) < 100 * scene_.energy(scene_.start)) return {};
        return "It has a hundred times the energy it began with.";
    }
    pic::Drawing drawing(double part) const override {
        pic::Drawing drawing;
        drawing.stage({{0, 0.1, 0}, 1.7}).no_ground();
        const Quaternion exact = scene_.solution.pose(time());
        if (angle_between(exact, run_.newest.orientation) > 0.02)
            add_handle(drawing, exact, {0, 0, 0}, pic::palette::ink, pic::Look::ghost);
        const Quaternion q = slerp(run_.previous.orientation, run_.newest.orientation, part);
        add_handle(drawing, q, {0, 0, 0}, pic::palette::body);
        if (trail_.size() > 1)
            drawing.add(pic::Trail{.points = trail_,
                                   .colour = pic::palette::angular_velocity,
                                   .width = 3,
                                   .opacity_at_start = 0});
        drawing.add(pic::Arrow{.from = {0, 0, 0},
                               .vector = run_.newest.angular_momentum * 0.36,
                               .colour = pic::palette::angular_momentum,
                               .label = "L",
                               .width = 10});
        drawing.add(pic::Arrow{.from = {0, 0, 0},
                               .vector = shown_omega(),
                               .colour = pic::palette::angular_velocity,
                               .label = "ω",
                               .width = 8});
        return drawing;
    }
    pic::Size size() const override { return {340, 420}; }
    pic::Camera camera(pic::Size size) const override {
        pic::Drawing room;
        room.add(pic::Ball{.centre = {0, 0.33, 0}, .radius = 1.24});
        return pic::fit(room, {0.5, 0.25, 1}, size, {.margin = 0.01});
    }
    std::vector<live::Number> numbers() const override {
        using Trace = live::Number::Trace;
        const Vector3 &L = run_.newest.angular_momentum, &L0 = scene_.start.angular_momentum;
        return {{"spin about the middle axis",
                 rotate(inverse(run_.newest.orientation), angular_velocity(run_.newest)).y(),
                 "rad/s", Trace::linear},
                {"off", 180 / pi * scene_.error(run_.newest, time()), "°", Trace::linear},
                {"energy over its start",
                 scene_.energy(run_.newest) / scene_.energy(scene_.start), ""},
                {"L has changed by", (L - L0).norm() / L0.norm() * 100, "%"}};
    }
    std::vector<double> state() const override {
        const Pinned& b = run_.newest;
        return {b.orientation.x(),     b.orientation.y(),      b.orientation.z(),
                b.orientation.w(),     b.angular_momentum.x(), b.angular_momentum.y(),
                b.angular_momentum.z()};
    }
    /// sin and cos in every step of all but Magnus', and a motion that doubles their last digit
    /// again and again.
    double page_tolerance() const override { return 1e-8; }

  private:
    /// What the method itself takes for omega, drawn at 0.6 m for a radian a second.
    Vector3 shown_omega() const {
        const Pinned& b = run_.newest;
        const bool printed = choice_ == 2;
        return 0.6 * (printed ? Vector3(b.angular_momentum.cwiseQuotient(b.inertia))
                              : angular_velocity(b));
    }
    FreeBody scene_ = flip();
    live::Run<Pinned> run_{that_turn_it, 0, scene_};
    int choice_ = 0;
    double rate_ = 60;
    std::vector<Vector3> trail_;
};

const live::Entry entry{"flip", [] { return std::unique_ptr<live::Figure>(new LiveFlip); }};

}  // namespace

}  // namespace nutshell
