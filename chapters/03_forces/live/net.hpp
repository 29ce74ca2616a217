// What a chain and a cloth have in common when they move in a page: a step up to their limit and
// past it, and a hand that pulls.
#pragma once
#include <nutshell/forces_methods.hpp>
#include <nutshell/live/run.hpp>
#include <nutshell/spring_limits.hpp>

namespace nutshell {

namespace pic = picture;

inline constexpr std::tuple on_a_net{methods::euler, methods::semi_implicit_euler,
                                     methods::verlet, methods::yoshida4, methods::rk4};

/// The net at rest: let go, and braked by drag [kg/s] for some seconds.
inline SpringNet braked(SpringNet net, double drag, double seconds) {
    constexpr double dt = 1e-3;
    net.drag = drag;
    auto step = methods::semi_implicit_euler.start(net);
    for (double t = 0; t < seconds; t += dt) net.start = step(std::move(net.start), net, t, dt);
    for (std::size_t i = 0; i < net.start.size(); ++i) net.start.velocity.set(i, Vector3::Zero());
    net.drag = 0;
    return net;
}

class LiveNet : public live::Figure {
  public:
    std::vector<live::Choice> choices() const override { return live::choices_of(on_a_net); }
    std::vector<live::Slider> sliders() const override {
        const double limit = 1e3 * limit_of(chosen_);
        return {{.name = "step dt",
                 .unit = "ms",
                 .least = 200 / omega_,
                 .most = 4e3 / omega_,
                 .start = 1e3 / omega_,
                 .mark = limit,
                 .mark_words = "limit θ/ω = " + digits(std::round(100 * limit) / 100) + " ms"}};
    }
    void begin(const live::Setting& setting) override {
        change(setting);
        pulled_ = false, shaken_ = 0;
        run_ = live::Run<Particles>(on_a_net, chosen_, net_);
    }
    /// Another step goes on from where it is; another method begins again.
    void change(const live::Setting& setting) override {
        require_positive(setting.values.at(0), "the step dt [ms]");
        const bool another = setting.choice != chosen_;
        dt_ = setting.values.at(0) / 1e3, chosen_ = setting.choice;
        if (another && run_.steps > 0) begin(setting);
    }
    double time() const override { return run_.time; }
    double step_size() const override { return dt_; }
    double pace() const override { return 0.3; }  // slow motion: it breaks within a second
    void step() override {
        if (held_) {  // by the hand: it goes where the hand goes
            run_.newest.position.set(*held_, hand_);
            run_.newest.velocity.set(*held_, Vector3::Zero());
        }
        run_.step(dt_);
        if (!pulled_ && strays() > 0.03) ++shaken_;  // what nobody pulls stays where it is
    }
    std::string ended() const override {
        if (farthest() < gone_at_ && shaken_ < 20) return {};
        const double limit = limit_of(chosen_);
        const std::string how =
            limit > 0 ? ", " + digits(std::round(1000 * dt_ / limit) / 1000) + " of the limit"
                      : "";
        return "It flew apart after " + digits(double(run_.steps)) + " steps of " +
               digits(1e3 * dt_) + " ms" + how + ".";
    }
    std::vector<live::Number> numbers() const override {
        using Trace = live::Number::Trace;
        const double limit = limit_of(chosen_);
        std::vector<live::Number> all{{"time", time(), "s"},
                                      {"steps", double(run_.steps), ""},
                                      {"energy", net_.energy(run_.newest), "J", Trace::linear},
                                      {"strays by", 100 * strays(), "cm", Trace::logarithmic}};
        if (limit > 0) all.push_back({"dt over its limit", dt_ / limit, ""});
        return all;
    }
    std::vector<double> state() const override {
        std::vector<double> all;
        for (const auto* axes : {&run_.newest.position, &run_.newest.velocity})
            for (const auto* axis : {&axes->x, &axes->y, &axes->z})
                all.insert(all.end(), axis->begin(), axis->end());
        return all;
    }

    /// The particle next to the pointer, if it is near.
    bool grab(const live::Ray& ray) override {
        double nearest = reach_;
        for (std::size_t i = 0; i < run_.newest.size(); ++i) {
            if (std::binary_search(net_.held.begin(), net_.held.end(), i)) continue;
            const Vector3 arm = run_.newest.position[i] + lift_ - ray.eye;
            const double off = (arm - ray.direction * arm.dot(ray.direction)).norm();
            if (off < nearest) nearest = off, held_ = i, depth_ = arm.dot(ray.direction);
        }
        if (held_) drag(ray), pulled_ = true, shaken_ = 0;
        return held_.has_value();
    }
    void drag(const live::Ray& ray) override { hand_ = ray.eye + depth_ * ray.direction - lift_; }
    void release() override { held_.reset(); }

  protected:
    /// @param net at rest    @param omega of its fastest mode [rad/s]
    /// @param gone_at  this far from its place it has flown apart, once it was pulled [m]
    /// @param reach of the hand [m]    @param lift  of what is drawn [m]
    LiveNet(SpringNet net, double omega, double gone_at, double reach, const Vector3& lift)
        : net_(std::move(net)), lift_(lift), omega_(omega), gone_at_(gone_at), reach_(reach) {}

    const Particles& now() const { return run_.newest; }
    /// Of the method's theta over omega [s]; 0: it bears no step, however small.
    double limit_of(int method) const {
        static const double yoshida = composed_limit(yoshida_weights());
        const double theta = method == 1 || method == 2 ? 2
                             : method == 3              ? yoshida
                             : method == 4              ? std::sqrt(8.0)
                                                        : 0;
        return theta / omega_;
    }
    /// The farthest that any particle is from where it began [m]; a number that is lost counts as
    /// farther.
    double strays() const {
        double most = 0;
        for (std::size_t i = 0; i < now().size(); ++i) {
            const double away = (now().position[i] - net_.start.position[i]).squaredNorm();
            if (!(away < 1e12)) return 1e6;
            most = std::max(most, away);
        }
        return std::sqrt(most);
    }

    SpringNet net_;
    const Vector3 lift_;

  private:
    double farthest() const { return strays(); }
    live::Run<Particles> run_;
    const double omega_, gone_at_, reach_;
    bool pulled_ = false;
    int shaken_ = 0;  // steps in which it was not where it should be
    std::optional<std::size_t> held_;
    Vector3 hand_ = Vector3::Zero();
    double depth_ = 0, dt_ = 1e-3;
    int chosen_ = 2;
};

}  // namespace nutshell
