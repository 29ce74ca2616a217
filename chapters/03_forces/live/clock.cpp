// One planet by two clocks: steps of equal time, and steps that shorten by themselves near the sun.
#include <nutshell/forces_methods.hpp>
#include <nutshell/live/run.hpp>
#include <nutshell/newton_scenes.hpp>
#include <nutshell/sentence.hpp>

namespace nutshell {

namespace pic = picture;

namespace {

class LiveClock : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override {
        return {{methods::verlet.key(), phrase("{}, equal times", methods::verlet),
                 methods::verlet.look},
                {methods::logarithmic_leapfrog.key(), methods::logarithmic_leapfrog.name,
                 methods::logarithmic_leapfrog.look}};
    }
    std::vector<live::Slider> sliders() const override {
        return {{.name = "steps an orbit", .least = 6, .most = 300, .start = 40, .whole = true}};
    }
    std::vector<live::State> states() const override {
        const double orbit = 2 * pi * 39.5 / 40;
        return {{.key = methods::verlet.key(),
                 .words = phrase("{}, equal times", methods::verlet),
                 .setting = {0, {40}},
                 .time = orbit},
                {.key = "leapfrog",
                 .words = methods::logarithmic_leapfrog.name,
                 .setting = {1, {40}},
                 .time = orbit,
                 .drawn = true},
                {.key = "few",
                 .words = phrase("{}, 12 steps", methods::logarithmic_leapfrog),
                 .setting = {1, {12}},
                 .time = orbit}};
    }

    void begin(const live::Setting& setting) override {
        steps_an_orbit_ = std::round(setting.values.at(0)), by_clock_ = setting.choice == 1;
        require_positive(steps_an_orbit_, "steps an orbit");
        equal_ = live::Run<PointMass>(std::tuple{methods::verlet}, 0, scene_);
        own_ = {scene_.start};
        previous_ = scene_.start.position;
        points_ = {previous_};
    }
    double time() const override { return by_clock_ ? own_.time : equal_.time; }
    double step_size() const override {
        if (!by_clock_) return 2 * pi / steps_an_orbit_;
        return leapfrog_(own_, scene_, 0.0, 2 * pi / steps_an_orbit_).time - own_.time;
    }
    double pace() const override { return 2 * pi / 6; }
    void step() override {
        previous_ = here();
        const double ds = 2 * pi / steps_an_orbit_;
        if (by_clock_)
            own_ = leapfrog_(own_, scene_, 0.0, ds);
        else
            equal_.step(ds);
        points_.push_back(here());
        if (points_.size() > 600) points_.erase(points_.begin(), points_.begin() + 100);
    }
    std::string ended() const override {
        if (here().norm() < 8) return {};
        return "The planet has left after " + digits(std::round(100 * time() / (2 * pi)) / 100) +
               " years.";
    }

    pic::Drawing drawing(double part) const override {
        pic::Drawing drawing;
        drawing.stage({{-0.6, 0, 0}, 1.3});
        drawing.ground(
            {.height = -0.06, .normal = Vector3::UnitZ(), .spacing = 0.5, .unit = "a"});
        drawing.add(pic::Trail{
            .points = ellipse_, .colour = pic::palette::exact, .dashed = true, .width = 3});
        drawing.add(pic::Ball{
            .centre = {0, 0, 0}, .radius = 0.08, .colour = pic::palette::gold, .shines = true});
        const auto shown = std::min(points_.size(), static_cast<std::size_t>(steps_an_orbit_));
        for (std::size_t i = points_.size() - shown; i < points_.size(); ++i)
            drawing.add(pic::Ball{.centre = points_[i],
                                  .radius = 0.03,
                                  .colour = pic::palette::symplectic,
                                  .contact_shadow = true});
        drawing.add(pic::Ball{.centre = previous_ + part * (here() - previous_),
                              .radius = 0.055,
                              .colour = pic::palette::symplectic,
                              .contact_shadow = true});
        drawing.add(pic::Ball{.centre = scene_.exact(time()).position,
                              .radius = 0.055,
                              .colour = pic::palette::exact,
                              .look = pic::Look::ghost});
        return drawing;
    }
    pic::Size size() const override { return {640, 520}; }
    pic::Camera camera(pic::Size size) const override {
        pic::Drawing all;
        all.add(
            pic::Trail{.points = {{-2, -1.1, 0}, {0.55, -1.1, 0}, {0.55, 1.1, 0}, {-2, 1.1, 0}}});
        return pic::fit(all, {0, 0, 1}, size, {.margin = 0.03});
    }
    std::vector<live::Number> numbers() const override {
        using Trace = live::Number::Trace;
        const double start = scene_.energy(scene_.start);
        const PointMass& body = by_clock_ ? own_.body : equal_.newest;
        return {{"time", time() / (2 * pi), "years"},
                {"error", scene_.error(body, time()), "a", Trace::logarithmic},
                {"energy", 100 * (scene_.energy(body) - start) / -start, "%", Trace::linear},
                {"this step", step_size() / (2 * pi), "years"}};
    }
    std::vector<double> state() const override {
        const PointMass& body = by_clock_ ? own_.body : equal_.newest;
        return {body.position.x(), body.position.y(), body.velocity.x(), body.velocity.y(),
                time()};
    }

  private:
    Vector3 here() const { return by_clock_ ? own_.body.position : equal_.newest.position; }
    static std::vector<Vector3> exact_path() {
        std::vector<Vector3> points;
        const Planet planet;
        for (int i = 0; i <= 200; ++i) points.push_back(planet.exact(2 * pi * i / 200).position);
        return points;
    }
    Planet scene_;
    LogHamiltonian leapfrog_{scene_.gm, scene_.start};
    live::Run<PointMass> equal_;
    TimedPlanet own_;
    Vector3 previous_ = scene_.start.position;
    std::vector<Vector3> points_, ellipse_ = exact_path();
    double steps_an_orbit_ = 40;
    bool by_clock_ = false;
};

const live::Entry entry{"clock", [] { return std::unique_ptr<live::Figure>(new LiveClock); }};

}  // namespace

}  // namespace nutshell
