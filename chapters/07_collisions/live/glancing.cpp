// A glancing hit of two equal balls: along the normal, and as printed.
#include <nutshell/impact_scenes.hpp>
#include <nutshell/live/figure.hpp>
#include "../drawings.hpp"

namespace nutshell {

namespace {

class LiveGlancing : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override {
        return {{"normal", "along the normal", {Family::symplectic, Mark::square}},
                {"printed", "as printed", {Family::explicit_one_step, Mark::circle}}};
    }
    std::vector<live::Slider> sliders() const override {
        return {{.name = "restitution",
                 .unit = "",
                 .least = 0,
                 .most = 1,
                 .start = 1,
                 .logarithmic = false},
                {.name = "beside the centre",
                 .unit = "m",
                 .least = 0,
                 .most = 0.95,
                 .start = 0.7,
                 .logarithmic = false}};
    }
    std::vector<live::State> states() const override {
        return {
            {.key = "normal",
             .words = "along the normal",
             .setting = {0, {1, 0.7}},
             .time = 2.25},
            {.key = "printed", .words = "as printed", .setting = {1, {1, 0.7}}, .time = 2.25}};
    }
    void begin(const live::Setting& setting) override {
        choice_ = setting.choice;
        scene_ = TwoBalls::glancing(setting.values.at(1));
        scene_.restitution = checked_restitution(setting.values.at(0));
        for (Particle* body : {&scene_.a, &scene_.b}) drift(*body, -impact);
        met_ = false, steps_ = 0;
        path_a_ = {scene_.a.position}, path_b_ = {scene_.b.position};
    }
    double time() const override { return static_cast<double>(steps_) * step_size(); }
    double step_size() const override { return 1 / 64.0; }
    double pace() const override { return 0.7; }
    void step() override {
        ++steps_;
        if (!met_ && time() == impact) {
            advance(step_size());
            if (choice_ == 0)
                collide(scene_.a, scene_.b, scene_.normal(), scene_.restitution);
            else
                collide_as_printed(scene_.a, scene_.b, scene_.restitution);
            met_ = true;
        } else {
            advance(step_size());
        }
        path_a_.push_back(scene_.a.position), path_b_.push_back(scene_.b.position);
        if (time() > 4) begin_again();
    }
    pic::Drawing drawing(double) const override {
        pic::Drawing drawing;
        drawing.stage({{0, 0, 0}, 3.2}).ground({.height = -0.5, .spacing = 1});
        if (path_a_.size() > 1) {
            drawing.add(trail(path_a_, pic::palette::gold));
            drawing.add(trail(path_b_, pic::palette::body));
        }
        drawing.add(pic::Ball{
            .centre = seen(scene_.a.position), .radius = 0.5, .colour = pic::palette::gold});
        drawing.add(pic::Ball{
            .centre = seen(scene_.b.position), .radius = 0.5, .colour = pic::palette::body});
        for (const Particle* body : {&scene_.a, &scene_.b})
            if (body->momentum.norm() > 1e-9)
                drawing.add(pic::Arrow{.from = seen(body->position) + Vector3(0, 0.51, 0),
                                       .vector = 0.5 * seen(velocity(*body)),
                                       .colour = pic::palette::velocity});
        return drawing;
    }
    pic::Size size() const override { return {960, 440}; }
    pic::Camera camera(pic::Size size) const override {
        return camera_on({-3.6, -0.5, -3.3}, {3.2, -0.5, 1.9}, {0, 2, 1}, size);
    }
    std::vector<live::Number> numbers() const override {
        const Vector3 va = velocity(scene_.a), vb = velocity(scene_.b);
        const double size = va.norm() * vb.norm();
        const double angle =
            size > 0 ? std::acos(std::clamp(va.dot(vb) / size, -1.0, 1.0)) * 180 / pi : 0;
        return {{"angle between them", angle, "°"},
                {"energy / start", (kinetic_energy(scene_.a) + kinetic_energy(scene_.b)) / 2, ""},
                {"momentum along", scene_.a.momentum.x() + scene_.b.momentum.x(), "kg m/s"}};
    }
    std::vector<double> state() const override {
        return {scene_.a.position.x(), scene_.a.position.y(), scene_.b.position.x(),
                scene_.b.position.y(), scene_.a.momentum.x(), scene_.a.momentum.y(),
                scene_.b.momentum.x(), scene_.b.momentum.y()};
    }

  private:
    static constexpr double impact = 1.5;  // [s], a whole number of steps

    static Vector3 seen(const Vector3& v) { return {v.x(), 0, -v.y()}; }  // on a table
    static pic::Trail trail(const std::vector<Vector3>& path, pic::Colour colour) {
        pic::Trail line{.points = {}, .colour = colour, .width = 5};
        for (const Vector3& p : path) line.points.push_back(seen(p) + Vector3(0, -0.49, 0));
        return line;
    }
    void advance(double dt) { drift(scene_.a, dt), drift(scene_.b, dt); }
    void begin_again() { begin({choice_, {scene_.restitution, offset()}}); }
    double offset() const { return path_a_.front().y(); }

    TwoBalls scene_;
    std::vector<Vector3> path_a_, path_b_;
    int choice_ = 0;
    bool met_ = false;
    long steps_ = 0;
};

const live::Entry entry{"glancing",
                        [] { return std::unique_ptr<live::Figure>(new LiveGlancing); }};

}  // namespace

}  // namespace nutshell
