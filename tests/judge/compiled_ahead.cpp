#include "compiled_ahead.hpp"
#include <algorithm>
#include "compiler.hpp"
#include "product.hpp"
#include "text.hpp"

namespace nutshell::judge {

namespace fs = std::filesystem;

namespace {

/// A function that can be declared here and compiled elsewhere: inline, at the left margin, no template.
struct Function {
    std::string head;               ///< the first line without attributes and without inline
    std::size_t first, open, last;  ///< lines, from 0: where it begins, and of its braces
    bool exercise;                  ///< its body holds one
};

/// What stands behind attributes and "inline "; nothing where a line does not begin so.
std::string behind_inline(const std::string& line) {
    const auto attributes = starts_with(line, "[[") ? line.find("]] ") : std::string::npos;
    const std::string rest = attributes == std::string::npos ? line : line.substr(attributes + 3);
    return starts_with(rest, "inline ") ? rest.substr(7) : "";
}

bool ends_with(const std::string& line, const std::string& end) {
    return line.size() >= end.size() && line.compare(line.size() - end.size(), end.size(), end) == 0;
}

/// Whether a line ends what it is part of, so that the next one begins something.
bool is_end(const std::string& line) {
    return line.empty() || starts_with(line, "//") || starts_with(line, "#") || ends_with(line, ";") ||
           ends_with(line, "{") || ends_with(line, "}");
}

std::vector<Function> functions_of(const Marked& header) {
    std::vector<Function> all;
    const auto& lines = header.lines;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        Function found{behind_inline(lines[i]), i, i, i, false};
        if (found.head.empty() || (i > 0 && !is_end(lines[i - 1]))) continue;
        std::string head = found.head;
        while (found.open + 1 < lines.size() && !is_end(lines[found.open])) head += " " + lines[++found.open];
        const std::string before = head.substr(0, head.find('('));
        const bool member = contains(before.substr(before.find_last_of(" *&") + 1), "::");
        if (member || names(head, "auto") || names(head, "constexpr") || !ends_with(head, ") {")) continue;
        found.last = found.open;
        while (found.last + 1 < lines.size() && lines[found.last] != "}") ++found.last;
        found.exercise = std::any_of(header.bodies.begin(), header.bodies.end(), [&](const Body& body) {
            return found.open < body.begin && body.end < found.last;
        });
        all.push_back(found);
        i = found.last;
    }
    return all;
}

struct Header {
    Marked text;
    std::vector<Function> functions;
    std::vector<std::string> includes;  ///< "nutshell/newton.hpp"
    bool as_it_is = false;              ///< an exercise in it is no function that can be compiled elsewhere
};

/// A header with as many lines, in which its functions are not inline, and only some have bodies.
std::string split(const Header& header, bool with_exercises, bool with_others) {
    std::vector<std::string> lines = header.text.lines;
    for (const Function& function : header.functions) {
        lines[function.first] = function.head;
        if (function.exercise ? with_exercises : with_others) continue;
        lines[function.open].replace(lines[function.open].size() - 2, 2, ";");
        for (std::size_t i = function.open + 1; i <= function.last; ++i) lines[i].clear();
    }
    return joined(lines, "\n") + "\n";
}

/// The name in an #include.
std::string included(const std::string& line) {
    const auto begin = line.find_first_of("<\"") + 1;
    return line.substr(begin, line.find_first_of(">\"", begin) - begin);
}

/// The names of our headers that a file with questions includes, by itself or by its helpers.
void read_questions(const fs::path& file, std::set<std::string>& found) {
    for (const auto& line : lines_of(read_text(file))) {
        if (starts_with(line, "#include <nutshell/")) found.insert(included(line));
        if (const fs::path helper = file.parent_path() / included(line);
            starts_with(line, "#include \"") && fs::exists(helper))
            read_questions(helper, found);
    }
}

/// The chapters' headers that a chapter's questions read, by their names.
class Headers {
  public:
    Headers(const Rooms& rooms, const Chapter& chapter)
        : chapter_(chapter), folders_(chapter_folders(rooms, chapter.number)) {
        for (const Number number : chapter.exercises) {
            read_questions(questions_file(rooms, chapter, number), reads[number]);
            for (const auto& name : reads[number]) read(name);
        }
        const auto stays = [&](const std::string& name) { return all.count(name) && all[name].as_it_is; };
        for (bool more = true; more;) {  // what includes one that stays as it is, stays so too
            more = false;
            for (auto& [name, header] : all)
                if (!header.as_it_is && std::any_of(header.includes.begin(), header.includes.end(), stays))
                    header.as_it_is = more = true;
        }
    }

    std::map<Number, std::set<std::string>> reads;
    std::map<std::string, Header> all;

  private:
    void read(const std::string& name) {
        if (all.count(name)) return;
        fs::path file;
        for (const fs::path& folder : folders_)
            if (fs::exists(folder / name)) file = folder / name;
        if (file.empty()) return;  // not a chapter's
        const bool own = std::any_of(chapter_.headers.begin(), chapter_.headers.end(),
                                     [&](const auto& header) { return header.path == name; });
        Header header;
        header.text = marked(own ? skeleton(read_text(file)) : read_text(file));
        if (!own) header.text.bodies.clear();  // no exercises here
        header.functions = functions_of(header.text);
        header.as_it_is = std::count_if(header.functions.begin(), header.functions.end(),
                                        [](const Function& function) { return function.exercise; }) !=
                          static_cast<std::ptrdiff_t>(header.text.bodies.size());
        for (const auto& line : header.text.lines)
            if (starts_with(line, "#include <nutshell/")) header.includes.push_back(included(line));
        all[name] = header;
        for (const auto& other : header.includes) read(other);
    }

    const Chapter& chapter_;
    std::vector<fs::path> folders_;
};

/// What is left of a header without its exercises and comments.
std::string given(const Marked& header) {
    std::map<Number, std::string> none;
    for (const Body& body : header.bodies) none[body.number] = "";
    return bare_code(replaced(with_bodies(header, none), "#include <nutshell/unanswered.hpp>\n", ""));
}

bool fits(const Rooms& rooms, const Chapter& chapter, const std::vector<Marked>& own) {
    for (std::size_t i = 0; i < own.size(); ++i)
        if (given(own[i]) != given(chapter.headers[i].reference)) return false;
    const fs::path folder = rooms.answers / chapter.folder / "nutshell";
    std::error_code problem;
    for (const auto& entry : fs::directory_iterator(folder, problem))
        if (const fs::path name = fs::path("nutshell") / entry.path().filename();
            starts_with(name.extension().string(), ".h") &&
            std::none_of(chapter.headers.begin(), chapter.headers.end(),
                         [&](const auto& header) { return header.path == name; }))
            return false;
    return true;
}

/// Writes these files and removes all others from the folder.
void write_all(const fs::path& folder, const std::map<std::string, std::string>& files) {
    fs::create_directories(folder);
    for (const auto& [name, text] : files) write_if_changed(folder / name, text);
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && !files.count(entry.path().lexically_relative(folder).string()))
            fs::remove(entry.path());
}

}  // namespace

bool Ahead::can_be_asked_from_outside(const std::vector<Number>& numbers) const {
    return std::none_of(numbers.begin(), numbers.end(), [&](Number number) {
        return std::find(templates.begin(), templates.end(), number) != templates.end();
    });
}

std::string Ahead::headers_for(const std::vector<Number>& numbers) const {
    std::set<std::string> all;
    for (const Number number : numbers) all.insert(reads.at(number).begin(), reads.at(number).end());
    std::string lines;
    for (const auto& name : all) lines += "#include <" + name + ">\n";
    return lines;
}

std::optional<Ahead> ahead_of(const Rooms& rooms, const Chapter& chapter, const std::vector<Marked>& own) {
    const fs::path folder = rooms.shared / "ahead" / chapter.folder, source = folder / "bodies.cpp";
    Ahead ahead{folder / "bodies.o", folder / "sheet", {}, folder / "questions"};
    auto words = compiler_words(rooms, true);
    for (const auto& word : precompiled(rooms, true)) words.push_back(word);
    words.push_back("-I" + (folder / "bodies").string());
    for (const auto& each : chapter_folders(rooms, chapter.number)) words.push_back("-I" + each.string());
    // each function by itself, so that a sheet takes those that it calls
    words.insert(words.end(), {"-w", "-ffunction-sections", "-c", source.string(), "-MMD", "-MF",
                               ahead.bodies.string() + ".d", "-o", ahead.bodies.string()});

    const Lock lock(rooms.shared);
    fs::create_directories(folder);
    if (!fits(rooms, chapter, own)) return std::nullopt;
    Headers headers(rooms, chapter);
    ahead.reads = headers.reads;
    std::map<std::string, std::string> for_bodies, for_sheet, for_questions;
    std::string all;
    for (const auto& [name, header] : headers.all) {
        if (header.as_it_is) continue;
        all += "#include <" + name + ">\n";
        for_bodies[name] = split(header, false, true);
        for_sheet[name] = split(header, true, false);
        for_questions[name] = split(header, false, false);
    }
    if (all.empty()) return std::nullopt;
    for (const auto& header : chapter.headers) {
        const auto found = for_sheet.find(header.path);
        const bool declared = found != for_sheet.end();
        ahead.skeletons.push_back(marked(declared ? found->second : skeleton(header.reference.text())));
        if (declared)
            for_sheet.erase(found);
        else
            for (const Body& body : header.reference.bodies) ahead.templates.push_back(body.number);
    }
    write_all(folder / "bodies", for_bodies);
    write_all(ahead.for_sheet, for_sheet);
    write_all(ahead.for_questions, for_questions);
    write_if_changed(source, all);
    const Product product{ahead.bodies, words, {.wall_seconds = 300}};
    if (!product.is_fresh())
        if (const Ran ran = product.make(); ran.exit_code != 0)
            throw MachineFault("the course's own functions could not be compiled:\n" + ran.err);
    return ahead;
}

}  // namespace nutshell::judge
