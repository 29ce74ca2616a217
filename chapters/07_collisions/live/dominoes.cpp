// A row of dominoes: their distance, their friction and the step in the reader's hand.
#include <nutshell/domino_scenes.hpp>
#include <nutshell/live/figure.hpp>
#include "../piles_drawings.hpp"

namespace nutshell {

namespace {

class LiveDominoes : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override {
        return {{"four", "four sub-steps", {Family::symplectic, Mark::square}},
                {"one", "one sub-step", {Family::explicit_one_step, Mark::circle}}};
    }
    std::vector<live::Slider> sliders() const override {
        return {{.name = "apart",
                 .unit = "m",
                 .least = 0.2,
                 .most = 0.6,
                 .start = 0.25,
                 .logarithmic = false,
                 .mark = 0.58,
                 .mark_words = "too far to touch"},
                {.name = "friction", .least = 0, .most = 1, .start = 0.5, .logarithmic = false},
                {.name = "steps a second", .least = 15, .most = 240, .start = 60, .whole = true}};
    }
    std::vector<live::State> states() const override {
        return {
            {.key = "row",
             .words = "25 cm apart, 60 steps a second",
             .setting = {0, {0.25, 0.5, 60}},
             .time = 1.5},
            {.key = "smooth", .words = "no friction", .setting = {0, {0.25, 0, 60}}, .time = 1.5},
            {.key = "coarse",
             .words = "15 steps a second, one sub-step",
             .setting = {1, {0.25, 0.5, 15}},
             .time = 2}};
    }
    void begin(const live::Setting& setting) override {
        row_ = DominoRow{};
        row_.spacing = setting.values.at(0);
        steps_a_second_ = std::round(setting.values.at(2));
        require_positive(steps_a_second_, "steps a second");
        row_.switches.sub_steps = setting.choice == 0 ? 4 : 1;
        world_ = row_.start();
        world_.surface.friction = setting.values.at(1);
        checked(world_.surface);
        engine_ = Engine(row_.switches), wave_ = DominoWave(row_), steps_ = 0;
    }
    double time() const override { return static_cast<double>(steps_) * step_size(); }
    double step_size() const override { return 1 / steps_a_second_; }
    double pace() const override { return 0.5; }
    void step() override {
        engine_.step(world_, step_size()), ++steps_;
        wave_.look(world_, time());
    }
    std::string ended() const override {
        if (time() < 6) return {};
        if (!wave_.all_fell()) return "After six seconds not all have fallen.";
        return "All have fallen; the wave ran at " +
               digits(std::round(100 * wave_.speed()) / 100) + " m/s.";
    }
    pic::Drawing drawing(double) const override {
        pic::Drawing drawing;
        const double length = (row_.pieces - 1) * row_.spacing;
        drawing.stage({{length / 2, 0, 0}, length / 2 + 0.6});
        drawing.ground({.height = 0, .spacing = 0.5});
        for (std::size_t i = 0; i < world_.bodies.size(); ++i)
            add_body(drawing, world_, i, layer_colour(i, world_.bodies.size()));
        return drawing;
    }
    pic::Size size() const override { return {800, 340}; }
    pic::Camera camera(pic::Size size) const override {
        pic::Drawing room;
        const double length = (row_.pieces - 1) * row_.spacing;
        room.add(
            pic::Box{.pose = Eigen::Isometry3d(Eigen::Translation3d(length / 2 + 0.15, 0.25, 0)),
                     .half_extents = {length / 2 + 0.3, 0.25, 0.2}});
        return pic::fit(room, {0.12, 0.35, 1}, size, {.margin = 0.03});
    }
    std::vector<live::Number> numbers() const override {
        double fallen = 0;
        for (const double at : wave_.times()) fallen += at >= 0;
        return {{"time", time(), "s"},
                {"falling or fallen", fallen, "", live::Number::Trace::linear},
                {"wave", wave_.speed(), "m/s"},
                {"overlap", 1000 * deepest_overlap(world_), "mm", live::Number::Trace::linear}};
    }
    std::vector<double> state() const override {
        std::vector<double> all;
        for (const Body& body : world_.bodies)
            all.insert(all.end(), {body.position.x(), body.position.y(), body.momentum.x(),
                                   body.momentum.y(), body.angular_momentum.z()});
        return all;
    }
    /// The first piece's lean and the turning of pieces are sines, which differ between the two
    /// C libraries in the last digit; pieces that hit each other make it grow.
    double page_tolerance() const override { return 1e-3; }

  private:
    DominoRow row_;
    World world_;
    Engine engine_;
    DominoWave wave_{DominoRow{}};
    double steps_a_second_ = 60;
    long steps_ = 0;
};

const live::Entry entry{"dominoes",
                        [] { return std::unique_ptr<live::Figure>(new LiveDominoes); }};

}  // namespace

}  // namespace nutshell
