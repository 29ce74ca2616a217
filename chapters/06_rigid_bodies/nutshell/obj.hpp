// Chapter 6 · Wavefront OBJ files: what of them a body needs, read with distrust.
#pragma once
#include <charconv>
#include <filesystem>
#include <fstream>
#include <nutshell/mesh.hpp>
#include <string_view>

namespace nutshell {

inline constexpr std::size_t most_obj_bytes = std::size_t{256}
                                              << 20;           ///< a file larger is refused
inline constexpr std::size_t most_obj_triangles = 16'000'000;  ///< so are more triangles
inline constexpr double most_obj_coordinate = 1e30;            ///< [m]; beyond, inertia overflows

// [obj_reader]
/// Reads the text of one OBJ file, a line at a time: v and f lines; polygons are cut into
/// triangles from their first corner; corners "7", "7/1", "7/1/2" and "7//2"; negative indices
/// count back from the last vertex so far. Everything wrong ends in a std::runtime_error with the
/// file's name, the line and the reason; nothing outside the text is read.
class ObjReader {
  public:
    ObjReader(std::string_view text, std::string name) : rest_(text), name_(std::move(name)) {}

    Mesh read() {
        line_ = 0;
        if (rest_.size() > most_obj_bytes)
            fail("is larger than " + std::to_string(most_obj_bytes) + " bytes");
        while (!rest_.empty()) {
            ++line_;
            const std::size_t end = rest_.find('\n');
            now_ = rest_.substr(0, end);
            rest_.remove_prefix(end == rest_.npos ? rest_.size() : end + 1);
            if (!now_.empty() && now_.back() == '\r') now_.remove_suffix(1);
            now_ = now_.substr(0, now_.find('#'));
            statement();
        }
        if (mesh_.triangles.empty()) fail("holds no faces");
        return std::move(mesh_);
    }

  private:
    std::string_view rest_, now_;  // of the text; of the line
    std::string name_;
    int line_ = 0;
    Mesh mesh_;
    long textures_ = 0, normals_ = 0;  // how many so far
    std::vector<int> face_;

    [[noreturn]] void fail(const std::string& reason) const {
        throw std::runtime_error(name_ + (line_ > 0 ? ":" + std::to_string(line_) : "") + ": " +
                                 reason);
    }

    static bool space(char c) { return c == ' ' || c == '\t'; }

    /// The next word of the line, empty at its end.
    std::string_view word() {
        std::size_t begin = 0;
        while (begin < now_.size() && space(now_[begin])) ++begin;
        std::size_t end = begin;
        while (end < now_.size() && !space(now_[end])) ++end;
        const std::string_view found = now_.substr(begin, end - begin);
        now_.remove_prefix(end);
        return found;
    }

    void statement() {
        const std::string_view kind = word();
        if (kind.empty()) return;
        if (kind == "v") return vertex();
        if (kind == "f") return face();
        if (kind == "vt") return static_cast<void>(++textures_);
        if (kind == "vn") return static_cast<void>(++normals_);
        for (const std::string_view known : {"g", "o", "s", "usemtl", "mtllib", "l", "p", "vp"})
            if (kind == known)
                return;  // groups, names, materials, lines and points have no volume
        fail("'" + printable(kind) + "' begins no statement that this reader knows");
    }

    void vertex() {
        Vector3 p;
        for (int axis = 0; axis < 3; ++axis) p[axis] = number(word());
        for (int more = 0; more < 4; ++more) {  // a weight, or a colour and a weight: not ours
            const std::string_view extra = word();
            if (extra.empty()) break;
            number(extra);
        }
        if (!word().empty())
            fail("a vertex has three coordinates, this one has more than seven numbers");
        mesh_.vertices.push_back(p);
    }

    void face() {
        face_.clear();
        for (std::string_view corner = word(); !corner.empty(); corner = word()) {
            const std::size_t first = corner.find('/');
            face_.push_back(index(corner.substr(0, first),
                                  static_cast<long>(mesh_.vertices.size()), "vertex"));
            if (first == corner.npos) continue;
            corner.remove_prefix(first + 1);
            const std::size_t second = corner.find('/');
            const std::string_view texture = corner.substr(0, second);
            if (second == corner.npos || !texture.empty()) index(texture, textures_, "texture");
            if (second != corner.npos) index(corner.substr(second + 1), normals_, "normal");
        }
        if (face_.size() < 3)
            fail("a face needs three corners, this one has " + std::to_string(face_.size()));
        if (mesh_.triangles.size() + face_.size() > most_obj_triangles)
            fail("more than " + std::to_string(most_obj_triangles) + " triangles");
        for (std::size_t k = 2; k < face_.size(); ++k) {
            mesh_.triangles.push_back({face_[0], face_[k - 1], face_[k]});
            mesh_.lines.push_back(line_);
        }
    }

    double number(std::string_view text) const {
        if (text.empty()) fail("a vertex needs three coordinates; a number is missing");
        if (text.front() == '+') text.remove_prefix(1);
        double value = 0;
        const auto [end, problem] =
            std::from_chars(text.data(), text.data() + text.size(), value);
        if (problem != std::errc() || end != text.data() + text.size())
            fail("'" + printable(text) + "' is not a number that fits");
        if (!(std::abs(value) <= most_obj_coordinate))
            fail("a number is not finite, or larger than 1e30");
        return value;
    }

    /// From an index as it is written, 1 for the first and -1 for the last of `count`, to one
    /// from 0.
    int index(std::string_view text, long count, const char* of) const {
        long value = 0;
        const auto [end, problem] =
            std::from_chars(text.data(), text.data() + text.size(), value);
        if (text.empty() || problem != std::errc() || end != text.data() + text.size())
            fail("'" + printable(text) + "' is not the index of a " + of);
        const bool inside = value < 0 ? value >= -count : value >= 1 && value <= count;
        if (!inside)
            fail("there is no " + std::string(of) + " " + std::to_string(value) +
                 "; the file has " + std::to_string(count) + " so far");
        return static_cast<int>(value < 0 ? value + count : value - 1);
    }

    /// At most thirty characters of a word, those that cannot be printed as dots.
    static std::string printable(std::string_view text) {
        std::string shown(text.substr(0, 30));
        for (char& c : shown)
            if (c < ' ' || c > '~') c = '.';
        return shown;
    }
};
// [/obj_reader]

/// The mesh in the text of an OBJ file. @param name  what errors call it
/// @throws std::runtime_error with name, line and reason if it cannot be read
inline Mesh parse_obj(std::string_view text, const std::string& name = "OBJ") {
    return ObjReader(text, name).read();
}

/// The mesh in an OBJ file. Each call gives a new mesh; nothing is added to an old one.
/// @throws std::runtime_error with the path and the reason if it cannot be opened or read
inline Mesh load_obj(const std::filesystem::path& path) {
    std::error_code problem;
    const auto bytes = std::filesystem::file_size(path, problem);
    if (problem) throw std::runtime_error(path.string() + ": " + problem.message());
    if (bytes > most_obj_bytes)
        throw std::runtime_error(path.string() + ": is larger than " +
                                 std::to_string(most_obj_bytes) + " bytes");
    std::string text(bytes, '\0');
    std::ifstream file(path, std::ios::binary);
    if (!file.read(text.data(), static_cast<std::streamsize>(bytes)))
        throw std::runtime_error(path.string() + ": cannot be read");
    return parse_obj(text, path.string());
}

/// The text of an OBJ file that reads back as the same mesh, every digit.
/// @param comment  its first line, after "# "
inline std::string obj_text(const Mesh& mesh, const std::string& comment) {
    std::ostringstream text;
    text.precision(17);
    text << "# " << comment << '\n';
    for (const Vector3& v : mesh.vertices)
        text << "v " << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
    for (const auto& [i, j, k] : mesh.triangles)
        text << "f " << i + 1 << ' ' << j + 1 << ' ' << k + 1 << '\n';
    return text.str();
}

}  // namespace nutshell
