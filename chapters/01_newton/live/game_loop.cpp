// The throw in two game loops on five machines, one of them as slow and one with as long a hitch
// as the sliders say.
#include <algorithm>
#include <array>
#include <nutshell/live/figure.hpp>
#include "../frames.hpp"

namespace nutshell {

namespace pic = picture;

namespace {

class LiveGameLoop : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override {
        return {{"following", "the step follows the frame", {}},
                {"fixed", "fixed steps, drawn between", {}}};
    }
    std::vector<live::Slider> sliders() const override {
        return {{.name = "slow machine",
                 .unit = "Hz",
                 .least = 4,
                 .most = 144,
                 .start = 30,
                 .whole = true},
                {.name = "hitch",
                 .unit = "s",
                 .least = 0,
                 .most = 1,
                 .start = 0.5,
                 .logarithmic = false}};
    }
    std::vector<live::State> states() const override {
        return {
            {.key = "following",
             .words = "the step follows the frame",
             .setting = {0, {30, 0.5}},
             .time = 3},
            {.key = "fixed",
             .words = "fixed steps, drawn between",
             .setting = {1, {30, 0.5}},
             .time = 3,
             .drawn = true},
            {.key = "slow", .words = "a machine of 8 Hz", .setting = {0, {8, 0.5}}, .time = 3}};
    }

    void begin(const live::Setting& setting) override {
        fixed_ = setting.choice == 1;
        require_positive(setting.values.at(0), "the slow machine's frames a second");
        seats_.clear();
        for (Machine machine : machines()) {
            if (machine.hertz == 30) {
                machine.hertz = setting.values.at(0);
                machine.label = digits(std::round(machine.hertz)) + " Hz";
            }
            if (machine.hitch > 0) machine.hitch = setting.values.at(1);
            seats_.push_back(
                {machine, frame_times(machine, scene_.duration), {}, {scene_.start.position}});
        }
        ticks_ = 0;
    }
    double time() const override { return static_cast<double>(ticks_) * tick; }
    double step_size() const override { return tick; }
    /// A moment passes; whoever has finished a frame shows it.
    void step() override {
        ++ticks_;
        for (Seat& seat : seats_)
            while (seat.next < seat.frames.size() &&
                   seat.shown.time + seat.frames[seat.next] <= time() + tick / 2) {
                seat.shown = seat.player.frame(seat.frames[seat.next++]);
                seat.path.push_back(ball_of(seat));
            }
    }
    std::string ended() const override {
        if (time() < scene_.duration) return {};
        double low = 1e9, high = -1e9;
        for (const Seat& seat : seats_)
            low = std::min(low, above(seat)), high = std::max(high, above(seat));
        return "After three seconds the five balls are " +
               digits(std::round(100 * (high - low))) + " cm apart.";
    }

    pic::Drawing drawing(double) const override {
        pic::Drawing drawing;
        drawing.stage({{15, 5, 0}, 17});
        drawing.ground({.height = -2.6, .spacing = 5});
        std::vector<Vector3> exact;
        for (int n = 0; n <= 100; ++n)
            exact.push_back(scene_.exact(scene_.duration * n / 100).position);
        drawing.add(pic::Trail{
            .points = exact, .colour = pic::palette::exact, .dashed = true, .width = 3});
        for (const Seat& seat : seats_) {
            if (seat.path.size() > 1)
                drawing.add(pic::Trail{
                    .points = seat.path, .colour = pic::palette::symplectic, .width = 2.5});
            drawing.add(pic::Ball{.centre = ball_of(seat),
                                  .radius = 0.28,
                                  .colour = pic::palette::symplectic,
                                  .contact_shadow = true});
        }
        label(drawing);
        return drawing;
    }
    pic::Size size() const override { return {800, 600}; }
    pic::Camera camera(pic::Size size) const override {
        pic::Drawing all;
        all.add(pic::Trail{.points = {{0, -3, 0}, {46, -3, 0}, {15, 13, 0}}});
        return pic::fit(all, {0.1, 0.12, 1}, size, {.margin = 0.05});
    }
    std::vector<live::Number> numbers() const override {
        std::vector<live::Number> all{{"time", time(), "s"}};
        for (const Seat& seat : seats_)
            all.push_back(
                {seat.machine.label, 100 * above(seat), "cm", live::Number::Trace::linear});
        return all;
    }
    std::vector<double> state() const override {
        std::vector<double> all;
        for (const Seat& seat : seats_)
            for (const Vector3& v : {seat.shown.following, seat.shown.fixed})
                all.insert(all.end(), {v.x(), v.y(), v.z()});
        return all;
    }

  private:
    struct Seat {
        Machine machine;
        std::vector<double> frames;
        Player player;
        std::vector<Vector3> path;
        Shown shown = Player().shown();
        std::size_t next = 0;
    };
    static constexpr double tick = 1.0 / 720;  // finer than any machine's frame [s]

    Vector3 ball_of(const Seat& seat) const {
        return fixed_ ? seat.shown.fixed : seat.shown.following;
    }
    /// Height above the exact path at the time of what is shown [m].
    double above(const Seat& seat) const {
        return (ball_of(seat) - scene_.exact(seat.shown.time).position).y();
    }
    /// The machines' names in a column beside their balls, the highest first: the balls are too near
    /// each other for names of their own.
    void label(pic::Drawing& drawing) const {
        std::vector<const Seat*> order;
        for (const Seat& seat : seats_) order.push_back(&seat);
        std::stable_sort(order.begin(), order.end(), [this](const Seat* a, const Seat* b) {
            return ball_of(*a).y() > ball_of(*b).y();
        });
        const double away = 2, apart = 3;  // [m]
        Vector3 at = ball_of(*order.front()) + Vector3(away, 2 * apart, 0);
        for (const Seat* seat : order) {
            std::string words = seat->machine.label;
            if (time() >= scene_.duration)
                words += ": " + digits(std::round(100 * std::abs(above(*seat)))) + " cm off";
            drawing.add(pic::Trail{.points = {ball_of(*seat), at},
                                   .colour = pic::palette::steel,
                                   .width = 1,
                                   .shadow = false});
            drawing.add(pic::Label{.at = at, .text = words});
            at.y() -= apart;
        }
    }

    ThrownBall scene_;
    bool fixed_ = false;
    long ticks_ = 0;
    std::vector<Seat> seats_;
};

const live::Entry entry{"game_loop",
                        [] { return std::unique_ptr<live::Figure>(new LiveGameLoop); }};

}  // namespace

}  // namespace nutshell
