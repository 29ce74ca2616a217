// Chapter 3's scenes S2, S2d, S3 and S5 in Boost.odeint and in our methods: error against processor time, one
// run, the same compiler and flags. Both sides get the least state a scene needs (two numbers, four for the
// planet).
//   peers_03_forces [--check] [--out DIR]    --check: fail where a point of odeint's is ahead of all of ours
#include <cstring>
#include <iostream>
#include <nutshell/chart/chart.hpp>
#include <nutshell/log_hamiltonian.hpp>
#include "03_odeint.hpp"

using namespace nutshell;
using namespace nutshell::peers;

namespace {

constexpr double margin = 1.5;  // a ratio of times that noise may make

// --- ours

/// A problem as a scene of ours: its state is flat, and its push is y'.
template <class Problem, int N>
struct FlatScene {
    using Y = Eigen::Matrix<double, N, 1>;
    const Problem& problem;
    Y start = Eigen::Map<const Y>(problem.start.data());
    Y operator()(const Y& at, double) const {
        Y dy;
        problem.rate(at, dy);
        return dy;
    }
};

template <class Scene, class Method>
void our_general(std::vector<Point>& points, const Scene& scene, const Method& method,
                 const std::vector<long>& steps) {
    constexpr int N = static_cast<int>(std::tuple_size_v<decltype(scene.start)>);
    const FlatScene<Scene, N> flat_scene{scene};
    for (const long n : steps)
        points.push_back(
            point(scene, method.name, method.look, std::to_string(n) + " steps", [&](const auto& observe) {
                const double dt = scene.duration / static_cast<double>(n);
                auto step = method.start(flat_scene);
                auto y = flat_scene.start;
                for (long i = 0; i < n; ++i) {
                    y = step(y, flat_scene, static_cast<double>(i) * dt, dt);
                    observe(y, static_cast<double>(i + 1) * dt);
                }
                return y;
            }));
}

template <class Scene>
void our_controlled(std::vector<Point>& points, const Scene& scene) {
    constexpr int N = static_cast<int>(std::tuple_size_v<decltype(scene.start)>);
    const FlatScene<Scene, N> flat_scene{scene};
    for (const double tolerance : {scene.final_error_only ? 1e-5 : 1e-2, 1e-4, 1e-6, 1e-8, 1e-10,
                                   1e-12})  // a coarse one loses the planet
        points.push_back(point(scene, std::string(methods::dormand_prince.name) + ", controlled",
                               variant(methods::dormand_prince.look), "tolerance " + lab::rounded(tolerance),
                               [&](const auto& observe) {
                                   return adaptive(flat_scene.start, flat_scene, 0, scene.duration,
                                                   {tolerance, tolerance}, scene.duration / 1000, observe);
                               }));
}

void our_spring(std::vector<Point>& points, const Spring2& scene, const std::vector<long>& steps) {
    for (const long n : steps)
        points.push_back(point(scene, methods::exact_propagator.name, methods::exact_propagator.look,
                               std::to_string(n) + " steps", [&](const auto& observe) {
                                   const double dt = scene.duration / static_cast<double>(n);
                                   const Eigen::Matrix2d step =
                                       oscillation(scene.scene.omega(), scene.scene.damping_rate(), dt);
                                   Eigen::Vector2d y(1, 0);
                                   for (long i = 0; i < n; ++i) {
                                       y = step * y;
                                       observe(y, static_cast<double>(i + 1) * dt);
                                   }
                                   return y;
                               }));
}

void our_fall(std::vector<Point>& points, const Fall2& scene, const std::vector<long>& steps) {
    for (const long n : steps)
        points.push_back(point(
            scene, methods::exponential_kick.name, methods::exponential_kick.look,
            std::to_string(n) + " steps", [&](const auto& observe) {
                PointMass s = scene.scene.start;
                const double dt = scene.duration / static_cast<double>(n);
                for (long i = 0; i < n; ++i) {
                    s = exponential_kick(s, scene.scene, 0, dt);
                    observe(std::array{s.position.y(), s.velocity.y()}, static_cast<double>(i + 1) * dt);
                }
                return s;
            }));
}

template <class Method>
void our_clock(std::vector<Point>& points, const Planet4& scene, const Method& method,
               const std::vector<long>& steps_an_orbit) {
    for (const long n : steps_an_orbit)
        points.push_back(point(
            scene, method.name, method.look, std::to_string(n) + " steps an orbit", [&](const auto& observe) {
                const TimedPlanet end = run_until({scene.scene.start}, method.start(scene.scene),
                                                  scene.duration, 2 * pi / static_cast<double>(n));
                observe(std::array{end.body.position.x(), end.body.position.y()}, scene.duration);
                return end;
            }));
}

// --- the comparison

/// The best of ours against one point of theirs: the least time of ours that is at least as accurate, over
/// theirs.
double behind(const Point& theirs, const std::vector<Point>& all, double round_off) {
    const double allowed =
        std::max(theirs.error * (1 + 1e-6), round_off);  // the same method rounds differently
    double best = std::numeric_limits<double>::infinity();
    for (const Point& p : all)
        if (!is_peer(p) && p.error <= allowed) best = std::min(best, p.seconds);
    return best / theirs.seconds;
}

template <class Scene>
bool compare(const Scene& scene, const std::vector<Point>& all, const std::filesystem::path& folder,
             const std::string& command, lab::Table& data) {
    chart::Chart chart;
    chart.title = "Against Boost.odeint (grey): " + scene.name;
    chart.subtitle = "The same compiler, flags and run. Down and left is better.";
    chart.x = {"processor time of the run [s]", chart::Scale::logarithmic};
    chart.y = {
        std::string(scene.final_error_only ? "error at the end [" : "largest error [") + scene.unit + "]",
        chart::Scale::logarithmic};
    chart.height = 520;
    chart.levels_y = {{scene.round_off, "round-off: below, chance decides"}};
    double worst = 0;
    bool ahead = true;
    for (const Point& p : all) {
        data.add({scene.id, p.method, p.how, p.seconds, p.error});
        if (!(p.error <= scene.worst)) continue;
        if (chart.series.empty() || chart.series.back().name != p.method) {
            chart.series.push_back({p.method});
            chart.series.back().look = p.look;
        }
        chart.series.back().add(p.seconds, std::max(p.error, 1e-16));
        chart.series.back().notes.push_back(p.how);
        if (is_peer(p)) {
            const double ratio = behind(p, all, scene.round_off);
            worst = std::max(worst, ratio);
            if (ratio > margin) {
                ahead = false;
                std::cout << "  " << scene.id << ": " << p.method << ", " << p.how << " (error " << p.error
                          << ") is ahead: our time is " << ratio << " of its\n";
            }
        }
    }
    chart::write_svg(chart, folder / ("odeint_" + scene.id + ".svg"));
    write_file(folder / ("odeint_" + scene.id + ".txt"),
               "command: " + command + "\nscene: " + scene.name + "\n");
    std::cout << "  " << scene.id << ", " << scene.name
              << ": where we are nearest to odeint, our best method takes " << worst
              << " of its time for the same error or less\n";
    return ahead;
}

/// Like for like: the same method with the same steps, time of ours over theirs.
double like_for_like(const std::vector<Point>& all, const std::string& ours, const std::string& theirs,
                     const std::string& how) {
    double a = 0, b = 0;
    for (const Point& p : all) {
        if (p.method == ours && p.how == how) a = p.seconds;
        if (p.method == theirs && p.how == how) b = p.seconds;
    }
    require(a > 0 && b > 0, "like_for_like: no run of " + ours + " and " + theirs + " with " + how);
    return a / b;
}

}  // namespace

int main(int argc, char** argv) try {
    bool check = false;
    std::filesystem::path folder = "out/03_forces";
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--check") == 0)
            check = true;
        else if (std::strcmp(argv[i], "--out") == 0 && i + 1 < argc)
            folder = argv[++i];
        else
            return std::cerr << "peers_03_forces: unknown argument '" << argv[i]
                             << "'. Usage: peers_03_forces [--check] [--out DIR]\n",
                   2;
    }
    const std::string command = "./course run 3";
    std::cout << "Boost.odeint on our scenes\n";
    lab::Table data{{"scene", "method", "how", "seconds", "error"}, {}};
    bool ahead = true;
    const std::vector<long> few{1, 2, 5, 10, 20, 40, 80, 160, 320, 640, 1280};

    for (const double ratio : {0.0, 0.1}) {
        const Spring2 scene(ratio);
        std::vector<Point> all;
        our_spring(all, scene, {1, 10, 100, 1000});
        our_general(all, scene, methods::rk4, {40, 80, 160, 320, 640, 1280, 2560});
        our_controlled(all, scene);
        odeint_all<2>(all, scene, {40, 80, 160, 320, 640, 1280, 2560});
        if (ratio == 0) {
            using Half = std::array<double, 1>;
            odeint_nystroem<1>(all, scene, "sb3a", ode::symplectic_rkn_sb3a_mclachlan<Half>(),
                               {40, 80, 160, 320, 640, 1280});
            odeint_nystroem<1>(all, scene, "sb3a_m4", ode::symplectic_rkn_sb3a_m4_mclachlan<Half>(),
                               {40, 80, 160, 320, 640, 1280});
        }
        ahead &= compare(scene, all, folder, command, data);
        const double rk4 = like_for_like(all, methods::rk4.name, "odeint rk4", "1280 steps");
        std::cout << "    the same RK4, ours over theirs: " << rk4 << " of the time\n";
        ahead &= rk4 < margin;
    }
    {
        const Fall2 scene;
        std::vector<Point> all;
        our_fall(all, scene, {1, 10, 100});
        our_general(all, scene, methods::rk4, few);
        our_controlled(all, scene);
        odeint_all<2>(all, scene, few);
        ahead &= compare(scene, all, folder, command, data);
    }
    {
        const Planet4 scene;
        std::vector<Point> all;
        our_clock(all, scene, methods::logarithmic_leapfrog, {20, 50, 100, 200, 500, 1000});
        our_clock(all, scene, methods::logarithmic_leapfrog8,
                  {4, 5, 6, 8, 10, 12, 16, 20, 24, 32, 40, 50, 64, 80, 100, 128, 160, 200});
        our_general(all, scene, methods::rk4, {20000, 50000, 100000, 200000});
        our_controlled(all, scene);
        odeint_all<4>(all, scene, {20000, 50000, 100000, 200000});
        using Half = std::array<double, 2>;
        odeint_nystroem<2>(all, scene, "sb3a", ode::symplectic_rkn_sb3a_mclachlan<Half>(),
                           {10000, 20000, 50000, 100000});
        odeint_nystroem<2>(all, scene, "sb3a_m4", ode::symplectic_rkn_sb3a_m4_mclachlan<Half>(),
                           {10000, 20000, 50000, 100000});
        ahead &= compare(scene, all, folder, command, data);
        const double rk4 = like_for_like(all, methods::rk4.name, "odeint rk4", "100000 steps");
        std::cout << "    the same RK4, ours over theirs: " << rk4 << " of the time\n";
        ahead &= rk4 < margin;
    }
    write_file(folder / "odeint.csv", lab::provenance(command) + data.csv());
    return check && !ahead ? 1 : 0;
} catch (const std::exception& problem) {
    std::cerr << "peers_03_forces: " << problem.what() << '\n';
    return 1;
}
