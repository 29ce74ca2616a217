// The cloth of chapter 3, hung up by two corners and at rest: past its limit it breaks in its
// fastest mode. The pointer pulls it.
#include <nutshell/sentence.hpp>
#include "net.hpp"

namespace nutshell {

namespace {

constexpr std::size_t n = 24;
constexpr double side = 1.5, mass = 0.5, stiffness = 60;  // [m], [kg], [N/m]: as in the chapter

/// Hung up by two corners that are closer together than it is wide, and braked until it rests.
SpringNet at_rest() {
    SpringNet net = cloth(n, side, mass, stiffness, Weave::with_shear_and_bend);
    net.held = {0, n - 1};
    for (std::size_t i = 0; i < n * n;
         ++i) {  // the cloth between the corners bulges: an arch near sin(pi x)
        const double across = static_cast<double>(i % n) / (n - 1);
        net.start.position.x[i] *= 0.75;
        const double square = across * (1 - across), arch = 16 * square / (5 - 4 * square);
        net.start.position.z[i] += 0.3 * arch + 0.03 * arch * (3 - 4 * arch * arch);
    }
    return braked(std::move(net), 6e-3, 8);
}

const SpringNet& rested() {
    static const SpringNet net = at_rest();
    return net;
}

class LiveCloth : public LiveNet {
  public:
    LiveCloth()
        : LiveNet(rested(), fastest_mode(rested(), rested().start, 1500).frequency, 1.2, 0.15,
                  {0, 2, 0}) {}
    std::vector<live::State> states() const override {
        const double limit = 1e3 * limit_of(2);
        return {{.key = "above",
                 .words = phrase("{} at 1.01 of its limit", methods::verlet),
                 .setting = {2, {1.01 * limit}},
                 .time = 0.32,
                 .instants = {0.1, 0.25, 0.3, 0.32, 0.34}},
                {.key = "below",
                 .words = phrase("{} at 0.99 of its limit", methods::verlet),
                 .setting = {2, {0.99 * limit}},
                 .time = 0.32}};
    }
    pic::Drawing drawing(double) const override {
        pic::Drawing drawing;
        drawing.stage({{0.55, 1, 0.1}, 1.4});
        drawing.ground({.spacing = 0.5});
        drawing.add(stripes(0, pic::palette::body));
        drawing.add(stripes(1, pic::mix(pic::palette::body, pic::Colour{1, 1, 1}, 0.55F)));
        for (const std::size_t i : net_.held) {
            const Vector3 corner = net_.start.position[i] + lift_;
            drawing.add(
                pic::Rod{.from = {corner.x(), 0, corner.z()}, .to = corner, .radius = 0.02});
            drawing.add(
                pic::Ball{.centre = corner, .radius = 0.04, .colour = pic::palette::steel});
        }
        return drawing;
    }
    pic::Size size() const override { return {560, 540}; }
    pic::Camera camera(pic::Size) const override {
        return {.eye = {1.9, 1.7, 4.3}, .target = {0.56, 1.05, 0}, .field_of_view = 0.55};
    }

  private:
    /// Stripes of three springs' width, so that the eye sees how it drapes.
    pic::Mesh stripes(int which, const pic::Colour& colour) const {
        pic::Mesh mesh;
        mesh.colour = colour, mesh.smooth = true;
        for (std::size_t i = 0; i < now().size(); ++i)
            mesh.points.push_back(now().position[i] + lift_);
        const int columns = n, rows = n;
        for (int r = 0; r + 1 < rows; ++r)
            for (int c = 0; c + 1 < columns; ++c) {
                if (c / 3 % 2 != which) continue;
                const int a = r * columns + c, b = a + 1, d = a + columns, e = d + 1;
                mesh.triangles.push_back({a, d, b});
                mesh.triangles.push_back({b, d, e});
            }
        return mesh;
    }
};

const live::Entry entry{"cloth_limit",
                        [] { return std::unique_ptr<live::Figure>(new LiveCloth); }};

}  // namespace

}  // namespace nutshell
