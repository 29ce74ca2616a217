// One spring by five methods at one theta = omega dt: chapter 3's sorting of the methods,
// in one look.
#include <nutshell/forces_methods.hpp>
#include <nutshell/forces_scenes.hpp>
#include <nutshell/live/run.hpp>

namespace nutshell {

namespace pic = picture;

namespace {

constexpr std::tuple on_one_spring{methods::euler, methods::semi_implicit_euler, methods::verlet,
                                   methods::rk4, methods::implicit_euler};

class LiveSpring : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override { return live::choices_of(on_one_spring); }
    std::vector<live::Slider> sliders() const override {
        const double limit = limit_of(chosen_);
        return {{.name = "θ = ω dt",
                 .least = 0.1,
                 .most = 4,
                 .start = 0.5,
                 .mark = limit,
                 .mark_words = "limit " + digits(limit)}};
    }
    std::vector<live::State> states() const override {
        return {{.key = "below",
                 .words = "θ = 1.98, eight steps",
                 .setting = {2, {1.98}},
                 .time = 8 * 1.98 / omega()},
                {.key = "above",
                 .words = "θ = 2.02, eight steps",
                 .setting = {2, {2.02}},
                 .time = 8 * 2.02 / omega(),
                 .drawn = true},
                {.key = "coarse",
                 .words = "13 steps a period",
                 .setting = {2, {2 * pi / 13}},
                 .time = 10}};
    }

    void begin(const live::Setting& setting) override {
        chosen_ = setting.choice, theta_ = setting.values.at(0);
        require_positive(theta_, "theta = omega dt");
        rows_.clear();
        for (int i = 0; i < count; ++i)
            rows_.push_back({live::Run<PointMass>(on_one_spring, i, scene_), -1});
        time_ = 0;
    }
    void change(const live::Setting& setting) override {
        const bool another = setting.values.at(0) != theta_;
        if (another) return begin(setting);
        chosen_ = setting.choice;
    }
    double time() const override { return time_; }
    double step_size() const override { return theta_ / omega(); }
    double pace() const override { return 0.7; }
    void step() override {
        time_ += step_size();
        for (Row& row : rows_) {
            if (row.gone >= 0) continue;
            row.run.step(step_size());
            if (!(scene_.energy(row.run.newest) < gone_at)) row.gone = time_;
        }
    }
    std::string ended() const override {
        if (time_ < 30) return {};
        std::string gone;
        int i = 0;
        each(on_one_spring, [&](const auto& method) {
            if (rows_[std::size_t(i++)].gone >= 0)
                gone += (gone.empty() ? "" : ", ") + std::string(method.name);
        });
        return gone.empty() ? "Thirty periods, and all are still there. Look at their amplitudes."
                            : "Flown apart within thirty periods: " + gone + ".";
    }

    pic::Drawing drawing(double part) const override {
        pic::Drawing drawing;
        drawing.stage({{-0.6, middle, 0}, 3.4});
        drawing.no_ground();
        const double wall = -2.3;
        drawing.add(box({wall - 0.06, middle, 0}, {0.05, count * gap / 2, 0.2}));
        const double shown = std::max(0.0, time_ - (1 - part) * step_size());
        int i = 0;
        each(on_one_spring, [&](const auto& method) {
            const Row& row = rows_[std::size_t(i)];
            const Vector3 level(0, (count - 1 - i) * gap, 0);
            const pic::Colour colour = pic::hex(shades_of(method.look.family));
            const Vector3 exact = level + scene_.exact(shown).position;
            drawing.add(pic::Ball{.centre = exact,
                                  .radius = 0.15,
                                  .colour = pic::palette::exact,
                                  .look = pic::Look::ghost});
            std::string words = method.name;
            if (row.gone >= 0) {
                words +=
                    ": flew apart after " + digits(std::round(row.gone / step_size())) + " steps";
            } else if (const double x = row.run.newest.position.x(); std::abs(x) > seen_to) {
                words += ": at " + digits(std::round(10 * x) / 10) + " m";
            } else {
                const Vector3 here = level + row.run.position(part);
                drawing.add(
                    pic::Tube{.points = pic::coil(level + Vector3(wall, 0, 0), here, 0.1, 12),
                              .radius = 0.018});
                drawing.add(pic::Ball{.centre = here, .radius = 0.15, .colour = colour});
            }
            drawing.add(pic::Label{
                .at = level + Vector3(wall + 0.05, 0.3, 0), .text = words, .colour = colour});
            ++i;
        });
        return drawing;
    }
    pic::Size size() const override { return {720, 620}; }
    pic::Camera camera(pic::Size size) const override {
        pic::Drawing all;
        all.add(pic::Trail{
            .points = {
                {-2.4, -0.3, 0}, {2.5, -0.3, 0}, {2.5, count * gap, 0}, {-2.4, count * gap, 0}}});
        return pic::fit(all, {0.02, 0.08, 1}, size, {.margin = 0.03, .field_of_view = 0.3});
    }
    std::vector<live::Number> numbers() const override {
        using Trace = live::Number::Trace;
        const Row& row = rows_.at(std::size_t(chosen_));
        const double start = scene_.energy(scene_.start);
        return {{"time", time_, "s"},
                {"steps a period", 2 * pi / theta_, ""},
                {"energy", 100 * (scene_.energy(row.run.newest) / start - 1), "%", Trace::linear},
                {"error", scene_.error(row.run.newest, row.run.time), "m", Trace::logarithmic}};
    }
    std::vector<double> state() const override {
        std::vector<double> all;
        for (const Row& row : rows_)
            all.insert(all.end(), {row.run.newest.position.x(), row.run.newest.velocity.x()});
        return all;
    }

  private:
    struct Row {
        live::Run<PointMass> run;
        double gone;  ///< when it flew apart [s]; negative: it has not
    };
    static constexpr int count = std::tuple_size_v<decltype(on_one_spring)>;
    static constexpr double gap = 0.78, middle = (count - 1) * gap / 2;  // between two rows [m]
    static constexpr double gone_at = 1e6, seen_to = 2.4;                // [J], [m]

    double omega() const { return scene_.omega(); }
    /// The largest theta that the method bears; 0: it bears none, or every one.
    static double limit_of(int method) {
        return method == 1 || method == 2 ? 2 : method == 3 ? std::sqrt(8.0) : 0;
    }
    static pic::Box box(const Vector3& at, const Vector3& half) {
        pic::Box thing{.half_extents = half, .colour = pic::palette::steel};
        thing.pose.translation() = at;
        return thing;
    }
    MassOnSpring scene_;
    int chosen_ = 2;
    double theta_ = 0.5, time_ = 0;
    std::vector<Row> rows_;
};

const live::Entry entry{"spring", [] { return std::unique_ptr<live::Figure>(new LiveSpring); }};

}  // namespace

}  // namespace nutshell
