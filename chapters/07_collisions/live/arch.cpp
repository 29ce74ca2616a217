// An arch of stones without mortar: its thickness, its friction and the number of its stones in the
// reader's hand, and the line of thrust as the contacts pass it on. Press on a stone and let go: a
// ball flies there along the line of sight.
#include "../arch_drawings.hpp"
#include "../throwing.hpp"

namespace nutshell {

namespace {

class LiveArch : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override {
        return {{"four", "four sub-steps", {Family::symplectic, Mark::square}},
                {"sixteen", "sixteen sub-steps", {Family::symplectic, Mark::triangle}},
                {"keystone", "no keystone", {Family::explicit_one_step, Mark::circle}}};
    }
    std::vector<live::Slider> sliders() const override {
        return {{.name = "thickness",
                 .unit = "r",
                 .least = 0.06,
                 .most = 0.4,
                 .start = 0.15,
                 .logarithmic = false,
                 .mark = least_,
                 .mark_words = "statics: none is thinner"},
                {.name = "friction", .least = 0, .most = 1, .start = 0.7, .logarithmic = false},
                {.name = "stones",
                 .least = 5,
                 .most = 21,
                 .start = 11,
                 .logarithmic = false,
                 .whole = true}};
    }
    std::vector<live::State> states() const override {
        return {{.key = "stands",
                 .words = "0.15 of the radius thick",
                 .setting = {0, {0.15, 0.7, 11}},
                 .time = 2},
                {.key = "falls",
                 .words = "0.1 of the radius thick",
                 .setting = {0, {0.1, 0.7, 11}},
                 .time = 0.7,
                 .drawn = true},
                {.key = "slides",
                 .words = "thick, but smooth",
                 .setting = {0, {0.3, 0.2, 11}},
                 .time = 0.8},
                {.key = "keystone",
                 .words = "no keystone",
                 .setting = {2, {0.2, 0.7, 11}},
                 .time = 0.5}};
    }
    void begin(const live::Setting& setting) override {
        arch_ = Arch{};
        arch_.thickness = setting.values.at(0) * arch_.radius;
        arch_.friction = setting.values.at(1);
        arch_.stones = static_cast<int>(std::lround(setting.values.at(2)));
        arch_.switches.sub_steps = setting.choice == 1 ? 16 : 4;
        require(arch_.stones <= 50, "the figure takes 50 stones at most");
        world_ = arch_.start(), whole_ = setting.choice != 2;
        if (!whole_) {
            world_.bodies.erase(world_.bodies.begin() + arch_.stones / 2);
            world_.shapes.erase(world_.shapes.begin() + arch_.stones / 2);
        }
        allowed_ = thrusts(arch_), least_ = least_thickness(arch_) / arch_.radius;
        engine_ = Engine(arch_.switches), steps_ = 0, fell_ = -1, throw_ = {};
    }
    double time() const override { return static_cast<double>(steps_) * step_size(); }
    double step_size() const override { return 1 / 60.0; }
    double pace() const override { return 0.5; }
    void step() override {
        engine_.step(world_, step_size()), ++steps_;
        double top = 0;
        for (std::size_t i = 0; i < stones(); ++i)
            top = std::max(top, world_.bodies[i].position.y());
        if (fell_ < 0 && top < arch_.radius / 2) fell_ = time();
    }
    std::string ended() const override {
        if (fell_ >= 0 && time() > fell_ + 1)
            return "It fell: after " + digits(std::round(10 * fell_) / 10) +
                   " s no stone was above half of its height.";
        return time() > 60 ? "A minute is over: begin again." : std::string();
    }

    bool grab(const live::Ray& ray) override { return throw_.grab(world_, ray); }
    void drag(const live::Ray& ray) override { throw_.drag(world_, ray); }
    void release() override { throw_.release(world_, stones(), 100, 0.25, 6); }

    pic::Drawing drawing(double) const override {
        pic::Drawing drawing;
        add_arch(drawing, arch_, world_, stones());
        if (whole_ && steps_ > 0) add_thrust(drawing, arch_, passed());
        throw_.show(drawing, 0.25);
        return drawing;
    }
    pic::Size size() const override { return {640, 320}; }
    pic::Camera camera(pic::Size size) const override { return arch_camera(arch_, size); }
    std::vector<live::Number> numbers() const override {
        using Trace = live::Number::Trace;
        double thrust = 0;
        if (whole_)
            for (const Passed& joint : passed()) thrust += joint.force.x() / (arch_.stones + 1);
        return {{"crown sunk", whole_ ? 1000 * arch_.sunk(world_) : 0, "mm", Trace::linear},
                {"thrust", thrust / 1000, "kN", Trace::linear},
                {"statics: from", allowed_ ? allowed_->low / 1000 : 0, "kN"},
                {"to", allowed_ ? allowed_->high / 1000 : 0, "kN"},
                {"fastest", top_speed(world_), "m/s", Trace::logarithmic}};
    }
    std::vector<double> state() const override {
        std::vector<double> all;
        for (const Body& body : world_.bodies)
            for (const Vector3* v : {&body.position, &body.momentum, &body.angular_momentum})
                all.insert(all.end(), {v->x(), v->y(), v->z()});
        return all;
    }
    double page_tolerance() const override { return 1e-3; }  // sines, and stones that tumble

  private:
    std::size_t stones() const {
        return static_cast<std::size_t>(arch_.stones - (whole_ ? 0 : 1));
    }
    std::vector<Passed> passed() const {
        return passed_on(arch_, world_, engine_, step_size() / arch_.switches.sub_steps);
    }
    Arch arch_;
    World world_;
    Engine engine_;
    Throw throw_;
    std::optional<Range> allowed_;
    double least_ = 0.1046;  // of the radius, by statics
    bool whole_ = true;      // with its keystone
    double fell_ = -1;       // when [s]; negative: it stands
    long steps_ = 0;
};

const live::Entry entry{"arch", [] { return std::unique_ptr<live::Figure>(new LiveArch); }};

}  // namespace

}  // namespace nutshell
