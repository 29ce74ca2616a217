// Two turns in either order, side by side.
#include <nutshell/live/figure.hpp>
#include "../drawings.hpp"

namespace nutshell {

namespace {

class LiveOrder : public live::Figure {
  public:
    std::vector<live::Slider> sliders() const override {
        return {{.name = "each turn",
                 .unit = "°",
                 .least = 1,
                 .most = 180,
                 .start = 90,
                 .logarithmic = false}};
    }
    std::vector<live::State> states() const override {
        return {{.key = "quarter",
                 .words = "two quarter turns",
                 .setting = {0, {90}},
                 .time = 2,
                 .instants = {0, 0.5, 1, 1.5, 2}},
                {.key = "small", .words = "two turns by 6°", .setting = {0, {6}}, .time = 2},
                {.key = "half", .words = "two half turns", .setting = {0, {180}}, .time = 2}};
    }
    void begin(const live::Setting& setting) override {
        angle_ = setting.values.at(0) * pi / 180;
        steps_ = 0;
    }
    void change(const live::Setting& setting) override {
        angle_ = setting.values.at(0) * pi / 180;
    }
    double time() const override { return static_cast<double>(steps_) * step_size(); }
    double step_size() const override { return 1.0 / 64; }
    double pace() const override { return 0.7; }
    void step() override { ++steps_; }
    std::string ended() const override {
        if (time() < 2) return {};
        return "The two ends are " + digits(std::round(10 * apart()) / 10) + "° apart.";
    }

    pic::Drawing drawing(double part) const override {
        const double shown = std::min(2.0, std::max(0.0, time() - (1 - part) * step_size()));
        const Vector3 left(0, 0.95, 0), right(0, -0.95, 0);
        pic::Drawing drawing;
        drawing.stage({{0, 0, 0}, 1.95}).no_ground();
        drawing.add(
            book(pose(Vector3::UnitX(), Vector3::UnitZ(), shown), left, pic::palette::body));
        drawing.add(
            book(pose(Vector3::UnitZ(), Vector3::UnitX(), shown), right, pic::palette::gold));
        if (shown < 2) {
            const bool first = shown < 1;
            add_axis(drawing, left, first ? Vector3::UnitX() : Vector3::UnitZ(),
                     first ? "x" : "z");
            add_axis(drawing, right, first ? Vector3::UnitZ() : Vector3::UnitX(),
                     first ? "z" : "x");
        }
        return drawing;
    }
    pic::Size size() const override { return {420, 560}; }
    pic::Camera camera(pic::Size size) const override {
        pic::Drawing room;
        for (const double y : {0.95, -0.95})
            room.add(pic::Ball{.centre = {0, y, 0}, .radius = 0.95});
        return pic::fit(room, {0.35, 0.4, 1}, size, {.margin = 0.02});
    }
    std::vector<live::Number> numbers() const override { return {{"apart", apart(), "°"}}; }
    std::vector<double> state() const override { return {angle_, time()}; }

  private:
    Quaternion pose(const Vector3& first, const Vector3& then, double shown) const {
        return product(quaternion_about(then, angle_ * std::max(0.0, shown - 1)),
                       quaternion_about(first, angle_ * std::min(1.0, shown)));
    }
    double apart() const {
        return 180 / pi *
               angle_between(pose(Vector3::UnitX(), Vector3::UnitZ(), std::min(2.0, time())),
                             pose(Vector3::UnitZ(), Vector3::UnitX(), std::min(2.0, time())));
    }
    static void add_axis(pic::Drawing& drawing, const Vector3& at, const Vector3& along,
                         const char* name) {
        drawing.add(pic::Arrow{.from = at - 1.0 * along,
                               .vector = 2.0 * along,
                               .colour = pic::palette::angular_velocity,
                               .label = name});
        const Vector3 side = along.cross(Vector3(0.3, 0.8, 1));
        drawing.add(pic::Trail{.points = arc(at + 0.75 * along, along, side, 0.3, 0, 1.5 * pi),
                               .colour = pic::palette::angular_velocity,
                               .width = 4});
    }
    double angle_ = pi / 2;
    long steps_ = 0;
};

const live::Entry entry{"order", [] { return std::unique_ptr<live::Figure>(new LiveOrder); }};

}  // namespace

}  // namespace nutshell
