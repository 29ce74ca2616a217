// A thrown spanner: its centre draws a parabola, whatever the rest of it does.
#include <nutshell/live/run.hpp>
#include <nutshell/rigid_methods.hpp>
#include <nutshell/sentence.hpp>
#include "../top_drawings.hpp"

namespace nutshell {

namespace {

constexpr double times = 2.5;  // the spanner is drawn larger than it is, and so is its tip's way

constexpr std::tuple that_throw_it{methods::kick_magnus_kick, methods::verlet,
                                   methods::printed_step, methods::corrected_step,
                                   methods::engine_step_without_gyroscopic};

class LiveThrown : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override { return live::choices_of(that_throw_it); }
    std::vector<live::Slider> sliders() const override {
        return {{.name = "steps a second", .least = 5, .most = 240, .start = 60, .whole = true}};
    }
    std::vector<live::State> states() const override {
        return {{.key = "magnus", .words = "Magnus' step", .setting = {0, {60}}, .time = 1},
                {.key = "printed",
                 .words = "as printed",
                 .setting = {2, {60}},
                 .time = 1,
                 .drawn = true},
                {.key = "missing",
                 .words = "without the gyroscopic term",
                 .setting = {4, {60}},
                 .time = 1},
                {.key = "coarse",
                 .words = phrase("{}, 15 steps", methods::verlet),
                 .setting = {1, {15}},
                 .time = 1}};
    }
    void begin(const live::Setting& setting) override {
        rate_ = std::round(setting.values.at(0));
        require_positive(rate_, "steps a second");
        run_ = live::Run<Body>(that_throw_it, setting.choice, scene_);
        family_ = choices().at(static_cast<std::size_t>(setting.choice)).look.family;
        shown_ = {run_.newest};
    }
    double time() const override { return run_.time; }
    double step_size() const override { return 1 / rate_; }
    double pace() const override { return 0.3; }
    void step() override {
        run_.step(step_size());
        if (run_.time > scene_.duration * (1 + 1e-9)) {  // it is thrown once more
            run_.newest = run_.previous = scene_.start, run_.time = 0;
            shown_ = {scene_.start};
            return;
        }
        shown_.push_back(run_.newest);
    }
    pic::Drawing drawing(double) const override {
        pic::Drawing drawing;
        drawing.ground({.height = 0.35, .spacing = 0.5});
        std::vector<Vector3> parabola, tip, exact_tip;
        for (int i = 0; i <= 60; ++i) parabola.push_back(scene_.exact(i / 60.).position);
        for (int i = 0; i <= 200; ++i) {
            const double t = time() * i / 200;
            exact_tip.push_back(point_of(scene_.exact(t), times * scene_.tip));
        }
        for (const Body& body : shown_) tip.push_back(point_of(body, times * scene_.tip));
        drawing.add(pic::Trail{
            .points = parabola, .colour = pic::palette::velocity, .dashed = true, .width = 3});
        if (tip.size() > 1) {
            drawing.add(pic::Trail{.points = exact_tip,
                                   .colour = pic::palette::ink,
                                   .dashed = true,
                                   .width = 2,
                                   .opacity = 0.6});
            drawing.add(pic::Trail{.points = tip, .colour = colour_of(family_), .width = 4});
        }
        // as a stroboscope shows it: seven flashes in the second
        const double flash = scene_.duration / 6;
        double next = 0;
        for (std::size_t i = 0; i < shown_.size(); ++i) {
            const double t = static_cast<double>(i) * step_size();
            const bool last = i + 1 == shown_.size();
            if (t + 1e-9 < next && !last) continue;
            if (t + 1e-9 >= next) next += flash;
            const Body exact = scene_.exact(t);
            if (angle_between(exact.orientation, shown_[i].orientation) > 0.1)
                add_spanner(drawing, exact.orientation, exact.position, times, pic::palette::ink,
                            pic::Look::ghost);
            add_spanner(drawing, shown_[i].orientation, shown_[i].position, times,
                        pic::palette::body);
            drawing.add(pic::Ball{
                .centre = shown_[i].position, .radius = 0.014, .colour = pic::palette::velocity});
        }
        return drawing;
    }
    pic::Size size() const override { return {960, 600}; }
    pic::Camera camera(pic::Size size) const override {
        pic::Drawing room;
        for (const double x : {-0.3, 3.3})
            for (const double y : {0.4, 2.75})
                room.add(pic::Ball{.centre = {x, y, 0}, .radius = 0.02});
        return pic::fit(room, {0.12, 0.1, 1}, size, {.margin = 0.01});
    }
    std::vector<live::Number> numbers() const override {
        using Trace = live::Number::Trace;
        return {{"centre off the parabola",
                 1000 * (run_.newest.position - scene_.exact(time()).position).norm(), "mm"},
                {"tip off", 1000 * scene_.error(run_.newest, time()), "mm", Trace::linear}};
    }
    std::vector<double> state() const override {
        const Body& b = run_.newest;
        return {b.position.x(),    b.position.y(),    b.position.z(),   b.orientation.x(),
                b.orientation.y(), b.orientation.z(), b.orientation.w()};
    }
    double page_tolerance() const override { return 1e-9; }  // sin and cos in every step

  private:
    ThrownSpanner scene_;
    live::Run<Body> run_{that_throw_it, 0, scene_};
    Family family_ = Family::exponential;
    double rate_ = 60;
    std::vector<Body> shown_;
};

const live::Entry entry{"thrown", [] { return std::unique_ptr<live::Figure>(new LiveThrown); }};

}  // namespace

}  // namespace nutshell
