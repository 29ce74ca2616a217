// The leaky cart of chapter 2, computed twice: as if its momentum were kept while its mass falls,
// and with honest books.
#include <nutshell/live/run.hpp>
#include <nutshell/newton_methods.hpp>
#include <nutshell/revised_newton_scenes.hpp>

namespace nutshell {

namespace pic = picture;

namespace {

class LiveCart : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override {
        return live::choices_of(newton_methods);
    }
    std::vector<live::Slider> sliders() const override {
        return {{.name = "step dt", .unit = "s", .least = 0.02, .most = 1, .start = 0.1},
                {.name = "sand lost",
                 .unit = "kg/s",
                 .least = 0.01,
                 .most = 0.19,
                 .start = 0.1,
                 .logarithmic = false}};
    }
    std::vector<live::State> states() const override {
        return {{.key = "both",
                 .words = "half the sand is lost",
                 .setting = {0, {0.1, 0.1}},
                 .time = 10},
                {.key = "nearly_all",
                 .words = "nearly all of it is lost",
                 .setting = {0, {0.1, 0.19}},
                 .time = 10}};
    }

    void begin(const live::Setting& setting) override {
        dt_ = setting.values.at(0);
        require_positive(dt_, "the step dt [s]");
        require_positive(setting.values.at(1), "the sand lost [kg/s]");
        told_scene_.start.flow.rate = is_scene_.start.flow.rate = -setting.values.at(1);
        told_ = live::Run<VariableMass>(newton_methods, setting.choice, told_scene_);
        is_ = live::Run<VariableMass>(newton_methods, setting.choice, is_scene_);
        told_images_ = {told_.newest}, is_images_ = {is_.newest};
        grains_.clear();
        last_image_ = last_grain_ = 0;
    }
    double time() const override { return is_.time; }
    double step_size() const override { return dt_; }
    void step() override {
        told_.step(dt_), is_.step(dt_);
        if (time() > last_grain_ + grain_every * 0.999) {
            last_grain_ = time();
            grains_.push_back(told_.newest.position.x());
        }
        if (time() > last_image_ + image_every * 0.999 && time() < is_scene_.duration - 1e-9) {
            last_image_ = time();
            told_images_.push_back(told_.newest), is_images_.push_back(is_.newest);
        }
    }
    std::string ended() const override {
        if (time() < is_scene_.duration - 1e-9) return {};
        return "After ten seconds: with K = m v and K kept " + speed(told_.newest) +
               ", in truth " + speed(is_.newest) + ".";
    }

    pic::Drawing drawing(double part) const override {
        pic::Drawing drawing;
        drawing.stage({{75, 0, -30}, 95});
        drawing.ground({.height = 0, .spacing = 10});
        // what the formula claims: each grain stays where it fell out
        for (const double x : grains_)
            drawing.add(pic::Ball{.centre = {x, 0.7, back + 3}, .radius = 0.7, .colour = sand});
        for (const Particle& image : told_images_) add_cart(drawing, image, image.position, back);
        // what happens: each grain slides along below the cart
        for (const Particle& image : is_images_) add_cart(drawing, image, image.position, front);
        add_cart(drawing, told_.newest, told_.position(part), back);
        const Vector3 here = is_.position(part);
        add_cart(drawing, is_.newest, here, front);
        for (std::size_t i = 0; i < grains_.size(); ++i)
            drawing.add(
                pic::Ball{.centre = {here.x() + (static_cast<double>(i) -
                                                 static_cast<double>(grains_.size()) / 2 + 0.5) *
                                                    0.55,
                                     0.7, front + 3},
                          .radius = 0.7,
                          .colour = sand});
        const auto label = [&](double x, double lane, const std::string& text) {
            drawing.add(pic::Label{.at = {x, 14, lane}, .text = text});
        };
        drawing.add(pic::Label{.at = {24, 17, back}, .text = "computed with K = m v, K kept"});
        drawing.add(pic::Label{.at = {2, 17, front}, .text = "the truth"});
        label(told_.position(part).x(), back, speed(told_.newest));
        label(here.x(), front, speed(is_.newest));
        return drawing;
    }
    pic::Size size() const override { return {960, 450}; }
    pic::Camera camera(pic::Size size) const override {
        pic::Drawing all;
        all.add(pic::Trail{
            .points = {{-8, 0, back}, {160, 0, back}, {160, 17, back}, {-8, 0, front + 3}}});
        return pic::fit(all, {0, 0.55, 1}, size, {.margin = 0.04, .field_of_view = 0.06});
    }
    std::vector<live::Number> numbers() const override {
        using Trace = live::Number::Trace;
        return {{"time", time(), "s"},
                {"speed, K kept", velocity(told_.newest).x(), "m/s", Trace::linear},
                {"speed, in truth", velocity(is_.newest).x(), "m/s", Trace::linear},
                {"still on board", is_.newest.mass, "kg"},
                {"honest books, off by", is_scene_.error(is_.newest, time()), "m"}};
    }
    std::vector<double> state() const override {
        std::vector<double> all;
        for (const Particle* cart : {static_cast<const Particle*>(&told_.newest),
                                     static_cast<const Particle*>(&is_.newest)})
            all.insert(all.end(), {cart->mass, cart->position.x(), cart->momentum.x()});
        return all;
    }

  private:
    static constexpr double back = -62, front = 0;               // lanes [m]
    static constexpr double image_every = 2, grain_every = 0.2;  // [s]
    inline static const pic::Colour sand = pic::palette::gold;

    static std::string speed(const Particle& cart) {
        return digits(std::round(10 * velocity(cart).x()) / 10) + " m/s";
    }
    /// A cart on its lane: as much of its load as its mass says.
    void add_cart(pic::Drawing& drawing, const Particle& cart, const Vector3& at,
                  double lane) const {
        const double x = at.x(),
                     load = 2.4 * cart.mass / is_scene_.start.mass;  // half height [m]
        const auto box = [&](double y, const Vector3& half, const pic::Colour& colour) {
            pic::Box thing{.half_extents = half, .colour = colour};
            thing.pose.translation() = Vector3(x, y, lane);
            drawing.add(thing);
        };
        box(3.1, {5.4, 0.3, 2.6}, pic::palette::steel);
        box(3.4 + load, {4.8, load, 2.3}, sand);
        for (const double wheel : {-3.4, 3.4})
            drawing.add(pic::Ball{.centre = {x + wheel, 1.4, lane + 1.6},
                                  .radius = 1.4,
                                  .colour = pic::palette::ink});
    }
    LeakyCart told_scene_ = LeakyCart::as_printed(), is_scene_;
    live::Run<VariableMass> told_, is_;
    std::vector<Particle> told_images_, is_images_;
    std::vector<double> grains_;
    double dt_ = 0.1, last_image_ = 0, last_grain_ = 0;
};

const live::Entry entry{"cart", [] { return std::unique_ptr<live::Figure>(new LiveCart); }};

}  // namespace

}  // namespace nutshell
