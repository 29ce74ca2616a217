// A heavy top: it nods, goes round steadily, sleeps or wakes, by how it is started.
#include <nutshell/live/run.hpp>
#include <nutshell/rigid_methods.hpp>
#include <nutshell/sentence.hpp>
#include "../top_drawings.hpp"

namespace nutshell {

namespace {

constexpr std::tuple that_spin_it{
    methods::yoshida4, methods::verlet,         methods::lie_rk4,
    methods::rk4,      methods::corrected_step, methods::engine_step_without_gyroscopic};

class LiveTop : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override { return live::choices_of(that_spin_it); }
    std::vector<live::Slider> sliders() const override {
        return {{.name = "spin",
                 .unit = "rad/s",
                 .least = 15,
                 .most = 60,
                 .start = 30,
                 .mark = sleeping_limit(standard_top()) / standard_top().along,
                 .mark_words = "wakes below"},
                {.name = "lean", .unit = "°", .least = 1, .most = 60, .start = 30},
                {.name = "sent round at",
                 .unit = "rad/s",
                 .least = 0,
                 .most = 10,
                 .start = 0,
                 .logarithmic = false,
                 .mark = slow_,
                 .mark_words = "steady"},
                {.name = "steps a second", .least = 10, .most = 240, .start = 60, .whole = true}};
    }
    std::vector<live::State> states() const override {
        const auto [slow, fast] = steady_precession(standard_top(), 3, pi / 6);
        return {{.key = "nodding",
                 .words = "let go: it nods",
                 .setting = {0, {30, 30, 0, 60}},
                 .time = 3.4},
                {.key = "slow",
                 .words = "sent round slowly",
                 .setting = {0, {30, 30, slow, 60}},
                 .time = 3.4,
                 .drawn = true},
                {.key = "fast",
                 .words = "sent round fast",
                 .setting = {0, {30, 30, fast, 60}},
                 .time = 3.4},
                {.key = "sleeping",
                 .words = "almost upright, 30 rad/s",
                 .setting = {0, {30, 1, 0, 60}},
                 .time = 6},
                {.key = "waking",
                 .words = "almost upright, 22 rad/s",
                 .setting = {0, {22, 1, 0, 60}},
                 .time = 6,
                 .drawn = true},
                {.key = "missing",
                 .words = "without the gyroscopic term",
                 .setting = {5, {30, 30, slow, 60}},
                 .time = 2},
                {.key = methods::rk4.key(),
                 .words = phrase("{}, 30 steps a second", methods::rk4),
                 .setting = {3, {30, 30, 0, 30}},
                 .time = 9}};
    }
    void begin(const live::Setting& setting) override {
        const Top top = standard_top();
        const double spin = setting.values.at(0), lean = setting.values.at(1) * pi / 180,
                     round = setting.values.at(2);
        rate_ = std::round(setting.values.at(3));
        require_positive(rate_, "steps a second");
        require(std::isfinite(spin) && std::isfinite(round) && lean > 0.001 && lean < pi,
                "the top must lean");
        Pinned body = leaning(top, lean);
        const Vector3 axis = rotate(body.orientation, {0, 0, 1}), up(0, 1, 0);
        const double L3 = top.along * spin;
        body.angular_momentum = L3 * axis + top.across * round * (up - axis.y() * axis);
        const double room = L3 * L3 - 4 * top.across * top.weight * std::cos(lean);
        slow_ = room > 0 ? steady_precession(top, L3, lean)[0] : 0;
        scene_ = {"top", 0.5, top, body, 10};
        run_ = live::Run<Pinned>(that_spin_it, setting.choice, scene_);
        family_ = choices().at(static_cast<std::size_t>(setting.choice)).look.family;
        path_ = {tip(body.orientation)}, exact_ = path_;
    }
    double time() const override { return run_.time; }
    double step_size() const override { return 1 / rate_; }
    double pace() const override { return 0.5; }
    void step() override {
        run_.step(step_size());
        path_.push_back(tip(run_.newest.orientation));
        const int parts = std::max(1, static_cast<int>(std::ceil(step_size() * 120)));
        for (int i = 1; i <= parts; ++i)
            exact_.push_back(
                tip(scene_.solution.pose(run_.time - step_size() * (1 - i / double(parts)))));
        for (auto* all : {&path_, &exact_})
            if (all->size() > 1600) all->erase(all->begin(), all->begin() + 400);
    }
    std::string ended() const override {
        if (scene_.energy(run_.newest) < 20 * scene_.energy(scene_.start)) return {};
        return "It has twenty times the energy it began with.";
    }
    pic::Drawing drawing(double part) const override {
        pic::Drawing drawing;
        drawing.stage({{0, 0.4, 0}, 1.15});
        drawing.ground({.height = -0.72, .spacing = 0.25});
        drawing.add(pic::Rod{.from = {0, -0.72, 0}, .to = {0, -0.02, 0}, .radius = 0.03});
        if (path_.size() > 1) {
            drawing.add(pic::Trail{.points = exact_,
                                   .colour = pic::palette::ink,
                                   .dashed = true,
                                   .width = 2.5,
                                   .opacity_at_start = 0.2});
            drawing.add(pic::Trail{.points = path_,
                                   .colour = colour_of(family_),
                                   .width = 4,
                                   .opacity_at_start = 0.15});
        }
        const Quaternion q = slerp(run_.previous.orientation, run_.newest.orientation, part);
        add_top(drawing, q, scene_.distance, pic::palette::body);
        const Vector3 c = scene_.centre(run_.newest);
        drawing.add(pic::Arrow{.from = c,
                               .vector = {0, -0.6, 0},
                               .colour = pic::palette::force,
                               .label = "m g",
                               .width = 5});
        drawing.add(pic::Arrow{.from = {0, 0, 0},
                               .vector = 0.4 * run_.newest.angular_momentum,
                               .colour = pic::palette::angular_momentum,
                               .label = "L",
                               .width = 5});
        return drawing;
    }
    pic::Size size() const override { return {440, 460}; }
    pic::Camera camera(pic::Size size) const override {
        pic::Drawing room;
        room.add(pic::Ball{.centre = {0, 0.2, 0}, .radius = 1.02});
        return pic::fit(room, {0.4, 0.35, 1}, size, {.margin = 0.01});
    }
    std::vector<live::Number> numbers() const override {
        using Trace = live::Number::Trace;
        const double lean =
            std::acos(std::clamp(rotate(run_.newest.orientation, {0, 0, 1}).y(), -1., 1.));
        return {{"lean", 180 / pi * lean, "°", Trace::linear},
                {"centre off", 1000 * scene_.error(run_.newest, time()), "mm", Trace::linear},
                {"energy over its start",
                 scene_.energy(run_.newest) / scene_.energy(scene_.start), ""}};
    }
    std::vector<double> state() const override {
        const Pinned& b = run_.newest;
        return {b.orientation.x(),     b.orientation.y(),      b.orientation.z(),
                b.orientation.w(),     b.angular_momentum.x(), b.angular_momentum.y(),
                b.angular_momentum.z()};
    }
    /// sin and cos in the start and in every step; near upright the motion doubles their last
    /// digit again and again.
    double page_tolerance() const override { return 1e-8; }

  private:
    static Vector3 tip(const Quaternion& q) { return rotate(q, Vector3(0, 0, 0.82)); }
    HeavyTopScene scene_ = nodding_top();
    live::Run<Pinned> run_{that_spin_it, 0, scene_};
    Family family_ = Family::symplectic;
    double rate_ = 60, slow_ = 0;
    std::vector<Vector3> path_, exact_;
};

const live::Entry entry{"top", [] { return std::unique_ptr<live::Figure>(new LiveTop); }};

}  // namespace

}  // namespace nutshell
