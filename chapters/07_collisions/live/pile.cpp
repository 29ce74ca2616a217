// A pile: up to a thousand spheres or cubes fall into a box.
#include <nutshell/live/figure.hpp>
#include "../piles_drawings.hpp"

namespace nutshell {

namespace {

class LivePile : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override {
        return {{"spheres", "spheres", {Family::symplectic, Mark::circle}},
                {"cubes", "cubes", {Family::implicit, Mark::square}}};
    }
    std::vector<live::Slider> sliders() const override {
        return {{.name = "side of a layer",
                 .unit = "bodies",
                 .least = 2,
                 .most = 10,
                 .start = 10,
                 .logarithmic = false,
                 .whole = true},
                {.name = "sub-steps",
                 .least = 1,
                 .most = 8,
                 .start = 4,
                 .logarithmic = false,
                 .whole = true}};
    }
    std::vector<live::State> states() const override {
        return {{.key = "spheres",
                 .words = "a thousand spheres",
                 .setting = {0, {10, 4}},
                 .time = 3,
                 .instants = {0, 0.4, 0.6, 1, 3}},
                {.key = "one", .words = "one sub-step", .setting = {0, {10, 1}}, .time = 3},
                {.key = "cubes", .words = "90 cubes", .setting = {1, {3, 4}}, .time = 3}};
    }
    void begin(const live::Setting& setting) override {
        pile_ = Pile{};
        pile_.cubes = setting.choice == 1;
        pile_.wide = static_cast<int>(std::lround(setting.values.at(0)));
        require(pile_.wide >= 1 && pile_.wide <= 10, "a layer's side is 1 to 10 bodies");
        world_ = pile_.start(), before_ = energy(world_);
        change(setting);
        engine_ = Engine(pile_.switches), steps_ = 0, deepest_ = 0;
    }
    void change(const live::Setting& setting) override {
        const bool another = std::lround(setting.values.at(0)) != pile_.wide ||
                             (setting.choice == 1) != pile_.cubes;
        if (another) return begin(setting);
        pile_.switches.sub_steps = static_cast<int>(std::lround(setting.values.at(1)));
        require(pile_.switches.sub_steps >= 1, "there is at least one sub-step");
        engine_.on = pile_.switches;
    }
    double time() const override { return static_cast<double>(steps_) * step_size(); }
    double step_size() const override { return 1 / 60.0; }
    void step() override {
        engine_.step(world_, step_size()), ++steps_;
        deepest_ = std::max(deepest_, overlap());
    }
    std::string ended() const override {
        if (time() < pile_.duration - 1e-9) return {};
        return digits(pile_.duration) + " seconds: no two bodies overlapped by more than " +
               digits(std::round(1e4 * deepest_) / 10) + " mm.";
    }
    pic::Drawing drawing(double) const override {
        pic::Drawing drawing;
        const double half = pile_.half_width();
        drawing.stage({{0, 1.2, 0}, 1.6 * half + 0.6});
        drawing.ground({.height = 0, .spacing = 0.5});
        add_room(drawing, half, 0.9);
        const std::size_t n = world_.bodies.size();
        for (std::size_t i = 0; i < n; ++i)
            add_body(drawing, world_, i, layer_colour(i * 10 / n, 10), n <= 100);
        return drawing;
    }
    pic::Size size() const override { return {400, 460}; }
    pic::Camera camera(pic::Size size) const override {
        const double half = pile_.half_width();
        pic::Drawing room;
        room.add(pic::Box{.pose = Eigen::Isometry3d(Eigen::Translation3d(0, 1.3, 0)),
                          .half_extents = {half, 1.3, half}});
        return pic::fit(room, {0.5, 0.35, 1}, size, {.margin = 0.03});
    }
    std::vector<live::Number> numbers() const override {
        using Trace = live::Number::Trace;
        return {{"time", time(), "s"},
                {"bodies", static_cast<double>(world_.bodies.size()), ""},
                {"contacts", static_cast<double>(engine_.contacts().size()), "", Trace::linear},
                {"overlap", 1000 * overlap(), "mm", Trace::linear},
                {"energy / start", energy(world_) / before_, "", Trace::linear}};
    }
    std::vector<double> state() const override {
        std::vector<double> all;
        for (const Body& body : world_.bodies)
            for (const Vector3* v : {&body.position, &body.momentum, &body.angular_momentum})
                all.insert(all.end(), {v->x(), v->y(), v->z()});
        return all;
    }

  private:
    /// The deepest, among the contacts of the last step [m].
    double overlap() const {
        double deepest = 0;
        for (const PressedContact& contact : engine_.contacts())
            deepest = std::max(deepest, -contact.separation);
        return deepest;
    }
    Pile pile_;
    World world_;
    Engine engine_;
    double before_ = 1, deepest_ = 0;
    long steps_ = 0;
};

const live::Entry entry{"pile", [] { return std::unique_ptr<live::Figure>(new LivePile); }};

}  // namespace

}  // namespace nutshell
