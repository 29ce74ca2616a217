// From one pose to another: by slerp, by nlerp, and each of three angles by itself.
#include <nutshell/live/figure.hpp>
#include "../drawings.hpp"

namespace nutshell {

namespace {

class LiveWay : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override {
        return {{"slerp", "slerp", {Family::exponential, Mark::triangle}},
                {"nlerp", "nlerp", {Family::symplectic, Mark::square}},
                {"angles", "three angles", {Family::explicit_one_step, Mark::triangle_down}}};
    }
    std::vector<live::State> states() const override {
        return {{.key = "slerp", .words = "slerp: even dots", .setting = {0, {}}, .time = 1},
                {.key = "nlerp",
                 .words = "nlerp: wider in the middle",
                 .setting = {1, {}},
                 .time = 1,
                 .drawn = true},
                {.key = "angles",
                 .words = "three angles: a detour",
                 .setting = {2, {}},
                 .time = 1,
                 .drawn = true}};
    }
    void begin(const live::Setting& setting) override { choice_ = setting.choice, steps_ = 0; }
    double time() const override { return static_cast<double>(steps_) * step_size(); }
    double step_size() const override { return 1.0 / 128; }
    double pace() const override { return 0.3; }
    void step() override { ++steps_; }
    std::string ended() const override { return time() < 1 ? "" : "There."; }

    pic::Drawing drawing(double part) const override {
        const double shown = std::min(1.0, std::max(0.0, time() - (1 - part) * step_size()));
        const Quaternion q = pose(shown);
        pic::Drawing drawing;
        drawing.stage({{0, 0, 0}, 1.12}).no_ground();
        drawing.add(pic::Ball{.radius = 0.97, .colour = pic::palette::steel, .orientation = q});
        const auto slerp_way = [&](double s) { return slerp(scene_.from, scene_.to, s); };
        add_way(drawing, slerp_way, pic::palette::ink, 1.0, 1, 0);
        for (int i = 0; choice_ == 1 && i <= 10 && i <= 10 * shown + 1e-9; ++i)  // slerp's dots
            drawing.add(pic::Ball{.centre = rotate(slerp_way(i / 10.0), Vector3::UnitZ()),
                                  .radius = 0.085,
                                  .colour = pic::palette::exponential,
                                  .look = pic::Look::ghost});
        add_way(
            drawing, [&](double s) { return pose(s); }, colour(), 1.0, shown, 0.05);
        const Vector3 nose = rotate(q, Vector3::UnitZ());
        drawing.add(pic::Arrow{.from = nose, .vector = 0.3 * nose, .colour = colour()});
        return drawing;
    }
    pic::Size size() const override { return {420, 420}; }
    pic::Camera camera(pic::Size size) const override {
        const Vector3 middle = rotate(scene_.by_angles(0.5), Vector3::UnitZ()) +
                               rotate(slerp(scene_.from, scene_.to, 0.5), Vector3::UnitZ());
        pic::Drawing room = drawing(1);
        room.title("room for a title");
        return pic::fit(room, middle, size, {.margin = 0.02});
    }
    std::vector<live::Number> numbers() const override {
        const double h = 1e-3, now = std::min(1.0 - h, std::max(h, time()));
        const double whole = angle_between(scene_.from, scene_.to);
        return {{"of the way", 100 * std::min(1.0, time()), "%"},
                {"speed / shortest way",
                 angle_between(pose(now - h), pose(now + h)) / (2 * h * whole), "",
                 live::Number::Trace::linear}};
    }
    std::vector<double> state() const override {
        const Quaternion q = pose(std::min(1.0, time()));
        return {q.x(), q.y(), q.z(), q.w()};
    }
    double page_tolerance() const override { return 1e-12; }  // sin and cos of one pose

  private:
    Quaternion pose(double part) const {
        if (choice_ == 0) return slerp(scene_.from, scene_.to, part);
        return choice_ == 1 ? nlerp(scene_.from, scene_.to, part) : scene_.by_angles(part);
    }
    pic::Colour colour() const {
        return choice_ == 0   ? pic::palette::exponential
               : choice_ == 1 ? pic::palette::symplectic
                              : pic::palette::explicit_euler;
    }
    TwoPoses scene_;
    int choice_ = 0;
    long steps_ = 0;
};

const live::Entry entry{"way", [] { return std::unique_ptr<live::Figure>(new LiveWay); }};

}  // namespace

}  // namespace nutshell
