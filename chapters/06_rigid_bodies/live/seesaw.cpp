// A seesaw with a child and a grown-up, whose seat is in the reader's hand: weights, arms,
// torque.
#include <nutshell/lever_scenes.hpp>
#include <nutshell/live/figure.hpp>
#include "../lever_drawings.hpp"

namespace nutshell {

namespace {

class LiveSeesaw : public live::Figure {
  public:
    std::vector<live::Slider> sliders() const override {
        const double balance = 25 * 1.8 / mass_;
        return {{.name = "the grown-up sits at",
                 .unit = "m",
                 .least = 0.2,
                 .most = 1.9,
                 .start = 0.5,
                 .logarithmic = false,
                 .mark = balance,
                 .mark_words = "balance at " + digits(balance) + " m"},
                {.name = "and weighs",
                 .unit = "kg",
                 .least = 30,
                 .most = 150,
                 .start = 75,
                 .logarithmic = false}};
    }
    std::vector<live::State> states() const override {
        return {{.key = "near", .words = "sits at 0.5 m", .setting = {0, {0.5, 75}}, .time = 0.7},
                {.key = "balance",
                 .words = "sits at 0.6 m",
                 .setting = {0, {0.6, 75}},
                 .time = 0.7,
                 .drawn = true},
                {.key = "far", .words = "sits at 1 m", .setting = {0, {1, 75}}, .time = 0.35}};
    }
    void begin(const live::Setting& setting) override {
        place_ = setting.values.at(0), mass_ = setting.values.at(1);
        require_positive(mass_, "the grown-up's mass [kg]");
        scene_ = Lever{"seesaw", 20, -2, 2, {{25, -1.8}, {mass_, place_}}, 0.5};
        body_ = scene_.start, steps_ = 0;
    }
    double time() const override { return static_cast<double>(steps_) * step_size(); }
    double step_size() const override { return 1.0 / 256; }
    double pace() const override { return 0.5; }
    void step() override {
        if (down()) return begin({0, {place_, mass_}});  // it starts again
        body_ = verlet(body_, scene_, time(), step_size());
        ++steps_;
    }
    pic::Drawing drawing(double) const override {
        pic::Drawing drawing;
        drawing.stage({{0, -0.1, 0}, 2.4}).ground({.height = -scene_.height, .spacing = 0.5});
        const auto at = [&](double along, double above) {
            return rotate(body_.orientation, Vector3(along, above, 0));
        };
        const auto box = [&](const Vector3& centre, const Vector3& half, pic::Colour colour) {
            pic::Box thing;
            thing.pose.translation() = centre;
            thing.pose.linear() = rotation_matrix(body_.orientation);
            thing.half_extents = half, thing.colour = colour;
            drawing.add(thing);
        };
        box({0, 0, 0}, {2, 0.03, 0.16}, pic::palette::gold);
        drawing.add(
            pic::Rod{.from = {0, -scene_.height, 0}, .to = {0, -0.03, 0}, .radius = 0.06});
        for (std::size_t i = 0; i < 2; ++i) {
            const Load& load = scene_.loads[i];
            const double size = 0.11 * std::cbrt(load.mass / 25);  // alike in shape
            box(at(load.place, 0.03 + size), Vector3::Constant(size), pic::palette::body);
            drawing.add(pic::Arrow{.from = at(load.place, 0) + Vector3(0, 0, 0.3),
                                   .vector = {0, -0.0007 * load.mass * -gravity.y(), 0},
                                   .colour = pic::palette::force,
                                   .label = digits(std::round(load.mass * -gravity.y())) + " N"});
        }
        return drawing;
    }
    pic::Size size() const override { return {640, 320}; }
    pic::Camera camera(pic::Size size) const override {
        pic::Drawing room;
        room.add(pic::Trail{.points = {{-2.1, -0.6, 0}, {2.1, 0.75, 0}}});
        return pic::fit(room, {0, 0.22, 1}, size, {.margin = 0.02});
    }
    std::vector<live::Number> numbers() const override {
        const double g = gravity.y();
        const double left = scene_.loads[0].mass * g * scene_.loads[0].place * cosine(),
                     right = scene_.loads[1].mass * g * scene_.loads[1].place * cosine();
        return {{"child's torque", left, "N m"},
                {"grown-up's torque", right, "N m"},
                {"inertia", scene_.start.inertia.z(), "kg m²"},
                {"tilt", 180 / pi * scene_.tilt(body_), "°", live::Number::Trace::linear}};
    }
    std::vector<double> state() const override {
        return {body_.orientation.z(), body_.orientation.w(), body_.angular_momentum.z()};
    }
    double page_tolerance() const override { return 1e-12; }  // sine and cosine in its tilt

  private:
    double cosine() const { return std::cos(scene_.tilt(body_)); }
    bool down() const {
        return scene_.imbalance() != 0 &&
               std::abs(scene_.tilt(body_)) >= std::abs(scene_.tilt_of_touch());
    }
    Lever scene_ = seesaw();
    Pinned body_;
    double place_ = 0.5, mass_ = 75;
    long steps_ = 0;
};

const live::Entry entry{"seesaw", [] { return std::unique_ptr<live::Figure>(new LiveSeesaw); }};

}  // namespace

}  // namespace nutshell
