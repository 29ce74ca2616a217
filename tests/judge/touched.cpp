#include "touched.hpp"
#include <algorithm>
#include <optional>
#include <set>
#include <sstream>
#include "judge_config.hpp"
#include "process.hpp"
#include "text.hpp"

namespace nutshell::judge {

namespace fs = std::filesystem;

namespace {

fs::path kept(const Chapter& chapter) {
    return fs::path(CONFIG_MINE) / "ran" / chapter.folder;
}

std::string without_line_numbers(const std::string& text) {
    std::string all;
    for (const auto& line : lines_of(text))
        if (!starts_with(line, "#line ")) all += line + "\n";
    return all;
}

/// The files under a folder, from there.
std::set<fs::path> files_under(const fs::path& folder) {
    std::set<fs::path> all;
    std::error_code none;
    for (fs::recursive_directory_iterator at(folder, none), end; !none && at != end; at.increment(none))
        if (at->is_regular_file(none)) all.insert(at->path().lexically_relative(folder));
    return all;
}

/// The bodies in which two headers differ; nothing if they differ elsewhere too.
std::optional<std::set<Number>> changed_bodies(const std::string& before, const std::string& now) {
    const Marked old = marked(before), fresh = marked(now);
    const auto outside = [](const Marked& source) {
        std::map<Number, std::string> none;
        for (const Body& body : source.bodies) none[body.number];
        return without_line_numbers(with_bodies(source, none));
    };
    if (outside(old) != outside(fresh)) return std::nullopt;
    std::set<Number> changed;
    for (const Body& body : fresh.bodies)
        if (without_line_numbers(old.body(body.number)->text) != without_line_numbers(body.text))
            changed.insert(body.number);
    return changed;
}

/// The bodies that have changed in all headers of the chapters up to this one.
std::optional<std::set<Number>> changed_since(const Rooms& rooms, const Chapter& chapter) {
    std::set<Number> all;
    for (const Chapter& each : chapters_of(rooms)) {
        if (each.number > chapter.number) continue;
        const fs::path before = kept(chapter) / each.folder, now = fs::path(CONFIG_MINE) / each.folder;
        const auto files = files_under(now);
        if (files != files_under(before)) return std::nullopt;
        for (const auto& file : files) {
            const auto changed = changed_bodies(read_text(before / file), read_text(now / file));
            if (!changed) return std::nullopt;
            all.insert(changed->begin(), changed->end());
        }
    }
    return all;
}

/// Whether a file of the course is newer than the last run.
bool course_is_newer(const fs::path& run) {
    std::error_code none;
    for (const auto* folder : {"common", "chapters"})
        for (const auto& file : files_under(fs::path(CONFIG_COURSE) / folder))
            if (fs::last_write_time(fs::path(CONFIG_COURSE) / folder / file, none) >
                fs::last_write_time(run, none))
                return true;
    return false;
}

std::vector<std::string> words_of(const std::string& line) {
    std::istringstream stream(line);
    std::vector<std::string> all;
    for (std::string word; std::getline(stream, word, '|');) all.push_back(word);
    return all;
}

}  // namespace

std::string touch_line(Number number) {
    return "::nutshell::lab::touched_here.bodies[" + std::to_string(32 * number.chapter + number.exercise) +
           "] = true;\n";
}

fs::path touched_file(const Chapter& chapter) {
    return kept(chapter) / "touched.new";
}

void forget(const Chapter& chapter) {
    std::error_code none;
    fs::remove(kept(chapter) / "touched", none);
}

Anew anew_for(const Rooms& rooms, const Chapter& chapter, const fs::path& out) {
    const fs::path run = kept(chapter) / "touched";
    if (!fs::exists(run) || !fs::exists(out / "numbers.csv") || course_is_newer(run)) return {};
    const auto lines = lines_of(read_text(run));
    const auto changed = changed_since(rooms, chapter);
    if (lines.empty() || lines.front() != fs::absolute(out).string() || !changed || changed->empty())
        return {};
    std::set<std::string> parts, sources;
    for (const auto& line : lines)
        if (const auto words = words_of(line); words.size() == 3)
            if (const auto number = number_of(words[2]); number && changed->count(*number))
                parts.insert(words[0]), sources.insert(words[1]);
    return {false, {parts.begin(), parts.end()}, {sources.begin(), sources.end()}};
}

void remember(const Rooms& rooms, const Chapter& chapter, const fs::path& out, const Anew& made) {
    std::string text = fs::absolute(out).string() + "\n";
    if (!made.all)  // what the other parts ran stays
        for (const auto& line : lines_of(read_text(kept(chapter) / "touched")))
            if (const auto words = words_of(line);
                words.size() == 3 &&
                std::find(made.parts.begin(), made.parts.end(), words[0]) == made.parts.end())
                text += line + "\n";
    text += read_text(touched_file(chapter));
    for (const Chapter& each : chapters_of(rooms)) {
        if (each.number > chapter.number) continue;
        fs::remove_all(kept(chapter) / each.folder);
        for (const auto& file : files_under(fs::path(CONFIG_MINE) / each.folder))
            write_text(kept(chapter) / each.folder / file,
                       read_text(fs::path(CONFIG_MINE) / each.folder / file));
    }
    write_text(kept(chapter) / "touched", text);
}

bool build_sources(const std::string& target, const std::vector<std::string>& sources) {
    const Ran listed = run({CONFIG_NINJA, "-C", CONFIG_BUILD, "-t", "commands", target},
                           {.wall_seconds = 60, .printed = 1 << 22});
    const auto commands = lines_of(listed.out);
    if (listed.exit_code != 0 || commands.empty()) return false;
    std::string link = commands.back();
    std::vector<std::string> build{CONFIG_CMAKE, "--build", CONFIG_BUILD, "--target"};
    std::string first;
    std::istringstream words(link);
    for (std::string word; words >> word;)
        for (const auto& source : sources)
            if (const std::string end =
                    fs::path(source).lexically_normal().lexically_relative(CONFIG_COURSE).string() + ".o";
                word.size() > end.size() && word.ends_with("/" + end))
                build.push_back(word), first += word + " ";
    if (build.size() != 4 + sources.size()) return false;
    for (std::size_t i = 4; i < build.size(); ++i) link = replaced(link, build[i] + " ", "");
    const std::size_t objects = link.find(" tests/judge/CMakeFiles/" + target);
    if (objects == std::string::npos)
        link = replaced(link, " -o ", " " + first + "-o ");
    else
        link.insert(objects + 1, first);
    return run(build, {.wall_seconds = 1800, .printed = 1 << 20}).exit_code == 0 &&
           run({"sh", "-c", "cd \"$0\" && " + link, CONFIG_BUILD}, {.wall_seconds = 300}).exit_code == 0;
}

}  // namespace nutshell::judge
