// A cube turned by many small turns: by (30) and (31) as printed, with the rows put right, and
// divided by the length each time.
#include <nutshell/live/figure.hpp>
#include "../drawings.hpp"

namespace nutshell {

namespace {

class LiveGrowing : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override {
        return {{"printed", "as printed", {Family::explicit_one_step, Mark::triangle_down}},
                {"rows", "rows put right", {Family::explicit_one_step, Mark::circle}},
                {"divided", "and divided", {Family::symplectic, Mark::diamond}}};
    }
    std::vector<live::Slider> sliders() const override {
        return {
            {.name = "steps in a turn", .least = 6, .most = 1000, .start = 40, .whole = true}};
    }
    std::vector<live::State> states() const override {
        return {{.key = "printed",
                 .words = "as printed, 1/10 turn",
                 .setting = {0, {40}},
                 .time = 0.1},
                {.key = "rows",
                 .words = "rows put right, 1 turn",
                 .setting = {1, {40}},
                 .time = 1,
                 .drawn = true},
                {.key = "divided",
                 .words = "and divided, 1 turn",
                 .setting = {2, {40}},
                 .time = 1,
                 .drawn = true}};
    }
    void begin(const live::Setting& setting) override {
        steps_a_turn_ = std::round(setting.values.at(0));
        require_positive(steps_a_turn_, "steps in a turn");
        choice_ = setting.choice;
        q_ = four_vector({0, 0, 0}, 1), steps_ = 0;
    }
    double time() const override { return static_cast<double>(steps_) / steps_a_turn_; }
    double step_size() const override { return 1 / steps_a_turn_; }  // in turns
    double pace() const override { return 0.25; }
    void step() override {
        const Vector3 beta = 2 * pi / steps_a_turn_ * axis_;
        const Eigen::Vector4d change = vector_product(beta, q_).coeffs() / 2;
        if (choice_ == 0)  // the scalar's row first
            q_ = Quaternion(Eigen::Vector4d(
                q_.coeffs() + Eigen::Vector4d(change[3], change[0], change[1], change[2])));
        else if (choice_ == 1)
            q_ = Quaternion(Eigen::Vector4d(q_.coeffs() + change));
        else
            q_ = small_turn(q_, beta);
        ++steps_;
    }
    std::string ended() const override {
        if (q_.norm() < 1.8) return {};
        return "The 4-vector is " + digits(std::round(100 * q_.norm()) / 100) + " long after " +
               digits(std::round(100 * time()) / 100) +
               " turns: its matrix is no rotation any more.";
    }
    pic::Drawing drawing(double) const override {
        const Quaternion exact = quaternion_about(axis_, 2 * pi * time());
        pic::Drawing drawing;
        drawing.stage({{0, 0, 0}, 1.25}).no_ground();
        add_frame(drawing, exact);
        add_cube(drawing, rotation_matrix(q_), {0, 0, 0},
                 choice_ == 2 ? pic::palette::symplectic : pic::palette::explicit_euler);
        return drawing;
    }
    pic::Size size() const override { return {420, 420}; }
    pic::Camera camera(pic::Size size) const override {
        pic::Drawing room;
        room.add(pic::Ball{.radius = 2.2});
        return pic::fit(room, {0.5, 0.6, 1}, size, {.margin = 0.02});
    }
    std::vector<live::Number> numbers() const override {
        const Quaternion exact = quaternion_about(axis_, 2 * pi * time());
        using Trace = live::Number::Trace;
        return {{"turns", time(), ""},
                {"length of the 4-vector", q_.norm(), "", Trace::linear},
                {"angle off", 180 / pi * angle_between(q_, exact), "°", Trace::linear}};
    }
    std::vector<double> state() const override { return {q_.x(), q_.y(), q_.z(), q_.w()}; }

  private:
    Vector3 axis_ = direction_of({1, 2, 3});
    Quaternion q_ = four_vector({0, 0, 0}, 1);
    int choice_ = 0;
    double steps_a_turn_ = 40;
    long steps_ = 0;
};

const live::Entry entry{"growing", [] { return std::unique_ptr<live::Figure>(new LiveGrowing); }};

}  // namespace

}  // namespace nutshell
