// The break of pool, from impact to impact.
#include <nutshell/impact_scenes.hpp>
#include <nutshell/live/figure.hpp>
#include "../drawings.hpp"

namespace nutshell {

namespace {

class LivePool : public live::Figure {
  public:
    std::vector<live::Slider> sliders() const override {
        return {{.name = "restitution",
                 .unit = "",
                 .least = 0.5,
                 .most = 1,
                 .start = 0.95,
                 .logarithmic = false},
                {.name = "off the line",
                 .unit = "mm",
                 .least = -25,
                 .most = 25,
                 .start = 5,
                 .logarithmic = false}};
    }
    std::vector<live::State> states() const override {
        return {
            {.key = "break",
             .words = "0.35 s after the start",
             .setting = {0, {0.95, 5}},
             .time = 0.35},
            {.key = "elastic", .words = "without loss", .setting = {0, {1, 5}}, .time = 0.35}};
    }
    void begin(const live::Setting& setting) override {
        balls_ = pool_break(8, 1e-5, setting.values.at(1) / 1000);
        balls_.restitution = checked_restitution(setting.values.at(0));
        setting_ = setting;
        start_ = balls_.all, steps_ = 0, impacts_ = 0;
    }
    double time() const override { return static_cast<double>(steps_) * step_size(); }
    double step_size() const override { return 1 / 512.0; }
    double pace() const override { return 0.1; }
    void step() override {
        impacts_ += fly_by_events(balls_, step_size());
        ++steps_;
        if (time() > 0.5) begin(setting_);
    }
    pic::Drawing drawing(double) const override {
        pic::Drawing drawing;
        const double r = balls_.radius;
        drawing.stage({{0.2, 0, 0}, 1}).ground({.height = -r, .spacing = 0.1});
        for (std::size_t i = 0; i < balls_.all.size(); ++i) {
            const Vector3& p = balls_.all[i].position;
            drawing.add(pic::Ball{.centre = p,
                                  .radius = r,
                                  .colour = i == 0 ? pic::palette::gold : pic::palette::body});
            const Vector3 v = velocity(balls_.all[i]);
            if (v.norm() > 0.05)
                drawing.add(pic::Arrow{.from = p + Vector3(0, r, 0),
                                       .vector = 0.03 * v,
                                       .colour = pic::palette::velocity,
                                       .width = 4});
        }
        return drawing;
    }
    pic::Size size() const override { return {960, 480}; }
    pic::Camera camera(pic::Size size) const override {
        return camera_on({-0.7, 0, -0.5}, {1.1, 0, 0.5}, {0, 1.6, 1}, size);
    }
    std::vector<live::Number> numbers() const override {
        return {{"impacts", static_cast<double>(impacts_), ""},
                {"energy / start", kinetic_energy(balls_.all) / kinetic_energy(start_), ""},
                {"momentum off", (total_momentum(balls_.all) - total_momentum(start_)).norm(),
                 "kg m/s"}};
    }
    std::vector<double> state() const override {
        std::vector<double> all;
        for (const Particle& ball : balls_.all)
            for (const Vector3& v : {ball.position, ball.momentum})
                all.push_back(v.x()), all.push_back(v.z());
        return all;
    }

  private:
    Balls balls_;
    std::vector<Particle> start_;
    live::Setting setting_;
    long steps_ = 0, impacts_ = 0;
};

const live::Entry entry{"pool", [] { return std::unique_ptr<live::Figure>(new LivePool); }};

}  // namespace

}  // namespace nutshell
