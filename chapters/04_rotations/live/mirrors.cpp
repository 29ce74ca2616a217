// Two mirrors make a turn: by twice the angle between them, wherever they stand.
#include <nutshell/live/figure.hpp>
#include <nutshell/reflections.hpp>
#include "../drawings.hpp"

namespace nutshell {

namespace {

class LiveMirrors : public live::Figure {
  public:
    std::vector<live::Slider> sliders() const override {
        return {{.name = "angle between the mirrors",
                 .unit = "°",
                 .least = 0,
                 .most = 180,
                 .start = 40,
                 .logarithmic = false,
                 .mark = 90,
                 .mark_words = "half a turn"},
                {.name = "first mirror at",
                 .unit = "°",
                 .least = 0,
                 .most = 180,
                 .start = 30,
                 .logarithmic = false}};
    }
    std::vector<live::State> states() const override {
        return {{.key = "apart", .words = "mirrors 40° apart", .setting = {0, {40, 30}}},
                {.key = "on",
                 .words = "both turned on by 15°",
                 .setting = {0, {40, 45}},
                 .drawn = true},
                {.key = "upright", .words = "mirrors 90° apart", .setting = {0, {90, 20}}}};
    }
    void begin(const live::Setting& setting) override { steps_ = 0, change(setting); }
    void change(const live::Setting& setting) override {
        between_ = setting.values.at(0) * pi / 180, first_ = setting.values.at(1) * pi / 180;
        require(std::isfinite(between_) && std::isfinite(first_),
                "the angles of the mirrors must be finite");
    }
    double time() const override { return static_cast<double>(steps_) * step_size(); }
    double step_size() const override { return 1.0 / 64; }
    void step() override { ++steps_; }
    /// The pair is turned on while time passes.
    std::string ended() const override {
        if (time() < 9) return {};
        return "The mirrors have made half a turn together, and the last letter has not moved.";
    }
    pic::Drawing drawing(double part) const override {
        const double on = pi / 9 * std::max(0.0, time() - (1 - part) * step_size());
        const Vector3 a = normal(first_ + on), b = normal(first_ + on + between_);
        pic::Drawing drawing;
        drawing.stage({{0, 0, 0}, 2.1}).no_ground();
        add_mirror(drawing, first_ + on, "1st");
        add_mirror(drawing, first_ + on + between_, "2nd");
        add_letter(drawing, {}, pic::palette::body, pic::Look::solid);
        add_letter(drawing, {a}, pic::mix(pic::palette::steel, pic::palette::paper, 0.35F),
                   pic::Look::solid);
        add_letter(drawing, {a, b}, pic::palette::gold, pic::Look::solid);
        const double foot = 0.17;  // the letter stands a little above the x axis
        add_arc(drawing, 0.5, first_ + on, first_ + on + between_, pic::palette::ink, "θ/2");
        add_arc(drawing, 0.85, foot, foot + 2 * between_, pic::palette::angular_velocity, "θ");
        return drawing;
    }
    pic::Size size() const override { return {420, 420}; }
    pic::Camera camera(pic::Size size) const override {
        pic::Drawing room;
        room.add(pic::Ball{.radius = 2.15});
        return pic::fit(room, {0.0, -0.35, 1}, size, {.margin = 0.02});
    }
    std::vector<live::Number> numbers() const override {
        return {{"between the mirrors", between_ * 180 / pi, "°"},
                {"turned by", logarithm(turn()).norm() * 180 / pi, "°"}};
    }
    std::vector<double> state() const override {
        const Quaternion q = turn();
        return {q.x(), q.y(), q.z(), q.w(), time()};
    }
    double page_tolerance() const override { return 1e-12; }  // sines and cosines of two angles

  private:
    /// The normal of a mirror that stands along z at `angle` [rad] from x.
    static Vector3 normal(double angle) { return {-std::sin(angle), std::cos(angle), 0}; }
    Quaternion turn() const {
        const double on = first_ + pi / 9 * time();
        return two_mirrors(normal(on), normal(on + between_));
    }
    static void add_mirror(pic::Drawing& drawing, double angle, const char* name) {
        const Quaternion stands = quaternion_about(Vector3::UnitZ(), angle);
        drawing.add(pic::Box{.pose = placed(stands, {0, 0, 0}),
                             .half_extents = {1.85, 0.015, 0.4},
                             .colour = pic::palette::steel,
                             .look = pic::Look::ghost});
        const Vector3 along = rotate(stands, Vector3::UnitX());
        drawing.add(pic::Rod{.from = -1.85 * along, .to = 1.85 * along, .radius = 0.018});
        drawing.add(pic::Label{1.98 * along, name, pic::palette::ink});
    }
    static void add_arc(pic::Drawing& drawing, double r, double from, double to,
                        pic::Colour colour, const char* name) {
        const Vector3 x = Vector3::UnitX(), z = Vector3::UnitZ();
        drawing.add(pic::Trail{
            .points = arc({0, 0, 0}, z, x, r, from, to), .colour = colour, .width = 4});
        drawing.add(pic::Label{turned((r + 0.13) * x, z, (from + to) / 2), name, colour});
    }
    /// A letter F that lies flat, seen in some mirrors one after the other: a mirrored one can be
    /// told from a turned one.
    static void add_letter(pic::Drawing& drawing, const std::vector<Vector3>& mirrors,
                           pic::Colour colour, pic::Look look) {
        struct Bar {
            double left, right, low, high;
        };
        for (const Bar& bar : {Bar{1.05, 1.75, 0.18, 0.32}, Bar{1.61, 1.75, 0.32, 0.68},
                               Bar{1.3, 1.44, 0.32, 0.56}}) {
            pic::Mesh box{.points = {},
                          .triangles = {{0, 1, 3},
                                        {0, 3, 2},
                                        {4, 5, 7},
                                        {4, 7, 6},
                                        {0, 1, 5},
                                        {0, 5, 4},
                                        {2, 3, 7},
                                        {2, 7, 6},
                                        {0, 2, 6},
                                        {0, 6, 4},
                                        {1, 3, 7},
                                        {1, 7, 5}},
                          .colour = colour,
                          .look = look};
            for (const double x : {bar.left, bar.right})
                for (const double y : {bar.low, bar.high})
                    for (const double z : {-0.07, 0.07}) {
                        Vector3 p(x, y, z);
                        for (const Vector3& mirror : mirrors) p = reflected(p, mirror);
                        box.points.push_back(p);
                    }
            drawing.add(box);
        }
    }
    double between_ = 0, first_ = 0;  // [rad]
    long steps_ = 0;
};

const live::Entry entry{"mirrors", [] { return std::unique_ptr<live::Figure>(new LiveMirrors); }};

}  // namespace

}  // namespace nutshell
