// A rolling wheel, with the velocity of its points and the path of one of them.
#include <nutshell/live/figure.hpp>
#include "../drawings.hpp"

namespace nutshell {

namespace {

class LiveRolling : public live::Figure {
  public:
    std::vector<live::State> states() const override {
        return {{.key = "rolling", .words = "", .setting = {}, .time = 1.7}};
    }
    void begin(const live::Setting&) override { q_ = scene_.start, steps_ = 0; }
    double time() const override { return static_cast<double>(steps_) * step_size(); }
    double step_size() const override { return 1.0 / 64; }
    void step() override {
        q_ = exponential_map(q_, scene_, time(), step_size());
        ++steps_;
        if (time() > scene_.duration) begin({});  // it starts again
    }
    pic::Drawing drawing(double) const override {
        const double r = scene_.radius;
        pic::Drawing drawing;
        drawing.ground({.height = 0, .spacing = 0.5});
        pic::Trail cycloid{.points = {}, .colour = pic::palette::gold, .width = 4};
        const Vector3 lowest(0, -r, 0);
        for (int i = 0; i <= 120; ++i) {
            const double t = time() * i / 120;
            cycloid.points.push_back(scene_.point(scene_.exact(t), t, lowest));
        }
        if (time() > 0) drawing.add(cycloid);
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
        const Vector3 painted(0, -scene_.radius, 0);
        return {{"speed of the painted point", scene_.velocity(q_, painted).norm(), "m/s",
                 live::Number::Trace::linear}};
    }
    std::vector<double> state() const override { return {q_.x(), q_.y(), q_.z(), q_.w()}; }

  private:
    RollingWheel scene_;
    Quaternion q_ = four_vector({0, 0, 0}, 1);
    long steps_ = 0;
};

const live::Entry entry{"rolling", [] { return std::unique_ptr<live::Figure>(new LiveRolling); }};

}  // namespace

}  // namespace nutshell
