// The stairs of the house go down only: a chapter includes itself, chapters before it and common/; common/
// includes no chapter; among the rooms of common/, too, the arrows go one way.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include "check.hpp"

namespace {

namespace fs = std::filesystem;
const fs::path project = PROJECT_DIR;

/// The rooms from the ground up: a file may include what is on its own stair or below.
std::vector<fs::path> stairs() {
    std::vector<fs::path> all;
    for (const char* room : {"base", "math", "chart", "lab", "picture", "live"})
        all.push_back(project / "common" / room);
    std::vector<fs::path> chapters;
    for (const auto& entry : fs::directory_iterator(project / "chapters"))
        if (entry.is_directory()) chapters.push_back(entry.path());
    std::sort(chapters.begin(), chapters.end());
    all.insert(all.end(), chapters.begin(), chapters.end());
    return all;
}

std::vector<fs::path> sources(const fs::path& room) {
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(room))
        if (entry.path().extension() == ".hpp" || entry.path().extension() == ".cpp")
            found.push_back(entry.path());
    return found;
}

std::vector<std::string> includes(std::istream& text) {
    static const std::regex line_of(R"(\s*#\s*include\s*[<"]([^>"]+)[>"].*)");
    std::vector<std::string> found;
    std::smatch match;
    for (std::string line; std::getline(text, line);)
        if (std::regex_match(line, match, line_of)) found.push_back(match[1]);
    return found;
}

/// "file includes what": each include from `file` of a header that stands above its room, the stair `here`, or
/// is reached by a path that leaves the room.
std::vector<std::string> upwards(const std::map<std::string, std::size_t>& stair_of, const fs::path& room,
                                 const fs::path& file, std::size_t here, std::istream& text) {
    std::vector<std::string> wrong;
    for (const auto& included : includes(text)) {
        const auto found = stair_of.find(included);
        const fs::path reached = (file.parent_path() / included).lexically_normal().lexically_relative(room);
        const bool leaves = included.rfind("../", 0) == 0 && reached.generic_string().rfind("..", 0) == 0;
        if (leaves || (found != stair_of.end() && found->second > here))
            wrong.push_back(file.lexically_relative(project).generic_string() + " includes " + included);
    }
    return wrong;
}

std::map<std::string, std::size_t> stair_of_each_header(const std::vector<fs::path>& rooms) {
    std::map<std::string, std::size_t> stair_of;  // "nutshell/newton.hpp" and the like
    for (std::size_t i = 0; i < rooms.size(); ++i)
        for (const auto& file : sources(rooms[i])) {
            const std::string name = fs::relative(file, rooms[i]).generic_string();
            if (name.rfind("nutshell/", 0) == 0) stair_of.emplace(name, i);
        }
    return stair_of;
}

}  // namespace

TEST_CASE("no arrow goes up the stairs") {
    const auto rooms = stairs();
    const auto stair_of = stair_of_each_header(rooms);
    REQUIRE(stair_of.count("nutshell/newton.hpp") == 1);
    for (std::size_t i = 0; i < rooms.size(); ++i)
        for (const auto& file : sources(rooms[i])) {
            std::ifstream text(file);
            CHECK(upwards(stair_of, rooms[i], file, i, text) == std::vector<std::string>{});
        }
}

TEST_CASE("an arrow up the stairs is seen") {
    const auto rooms = stairs();
    const auto stair_of = stair_of_each_header(rooms);
    std::istringstream text(
        "#include <vector>\n  # include <nutshell/newton.hpp>  // Newton\n"
        "#include \"../inside.hpp\"\n#include \"../../up.hpp\"\n");
    const auto below = stair_of.at("nutshell/newton.hpp") - 1;
    CHECK(upwards(stair_of, project / "room", project / "room/live/a.cpp", below, text) ==
          std::vector<std::string>{"room/live/a.cpp includes nutshell/newton.hpp",
                                   "room/live/a.cpp includes ../../up.hpp"});
}
