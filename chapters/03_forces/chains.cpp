// A chain and a cloth: how they hang, how close that is to the exact shape, and the step at which
// they fly apart.
#include <nutshell/chart/chart.hpp>
#include <nutshell/hanging_chain.hpp>
#include <nutshell/picture/picture.hpp>
#include "method_limits.hpp"
#include "scale.hpp"

namespace nutshell {

namespace pic = picture;

namespace {

// --- the chain

constexpr double cord_mass = 1, cord_length = 3,
                 cord_stiffness = 40;  // [kg], at rest [m], tension over stretch [N]

/// The cord cut into links, between two ends at the same height, 2 m apart.
HangingChain cut_into(std::size_t links) {
    const auto n = static_cast<double>(links);
    return {
        links - 1, cord_mass / n, {cord_stiffness * n / cord_length, cord_length / n}, {2, 0}};
}

double distance(const Vector3& a, const Vector2& b) {
    return (a - Vector3(b.x(), b.y(), 0)).norm();
}

/// The gaps [m] between the rest shape of a chain and that of a cord.
double gap(const HangingChain& chain, const Cord& cord) {
    const auto points = rest_shape(chain);
    const EndTension tension = end_tension(cord);
    double largest = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        largest = std::max(
            largest, (points[i] -
                      cord_point(cord, tension, static_cast<double>(i) * chain.link.rest_length))
                         .norm());
    return largest;
}

Cord inextensible(Cord cord) {
    cord.stiffness = std::numeric_limits<double>::infinity();
    return cord;
}

void draw_chain(lab::Report& report, const Particles& hung, const HangingChain& chain,
                double error, double cosh_gap, double dt) {
    const Vector3 lift(0, 1.75, 0);  // [m], of the two ends above the ground
    pic::Drawing drawing;
    std::vector<Vector3> computed, exact, cosh;
    for (std::size_t i = 0; i < hung.size(); ++i) computed.push_back(hung.position[i] + lift);
    for (const Vector2& p : rest_shape(chain)) exact.push_back(Vector3(p.x(), p.y(), 0) + lift);
    const Cord stiff = inextensible(cord_of(chain));
    const EndTension tension = end_tension(stiff);
    for (int i = 0; i <= 120; ++i) {
        const Vector2 p = cord_point(stiff, tension, stiff.length * i / 120);
        cosh.push_back(Vector3(p.x(), p.y(), 0) + lift);
    }
    for (const Vector3& end : {computed.front(), computed.back()})
        drawing.add(pic::Rod{.from = {end.x(), 0, 0}, .to = end, .radius = 0.035});
    for (std::size_t i = 0; i + 1 < computed.size(); ++i)
        drawing.add(pic::Rod{.from = computed[i], .to = computed[i + 1], .radius = 0.014});
    for (std::size_t i = 1; i + 1 < computed.size(); ++i) {
        drawing.add(
            pic::Ball{.centre = computed[i], .radius = 0.05, .colour = pic::palette::symplectic});
        drawing.add(pic::Ball{.centre = exact[i],
                              .radius = 0.085,
                              .colour = pic::palette::exact,
                              .look = pic::Look::ghost});
    }
    drawing.add(pic::Trail{
        .points = cosh, .colour = pic::palette::explicit_euler, .dashed = true, .shadow = false});
    drawing.add(pic::Label{.at = cosh[60] + Vector3(0, 0.2, 0),
                           .text = "cosh",
                           .colour = pic::palette::explicit_euler});
    drawing.title("A chain of springs does not hang as a cosh");
    drawing.caption(
        "Green: let go straight, damped, at rest. Ghost: exact. Dashed: the same cord without "
        "stretch.");
    const pic::Camera camera = pic::fit(drawing, {0.12, 0.16, 1}, {}, {.margin = 0.04});
    pic::save(report.path("chain.png"),
              {report.command(),
               "hanging chain, 11 masses, 12 links, 1 kg, 3 m at rest",
               "semi-implicit Euler",
               lab::rounded(dt, "%g s"),
               {{"largest distance to the exact shape", error, "m"},
                {"largest distance to the cosh", cosh_gap, "m"}}},
              [&]() -> pic::Sheet {
                  return pic::Shot{drawing, camera};
              });
}

void hang_a_chain(lab::Report& report) {
    report.heading("A hanging chain");
    const HangingChain chain = cut_into(12);
    SpringNet net = nutshell::chain(chain.masses, chain.mass, chain.link, {0, 0, 0}, {2, 0, 0});
    net.drag = 0.4, net.duration = 40;
    constexpr long steps = 20'000;
    const Particles hung = lab::run(net, methods::semi_implicit_euler, steps);
    const auto exact = rest_shape(chain);
    double error = 0;
    lab::Table shape{{"point", "x_m", "y_m", "exact_x_m", "exact_y_m"}, {}};
    for (std::size_t i = 0; i < exact.size(); ++i) {
        error = std::max(error, distance(hung.position[i], exact[i]));
        shape.add({std::to_string(i), lab::exact_digits(hung.position.x[i]),
                   lab::exact_digits(hung.position.y[i]), lab::exact_digits(exact[i].x()),
                   lab::exact_digits(exact[i].y())});
    }
    report.data("chain.csv", shape);
    const EndTension tension = end_tension(chain);
    const double cosh_gap = gap(chain, inextensible(cord_of(chain)));
    report.number("chain.error", error, "m");
    report.number("chain.horizontal", tension.horizontal, "N");
    report.number("chain.vertical", tension.vertical, "N");
    report.number("chain.sag", -exact[6].y(), "m");
    report.number("chain.catenary_gap", gap(chain, cord_of(chain)), "m");
    report.number("chain.cosh_gap", cosh_gap, "m");
    report.say("12 links, let go and damped: " + lab::rounded(error) +
               " m from the exact rest shape, " + lab::rounded(gap(chain, cord_of(chain))) +
               " m from the elastic catenary, " + lab::rounded(cosh_gap) + " m from the cosh");
    draw_chain(report, hung, chain, error, cosh_gap, net.duration / steps);

    chart::Chart chart;
    chart.title = "With more links: the elastic catenary, not the cosh";
    chart.subtitle = "a cord of 1 kg, 3 m long at rest, between ends 2 m apart, cut into links";
    chart.x = {"links", chart::Scale::logarithmic};
    chart.y = {"largest gap between the rest shapes [m]", chart::Scale::logarithmic};
    chart.guides = {-1, -2};
    chart::Series elastic{"to the elastic catenary"}, cosh{"to the cosh"};
    lab::Table gaps{{"links", "gap_to_elastic_catenary_m", "gap_to_cosh_m"}, {}};
    std::vector<double> shares;
    for (std::size_t links = 4; links <= 1024; links *= 2) {
        const HangingChain finer = cut_into(links);
        elastic.x.push_back(double(links)), elastic.y.push_back(gap(finer, cord_of(finer)));
        cosh.x.push_back(double(links)),
            cosh.y.push_back(gap(finer, inextensible(cord_of(finer))));
        shares.push_back(1 / double(links));
        gaps.add({std::to_string(links), lab::exact_digits(elastic.y.back()),
                  lab::exact_digits(cosh.y.back())});
    }
    const double order = lab::observed_order(shares, elastic.y);
    report.number("chain.gap_order", order);
    report.number("chain.cosh_gap_1024", cosh.y.back(), "m");
    report.say("the gap to the elastic catenary shrinks with order " +
               lab::rounded(order, "%.3f") + " in 1/links");
    chart.series = {elastic, cosh};
    report.data("chain_gap.csv", gaps);
    chart::write_svg(chart, report.path("chain_gap.svg"));
}

// --- limits

/// The largest step at which a method does not let a small shake grow, by bisection.
template <class Scene, class Method>
double measured_limit(const Scene& small, const Method& method, double expected) {
    const auto stable = [&](double dt) {
        return lab::stays_within(small, method, dt, 1000, 1e-6,
                                 [](const auto& s) { return fastest_speed(s); });
    };
    return lab::stability_limit(stable, 0.8 * expected, 1.2 * expected, 1e-4);
}

/// Every conditionally stable method on a chain and a cloth, as omega dt with omega of the
/// fastest mode.
void limits_of_methods(lab::Report& report, const SpringNet& a_chain, const SpringNet& a_cloth) {
    lab::Table table{{"method", "predicted", "found on the chain", "found on the cloth"}, {}};
    const double chain_omega = fastest_mode(a_chain, a_chain.start).frequency;
    const double cloth_omega = fastest_mode(a_cloth, a_cloth.start).frequency;
    const auto line = [&](const auto& method, double theta) {
        const auto found = [&](const SpringNet& net, double dt) {
            return measured_limit(shaken(net), method, dt);
        };
        const double on_chain = chain_omega * found(a_chain, theta / chain_omega);
        const double on_cloth = cloth_omega * found(a_cloth, theta / cloth_omega);
        const std::string word = method.key();
        table.add({method.name, lab::rounded(theta, "%.4f"), lab::rounded(on_chain, "%.4f"),
                   lab::rounded(on_cloth, "%.4f")});
        report.number("net_limit." + word + ".predicted", theta);
        report.number("net_limit." + word + ".chain", on_chain);
        report.number("net_limit." + word + ".cloth", on_cloth);
    };
    line(methods::semi_implicit_euler, 2);
    line(methods::verlet, 2);
    line(methods::yoshida4, composed_limit(yoshida_weights()));
    line(methods::kahan_li8, composed_limit(kahan_li_weights()));
    line(methods::rk4, std::sqrt(8.0));
    report.print(table);
    report.data("net_methods.csv", table);
}

void find_limits(lab::Report& report) {
    report.heading("The largest step of Verlet [s]: by formula, by the fastest mode, by running");
    constexpr double mass = 0.02, stiffness = 50;
    lab::Table table{{"scene", "formula", "fastest mode", "measured", "measured / formula"}, {}};
    const auto line = [&](const std::string& name, const std::string& word, const SpringNet& net,
                          double fastest) {
        const double formula = 2 / fastest, mode = 2 / fastest_mode(net, net.start).frequency,
                     measured = measured_limit(shaken(net), methods::verlet, formula);
        table.add({name, lab::rounded(formula, "%.6f"), lab::rounded(mode, "%.6f"),
                   lab::rounded(measured, "%.6f"), lab::rounded(measured / formula, "%.4f")});
        report.number("net_limit." + word + ".formula", formula, "s");
        report.number("net_limit." + word + ".mode", mode, "s");
        report.number("net_limit." + word + ".measured", measured, "s");
        report.number("net_limit." + word + ".in_structural",
                      formula / std::sqrt(net.start.mass[0] / stiffness));
    };
    line("chain of 10, both ends held", "chain",
         chain(10, mass, {stiffness, 0.1}, {0, 0, 0}, {1.1, 0, 0}),
         chain_frequency(10, mass, stiffness));
    line("chain of 10, one end free", "chain_free",
         chain(10, mass, {stiffness, 0.1}, {0, 0, 0}, {1, 0, 0}, true),
         chain_frequency(10, mass, stiffness, true));
    for (const auto& [weave, name, word] :
         {std::tuple(Weave::structural, "cloth, structural", "cloth_structural"),
          std::tuple(Weave::with_shear, "cloth, and shear", "cloth_shear"),
          std::tuple(Weave::with_shear_and_bend, "cloth, and bend", "cloth_bend")}) {
        const SpringNet net = cloth(24, 1, mass * 24 * 24, stiffness, weave);
        line(name, word, net, cloth_frequency(net.springs.kinds, mass));
    }
    report.print(table);
    report.data("chain_cloth_limits.csv", table);
    limits_of_methods(report, chain(10, mass, {stiffness, 0.1}, {0, 0, 0}, {1.1, 0, 0}),
                      cloth(24, 1, mass * 24 * 24, stiffness, Weave::with_shear_and_bend));
}

// --- the cloth

/// The cloth as two meshes: stripes of three springs' width, so that the eye sees how it drapes.
pic::Mesh stripes(const SpringNet& net, const Particles& all, const Vector3& lift, int which,
                  const pic::Colour& colour) {
    pic::Mesh mesh;
    mesh.colour = colour, mesh.smooth = true;
    for (std::size_t i = 0; i < all.size(); ++i) mesh.points.push_back(all.position[i] + lift);
    const int columns = static_cast<int>(net.springs.columns),
              rows = static_cast<int>(net.springs.rows);
    for (int r = 0; r + 1 < rows; ++r)
        for (int c = 0; c + 1 < columns; ++c) {
            if (c / 3 % 2 != which) continue;
            const int a = r * columns + c, b = a + 1, d = a + columns, e = d + 1;
            mesh.triangles.push_back({a, d, b});
            mesh.triangles.push_back({b, d, e});
        }
    return mesh;
}

pic::Shot draw_cloth(const SpringNet& net, const Particles& all, pic::Size size,
                     const std::string& title, const std::string& caption) {
    const Vector3 lift(0, 2, 0);
    pic::Drawing drawing;
    drawing.add(stripes(net, all, lift, 0, pic::palette::body));
    drawing.add(
        stripes(net, all, lift, 1, pic::mix(pic::palette::body, pic::palette::paper, 0.55F)));
    for (const std::size_t i : net.held) {
        const Vector3 corner = net.start.position[i] + lift;
        drawing.add(pic::Rod{.from = {corner.x(), 0, corner.z()}, .to = corner, .radius = 0.02});
        drawing.add(pic::Ball{.centre = corner, .radius = 0.04, .colour = pic::palette::steel});
    }
    if (!title.empty()) drawing.title(title);
    if (!caption.empty()) drawing.caption(caption);
    const pic::Camera camera{
        .eye = {1.9, 1.7, 4.3}, .target = {0.56, 1.05, 0}, .field_of_view = 0.55};
    return {drawing, camera, size};
}

double farthest(const Particles& a, const Particles& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most, (a.position[i] - b.position[i]).norm());
    return most;
}

void hang_a_cloth(lab::Report& report) {
    report.heading("A cloth hung up by two corners");
    constexpr std::size_t n = 24;
    constexpr double side = 1.5, mass = 0.5, stiffness = 60, drag = 2e-3,
                     settle_dt = 1e-3;  // [m], [kg], [N/m], [kg/s], [s]
    constexpr double narrower = 0.75;   // the held corners' distance over the cloth's side
    SpringNet net = cloth(n, side, mass, stiffness, Weave::with_shear_and_bend);
    net.held = {0, n - 1}, net.drag = drag, net.duration = 60;
    for (std::size_t i = 0; i < n * n;
         ++i) {  // the corners come closer, and the cloth between them bulges
        const double across = static_cast<double>(i % n) / (n - 1);
        net.start.position.x[i] *= narrower;
        net.start.position.z[i] += 0.3 * std::sin(pi * across) + 0.03 * std::sin(3 * pi * across);
    }
    net.start =
        lab::run(net, methods::semi_implicit_euler, std::lround(net.duration / settle_dt));
    double speed = 0;
    for (std::size_t i = 0; i < net.start.size(); ++i)
        speed = std::max(speed, net.start.velocity[i].norm());
    report.number("cloth.rest_speed", speed, "m/s");
    report.number("cloth.droop",
                  -*std::min_element(net.start.position.y.begin(), net.start.position.y.end()),
                  "m");
    pic::save(report.path("cloth.png"),
              {report.command(),
               "cloth, 24 x 24 particles, 1.5 m, 0.5 kg, held at two corners",
               "semi-implicit Euler",
               lab::rounded(settle_dt, "%g s"),
               {{"fastest particle", speed, "m/s"}}},
              [&]() -> pic::Sheet {
                  return draw_cloth(net, net.start, {}, "A cloth hung up by two corners",
                                    "24 x 24 particles, springs to the next, across, and to the "
                                    "next but one; at rest");
              });

    net.drag = 0;
    const double mode = 2 / fastest_mode(net, net.start, 4000).frequency;
    const auto strays = [&](double dt, long steps) {
        Particles all = net.start;
        auto verlet_step = methods::verlet.start(net);
        long step = 0;
        for (; step < steps && farthest(all, net.start) < 2 * side / n; ++step)
            all = verlet_step(std::move(all), net, double(step) * dt, dt);
        return std::pair(all, step);
    };
    Particles above,
        below;  // at 1.01 of the limit until a particle strays, and at 0.99 for as many steps
    long steps = 0, same = 0;
    std::tie(above, steps) = strays(1.01 * mode, 100'000);
    std::tie(below, same) = strays(0.99 * mode, steps);
    report.number("cloth.limit", mode, "s");
    report.number("cloth.steps", double(steps));
    report.number("cloth.strays_at_0.99", farthest(below, net.start), "m");
    report.number("cloth.strays_at_1.01", farthest(above, net.start), "m");
    report.say("Verlet at 0.99 of its limit strays " + lab::rounded(farthest(below, net.start)) +
               " m in " + std::to_string(same) + " steps, at 1.01 " +
               lab::rounded(farthest(above, net.start)) + " m in " + std::to_string(steps));
}

}  // namespace

void chains_and_cloths(lab::Report& report) {
    hang_a_chain(report);
    find_limits(report);
    hang_a_cloth(report);
}

}  // namespace nutshell
