// Where omega wanders in the body: along the curves in which the energy's ellipsoid is cut by
// that of L.
#include <nutshell/live/run.hpp>
#include <nutshell/rigid_methods.hpp>
#include "../top_drawings.hpp"

namespace nutshell {

namespace {

constexpr std::tuple that_wander{methods::kick_magnus_kick, methods::kick_split_kick,
                                 methods::corrected_step, methods::engine_step,
                                 methods::engine_step_without_gyroscopic};

/// A place on the ellipsoid of the flip's energy, as the arrow from the origin [rad/s].
Vector3 on_ellipsoid(const FreeBody& scene, const Vector3& direction) {
    const double e = direction.dot(scene.start.inertia.cwiseProduct(direction)) / 2;
    return direction * std::sqrt(scene.energy(scene.start) / e);
}

class LivePolhode : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override { return live::choices_of(that_wander); }
    std::vector<live::Slider> sliders() const override {
        return {{.name = "start off the middle axis",
                 .unit = "°",
                 .least = 0.5,
                 .most = 80,
                 .start = 4},
                {.name = "steps a second", .least = 5, .most = 240, .start = 60, .whole = true}};
    }
    std::vector<live::State> states() const override {
        return {{.key = "middle",
                 .words = "near the middle axis",
                 .setting = {0, {4, 60}},
                 .time = 7},
                {.key = "corrected",
                 .words = "with a constant ω in each step",
                 .setting = {2, {4, 60}},
                 .time = 14,
                 .drawn = true},
                {.key = "engine",
                 .words = methods::engine_step.name,
                 .setting = {3, {30, 20}},
                 .time = 9},
                {.key = "missing",
                 .words = "without the gyroscopic term",
                 .setting = {4, {30, 60}},
                 .time = 7}};
    }
    void begin(const live::Setting& setting) override {
        const double angle = setting.values.at(0) * pi / 180;
        rate_ = std::round(setting.values.at(1));
        require_positive(rate_, "steps a second");
        require(angle > 0 && angle < pi / 2, "the start must be off the middle axis");
        const Vector3 axis(std::sin(angle) * 0.6, std::cos(angle), std::sin(angle) * 0.8);
        scene_ = FreeBody("polhode", flip().start.inertia, on_ellipsoid(flip(), axis), 30,
                          flip().need);
        run_ = live::Run<Pinned>(that_wander, setting.choice, scene_);
        family_ = choices().at(static_cast<std::size_t>(setting.choice)).look.family;
        trail_ = {place(omega())};
    }
    double time() const override { return run_.time; }
    double step_size() const override { return 1 / rate_; }
    void step() override {
        run_.step(step_size());
        trail_.push_back(place(omega()));
        if (trail_.size() > 4000) trail_.erase(trail_.begin(), trail_.begin() + 1000);
    }
    std::string ended() const override {
        if (scene_.energy(run_.newest) < 20 * scene_.energy(scene_.start)) return {};
        return "It has twenty times the energy it began with.";
    }
    pic::Drawing drawing(double) const override {
        pic::Drawing drawing;
        drawing.stage({{0, 0, 0}, 3}).no_ground();
        add_ellipsoid(drawing);
        const std::vector<double> angles{12, 25, 40, 55, 70, 80};
        for (const int side : {0, 2})
            for (const double degrees : angles)
                for (const double sign : {-1., 1.}) {
                    Vector3 d = Vector3::Zero();
                    d[1] = std::cos(degrees * pi / 180),
                    d[side] = sign * std::sin(degrees * pi / 180);
                    drawing.add(pic::Trail{.points = path(on_ellipsoid(scene_, d)),
                                           .colour = pic::palette::ink,
                                           .width = 1.5,
                                           .opacity = 0.5});
                }
        drawing.add(pic::Trail{
            .points = path(scene_.start.angular_momentum.cwiseQuotient(scene_.start.inertia)),
            .colour = pic::palette::ink,
            .dashed = true,
            .width = 3});
        if (trail_.size() > 1)
            drawing.add(pic::Trail{.points = trail_, .colour = colour_of(family_), .width = 5});
        drawing.add(pic::Ball{
            .centre = place(omega()), .radius = 0.09, .colour = pic::palette::angular_velocity});
        const std::array<const char*, 3> names{"smallest moment", "middle", "largest"};
        for (int axis = 0; axis < 3; ++axis) {
            // the end of the axis that the camera sees
            const Vector3 out = (axis == 0 ? -1 : 1) * Vector3::Unit(axis);
            drawing.add(pic::Arrow{.from = on_ellipsoid(scene_, out),
                                   .vector = 0.45 * out,
                                   .colour = pic::palette::ink,
                                   .label = names[static_cast<std::size_t>(axis)],
                                   .width = 3});
        }
        return drawing;
    }
    pic::Size size() const override { return {560, 460}; }
    pic::Camera camera(pic::Size size) const override {
        pic::Drawing room;
        room.add(pic::Ball{.radius = 2.6});
        return pic::fit(room, {-0.7, 0.55, 1}, size, {.margin = 0.02});
    }
    std::vector<live::Number> numbers() const override {
        using Trace = live::Number::Trace;
        const Vector3 &L = run_.newest.angular_momentum, &L0 = scene_.start.angular_momentum;
        return {{"energy over its start",
                 scene_.energy(run_.newest) / scene_.energy(scene_.start), "", Trace::linear},
                {"|L| over its start", L.norm() / L0.norm(), "", Trace::linear}};
    }
    std::vector<double> state() const override {
        const Vector3 w = omega();
        return {w.x(), w.y(), w.z()};
    }
    double page_tolerance() const override { return 1e-8; }  // as of the flip

  private:
    Vector3 omega() const {
        return rotate(inverse(run_.newest.orientation), run_.newest.angular_momentum)
            .cwiseQuotient(run_.newest.inertia);
    }
    /// A little outside of the ellipsoid, so that the line lies on it.
    static Vector3 place(const Vector3& omega) { return 1.012 * omega; }
    /// The whole way of omega in the body, from this one on.
    std::vector<Vector3> path(const Vector3& from) const {
        const Vector3& I = scene_.start.inertia;
        const FreeTop top(I, Quaternion::Identity(), I.cwiseProduct(from));
        std::vector<Vector3> points;
        const double period = 2 * top.between_flips();
        for (int i = 0; i <= 90; ++i)
            points.push_back(place(top.in_body(period * i / 90).cwiseQuotient(I)));
        return points;
    }
    void add_ellipsoid(pic::Drawing& drawing) const {
        pic::Mesh mesh{.points = {},
                       .triangles = {},
                       .colour = pic::mix(pic::palette::steel, pic::palette::paper, 0.5F),
                       .smooth = true};
        constexpr int bands = 24, around = 48;
        for (int i = 0; i <= bands; ++i)
            for (int j = 0; j < around; ++j) {
                const double a = pi * i / bands, b = 2 * pi * j / around;
                mesh.points.push_back(on_ellipsoid(
                    scene_, {std::sin(a) * std::cos(b), std::cos(a), std::sin(a) * std::sin(b)}));
            }
        for (int i = 0; i < bands; ++i)
            for (int j = 0; j < around; ++j) {
                const int a = i * around + j, b = i * around + (j + 1) % around;
                if (i > 0) mesh.triangles.push_back({a, b, a + around});
                if (i + 1 < bands) mesh.triangles.push_back({b, b + around, a + around});
            }
        drawing.add(mesh);
    }
    FreeBody scene_ = flip();
    live::Run<Pinned> run_{that_wander, 0, scene_};
    Family family_ = Family::exponential;
    double rate_ = 60;
    std::vector<Vector3> trail_;
};

const live::Entry entry{"polhode", [] { return std::unique_ptr<live::Figure>(new LivePolhode); }};

}  // namespace

}  // namespace nutshell
