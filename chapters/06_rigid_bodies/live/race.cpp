// A bob on a thin rod and a heavy rod of the same length, let go together: who hangs first?
#include <nutshell/live/figure.hpp>
#include <nutshell/pendulum_scenes.hpp>
#include "../lever_drawings.hpp"

namespace nutshell {

namespace {

class LiveRace : public live::Figure {
  public:
    std::vector<live::Slider> sliders() const override {
        return {{.name = "let go at",
                 .unit = "°",
                 .least = 5,
                 .most = 110,
                 .start = 90,
                 .logarithmic = false}};
    }
    std::vector<live::State> states() const override {
        return {{.key = "quarter", .words = "the rod hangs", .setting = {0, {90}}, .time = 0.483},
                {.key = "small", .words = "small swings", .setting = {0, {5}}, .time = 0.41}};
    }
    void begin(const live::Setting& setting) override {
        const double angle = setting.values.at(0) * pi / 180;
        require(angle > 0 && angle < pi, "let go at: the angle must be between 0 and 180°");
        bob_ = rod_pendulum(angle), rod_ = compound_pendulum(angle);
        bob_now_ = bob_.start, rod_now_ = rod_.start;
        steps_ = 0, bob_hung_ = rod_hung_ = 0;
    }
    double time() const override { return static_cast<double>(steps_) * step_size(); }
    double step_size() const override { return 1.0 / 512; }
    double pace() const override { return 0.5; }
    void step() override {
        const double t = time(), dt = step_size();
        bob_now_ = verlet(bob_now_, bob_, t, dt), rod_now_ = verlet(rod_now_, rod_, t, dt);
        ++steps_;
        if (bob_hung_ == 0 && bob_.angle_of(bob_now_) <= 0) bob_hung_ = time();
        if (rod_hung_ == 0 && rod_.angle_of(rod_now_) <= 0) rod_hung_ = time();
    }
    pic::Drawing drawing(double) const override {
        pic::Drawing drawing;
        drawing.stage({{0.5, -0.4, 0}, 1.9}).no_ground();
        const Vector3 left(-0.2, 0, 0), right(1.2, 0, 0);
        add_nail(drawing, left), add_nail(drawing, right);
        for (const Vector3& nail : {left, right})
            drawing.add(pic::Trail{.points = {nail, nail + Vector3(0, -1.15, 0)},
                                   .colour = pic::palette::ink,
                                   .dashed = true,
                                   .width = 2});
        add_bob(drawing, left, bob_now_.orientation, 1, pic::palette::body);
        add_heavy_rod(drawing, right, rod_now_.orientation, 1, pic::palette::gold);
        return drawing;
    }
    pic::Size size() const override { return {840, 360}; }
    pic::Camera camera(pic::Size size) const override {
        pic::Drawing room;
        room.add(pic::Trail{.points = {{-1.35, -1.2, 0}, {2.35, 0.4, 0}}});
        return pic::fit(room, {0.1, 0.05, 1}, size, {.margin = 0.03});
    }
    std::vector<live::Number> numbers() const override {
        using Trace = live::Number::Trace;
        const double degree = 180 / pi;
        return {{"bob", degree * bob_.angle_of(bob_now_), "°", Trace::linear},
                {"rod", degree * rod_.angle_of(rod_now_), "°", Trace::linear},
                {"bob hung first after", bob_hung_, "s"},
                {"rod hung first after", rod_hung_, "s"}};
    }
    std::vector<double> state() const override {
        return {bob_now_.orientation.z(),      bob_now_.orientation.w(),
                rod_now_.orientation.z(),      rod_now_.orientation.w(),
                bob_now_.angular_momentum.z(), rod_now_.angular_momentum.z()};
    }
    double page_tolerance() const override { return 1e-12; }  // starts with sine and cosine

  private:
    Pendulum bob_ = rod_pendulum(1), rod_ = compound_pendulum(1);
    Pinned bob_now_, rod_now_;
    double bob_hung_ = 0, rod_hung_ = 0;
    long steps_ = 0;
};

const live::Entry entry{"race", [] { return std::unique_ptr<live::Figure>(new LiveRace); }};

}  // namespace

}  // namespace nutshell
