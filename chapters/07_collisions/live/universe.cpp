// The source's universe, with its own camera: as printed, its own rules mended, by our engine.
#include <nutshell/live/figure.hpp>
#include <nutshell/universe_scene.hpp>
#include "../piles_drawings.hpp"

namespace nutshell {

namespace {

class LiveUniverse : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override {
        return {{"printed", "as printed", {Family::explicit_one_step, Mark::triangle_down}},
                {"mended", "its rules mended", {Family::implicit, Mark::circle}},
                {"engine", "our engine", {Family::symplectic, Mark::square}}};
    }
    std::vector<live::Slider> sliders() const override {
        return {{.name = "pace", .unit = "x", .least = 1, .most = 60, .start = 12}};
    }
    std::vector<live::State> states() const override {
        return {{.key = "printed",
                 .words = "as printed",
                 .setting = {0, {12}},
                 .time = 25,
                 .instants = {0, 10, 20, 30, 40}},
                {.key = "engine", .words = "our engine", .setting = {2, {12}}, .time = 25},
                {.key = "mended", .words = "its rules mended", .setting = {1, {12}}, .time = 25},
                {.key = "nan",
                 .words = "as printed, after eight minutes",
                 .setting = {0, {60}},
                 .time = 475}};
    }
    void begin(const live::Setting& setting) override {
        which_ = setting.choice;
        change(setting);
        printed_ = PrintedUniverse{};
        world_ = world_of(scene_), engine_ = Engine(universe_switches), steps_ = 0;
    }
    void change(const live::Setting& setting) override {
        pace_ = setting.values.at(0);
        require_positive(pace_, "the pace");
        if (setting.choice != which_) begin(setting);
    }
    double time() const override { return static_cast<double>(steps_) * step_size(); }
    double step_size() const override { return scene_.dt; }
    double pace() const override { return pace_; }
    void step() override {
        if (which_ == 0) printed_.evolve(static_cast<float>(scene_.dt));
        if (which_ == 1) evolve_mended(scene_, world_.bodies[0], scene_.dt);
        if (which_ == 2) engine_.step(world_, scene_.dt);
        ++steps_;
    }
    std::string ended() const override {
        if (!printed_.R.allFinite())
            return "Step " + digits(static_cast<double>(steps_)) +
                   ": R is not a number. The ball has vanished from the screen.";
        return time() < 480 ? std::string() : "Eight minutes are over.";
    }
    pic::Drawing drawing(double) const override {
        pic::Drawing drawing;
        drawing.stage({{0, 1.5, 0}, 5});
        drawing.ground({.height = 0, .spacing = 1});
        const pic::Colour air = pic::mix(pic::palette::air, pic::palette::horizon, 0.5F);
        drawing.sky({air, air});
        if (!printed_.R.allFinite()) return drawing;
        drawing.add(pic::Ball{.centre = place(),
                              .radius = scene_.radius,
                              .colour = which_ == 0   ? pic::palette::explicit_euler
                                        : which_ == 1 ? pic::palette::implicit
                                                      : pic::palette::symplectic,
                              .orientation = pose()});
        return drawing;
    }
    pic::Size size() const override { return {640, 480}; }
    /// The source's: gluLookAt(0, 3.5, 8, 0, 3.5, 0, 0, 1, 0), 60 degrees.
    pic::Camera camera(pic::Size) const override {
        return {.eye = {0, 3.5, 8}, .target = {0, 3.5, 0}, .field_of_view = pi / 3};
    }
    std::vector<live::Number> numbers() const override {
        using Trace = live::Number::Trace;
        return {{"time", time(), "s"},
                {"lowest point", place().y() - scene_.radius, "m", Trace::linear},
                {"|L|", spin(), "kg m²/s", Trace::logarithmic}};
    }
    std::vector<double> state() const override {
        const Vector3 p = place();
        return {p.x(), p.y(), p.z(), spin()};
    }

  private:
    Vector3 place() const {
        return which_ == 0 ? Vector3(printed_.p.cast<double>()) : world_.bodies[0].position;
    }
    Quaternion pose() const {
        if (which_ != 0) return world_.bodies[0].orientation;
        return Quaternion(Matrix3(printed_.R.cast<double>())).normalized();
    }
    double spin() const {
        return which_ == 0 ? static_cast<double>(printed_.L.norm())
                           : world_.bodies[0].angular_momentum.norm();
    }
    Universe scene_;
    PrintedUniverse printed_;
    World world_;
    Engine engine_;
    int which_ = 0;
    double pace_ = 12;
    long steps_ = 0;
};

const live::Entry entry{"universe",
                        [] { return std::unique_ptr<live::Figure>(new LiveUniverse); }};

}  // namespace

}  // namespace nutshell
