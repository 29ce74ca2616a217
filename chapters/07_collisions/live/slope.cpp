// A block on a slope by contact impulses alone: when it sticks, how fast it slides, and what a
// pyramid in place of the cone makes of it.
#include <nutshell/friction_scenes.hpp>
#include <nutshell/live/figure.hpp>
#include "../drawings.hpp"

namespace nutshell {

namespace {

class LiveSlope : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override {
        return {{"cone", "cone", {Family::symplectic, Mark::square}},
                {"pyramid", "pyramid", {Family::explicit_one_step, Mark::circle}}};
    }
    std::vector<live::Slider> sliders() const override {
        const double steepest = std::atan(scene_.friction) * 180 / pi;
        return {{.name = "slope",
                 .unit = "°",
                 .least = 0,
                 .most = 44,
                 .start = 30,
                 .logarithmic = false,
                 .mark = steepest,
                 .mark_words = "sticks up to " + digits(std::round(10 * steepest) / 10) + "°"},
                {.name = "friction μ", .least = 0, .most = 1, .start = 0.5, .logarithmic = false},
                {.name = "block turned by",
                 .unit = "°",
                 .least = 0,
                 .most = 90,
                 .start = 0,
                 .logarithmic = false}};
    }
    std::vector<live::State> states() const override {
        return {{.key = "slides",
                 .words = "30°, μ = 0.5: it slides",
                 .setting = {0, {30, 0.5, 0}},
                 .time = 2},
                {.key = "pyramid",
                 .words = "turned by 45°, in a pyramid",
                 .setting = {1, {30, 0.5, 45}},
                 .time = 2,
                 .drawn = true},
                {.key = "turned",
                 .words = "turned by 45°, in a cone",
                 .setting = {0, {30, 0.5, 45}},
                 .time = 2},
                {.key = "sticks",
                 .words = "26°: it sticks",
                 .setting = {0, {26, 0.5, 0}},
                 .time = 2}};
    }
    void begin(const live::Setting& setting) override {
        scene_ = BlockOnSlope{};
        scene_.slope = setting.values.at(0) * pi / 180;
        scene_.friction = setting.values.at(1);
        scene_.heading = setting.values.at(2) * pi / 180;
        require(scene_.slope >= 0 && scene_.slope < pi / 4,
                "the slope must be from 0 to below 45 degrees, where a cube tips");
        scene_.switches.pyramid = setting.choice == 1;
        world_ = scene_.start();
        checked(world_.surface);
        engine_ = Engine(scene_.switches), steps_ = 0;
    }
    double time() const override { return static_cast<double>(steps_) * step_size(); }
    double step_size() const override { return 1 / 60.0; }
    void step() override { engine_.step(world_, step_size()), ++steps_; }
    std::string ended() const override {
        if (way() > longest)
            return "It slides, " + digits(longest) + " m in " +
                   digits(std::round(100 * time()) / 100) + " s.";
        if (time() < 5 - 1e-9) return {};
        if (way() < 0.01) return "It has stuck for five seconds.";
        return "It slides, " + digits(std::round(100 * way())) + " cm in five seconds.";
    }

    pic::Drawing drawing(double) const override {
        pic::Drawing drawing;
        drawing.stage({view() * Vector3(2.2, 0, 0), 3.4}).no_ground();
        drawing.add(box(view() * Vector3(2.2, -0.1, 0), view(), {3.4, 0.1, 1.1},
                        pic::palette::steel, pic::Look::solid));
        const Body& body = world_.bodies[0];
        const Eigen::Matrix3d to = view() * turned();
        const double law = scene_.sticks() ? 0 : scene_.exact_speed(1) * time() * time() / 2;
        drawing.add(box(view() * Vector3(std::min(law, longest), 0.5, 0), to,
                        Vector3::Constant(0.5), pic::palette::exact, pic::Look::ghost));
        pic::Box block = box(to * body.position, to * rotation_matrix(body.orientation),
                             Vector3::Constant(0.5),
                             scene_.switches.pyramid ? pic::palette::explicit_euler
                                                     : pic::palette::symplectic,
                             pic::Look::solid);
        block.marked = true;
        drawing.add(block);
        const Vector3 top = to * body.position + view() * Vector3(0, 0.5, 0);
        if (velocity(body).norm() > 0.02)
            drawing.add(pic::Arrow{.from = top,
                                   .vector = 0.5 * (to * velocity(body)),
                                   .colour = pic::palette::velocity,
                                   .label = "v"});
        return drawing;
    }
    pic::Size size() const override { return {560, 440}; }
    pic::Camera camera(pic::Size size) const override {
        pic::Drawing room;
        for (const double x : {-1.2, 5.6})
            for (const double y : {-0.1, 1.3})
                for (const double z : {-1.1, 1.1})
                    room.add(pic::Ball{.centre = view() * Vector3(x, y, z), .radius = 0.02});
        return pic::fit(room, {0.15, 0.4, 1}, size, {.margin = 0.03});
    }
    std::vector<live::Number> numbers() const override {
        using Trace = live::Number::Trace;
        const Vector3 v = velocity(world_.bodies[0]);
        return {{"time", time(), "s"},
                {"speed", v.norm(), "m/s", Trace::linear},
                {"by Coulomb's law", scene_.exact_speed(time()), "m/s"},
                {"block has slid", way(), "m"}};
    }
    std::vector<double> state() const override {
        const Body& body = world_.bodies[0];
        std::vector<double> all;
        for (const Vector3* v : {&body.position, &body.momentum, &body.angular_momentum})
            all.insert(all.end(), {v->x(), v->y(), v->z()});
        return all;
    }
    /// Sine and cosine of the slope and the block's direction: the two C libraries may differ in
    /// their last digit, and forces are constant, so it does not grow.
    double page_tolerance() const override { return 1e-11; }

  private:
    static constexpr double longest = 5;  // of the slope [m]

    /// The scene's floor is level and its gravity leans; in the picture the slope leans.
    Eigen::Matrix3d view() const {
        return Eigen::AngleAxisd(-scene_.slope, Vector3::UnitZ()).toRotationMatrix();
    }
    /// Downhill is the picture's x.
    Eigen::Matrix3d turned() const {
        return Eigen::AngleAxisd(scene_.heading, Vector3::UnitY()).toRotationMatrix();
    }
    /// How far it has come down the slope [m].
    double way() const {
        return (world_.bodies[0].position - Vector3(0, 0.5, 0)).dot(scene_.downhill());
    }
    static pic::Box box(const Vector3& at, const Eigen::Matrix3d& turn, const Vector3& half,
                        pic::Colour colour, pic::Look look) {
        pic::Box thing{.half_extents = half, .colour = colour, .look = look};
        thing.pose.linear() = turn, thing.pose.translation() = at;
        return thing;
    }
    BlockOnSlope scene_;
    World world_ = scene_.start();
    Engine engine_;
    long steps_ = 0;
};

const live::Entry entry{"slope", [] { return std::unique_ptr<live::Figure>(new LiveSlope); }};

}  // namespace

}  // namespace nutshell
