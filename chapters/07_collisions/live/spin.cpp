// A ball with back-spin meets the floor: friction and the two laws of restitution.
#include <nutshell/live/figure.hpp>
#include <nutshell/spin_scenes.hpp>
#include "../drawings.hpp"

namespace nutshell {

namespace {

class LiveSpin : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override {
        return {{"clamped", laws::clamped.name, laws::clamped.look},
                {"echo", laws::echo.name, laws::echo.look}};
    }
    std::vector<live::Slider> sliders() const override {
        return {{.name = "friction μ",
                 .unit = "",
                 .least = 0,
                 .most = 1,
                 .start = 0.8,
                 .logarithmic = false},
                {.name = "back-spin",
                 .unit = "rad/s",
                 .least = -80,
                 .most = 80,
                 .start = 20,
                 .logarithmic = false},
                {.name = "restitution",
                 .unit = "",
                 .least = 0,
                 .most = 1,
                 .start = 0.5,
                 .logarithmic = false}};
    }
    std::vector<live::State> states() const override {
        return {{.key = "sticks",
                 .words = "sticks: it ends up rolling",
                 .setting = {0, {0.8, 20, 0.5}},
                 .time = 0.5},
                {.key = "rubber",
                 .words = "hard rubber: the contact moves back",
                 .setting = {1, {0.8, 20, 0.5}},
                 .time = 0.5},
                {.key = "slides", .words = "slides", .setting = {0, {0.2, 20, 0.5}}, .time = 0.5},
                {.key = "smooth", .words = "smooth", .setting = {0, {0, 20, 0.5}}, .time = 0.5}};
    }
    void begin(const live::Setting& setting) override {
        setting_ = setting;
        scene_ = SpinningBall(setting.values.at(0));
        scene_.spin.z() = setting.values.at(1);
        scene_.surface.restitution = setting.values.at(2);
        scene_.surface = checked(scene_.surface);
        body_ = scene_.ball();
        nutshell::drift(body_, -impact);
        steps_ = 0, seen_.clear();
        see();
    }
    double time() const override { return static_cast<double>(steps_) * step_size(); }
    double step_size() const override { return 1 / 256.0; }
    double pace() const override { return 0.25; }
    void step() override {
        ++steps_;
        nutshell::drift(body_, step_size());
        if (time() == impact) {
            Body floor = immovable_body();
            collide(floor, body_, scene_.contact(), scene_.surface,
                    setting_.choice == 0 ? laws::clamped : laws::echo);
        }
        if (steps_ % 16 == 0) see();
        if (time() > 0.75) begin(setting_);
    }
    pic::Drawing drawing(double) const override {
        pic::Drawing drawing;
        drawing.stage({{0.3, 0.4, 0}, 1.1}).ground({.height = 0, .spacing = 0.2});
        pic::Trail path{.points = {}, .colour = pic::palette::ink, .width = 2};
        for (const Body& was : seen_) path.points.push_back(was.position + Vector3(0, 0, -0.1));
        if (path.points.size() > 1) drawing.add(path);
        for (const Body& was : seen_) drawing.add(marked(was));
        drawing.add(marked(body_));
        drawing.add(pic::Arrow{.from = body_.position + Vector3(0, 0, scene_.radius),
                               .vector = 0.08 * velocity(body_),
                               .colour = pic::palette::velocity,
                               .label = "v"});
        return drawing;
    }
    pic::Size size() const override { return {960, 440}; }
    pic::Camera camera(pic::Size size) const override {
        return camera_on({-0.85, 0, 0}, {1.15, 1, 0}, {0, 0.2, 1}, size);
    }
    std::vector<live::Number> numbers() const override {
        const Body floor = immovable_body();
        Contact under = scene_.contact();
        under.point = body_.position - Vector3(0, scene_.radius, 0);
        return {{"speed along the floor", velocity(body_).x(), "m/s"},
                {"spin", angular_velocity(body_).z(), "rad/s"},
                {"lowest point", contact_velocity(floor, body_, under).x(), "m/s"},
                {"energy / start", kinetic_energy(body_) / kinetic_energy(scene_.ball()), ""}};
    }
    std::vector<double> state() const override {
        const Quaternion& q = body_.orientation;
        return {body_.position.x(),
                body_.position.y(),
                body_.momentum.x(),
                body_.momentum.y(),
                body_.angular_momentum.z(),
                q.z(),
                q.w()};
    }
    double page_tolerance() const override { return 1e-12; }  // sin and cos of its turns

  private:
    static constexpr double impact = 0.1875;  // [s], a whole number of steps

    void see() { seen_.push_back(body_); }
    pic::Ball marked(const Body& body) const {
        return {.centre = body.position,
                .radius = scene_.radius,
                .colour = setting_.choice == 0 ? pic::palette::explicit_euler
                                               : pic::palette::symplectic,
                .orientation = body.orientation,
                .contact_shadow = true};
    }
    SpinningBall scene_;
    Body body_;
    std::vector<Body> seen_;
    live::Setting setting_{0, {0.8, 20, 0.5}};
    long steps_ = 0;
};

const live::Entry entry{"spin", [] { return std::unique_ptr<live::Figure>(new LiveSpin); }};

}  // namespace

}  // namespace nutshell
