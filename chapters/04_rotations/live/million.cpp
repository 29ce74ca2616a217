// A cube turned a million times and more: what is left of it in float and in double.
#include <nutshell/live/figure.hpp>
#include <nutshell/many_turns.hpp>
#include "../drawings.hpp"

namespace nutshell {

namespace {

class LiveMillion : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override {
        return {{"printed",
                 "matrix, float, as printed",
                 {Family::explicit_one_step, Mark::triangle_down}},
                {"float", "4-vector, float", {Family::peer, Mark::circle}},
                {"divided", "4-vector, float, divided", {Family::symplectic, Mark::diamond}},
                {"double", "4-vector, double", {Family::exponential, Mark::circle}}};
    }
    std::vector<live::Slider> sliders() const override {
        return {{.name = "each turn", .unit = "rad", .least = 1e-4, .most = 0.5, .start = 0.008}};
    }
    std::vector<live::State> states() const override {
        return {{.key = "printed",
                 .words = "as printed, in float",
                 .setting = {0, {0.008}},
                 .time = 4},
                {.key = "divided",
                 .words = "4-vector in float, divided",
                 .setting = {2, {0.008}},
                 .time = 4,
                 .drawn = true},
                {.key = "tiny",
                 .words = "as printed, 0.0002 rad a turn",
                 .setting = {0, {2e-4}},
                 .time = 5}};
    }
    void begin(const live::Setting& setting) override {
        choice_ = setting.choice;
        scene_.angle = setting.values.at(0), scene_.turns = 0;
        require_positive(scene_.angle, "the angle of each turn [rad]");
        step_ = quaternion_about(scene_.axis, scene_.angle), pose_ = four_vector({0, 0, 0}, 1);
        float_step_ = step_.cast<float>(), float_pose_ = pose_.cast<float>();
        const Vector3 v = -scene_.angle * direction_of(scene_.axis);  // E51: it turns by -v
        printed_step_ = printed::rotation(v.cast<float>());
        printed_pose_ = Eigen::Matrix3f::Identity();
        look();
    }
    double time() const override { return 1e-6 * static_cast<double>(scene_.turns); }
    double step_size() const override { return 1e-3; }  // in millions: a step is a thousand turns
    double pace() const override { return 0.1; }
    void step() override {
        for (int turn = 0; turn < 1000; ++turn) {
            if (choice_ == 0) printed_pose_ = printed::product(printed_step_, printed_pose_);
            if (choice_ == 1 || choice_ == 2) float_pose_ = float_step_ * float_pose_;
            if (choice_ == 2) float_pose_.normalize();
            if (choice_ == 3) pose_ = step_ * pose_;
        }
        scene_.turns += 1000;
        look();
    }
    std::string ended() const override {
        if (worn_.stretch < 1) return {};
        return "After " + digits(std::round(1000 * time()) / 1000) +
               " million turns the volume is " + digits(std::round(100 * worn_.volume) / 100) +
               " of what it was: this is no rotation any more.";
    }
    pic::Drawing drawing(double) const override {
        pic::Drawing drawing;
        drawing.stage({{0, 0, 0}, 1.25}).no_ground();
        add_frame(drawing, scene_.exact(scene_.turns));
        add_cube(drawing, map_, {0, 0, 0}, colour());
        return drawing;
    }
    pic::Size size() const override { return {420, 420}; }
    pic::Camera camera(pic::Size size) const override {
        pic::Drawing room;
        room.add(pic::Ball{.radius = 1.15});
        return pic::fit(room, {0.5, 0.6, 1}, size, {.margin = 0.02});
    }
    std::vector<live::Number> numbers() const override {
        using Trace = live::Number::Trace;
        return {{"million turns", time(), ""},
                {"stretch |RᵀR − 1|", worn_.stretch, "", Trace::logarithmic},
                {"volume", worn_.volume, ""},
                {"angle off", worn_.angle, "rad", Trace::logarithmic}};
    }
    std::vector<double> state() const override {
        return std::vector<double>(map_.data(), map_.data() + 9);
    }
    double page_tolerance() const override {
        return 1e-9;
    }  // the last digit of one sine and cosine, a million times

  private:
    /// The matrix as it is now, and how worn it is.
    void look() {
        const Quaternion exact = scene_.exact(scene_.turns);
        const Quaternion q = choice_ == 3 ? pose_ : Quaternion(float_pose_.cast<double>());
        map_ = choice_ == 0 ? Matrix3(printed_pose_.cast<double>()) : rotation_matrix(q);
        worn_ = choice_ == 0 ? wear_of(map_, exact) : wear_of(q, exact);
    }
    pic::Colour colour() const {
        return choice_ == 0   ? pic::palette::explicit_euler
               : choice_ == 1 ? pic::palette::steel
               : choice_ == 2 ? pic::palette::symplectic
                              : pic::palette::exponential;
    }
    ManyTurns scene_;  // its turns are those made so far
    int choice_ = 0;
    Quaternion step_, pose_;
    Eigen::Quaternionf float_step_, float_pose_;
    Eigen::Matrix3f printed_step_, printed_pose_;
    Matrix3 map_ = Matrix3::Identity();
    Wear worn_;
};

const live::Entry entry{"million", [] { return std::unique_ptr<live::Figure>(new LiveMillion); }};

}  // namespace

}  // namespace nutshell
