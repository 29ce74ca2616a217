// make_meshes FOLDER: writes the meshes of the course. A test compares what is in the repository with what this
// would write.
#include <cstdio>
#include <nutshell/mesh_shapes.hpp>
#include <nutshell/obj.hpp>
#include <nutshell/write_file.hpp>

using namespace nutshell;

int main(int argc, char** argv) {
    if (argc != 2) return std::fprintf(stderr, "make_meshes FOLDER\n"), 2;
    for (const auto& [name, mesh] : course_meshes())
        write_file(std::filesystem::path(argv[1]) / (name + ".obj"), obj_text(mesh, mesh_comment(name)));
}
