// A block or a ball on a slope by contact impulses alone: when it sticks, how fast it slides or
// rolls, and what a pyramid in place of the cone makes of it.
#include <nutshell/friction_scenes.hpp>
#include <nutshell/live/figure.hpp>
#include "../drawings.hpp"

namespace nutshell {

namespace {

class LiveSlope : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override {
        return {{"cone", "block", {Family::symplectic, Mark::square}},
                {"pyramid", "block, in a pyramid", {Family::explicit_one_step, Mark::circle}},
                {"ball", "ball", {Family::symplectic, Mark::circle}}};
    }
    std::vector<live::Slider> sliders() const override {
        // a ball's friction has two sevenths of the pull to bear; a pyramid bears it along two axes
        const double pyramid = 1 / std::max(std::cos(scene_.heading), std::sin(scene_.heading));
        const double grip = ball_ ? 3.5 : scene_.switches.pyramid ? pyramid : 1;
        const double steepest = std::atan(grip * scene_.friction) * 180 / pi;
        return {{.name = "slope",
                 .unit = "°",
                 .least = 0,
                 .most = 44,
                 .start = 30,
                 .logarithmic = false,
                 .mark = steepest,
                 .mark_words = (ball_ ? "rolls up to " : "sticks up to ") +
                               digits(std::round(10 * steepest) / 10) + "°"},
                {.name = "friction μ", .least = 0, .most = 1, .start = 0.5, .logarithmic = false},
                {.name = "block turned by",
                 .unit = "°",
                 .least = 0,
                 .most = 90,
                 .start = 45,
                 .logarithmic = false},
                {.name = "starts at",
                 .unit = "m/s",
                 .least = 0,
                 .most = 8,
                 .start = 0,
                 .logarithmic = false}};
    }
    std::vector<live::State> states() const override {
        return {
            {.key = "cone",
             .words = "turned by 45°, in a cone",
             .setting = {0, {30, 0.5, 45, 0}},
             .time = 2},
            {.key = "pyramid",
             .words = "turned by 45°, in a pyramid",
             .setting = {1, {30, 0.5, 45, 0}},
             .time = 2,
             .drawn = true},
            {.key = "edge",
             .words = "along its edge, in a pyramid",
             .setting = {1, {30, 0.5, 0, 0}},
             .time = 2},
            {.key = "sticks",
             .words = "26°: it sticks",
             .setting = {0, {26, 0.5, 45, 0}},
             .time = 2},
            {.key = "ball", .words = "a ball rolls", .setting = {2, {30, 0.5, 0, 0}}, .time = 1},
            {.key = "bowling",
             .words = "a bowling ball on the level",
             .setting = {2, {0, 0.1, 0, 7}},
             .time = 1.5}};
    }
    void begin(const live::Setting& setting) override {
        scene_ = BlockOnSlope{};
        scene_.slope = setting.values.at(0) * pi / 180;
        scene_.friction = setting.values.at(1);
        scene_.heading = setting.values.at(2) * pi / 180;
        require(scene_.slope >= 0 && scene_.slope < pi / 4,
                "the slope must be from 0 to below 45 degrees, where a cube tips");
        scene_.switches.pyramid = setting.choice == 1;
        ball_ = setting.choice == 2, speed_ = setting.values.at(3);
        require(std::isfinite(speed_) && speed_ >= 0, "it starts down the slope");
        longest_ = speed_ > 0 ? 14 : 5;
        world_ = scene_.start();
        checked(world_.surface);
        if (ball_)
            world_.bodies[0] = solid_ball(1, 0.5, {0, 0.5, 0}), world_.shapes[0] = Sphere{0.5};
        world_.bodies[0].momentum = world_.bodies[0].mass * speed_ * scene_.downhill();
        engine_ = Engine(scene_.switches), steps_ = 0;
    }
    double time() const override { return static_cast<double>(steps_) * step_size(); }
    double step_size() const override { return 1 / 60.0; }
    void step() override { engine_.step(world_, step_size()), ++steps_; }
    std::string ended() const override {
        const bool over = way() > longest_;
        if (!over && time() < 5 - 1e-9) return {};
        const std::string end =
            over ? digits(longest_) + " m in " + digits(std::round(100 * time()) / 100) + " s."
                 : digits(std::round(100 * way())) + " cm in five seconds.";
        if (ball_) return (slip() < 1e-6 ? "It rolls, " : "It slips, ") + end;
        if (velocity(world_.bodies[0]).norm() > 0.01) return "It slides, " + end;
        return way() < 0.01 ? "It has stuck for five seconds." : "It has come to rest, " + end;
    }

    pic::Drawing drawing(double) const override {
        pic::Drawing drawing;
        const double middle = longest_ / 2 - 0.3, half = longest_ / 2 + 0.9;
        drawing.stage({view() * Vector3(middle, 0, 0), half}).no_ground();
        drawing.add(box(view() * Vector3(middle, -0.1, 0), view(), {half, 0.1, 1.1},
                        pic::palette::steel, pic::Look::solid));
        const Body& body = world_.bodies[0];
        const Eigen::Matrix3d to = view() * turned();
        const double law =
            std::min(way_down(scene_.slope, scene_.friction, ball_, speed_, time()), longest_);
        const pic::Colour colour =
            scene_.switches.pyramid ? pic::palette::explicit_euler : pic::palette::symplectic;
        const Vector3 exact = view() * Vector3(law, 0.5, 0), here = to * body.position;
        const Eigen::Matrix3d turn = to * rotation_matrix(body.orientation);
        if (ball_) {
            drawing.add(pic::Ball{.centre = exact,
                                  .radius = 0.5,
                                  .colour = pic::palette::exact,
                                  .look = pic::Look::ghost});
            drawing.add(pic::Ball{.centre = here,
                                  .radius = 0.5,
                                  .colour = colour,
                                  .orientation = Quaternion(turn)});
        } else {
            drawing.add(
                box(exact, to, Vector3::Constant(0.5), pic::palette::exact, pic::Look::ghost));
            pic::Box block = box(here, turn, Vector3::Constant(0.5), colour, pic::Look::solid);
            block.marked = true;
            drawing.add(block);
        }
        const Vector3 top = here + view() * Vector3(0, 0.5, 0);
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
        for (const double x : {-1.2, longest_ + 0.6})
            for (const double y : {-0.1, 1.3})
                for (const double z : {-1.1, 1.1})
                    room.add(pic::Ball{.centre = view() * Vector3(x, y, z), .radius = 0.02});
        return pic::fit(room, {0.15, 0.4, 1}, size, {.margin = 0.03});
    }
    std::vector<live::Number> numbers() const override {
        using Trace = live::Number::Trace;
        const Vector3 v = velocity(world_.bodies[0]);
        const double dt = 1e-4, t = time();  // Coulomb's law is of the way
        const auto law = [&](double at) {
            return way_down(scene_.slope, scene_.friction, ball_, speed_, at);
        };
        std::vector<live::Number> all{
            {"time", t, "s"},
            {"speed", v.norm(), "m/s", Trace::linear},
            {"by Coulomb's law", t > 0 ? (law(t) - law(t - dt)) / dt : speed_, "m/s"},
            {"way", way(), "m"},
            {"lowest point slides at", slip(), "m/s", Trace::linear}};
        return all;
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
    /// How fast its lowest point slides [m/s].
    double slip() const {
        const Body& body = world_.bodies[0];
        return (velocity(body) + angular_velocity(body).cross(Vector3(0, -0.5, 0))).norm();
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
    bool ball_ = false;
    double speed_ = 0, longest_ = 5;  // [m/s], of the slope [m]
    long steps_ = 0;
};

const live::Entry entry{"slope", [] { return std::unique_ptr<live::Figure>(new LiveSlope); }};

}  // namespace

}  // namespace nutshell
