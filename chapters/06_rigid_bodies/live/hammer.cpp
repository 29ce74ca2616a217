// A hammer thrown end over end: one point of it flies a parabola, and the head's material says
// which.
#include <nutshell/live/figure.hpp>
#include <nutshell/thrown_scenes.hpp>
#include "../lever_drawings.hpp"

namespace nutshell {

namespace {

class LiveHammer : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override {
        return {{"grip", "follow the grip", {}},
                {"middle", "the middle of the shaft", {}},
                {"head", "the head", {}}};
    }
    std::vector<live::Slider> sliders() const override {
        return {{.name = "turns a second",
                 .least = 0.2,
                 .most = 4,
                 .start = 1.5,
                 .logarithmic = false},
                {.name = "density of the head",
                 .unit = "kg/m³",
                 .least = 100,
                 .most = 20000,
                 .start = 7800,
                 .mark = 7800,
                 .mark_words = "iron"}};
    }
    std::vector<live::State> states() const override {
        return {
            {.key = "grip", .words = "an iron head", .setting = {0, {1.5, 7800}}, .time = 0.9},
            {.key = "cork",
             .words = "a head of cork",
             .setting = {0, {1.5, 200}},
             .time = 0.9,
             .drawn = true},
            {.key = "middle",
             .words = "the middle of the shaft",
             .setting = {1, {1.5, 7800}},
             .time = 0.9}};
    }
    void begin(const live::Setting& setting) override {
        setting_ = setting;
        std::vector<Block> blocks = hammer();
        blocks[1].density = setting.values.at(1);
        require_positive(blocks[1].density, "the density of the head [kg/m^3]");
        const double height = setting.choice == 0 ? -0.15 : setting.choice == 1 ? 0 : 0.17;
        scene_ = ThrownThing("hammer", blocks, {0, height, 0}, {2.5, 4.5, 0},
                             {0, 0, -2 * pi * setting.values.at(0)});
        body_ = scene_.start, steps_ = 0;
        path_ = {point()}, centres_ = {body_.position}, poses_ = {body_.orientation};
    }
    double time() const override { return static_cast<double>(steps_) * step_size(); }
    double step_size() const override { return 1.0 / 120; }
    double pace() const override { return 0.4; }
    void step() override {
        if (time() > scene_.duration) return begin(live::Setting(setting_));  // again
        body_ = verlet(body_, scene_, time(), step_size());
        ++steps_;
        path_.push_back(point());
        if (steps_ % 12 == 0)
            centres_.push_back(body_.position), poses_.push_back(body_.orientation);
    }
    pic::Drawing drawing(double) const override {
        pic::Drawing drawing;
        drawing.stage({{1.15, 0.5, 0}, 1.5}).ground({.height = -0.4, .spacing = 0.5});
        std::vector<Vector3> parabola;
        for (int i = 0; i <= 60; ++i)
            parabola.push_back(scene_.exact(scene_.duration * i / 60).position);
        drawing.add(pic::Trail{
            .points = parabola, .colour = pic::palette::exact, .dashed = true, .width = 3});
        for (std::size_t i = 0; i < centres_.size(); ++i)
            add_thing(drawing, poses_[i], centres_[i]);
        if (path_.size() > 1)
            drawing.add(pic::Trail{.points = path_, .colour = pic::palette::body, .width = 4});
        add_thing(drawing, body_.orientation, body_.position);
        drawing.add(pic::Ball{.centre = point(), .radius = 0.028, .colour = pic::palette::body});
        for (const Vector3& centre : centres_)
            drawing.add(pic::Ball{.centre = centre + Vector3(0, 0, 0.03),
                                  .radius = 0.018,
                                  .colour = pic::palette::ink});
        return drawing;
    }
    pic::Size size() const override { return {560, 360}; }
    pic::Camera camera(pic::Size size) const override {
        pic::Drawing room;
        room.add(pic::Trail{.points = {{-0.3, -0.35, 0}, {2.6, 1.35, 0}}});
        return pic::fit(room, {0.05, 0.1, 1}, size, {.margin = 0.02});
    }
    std::vector<live::Number> numbers() const override {
        return {{"mass", scene_.thing.mass, "kg"},
                {"centre of mass from the grip", scene_.thing.centre.y() + 0.15, "m"},
                {"inertia about it", scene_.thing.inertia(2, 2), "kg m²"}};
    }
    std::vector<double> state() const override {
        return {body_.position.x(), body_.position.y(), body_.orientation.z(),
                body_.orientation.w()};
    }
    double page_tolerance() const override { return 1e-12; }  // sine and cosine of its turns

  private:
    Vector3 point() const { return point_of(body_, scene_.in_body(scene_.tip)); }
    void add_thing(pic::Drawing& drawing, const Quaternion& pose, const Vector3& at) const {
        // from the axes of the blocks into those of the body, and out with its pose
        const Quaternion turn = product(pose, inverse(scene_.start.orientation));
        add_blocks(drawing, scene_.blocks, turn, scene_.thing.centre, at);
    }
    ThrownThing scene_ = thrown_hammer();
    live::Setting setting_;
    Body body_;
    std::vector<Vector3> path_, centres_;
    std::vector<Quaternion> poses_;
    long steps_ = 0;
};

const live::Entry entry{"hammer", [] { return std::unique_ptr<live::Figure>(new LiveHammer); }};

}  // namespace

}  // namespace nutshell
