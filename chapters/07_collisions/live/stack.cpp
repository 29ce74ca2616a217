// A stack of boxes, with every switch of the engine in the reader's hand. Press on a box and let
// go: a ball flies there along the line of sight.
#include "../throwing.hpp"

namespace nutshell {

namespace {

class LiveStack : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override {
        const Look off{Family::explicit_one_step, Mark::circle};
        return {{"all", "everything on", {Family::symplectic, Mark::square}},
                {"cold", "no warm start", off},
                {"one", "one sub-step", off},
                {"hard", "hard contacts", off},
                {"naive", "once round, nothing remembered", off}};
    }
    std::vector<live::Slider> sliders() const override {
        return {{.name = "boxes",
                 .least = 2,
                 .most = 20,
                 .start = 10,
                 .logarithmic = false,
                 .whole = true},
                {.name = "ball", .unit = "m/s", .least = 2, .most = 40, .start = 15}};
    }
    std::vector<live::State> states() const override {
        return {{.key = "naive",
                 .words = "once round, nothing remembered",
                 .setting = {4, {10, 15}},
                 .time = 1.5},
                {.key = "all",
                 .words = "everything on",
                 .setting = {0, {10, 15}},
                 .time = 3,
                 .drawn = true}};
    }
    void begin(const live::Setting& setting) override {
        Stack scene;
        scene.boxes = static_cast<int>(std::lround(setting.values.at(0)));
        speed_ = setting.values.at(1);
        require_positive(speed_, "the ball's speed [m/s]");
        require(scene.boxes >= 1 && scene.boxes <= 100, "the stack takes 1 to 100 boxes");
        world_ = scene.start(), boxes_ = scene.boxes;
        engine_ = Engine(switches_of(setting.choice));
        steps_ = 0, throw_ = {};
    }
    void change(const live::Setting& setting) override {
        if (std::lround(setting.values.at(0)) != boxes_) return begin(setting);
        speed_ = setting.values.at(1);
        require_positive(speed_, "the ball's speed [m/s]");
        engine_.on = switches_of(setting.choice);
    }
    double time() const override { return static_cast<double>(steps_) * step_size(); }
    double step_size() const override { return 1 / 60.0; }
    void step() override { engine_.step(world_, step_size()), ++steps_; }
    std::string ended() const override {
        return time() > 60 ? "A minute is over: begin again." : std::string();
    }

    bool grab(const live::Ray& ray) override { return throw_.grab(world_, ray); }
    void drag(const live::Ray& ray) override { throw_.drag(world_, ray); }
    void release() override {
        throw_.release(world_, static_cast<std::size_t>(boxes_), 2, 0.3, speed_);
    }

    pic::Drawing drawing(double) const override {
        pic::Drawing drawing;
        drawing.stage({{0, boxes_ / 2.0, 0}, 0.8 * boxes_ + 1.5});
        drawing.ground({.height = 0, .spacing = 1});
        const auto boxes = static_cast<std::size_t>(boxes_);
        for (std::size_t i = 0; i < world_.bodies.size(); ++i)
            add_body(drawing, world_, i,
                     i < boxes ? layer_colour(i, boxes) : pic::palette::explicit_euler);
        throw_.show(drawing, 0.3);
        return drawing;
    }
    pic::Size size() const override { return {480, 600}; }
    pic::Camera camera(pic::Size size) const override {
        pic::Drawing room;
        room.add(pic::Box{.pose = Eigen::Isometry3d(Eigen::Translation3d(0, boxes_ / 2.0, 0)),
                          .half_extents = {2.2, boxes_ / 2.0, 0.8}});
        return pic::fit(room, {0.5, 0.22, 1}, size, {.margin = 0.05});
    }
    std::vector<live::Number> numbers() const override {
        using Trace = live::Number::Trace;
        World stack = world_;
        stack.bodies.resize(static_cast<std::size_t>(boxes_));
        stack.shapes.resize(stack.bodies.size());
        return {{"drift", 1000 * Stack{}.drift(stack), "mm", Trace::logarithmic},
                {"overlap", 1000 * deepest_overlap(stack), "mm", Trace::linear},
                {"fastest", top_speed(world_), "m/s", Trace::logarithmic}};
    }
    std::vector<double> state() const override {
        std::vector<double> all;
        for (const Body& body : world_.bodies)
            for (const Vector3* v : {&body.position, &body.momentum, &body.angular_momentum})
                all.insert(all.end(), {v->x(), v->y(), v->z()});
        return all;
    }

  private:
    static Switches switches_of(int choice) {
        switch (choice) {
            case 1:
                return {.warm_start = false};
            case 2:
                return {.sub_steps = 1};
            case 3:
                return {.soft = false};
            case 4:
                return {.sub_steps = 1, .relaxing = 0, .warm_start = false};
            default:
                return {};
        }
    }
    World world_;
    Engine engine_;
    int boxes_ = 10;
    long steps_ = 0;
    double speed_ = 15;
    Throw throw_;
};

const live::Entry entry{"stack", [] { return std::unique_ptr<live::Figure>(new LiveStack); }};

}  // namespace

}  // namespace nutshell
