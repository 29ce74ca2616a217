// A rolling wheel, with the velocity of its points and the path of one of them; turned by first
// order it slips.
#include <nutshell/live/run.hpp>
#include <nutshell/sentence.hpp>
#include <nutshell/spinning_methods.hpp>
#include "../drawings.hpp"

namespace nutshell {

namespace {

class LiveRolling : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override {
        return live::choices_of(std::tuple{methods::exponential_map, methods::first_order_unit});
    }
    std::vector<live::Slider> sliders() const override {
        return {
            {.name = "steps in a turn", .least = 4, .most = 256, .start = 128, .whole = true}};
    }
    std::vector<live::State> states() const override {
        return {{.key = "rolling",
                 .words = phrase("{}, 128 steps a turn", methods::exponential_map),
                 .setting = {0, {128}},
                 .time = 1.7},
                {.key = "slipping",
                 .words = "first order, 8 steps a turn",
                 .setting = {1, {8}},
                 .time = 4}};
    }
    void begin(const live::Setting& setting) override {
        setting_ = setting;
        steps_a_turn_ = std::round(setting.values.at(0));
        require_positive(steps_a_turn_, "steps in a turn");
        q_ = scene_.start, steps_ = 0;
        path_ = {painted()};
    }
    double time() const override { return static_cast<double>(steps_) * step_size(); }
    double step_size() const override {
        return 2 * pi * scene_.radius / scene_.speed / steps_a_turn_;
    }
    void step() override {
        if (static_cast<double>(steps_) >= 2 * steps_a_turn_) return begin(setting_);  // again
        q_ = setting_.choice == 0 ? exponential_map(q_, scene_, time(), step_size())
                                  : first_order_unit(q_, scene_, time(), step_size());
        ++steps_;
        path_.push_back(painted());
    }
    pic::Drawing drawing(double) const override {
        const double r = scene_.radius;
        pic::Drawing drawing;
        drawing.ground({.height = 0, .spacing = 0.5});
        if (time() > 0) {
            pic::Trail cycloid{
                .points = {}, .colour = pic::palette::ink, .dashed = true, .width = 2};
            for (int i = 0; i <= 120; ++i) {
                const double t = time() * i / 120;
                cycloid.points.push_back(scene_.point(scene_.exact(t), t, {0, -r, 0}));
            }
            if (setting_.choice == 1) drawing.add(cycloid);
            drawing.add(pic::Trail{.points = path_, .colour = pic::palette::gold, .width = 4});
        }
        // the painted spoke, which starts upwards in the picture of a wheel, starts downwards
        const Quaternion shown = product(q_, quaternion_about(Vector3::UnitZ(), pi));
        add_wheel(drawing, shown, scene_.centre(time()), r, 8, pic::palette::body, true);
        for (int i = 0; i < 8; ++i) {
            const Vector3 p = r * Vector3(std::sin(pi / 4 * i), -std::cos(pi / 4 * i), 0);
            const Vector3 v = scene_.velocity(q_, p);
            if (v.norm() > 0.02 * scene_.speed)
                drawing.add(pic::Arrow{.from = scene_.point(q_, time(), p),
                                       .vector = 0.2 * v,
                                       .colour = pic::palette::velocity,
                                       .width = 5});
        }
        return drawing;
    }
    pic::Size size() const override { return {960, 300}; }
    pic::Camera camera(pic::Size size) const override {
        pic::Drawing room;
        room.add(
            pic::Trail{.points = {{-0.5, 0, 0}, {4.2, 0, 0}, {4.2, 1.1, 0}, {-0.5, 1.1, 0}}});
        return pic::fit(room, {0.05, 0.12, 1}, size, {.margin = 0.02});
    }
    std::vector<live::Number> numbers() const override {
        using Trace = live::Number::Trace;
        const Vector3 lowest(0, -scene_.radius, 0);
        return {{"speed of the painted point", scene_.velocity(q_, lowest).norm(), "m/s",
                 Trace::linear},
                {"off", 1000 * scene_.error(q_, time()), "mm", Trace::linear}};
    }
    std::vector<double> state() const override { return {q_.x(), q_.y(), q_.z(), q_.w()}; }
    double page_tolerance() const override {
        return 1e-12;
    }  // sin and cos in every step, a thousand of them

  private:
    Vector3 painted() const { return scene_.point(q_, time(), {0, -scene_.radius, 0}); }
    RollingWheel scene_;
    live::Setting setting_{0, {128}};
    Quaternion q_ = four_vector({0, 0, 0}, 1);
    std::vector<Vector3> path_;
    double steps_a_turn_ = 128;
    long steps_ = 0;
};

const live::Entry entry{"rolling", [] { return std::unique_ptr<live::Figure>(new LiveRolling); }};

}  // namespace

}  // namespace nutshell
