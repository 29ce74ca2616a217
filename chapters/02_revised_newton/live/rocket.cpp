// The water rocket of chapter 2 with all that it has thrown down, and the books of momentum.
#include <nutshell/live/run.hpp>
#include <nutshell/newton_methods.hpp>
#include <nutshell/revised_newton_scenes.hpp>
#include <nutshell/sentence.hpp>

namespace nutshell {

namespace pic = picture;

namespace {

class LiveRocket : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override {
        return live::choices_of(newton_methods);
    }
    std::vector<live::Slider> sliders() const override {
        return {{.name = "step dt", .unit = "s", .least = 0.005, .most = 0.3, .start = 0.025}};
    }
    std::vector<live::State> states() const override {
        return {{.key = methods::verlet.key(),
                 .words = phrase("{}, 0.025 s", methods::verlet),
                 .setting = {2, {0.025}},
                 .time = 1.5},
                {.key = methods::euler.key(),
                 .words = phrase("{}, 0.15 s", methods::euler),
                 .setting = {0, {0.15}},
                 .time = 1.5}};
    }

    void begin(const live::Setting& setting) override {
        dt_ = setting.values.at(0), method_ = setting.choice;
        require_positive(dt_, "the step dt [s]");
        run_ = live::Run<RocketAndExhaust>(newton_methods, method_, books_);
        images_ = {run_.newest.rocket};
        last_image_ = 0;
    }
    double time() const override { return run_.time; }
    double step_size() const override {
        const double left = scene_.duration - time();
        return left > 1e-9 ? std::min(dt_, left) : dt_;
    }
    double pace() const override { return 0.5; }
    void step() override {
        run_.step(step_size());
        if (time() > last_image_ + 0.299) {
            last_image_ = time();
            images_.push_back(run_.newest.rocket);
        }
    }
    std::string ended() const override {
        if (time() < scene_.duration - 1e-9) return {};
        return "The water is used up after " + digits(time()) + " s, at a height of " +
               digits(std::round(100 * run_.newest.rocket.position.y()) / 100) + " m.";
    }

    pic::Drawing drawing(double part) const override {
        pic::Drawing drawing;
        drawing.stage({{2, 11, 0}, 14});
        drawing.ground({.height = 0, .spacing = 5});
        for (const Particle& image : images_)
            add_rocket(drawing, image, image.position, pic::Look::solid);
        const Particle &now = run_.newest.rocket, &before = run_.previous.rocket;
        add_rocket(drawing, now, before.position + part * (now.position - before.position),
                   pic::Look::solid);
        const Particle exact = scene_.exact(time());
        add_rocket(drawing, exact, exact.position, pic::Look::ghost);
        for (const Particle& parcel : run_.newest.exhaust)
            if (parcel.position.y() > 0)
                drawing.add(
                    pic::Ball{.centre = parcel.position, .radius = 0.22, .colour = water});
        return drawing;
    }
    pic::Size size() const override { return {620, 760}; }
    pic::Camera camera(pic::Size size) const override {
        pic::Drawing all;
        all.add(pic::Trail{.points = {{-3, 0, 0}, {7, 0, 0}, {7, 26, 0}, {-3, 26, 0}}});
        return pic::fit(all, {0.15, 0.15, 1}, size, {.margin = 0.04});
    }
    std::vector<live::Number> numbers() const override {
        using Trace = live::Number::Trace;
        const RocketAndExhaust& all = run_.newest;
        return {{"time", time(), "s"},
                {"height", all.rocket.position.y(), "m"},
                {"speed", velocity(all.rocket).norm(), "m/s"},
                {"error", scene_.error(all.rocket, time()), "m", Trace::logarithmic},
                {"momentum of all, off by",
                 (total_momentum(all) - books_.exact_momentum(time())).norm(), "kg m/s",
                 Trace::logarithmic}};
    }
    std::vector<double> state() const override {
        std::vector<double> all;
        const auto add = [&](const Particle& p) {
            for (const Vector3& v : {p.position, p.momentum})
                all.insert(all.end(), {v.x(), v.y(), v.z()});
        };
        add(run_.newest.rocket);
        for (const Particle& parcel : run_.newest.exhaust) add(parcel);
        return all;
    }

  private:
    inline static const pic::Colour water{0.337F, 0.706F, 0.914F};

    /// Blue: the share of its first mass that is left.
    void add_rocket(pic::Drawing& drawing, const Particle& rocket, const Vector3& at,
                    pic::Look look) const {
        const Vector3 axis = -scene_.start.flow.velocity.normalized(),
                      tail = at + Vector3(0, 0.4, 0);
        const double full = 2.2 * rocket.mass / scene_.start.mass;
        drawing.add(pic::Rod{.from = tail,
                             .to = tail + full * axis,
                             .radius = 0.42,
                             .colour = water,
                             .look = look});
        drawing.add(pic::Rod{.from = tail + full * axis,
                             .to = tail + 2.4 * axis,
                             .radius = 0.38,
                             .colour = pic::palette::steel,
                             .look = look});
        drawing.add(pic::Ball{.centre = tail + 2.4 * axis,
                              .radius = 0.38,
                              .colour = pic::palette::steel,
                              .look = look});
    }
    Rocket scene_ = Rocket::with_midway(water_rocket());
    RocketBooks books_{scene_};
    live::Run<RocketAndExhaust> run_;
    std::vector<Particle> images_;
    int method_ = 2;
    double dt_ = 0.025, last_image_ = 0;
};

const live::Entry entry{"rocket", [] { return std::unique_ptr<live::Figure>(new LiveRocket); }};

}  // namespace

}  // namespace nutshell
