// Three rings in the reader's hand; the innermost rolls by itself. At a pitch of 90 degrees two of
// them turn about one axis.
#include <nutshell/live/figure.hpp>
#include "../drawings.hpp"

namespace nutshell {

namespace {

class LiveGimbals : public live::Figure {
  public:
    std::vector<live::Slider> sliders() const override {
        return {{.name = "yaw",
                 .unit = "°",
                 .least = -180,
                 .most = 180,
                 .start = 30,
                 .logarithmic = false},
                {.name = "pitch",
                 .unit = "°",
                 .least = -90,
                 .most = 90,
                 .start = -35,
                 .logarithmic = false},
                {.name = "roll",
                 .unit = "°",
                 .least = -180,
                 .most = 180,
                 .start = 20,
                 .logarithmic = false}};
    }
    std::vector<live::State> states() const override {
        return {{.key = "free", .words = "pitch −35°: three axes", .setting = {0, {30, -35, 20}}},
                {.key = "locked",
                 .words = "pitch −90°: two",
                 .setting = {0, {30, -90, 20}},
                 .drawn = true}};
    }
    void begin(const live::Setting& setting) override { steps_ = 0, change(setting); }
    void change(const live::Setting& setting) override {
        angles_ = {setting.values.at(0) * pi / 180, setting.values.at(1) * pi / 180,
                   setting.values.at(2) * pi / 180};
    }
    double time() const override { return static_cast<double>(steps_) * step_size(); }
    double step_size() const override { return 1.0 / 64; }
    void step() override { ++steps_; }
    pic::Drawing drawing(double part) const override {
        pic::Drawing drawing = gimbals(rolled(std::max(0.0, time() - (1 - part) * step_size())));
        drawing.no_ground().stage({{0, 0.15, 0}, 2.2});
        return drawing;
    }
    pic::Size size() const override { return {480, 480}; }
    pic::Camera camera(pic::Size size) const override {
        pic::Drawing room = gimbals(angles_);
        room.stage({{0, 0.15, 0}, 2.2}).title("room for a title");
        return pic::fit(room, {-0.5, 0.75, 1}, size, {.margin = 0.06});
    }
    std::vector<live::Number> numbers() const override {
        const Vector3 roll = rotate(orientation_of(angles_), Vector3::UnitZ());
        return {{"angle between the axes of yaw and roll",
                 180 / pi * std::acos(std::min(1.0, std::abs(roll.y()))), "°"}};
    }
    std::vector<double> state() const override {
        return {angles_.yaw, angles_.pitch, rolled(time()).roll};
    }

  private:
    EulerAngles rolled(double time) const {
        return {angles_.yaw, angles_.pitch, angles_.roll + 0.8 * time};
    }
    EulerAngles angles_;
    long steps_ = 0;
};

const live::Entry entry{"gimbals", [] { return std::unique_ptr<live::Figure>(new LiveGimbals); }};

}  // namespace

}  // namespace nutshell
