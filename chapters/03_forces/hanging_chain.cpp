// A chain between two ends: how it hangs, and how close that is to the exact shape.
#include <nutshell/chain_scenes.hpp>
#include <nutshell/chart/chart.hpp>
#include <nutshell/hanging_chain.hpp>
#include <nutshell/lab/run.hpp>
#include <nutshell/newton_methods.hpp>
#include <nutshell/picture/picture.hpp>
#include "scale.hpp"

namespace nutshell {

namespace pic = picture;

namespace {

constexpr double cord_mass = 1, cord_length = 3,
                 cord_stiffness = 40;  // [kg], at rest [m], tension over stretch [N]

/// The cord cut into links, between two ends at the same height, 2 m apart.
HangingChain cut_into(std::size_t links) {
    const auto n = static_cast<double>(links);
    return {
        links - 1, cord_mass / n, {cord_stiffness * n / cord_length, cord_length / n}, {2, 0}};
}

std::string words_of(const HangingChain& chain) {
    return "hanging chain, " + std::to_string(chain.masses) + " masses, " +
           std::to_string(chain.masses + 1) + " links";
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
               words_of(chain) + ", " + lab::rounded(cord_mass) + " kg, " +
                   lab::rounded(cord_length) + " m at rest",
               methods::semi_implicit_euler.name,
               lab::rounded(dt, "%g s"),
               {{"largest distance to the exact shape", error, "m"},
                {"largest distance to the cosh", cosh_gap, "m"}}},
              [&]() -> pic::Sheet {
                  return pic::Shot{drawing, camera};
              });
}

/// The chain let go in a straight line, at five instants: one camera, one scale.
void draw_falling_chain(lab::Report& report, SpringNet net, const std::string& words, double dt) {
    const Vector3 lift(0, 1.75, 0);  // [m]
    std::vector<pic::Drawing> instants;
    for (const double t : {0.0, 0.15, 0.3, 0.6, 5.0}) {
        net.duration = t;
        const Particles now =
            t == 0 ? net.start : lab::run(net, methods::semi_implicit_euler, std::lround(t / dt));
        pic::Drawing drawing;
        for (const std::size_t i : {std::size_t{0}, now.size() - 1}) {
            const Vector3 end = now.position[i] + lift;
            drawing.add(pic::Rod{.from = {end.x(), 0, 0}, .to = end, .radius = 0.05});
        }
        for (std::size_t i = 0; i + 1 < now.size(); ++i)
            drawing.add(pic::Rod{.from = now.position[i] + lift,
                                 .to = now.position[i + 1] + lift,
                                 .radius = 0.025});
        for (std::size_t i = 1; i + 1 < now.size(); ++i)
            drawing.add(pic::Ball{.centre = now.position[i] + lift,
                                  .radius = 0.08,
                                  .colour = pic::palette::symplectic});
        drawing.title(lab::rounded(t) + " s");
        instants.push_back(drawing);
    }
    const pic::Size size{400, 420};
    const pic::Camera camera = pic::fit(instants.back(), {0.12, 0.16, 1}, size, {.margin = 0.06});
    pic::save(report.path("chain_falls.png"),
              {report.command(),
               words + ", let go in a straight line",
               methods::semi_implicit_euler.name,
               lab::rounded(dt, "%g s"),
               {}},
              [&]() -> pic::Sheet {
                  std::vector<pic::Shot> shots;
                  for (const pic::Drawing& drawing : instants)
                      shots.push_back({drawing, camera, size});
                  return {shots, static_cast<int>(shots.size())};
              });
}

}  // namespace

void hanging_chain(lab::Report& report) {
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
        shape.add({i, hung.position.x[i], hung.position.y[i], exact[i].x(), exact[i].y()});
    }
    report.data("chain.csv", shape);
    const EndTension tension = end_tension(chain);
    const double cosh_gap = gap(chain, inextensible(cord_of(chain)));
    report.number("chain.error", error, "m");
    report.number("chain.horizontal", tension.horizontal, "N");
    report.number("chain.sag", -exact[6].y(), "m");
    report.number("chain.catenary_gap", gap(chain, cord_of(chain)), "m");
    report.number("chain.cosh_gap", cosh_gap, "m");
    report.say(words_of(chain) + ", let go and damped: " + lab::rounded(error) +
               " m from the exact rest shape, " + lab::rounded(gap(chain, cord_of(chain))) +
               " m from the elastic catenary, " + lab::rounded(cosh_gap) + " m from the cosh");
    draw_chain(report, hung, chain, error, cosh_gap, net.duration / steps);
    draw_falling_chain(report, net, words_of(chain), net.duration / steps);

    chart::Chart chart;
    chart.title = "With more links: the elastic catenary, not the cosh";
    chart.subtitle = "A cord of " + lab::rounded(cord_mass) + " kg, " +
                     lab::rounded(cord_length) + " m long at rest, between ends " +
                     lab::rounded(chain.end.x()) + " m apart, cut into links.";
    chart.x = {"links", chart::Scale::logarithmic};
    chart.y = {"largest gap between the rest shapes [m]", chart::Scale::logarithmic};
    chart.guides = {-1, -2};
    chart::Series elastic{"to the elastic catenary"}, cosh{"to the cosh"};
    std::vector<double> shares;
    for (std::size_t links = 4; links <= 1024; links *= 2) {
        const HangingChain finer = cut_into(links);
        elastic.add(double(links), gap(finer, cord_of(finer)));
        cosh.add(double(links), gap(finer, inextensible(cord_of(finer))));
        shares.push_back(1 / double(links));
    }
    const double order = lab::observed_order(shares, elastic.y);
    report.number("chain.gap_order", order);
    report.number("chain.cosh_gap_1024", cosh.y.back(), "m");
    report.say("the gap to the elastic catenary shrinks with order " +
               lab::rounded(order, "%.3f") + " in 1/links");
    chart.series = {elastic, cosh};
    report.draw("chain_gap", chart);
}

}  // namespace nutshell
