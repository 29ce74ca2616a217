// One run of the fuzzer: whatever the bytes, either an error of the right type that says something, or a mesh
// that can be trusted; and of that mesh either a reason why it is no body, or a body that can exist.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <nutshell/obj.hpp>

using namespace nutshell;

namespace {

void must(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "broken promise: %s\n", what);
    std::abort();
}

void check_mesh(const Mesh& mesh) {
    const auto count = static_cast<int>(mesh.vertices.size());
    must(!mesh.triangles.empty(), "a mesh without faces is refused");
    must(mesh.lines.size() == mesh.triangles.size(), "every triangle has its line");
    for (const auto& triangle : mesh.triangles)
        for (const int corner : triangle) must(corner >= 0 && corner < count, "corners are vertices");
    for (const Vector3& vertex : mesh.vertices)
        must(vertex.allFinite() && vertex.cwiseAbs().maxCoeff() <= most_obj_coordinate,
             "vertices are finite");
    const Mesh again = parse_obj(obj_text(mesh, "again"));
    must(again.vertices == mesh.vertices && again.triangles == mesh.triangles, "what is written reads back");
}

void check_body(const Mesh& mesh, const MassProperties& body) {
    must(std::isfinite(body.mass) && body.mass > 0, "the mass is greater than zero");
    must(body.centre.allFinite() && body.inertia.allFinite(), "centre and inertia are finite");
    Vector3 low = mesh.vertices[static_cast<std::size_t>(mesh.triangles[0][0])], high = low;
    for (const auto& triangle : mesh.triangles)
        for (const int corner : triangle) {
            low = low.cwiseMin(mesh.vertices[static_cast<std::size_t>(corner)]);
            high = high.cwiseMax(mesh.vertices[static_cast<std::size_t>(corner)]);
        }
    const Vector3 slack = 1e-4 * (high - low) + 1e-12 * high.cwiseAbs() + 1e-12 * low.cwiseAbs();
    must((body.centre.array() >= (low - slack).array()).all() &&
             (body.centre.array() <= (high + slack).array()).all(),
         "the centre lies in the box");
    must(why_impossible(symmetric_axes(body.inertia).moments, 1e-4).empty(), "a body can have this inertia");
}

}  // namespace

/// 0: refused by the reader, 1: a mesh that is no body, 2: a body.
int outcome(std::string_view text) {
    Mesh mesh;
    try {
        mesh = parse_obj(text, "input");
    } catch (const std::runtime_error& problem) {
        must(std::string_view(problem.what()).substr(0, 5) == "input",
             "an error begins with the file's name");
        return 0;
    }
    check_mesh(mesh);
    try {
        check_body(mesh, mass_properties(mesh, 1));
    } catch (const std::invalid_argument& problem) {
        must(problem.what()[0] != '\0', "a refusal has its reason");
        return 1;
    }
    return 2;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    outcome({reinterpret_cast<const char*>(data), size});
    return 0;
}
