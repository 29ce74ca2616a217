// The planet of chapter 1: one orbit after another, by each of the three methods.
#include <nutshell/live/run.hpp>
#include <nutshell/newton_methods.hpp>
#include <nutshell/newton_scenes.hpp>
#include <nutshell/sentence.hpp>

namespace nutshell {

namespace pic = picture;

namespace {

class LivePlanet : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override {
        return live::choices_of(newton_methods);
    }
    std::vector<live::Slider> sliders() const override {
        return {{.name = "steps a year", .least = 20, .most = 2000, .start = 100, .whole = true}};
    }
    std::vector<live::State> states() const override {
        return {{.key = methods::euler.key(),
                 .words = phrase("{}, 1000 steps a year", methods::euler),
                 .setting = {0, {1000}},
                 .time = 6 * 2 * pi},
                {.key = methods::verlet.key(),
                 .words = phrase("{}, 100 steps a year", methods::verlet),
                 .setting = {2, {100}},
                 .time = 20 * 2 * pi,
                 .drawn = true}};
    }

    void begin(const live::Setting& setting) override {
        steps_a_year_ = std::round(setting.values.at(0));
        require_positive(steps_a_year_, "steps a year");
        method_ = setting.choice;
        run_ = live::Run<PointMass>(newton_methods, method_, scene_);
        trail_ = {scene_.start.position};
        low_ = {-1.6, -0.8, 0}, high_ = {0.4, 0.8, 0};  // of the ellipse
        farthest_ = 0;
    }
    double time() const override { return run_.time; }
    double step_size() const override { return 2 * pi / steps_a_year_; }
    double pace() const override { return 2 * pi / 6; }  // a year in six seconds
    void step() override {
        run_.step(step_size());
        const auto every = static_cast<long>(std::ceil(steps_a_year_ / 200));
        if (run_.steps % every == 0) trail_.push_back(run_.newest.position);
        if (trail_.size() > 5000) trail_.erase(trail_.begin(), trail_.begin() + 1000);
        farthest_ = std::max(farthest_, run_.newest.position.norm());
        low_ = low_.cwiseMin(run_.newest.position), high_ = high_.cwiseMax(run_.newest.position);
    }
    std::string ended() const override {
        if (farthest_ < 8) return {};
        return "The planet has left: it is eight times as far from the sun as it should be on "
               "average, after " +
               digits(std::round(10 * years()) / 10) + " years.";
    }

    pic::Drawing drawing(double part) const override {
        const pic::Colour colour =
            method_ == 0 ? pic::palette::explicit_euler : pic::palette::symplectic;
        const Vector3 here = run_.position(part);
        const double shown = std::max(0.0, time() - (1 - part) * step_size());
        pic::Drawing drawing;
        drawing.stage({{-0.6, 0, 0}, std::max(1.3, farthest_)});
        drawing.ground(
            {.height = -0.25, .normal = Vector3::UnitZ(), .spacing = 0.5, .unit = "a"});
        drawing.add(pic::Trail{
            .points = ellipse_, .colour = pic::palette::ink, .dashed = true, .width = 3});
        std::vector<Vector3> path = trail_;
        path.push_back(here);
        drawing.add(
            pic::Trail{.points = path, .colour = colour, .width = 2.5, .opacity_at_start = 0.4});
        drawing.add(pic::Ball{
            .centre = {0, 0, 0}, .radius = 0.06, .colour = pic::palette::gold, .shines = true});
        drawing.add(
            pic::Ball{.centre = here, .radius = 0.06, .colour = colour, .contact_shadow = true});
        drawing.add(pic::Ball{.centre = scene_.exact(shown).position,
                              .radius = 0.06,
                              .colour = pic::palette::exact,
                              .look = pic::Look::ghost});
        return drawing;
    }
    pic::Size size() const override { return {640, 560}; }
    pic::Camera camera(pic::Size size) const override {
        pic::Drawing all;
        all.add(pic::Trail{.points = ellipse_});
        all.add(pic::Trail{
            .points = {low_, {low_.x(), high_.y(), 0}, high_, {high_.x(), low_.y(), 0}}});
        return pic::fit(all, {-0.3, -1.0, 1.5}, size, {.margin = 0.08, .up = Vector3::UnitZ()});
    }
    std::vector<live::Number> numbers() const override {
        const double start = scene_.energy(scene_.start);
        using Trace = live::Number::Trace;
        return {
            {"time", years(), "years"},
            {"energy", 100 * (scene_.energy(run_.newest) - start) / -start, "%", Trace::linear},
            {"error", scene_.error(run_.newest, time()), "a", Trace::logarithmic}};
    }
    std::vector<double> state() const override {
        const auto &x = run_.newest.position, &v = run_.newest.velocity;
        return {x.x(), x.y(), x.z(), v.x(), v.y(), v.z()};
    }

  private:
    double years() const { return time() / (2 * pi); }
    static std::vector<Vector3> exact_path() {
        std::vector<Vector3> points;
        const Planet planet;
        for (int n = 0; n <= 300; ++n)
            points.push_back(planet.exact(planet.duration * n / 300).position);
        return points;
    }
    Planet scene_;
    live::Run<PointMass> run_;
    int method_ = 2;
    double steps_a_year_ = 100, farthest_ = 0;
    Vector3 low_, high_;  // corners of what it has filled
    std::vector<Vector3> trail_, ellipse_ = exact_path();
};

const live::Entry entry{"planet", [] { return std::unique_ptr<live::Figure>(new LivePlanet); }};

}  // namespace

}  // namespace nutshell
