// Coning by each method: the tip of the body's x axis and a point beside it, the exact body as a
// ghost.
#include <nutshell/live/run.hpp>
#include <nutshell/sentence.hpp>
#include <nutshell/spinning_methods.hpp>
#include "../drawings.hpp"

namespace nutshell {

namespace {

constexpr std::tuple that_follow_it{methods::exponential_map, methods::exponential_midpoint,
                                    methods::magnus4, methods::rk4_pose};

class LiveCone : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override {
        return live::choices_of(that_follow_it);
    }
    std::vector<live::Slider> sliders() const override {
        return {{.name = "steps a round", .least = 6, .most = 500, .start = 24, .whole = true}};
    }
    std::vector<live::State> states() const override {
        return {{.key = methods::exponential_map.key(),
                 .words = phrase("{}, 24 steps: off", methods::exponential_map),
                 .setting = {0, {24}},
                 .time = 2},
                {.key = "midpoint",
                 .words = "midpoint, 24 steps: hardly off",
                 .setting = {1, {24}},
                 .time = 2,
                 .drawn = true},
                {.key = "magnus",
                 .words = phrase("{}, 24 steps: on the path", methods::magnus4),
                 .setting = {2, {24}},
                 .time = 2,
                 .drawn = true}};
    }
    void begin(const live::Setting& setting) override {
        choice_ = setting.choice;
        steps_a_round_ = std::round(setting.values.at(0));
        require_positive(steps_a_round_, "steps a round");
        q_ = scene_.start, steps_ = 0, worst_ = 0;
        trail_ = {fin(q_)};
    }
    double time() const override { return static_cast<double>(steps_) * step_size(); }
    double step_size() const override { return scene_.duration / steps_a_round_; }
    double pace() const override { return 0.4; }
    void step() override {
        const double t = time(), dt = step_size();
        q_ = choice_ == 0   ? exponential_map(q_, scene_, t, dt)
             : choice_ == 1 ? exponential_midpoint(q_, scene_, t, dt)
             : choice_ == 2 ? magnus4(q_, scene_, t, dt)
                            : rk4_pose(q_, scene_, t, dt);
        ++steps_;
        worst_ = std::max(worst_, scene_.error(q_, time()));
        trail_.push_back(fin(q_));
        if (trail_.size() > 2000) trail_.erase(trail_.begin(), trail_.begin() + 500);
    }
    pic::Drawing drawing(double) const override {
        pic::Drawing drawing;
        drawing.stage({{0, 0, 0}, 1.35}).no_ground();
        pic::Trail exact{.points = {}, .colour = pic::palette::ink, .dashed = true, .width = 2.5};
        for (int i = 0; i <= 200; ++i)
            exact.points.push_back(fin(scene_.exact(scene_.duration * i / 200)));
        drawing.add(exact);
        if (trail_.size() > 1)
            drawing.add(pic::Trail{.points = trail_, .colour = colour(), .width = 4});
        add_body(drawing, scene_.exact(time()), pic::palette::steel, pic::Look::ghost);
        add_body(drawing, q_, colour(), pic::Look::solid);
        return drawing;
    }
    pic::Size size() const override { return {420, 420}; }
    pic::Camera camera(pic::Size size) const override {
        pic::Drawing room;
        room.add(pic::Ball{.radius = 1.15});
        return pic::fit(room, {0.7, -1, 0.8}, size, {.margin = 0.02, .up = Vector3::UnitZ()});
    }
    std::vector<live::Number> numbers() const override {
        return {{"off", 180 / pi * scene_.error(q_, time()), "°", live::Number::Trace::linear},
                {"at most so far", 180 / pi * worst_, "°"}};
    }
    std::vector<double> state() const override { return {q_.x(), q_.y(), q_.z(), q_.w()}; }

  private:
    /// The tip of a fin: out on the body's x and a little aside, so that its own spin shows.
    static Vector3 fin(const Quaternion& q) { return rotate(q, Vector3(0.9, 0.45, 0)); }
    static void add_body(pic::Drawing& drawing, const Quaternion& q, pic::Colour colour,
                         pic::Look look) {
        const Vector3 nose = rotate(q, Vector3(1.05, 0, 0));
        drawing.add(pic::Rod{
            .from = {0, 0, 0}, .to = nose, .radius = 0.06, .colour = colour, .look = look});
        drawing.add(pic::Rod{.from = rotate(q, Vector3(0.9, 0, 0)),
                             .to = fin(q),
                             .radius = 0.04,
                             .colour = colour,
                             .look = look});
        drawing.add(pic::Ball{.centre = fin(q), .radius = 0.07, .colour = colour, .look = look});
    }
    double page_tolerance() const override {
        return 1e-12;
    }  // sin and cos in every step, a thousand of them
    pic::Colour colour() const {
        return choice_ == 3 ? pic::palette::runge_kutta : pic::palette::exponential;
    }
    Coning scene_;
    Quaternion q_ = four_vector({0, 0, 0}, 1);
    int choice_ = 0;
    double steps_a_round_ = 24, worst_ = 0;  // worst_ [rad]
    long steps_ = 0;
    std::vector<Vector3> trail_;
};

const live::Entry entry{"cone", [] { return std::unique_ptr<live::Figure>(new LiveCone); }};

}  // namespace

}  // namespace nutshell
