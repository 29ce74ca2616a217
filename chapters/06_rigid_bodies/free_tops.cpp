// Free bodies: the flip, what each method keeps, and the failures with their numbers.
#include <nutshell/chart/chart.hpp>
#include <nutshell/lab/run.hpp>
#include <nutshell/rigid_methods.hpp>
#include <nutshell/sentence.hpp>
#include <nutshell/top_scenes.hpp>
#include "program.hpp"

namespace nutshell {

namespace {

constexpr double dt = 1. / 60;

/// The angle between two arrows [rad].
double angle_of(const Vector3& a, const Vector3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The angular velocity along the body's middle axis [rad/s].
double about_middle(const Pinned& body) {
    return rotate(inverse(body.orientation), angular_velocity(body)).y();
}

void when_it_flips(lab::Report& report) {
    const FreeBody scene = flip();
    report.heading("The flip: moments 1, 2, 3 kg m^2, spun about the middle axis");
    report.number("flip.spin", angular_velocity(scene.start).norm(), "rad/s");
    report.number("flip.first", scene.solution.first_flip(), "s");
    report.number("flip.between", scene.solution.between_flips(), "s");
    report.say("It flips after " + lab::rounded(scene.solution.first_flip(), "%.6f") +
               " s, then every " + lab::rounded(scene.solution.between_flips(), "%.6f") + " s.");

    chart::Chart chart;
    chart.title = "The handle flips, and as printed it never does";
    chart.subtitle =
        "Its spin about its own middle axis; steps of 1/60 s. A flip: the sign changes.";
    chart.x = {"time [s]", chart::Scale::linear, 0, scene.duration};
    chart.y = {"spin about the middle axis [rad/s]", chart::Scale::linear, -2.4, 2.4};
    chart::Series exact{"exact"};
    exact.draw = chart::Draw::ghost;
    for (int i = 0; i <= 600; ++i) {
        const double t = scene.duration * i / 600;
        exact.x.push_back(t);
        exact.y.push_back(scene.solution.in_body(t).y() / scene.start.inertia.y());
    }
    chart.series.push_back(exact);
    each(std::tuple{methods::kick_magnus_kick, methods::corrected_step}, [&](const auto& method) {
        chart::Series series{method.name};
        series.look = method.look, series.draw = chart::Draw::line;
        lab::run(scene, method, lab::steps_of(scene.duration, dt),
                 [&](const Pinned& body, double t) {
                     series.x.push_back(t), series.y.push_back(about_middle(body));
                 });
        chart.series.push_back(series);
    });
    // As printed, omega is I0^-1 L for ever: what the program itself takes for the spin.
    chart::Series printed{methods::printed_step.name};
    printed.look = methods::printed_step.look, printed.draw = chart::Draw::line;
    const Vector3 frozen = scene.start.angular_momentum.cwiseQuotient(scene.start.inertia);
    printed.x = {0, scene.duration}, printed.y = {frozen.y(), frozen.y()};
    chart.series.push_back(printed);
    chart::write_svg(chart, report.path("flip_spin.svg"));

    // how many times it turns over in the run, by each method
    each(std::tuple{methods::printed_step, methods::corrected_step,
                    methods::engine_step_without_gyroscopic, methods::kick_magnus_kick},
         [&](const auto& method) {
             double flips = 0, before = 1;
             const bool turns = std::string(method.name) != methods::printed_step.name;
             lab::run(scene, method, lab::steps_of(scene.duration, dt),
                      [&](const Pinned& body, double) {
                          const double now = turns ? about_middle(body) : frozen.y();
                          if (now * before < 0) ++flips;
                          if (now != 0) before = now;
                      });
             report.number("flip." + method.key() + ".flips", flips);
         });
    for (const int seconds : {1, 4}) {  // the printed pose, off by
        FreeBody start = scene;
        start.duration = seconds;
        report.number(
            "flip.printed.after_" + std::to_string(seconds),
            scene.error(lab::run(start, methods::printed_step, 60 * seconds), seconds) * 180 / pi,
            "degrees");
    }
    // near the middle axis what is off it grows as e^(growth t)
    const Vector3 I = scene.start.inertia, J = I.cwiseInverse();
    report.number("flip.growth",
                  scene.start.angular_momentum.y() * std::sqrt((J[1] - J[2]) * (J[0] - J[1])),
                  "1/s");
    // omega in the world: how far it strays while L stands still
    double farthest = 0;
    for (int i = 0; i <= 3000; ++i) {
        const double t = scene.duration * i / 3000;
        farthest = std::max(
            farthest, angle_of(angular_velocity(scene.exact(t)), scene.start.angular_momentum));
    }
    report.number("flip.omega_from_L", farthest * 180 / pi, "degrees");
}

/// What one run keeps: time series of the energy, of the length of L, and of L, as changes
/// relative to the start.
struct Course {
    std::vector<double> time, energy, length, vector;
};

template <class Method>
Course course(const FreeBody& scene, const Method& method) {
    Course c;
    const Vector3 first = scene.start.angular_momentum;
    const double E = scene.energy(scene.start), size = first.norm();
    long n = 0;
    lab::run(scene, method, lab::steps_of(scene.duration, dt), [&](const Pinned& body, double t) {
        if (n++ % 20 != 0) return;
        c.time.push_back(t);
        c.energy.push_back(std::abs(scene.energy(body) / E - 1));
        c.length.push_back(std::abs(body.angular_momentum.norm() / size - 1));
        c.vector.push_back((body.angular_momentum - first).norm() / size);
    });
    return c;
}

double largest(const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
}

void what_is_kept(lab::Report& report) {
    const FreeBody scene = near_middle_axis();
    report.heading("What is kept over 100 s, steps of 1/60 s: scene S7");
    lab::Table table{{"method", "energy", "|L|", "vector L"}, {}};
    chart::Figure figure;
    figure.title = "Energy and |L| can be perfect while L turns away";
    figure.subtitle =
        "Scene S7, steps of 1/60 s; changes relative to the start. A method that keeps something "
        "to the last bit has no line there.";
    figure.columns = 3;
    std::array<chart::Chart, 3> panels;
    const std::array<const char*, 3> titles{"energy", "length of L", "L itself"};
    for (std::size_t i = 0; i < 3; ++i) {
        panels[i].title = titles[i];
        panels[i].x = {"time [s]", chart::Scale::linear, 0, scene.duration};
        panels[i].y = {"relative change", chart::Scale::logarithmic, 1e-16, 10};
        panels[i].cut = true;
    }
    each(std::tuple{methods::corrected_step, methods::engine_step,
                    methods::engine_step_without_gyroscopic, methods::kick_split_kick,
                    methods::kick_magnus_kick, methods::rk4},
         [&](const auto& method) {
             const Course c = course(scene, method);
             const std::string key = "kept." + method.key();
             report.number(key + ".energy", largest(c.energy));
             report.number(key + ".length", largest(c.length));
             report.number(key + ".vector", largest(c.vector));
             table.add({method.name, lab::rounded(largest(c.energy), "%.1e"),
                        lab::rounded(largest(c.length), "%.1e"),
                        lab::rounded(largest(c.vector), "%.1e")});
             const std::array<const std::vector<double>*, 3> all{&c.energy, &c.length, &c.vector};
             for (std::size_t i = 0; i < 3; ++i) {
                 if (largest(*all[i]) == 0) continue;  // to the bit
                 chart::Series series{method.name, c.time, *all[i], chart::Draw::line};
                 series.look = method.look;
                 panels[i].series.push_back(series);
             }
         });
    report.print(table);
    figure.panels.assign(panels.begin(), panels.end());
    chart::write_svg(figure, report.path("kept.svg"));
}

void failures(lab::Report& report) {
    const FreeBody scene = near_middle_axis();
    report.heading("Failures on S7: off by [rad] after 100 s, for steps a second");
    lab::Table table{{"method", "60", "240", "960"}, {}};
    chart::Chart chart;
    chart.title = phrase("A constant ω never arrives, {} arrives late", methods::lie_rk4);
    chart.subtitle = "Scene S7, 100 s. L comes from the world; the question is how often.";
    chart.x = {"steps a second", chart::Scale::logarithmic};
    chart.y = {"largest error [rad]", chart::Scale::logarithmic};
    chart.guides = {-4};
    chart.tolerance = {scene.need.tolerance, "a hundredth of a pixel"};
    each(std::tuple{methods::kick_constant_kick, methods::lie_rk4, methods::kick_magnus_kick},
         [&](const auto& method) {
             chart::Series series{method.name};
             series.look = method.look;
             std::vector<std::string> row{method.name};
             for (const long rate : {30L, 60L, 120L, 240L, 480L, 960L}) {
                 const double error = lab::measure(scene, method, 100 * rate).max_error;
                 series.x.push_back(static_cast<double>(rate)), series.y.push_back(error);
                 if (rate == 60 || rate == 240 || rate == 960) row.push_back(lab::rounded(error));
                 report.number("failure." + method.key() + "." + std::to_string(rate), error,
                               "rad");
             }
             table.add(row);
             chart.series.push_back(series);
         });
    report.print(table);
    report.number("failure.stages",
                  lab::measure(scene, methods::lie_rk4, 6000).max_error /
                      lab::measure(scene, methods::kick_magnus_kick, 6000).max_error);
    report.number("failure.stages.energy",
                  lab::largest_change(scene, methods::lie_rk4, 6000, [&](const Pinned& b) {
                      return scene.energy(b);
                  }) / scene.energy(scene.start));
    // a step of 16 us, and still lost
    const Pinned last = lab::run(scene, methods::kick_constant_kick, 6'144'000);
    report.number("failure.constant.finest", scene.error(last, 100), "rad");
    report.number("failure.constant.finest_rate", 61'440);
    chart::write_svg(chart, report.path("s7_failures.svg"));

    const FreeBody plate = wobbling_plate();
    const double E = plate.energy(plate.start);
    double doubled = 0;
    lab::run(plate, methods::engine_step, 600, [&](const Pinned& body, double t) {
        if (doubled == 0 && plate.energy(body) > 2 * E) doubled = t;
    });
    report.number("plate.engine.doubled", doubled, "s");
    // Euler's method on a wobble that goes round in the body at Omega: energy of the wobble times
    // 1 + (Omega dt)^2 a step, that of the spin unchanged
    const Vector3 I = plate.start.inertia, M = plate.start.angular_momentum;
    const double Omega = M.z() * (1 / I.x() - 1 / I.z()), wobbling = M.x() * M.x() / I.x() / 2;
    report.number("plate.engine.law",
                  dt * std::log(1 + E / wobbling) / std::log1p(Omega * Omega * dt * dt), "s");
    const auto gain = [&](const auto& method, long steps) {
        return lab::largest_change(plate, method, steps,
                                   [&](const Pinned& b) { return plate.energy(b); }) /
               E;
    };
    report.number("plate.engine.gain", 1 + gain(methods::engine_step, 600));
    report.number("plate.split.gain", gain(methods::kick_split_kick, 600));
    report.say(sentence("{} doubles the energy of a wobbling plate in ", methods::engine_step) +
               lab::rounded(doubled) + " s and multiplies it by " +
               lab::rounded(1 + gain(methods::engine_step, 600)) + " in 10 s.");
}

}  // namespace

void free_bodies(lab::Report& report) {
    when_it_flips(report);
    what_is_kept(report);
    failures(report);
}

}  // namespace nutshell
