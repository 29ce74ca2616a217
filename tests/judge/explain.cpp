// What a compiler says, in words for a learner: the learner's own line first, never a list of templates.
#include "explain.hpp"
#include <algorithm>
#include <regex>
#include "sheets.hpp"
#include "text.hpp"
#include "tokens.hpp"

namespace nutshell::judge {

namespace {

struct Said {
    std::string file, message;
    std::size_t line = 0;
    std::size_t at = 0;  ///< the place of its error among all that was said
};

bool is_error(const std::string& text, std::smatch& found) {
    static const std::regex error(R"(^(.*?):(\d+)(?::\d+)?: (?:fatal )?error: (.*)$)");
    return std::regex_match(text, found, error);
}

/// All that was said, in lines short enough for a regular expression (a learner's line may have any length):
/// of a long one the begin and the end, where a compiler says from what to what it cannot convert.
std::vector<std::string> short_lines(const std::string& said) {
    auto lines = lines_of(said);
    for (auto& line : lines)
        if (line.size() > 1000) line.replace(600, line.size() - 1000, " ... ");
    return lines;
}

/// The first error that is on a line below `own`, or was called from one; else the first of all.
Said first_error(const std::vector<std::string>& lines, const std::string& own) {
    static const std::regex context(
        R"(^(.*?):(\d+)(?::\d+)?: (?:  required (?:from|by)|  recursively required|note: in instantiation|note: in call).*$)");
    std::smatch found;
    const auto is_any_error = [&](std::size_t k) { return is_error(lines[k], found); };
    Said first;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (!is_any_error(i)) continue;
        const Said here{found[1], found[3], static_cast<std::size_t>(std::stoul(found[2])), i};
        if (starts_with(here.file, own)) return here;
        if (first.file.empty()) first = here;
        std::size_t begin = i, end = i + 1;
        while (begin > 0 && !is_any_error(begin - 1)) --begin;
        while (end < lines.size() && !is_any_error(end)) ++end;
        std::vector<std::size_t> order;  // g++ says who called before the error, clang after it
        for (std::size_t k = begin; k < end; ++k)
            if (k != i) order.push_back(k);
        for (const std::size_t k : order)
            if (std::regex_match(lines[k], found, context) && starts_with(found[1].str(), own))
                return {found[1], here.message, static_cast<std::size_t>(std::stoul(found[2])), i};
    }
    return first;
}

/// The notes that belong to the error at `at`, in plain types.
std::string notes_after(const std::vector<std::string>& lines, std::size_t at) {
    std::string notes;
    std::smatch found;
    for (std::size_t k = at + 1; k < lines.size() && k < at + 30 && !is_error(lines[k], found); ++k)
        if (const auto note = lines[k].find(" note: "); note != std::string::npos)
            notes += plain_types(lines[k].substr(note)) + "\n";
    return notes;
}

/// Braces that do not pair up inside a body are told best by counting them.
std::optional<CompileProblem> unpaired_braces(const Marked& learner, const std::string& name) {
    for (const Body& body : learner.bodies) {
        const std::string code = bare_code(body.text);
        const auto opened = std::count(code.begin(), code.end(), '{'),
                   closed = std::count(code.begin(), code.end(), '}');
        if (opened == closed) continue;
        CompileProblem problem;
        problem.number = body.number;
        problem.where = name + ":" + std::to_string(body.begin + 2);
        problem.line = trimmed(learner.lines[body.begin + 1]);
        problem.message = "Between its marks, the answer to " + body.number.text() + " opens " +
                          std::to_string(opened) + " braces { and closes " + std::to_string(closed) + ".";
        return problem;
    }
    return std::nullopt;
}

/// The line `#include <...>` that is missing, as far as the compiler's words tell.
std::string missing_include(const std::vector<std::string>& lines, const Said& error,
                            const std::string& message) {
    static const std::regex include(R"(#include (<[\w/.]+>))"),
        member(R"(no member named '(\w+)' in namespace 'std')");
    std::smatch found;
    for (std::size_t k = error.at; k < lines.size() && k < error.at + 8; ++k)
        if (contains(lines[k], "note:") && std::regex_search(lines[k], found, include)) return found[1];
    if (!std::regex_search(message, found, member)) return "";
    const std::string name = found[1];
    return "<" + (name == "cout" || name == "cerr" || name == "endl" ? "iostream" : name) + ">";
}

/// clang tells in a note why a function cannot be called.
std::string from_notes(const std::string& message, const std::string& notes) {
    static const std::regex count(R"((?:requires|expects) (\d+) arguments?, (?:but )?(\d+) (?:w|provided))"),
        type(
            R"(no known conversion (?:for argument (\d+) )?from '(?:const )?([^']*)' to '(?:const )?([^']*?)&?')");
    static const std::regex axis(
        R"(candidate: '?template ?<(?:int|std::size_t|unsigned int|long unsigned int|long int) \w+>[^(]*?(\w+)\()");
    std::smatch found;
    if (contains(message, "no viable overloaded") &&
        (contains(notes, "not marked const") || contains(notes, "conversion from 'const ")))
        return says_const;
    if (!contains(message, "no matching function")) return "";
    if (std::regex_search(notes, found, axis))
        return found[1].str() + " takes its number in angle brackets: " + found[1].str() + "<0>(...).";
    if (std::regex_search(notes, found, count) && !std::regex_search(notes, type))
        return std::string("This function is called with too ") +
               (std::stoi(found[2]) < std::stoi(found[1]) ? "few" : "many") +
               " values: look at its line in the header.";
    int furthest = 0;  // of several functions of this name, the one that more values fit is meant
    std::string meaning;
    for (std::sregex_iterator each(notes.begin(), notes.end(), type), end; each != end; ++each) {
        const int argument = (*each)[1].matched ? std::stoi((*each)[1]) : 0;
        if (!meaning.empty() && argument <= furthest) continue;
        furthest = argument;
        meaning =
            "A value of type " + (*each)[2].str() + " stands where a " + (*each)[3].str() + " is needed.";
    }
    return meaning;
}

/// The semicolon that is missed before a line's first word belongs to the line above.
void move_up_to_semicolon(CompileProblem& problem, const Marked& learner, std::size_t line,
                          const std::string& name) {
    static const std::regex before("before '(.*)'");
    if (!contains(problem.message, "semicolon") || line < 2 || line > learner.lines.size()) return;
    std::size_t above = line - 1;  // counted from 1
    while (above > 1 && bare_code(learner.lines[above - 1]).empty()) --above;
    const std::string code = bare_code(learner.lines[above - 1]);
    std::smatch found;
    const std::string word = std::regex_search(problem.compiler, found, before) ? found[1].str() : "";
    if (word.empty() || !starts_with(problem.line, word) || code.empty() ||
        contains(";{}", code.substr(code.size() - 1)))
        return;
    problem.where = name + ":" + std::to_string(above);
    problem.line = trimmed(learner.lines[above - 1]);
    problem.message = "A semicolon is missing at the end of this line.";
}

/// The error on the same line that two operands side by side give, where the first one does not tell.
std::string side_by_side(const std::vector<std::string>& lines, const Said& error, const std::string& line) {
    static const std::regex expected(R"(^expected '[;)]' before '?[\w(])");
    std::smatch found;
    for (std::size_t k = error.at + 1; k < lines.size(); ++k)
        if (is_error(lines[k], found) && found[1] == error.file && std::stoul(found[2]) == error.line) {
            const std::string message = found[3];
            if (std::regex_search(message, expected)) return missing_sign(line);
        }
    return "";
}

}  // namespace

/// Our questions cannot call a function: it is gone, or called otherwise than the chapter says.
CompileProblem Sheets::cannot_be_called(const std::vector<std::string>& lines, const std::string& compiler,
                                        std::size_t at, const std::vector<Number>& numbers) const {
    static const std::regex questions(R"(exercises/(\d+\.\d+)_)");
    CompileProblem problem;
    problem.compiler = compiler;
    problem.number = numbers.front();
    std::string block = lines[at] + "\n";
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (i + 60 > at && i < at + 12) block += lines[i] + "\n";
    std::smatch found;
    if (std::regex_search(block, found, questions)) problem.number = number_of(found[1].str());
    problem.message = exercise_of(*problem.number).function +
                      " cannot be called as the chapter calls it. Its first line must stay as it was: " +
                      signature(chapter_.header_of(*problem.number).reference, *problem.number);
    return problem;
}

/// A line of the skeleton's includes that is gone explains more than its consequences.
std::string Sheets::lost_include() const {
    for (const auto& header : chapter_.headers) {
        const auto file = rooms_.answers / chapter_.folder / header.path;
        if (!std::filesystem::exists(file)) continue;
        const std::string text = read_text(file);
        for (const auto& line : header.reference.lines)
            if (starts_with(line, "#include ") && !contains(text, line))
                return "The line " + line + " is missing in " + named(file.string()) +
                       ": put it back at the top.";
    }
    return "";
}

CompileProblem Sheets::explain(const std::string& said, const std::vector<Number>& numbers) const {
    CompileProblem problem;
    if (said.empty()) {
        problem.message =
            "The compiler did not come to an end within a minute of work, or ran out of memory. Undo the "
            "last "
            "change and try again.";
        return problem;
    }
    const auto lines = short_lines(said);
    const std::string own = (rooms_.answers / "").string();
    const Said error = first_error(lines, own);
    if (error.file.empty() && contains(said, "internal compiler error")) {
        problem.message =
            "The compiler itself crashed on it, twice: is something nested much too deep, or a line far too "
            "long?";
        return problem;
    }
    if (error.file.empty()) {
        problem.message = "It compiles, but does not link: something is declared and never defined.";
        problem.compiler = plain_types(lines.empty() ? "" : lines.front());
        return problem;
    }
    static const std::regex unnamed(R"('[^']*<lambda[^']*')");
    problem.compiler = std::regex_replace(plain_types(error.message), unnamed, "'a function'");
    if (contains(error.message, "int main(")) {
        problem.message = "There is a main() in your file. The judge has its own: take yours out.";
        return problem;
    }
    for (const auto& header : chapter_.headers)  // it makes nonsense of all that follows
        if (const auto file = rooms_.answers / chapter_.folder / header.path; std::filesystem::exists(file))
            if (const auto braces = unpaired_braces(marked(read_text(file)), named(file.string())))
                return *braces;
    if (!starts_with(error.file, own)) return cannot_be_called(lines, problem.compiler, error.at, numbers);

    const std::string name = named(error.file);
    const Marked learner = marked(read_text(error.file));
    problem.where = name + ":" + std::to_string(error.line);
    problem.number = learner.at_line(error.line);
    if (error.line >= 1 && error.line <= learner.lines.size())
        problem.line = trimmed(learner.lines[error.line - 1]).substr(0, 300);
    problem.beyond = contains(error.message, "nutshell::exercises::");  // a type of the questions
    problem.message = lost_include();
    if (problem.message.empty())
        if (const std::string include = missing_include(lines, error, problem.compiler); !include.empty())
            problem.message =
                "Something here needs the line #include " + include + " at the top of the file.";
    const std::string notes = notes_after(lines, error.at);
    if (problem.message.empty() && contains(problem.compiler, "operator") &&
        !contains(problem.compiler, "function"))
        problem.message = side_by_side(lines, error, bare_code(problem.line));
    if (problem.message.empty() && problem.number)
        problem.message = meaning_in_line(problem.compiler, notes, bare_code(problem.line),
                                          reach_in(learner, *problem.number));
    if (problem.message.empty()) problem.message = from_notes(problem.compiler, notes);
    if (problem.message.empty()) problem.message = meaning_of(problem.compiler);
    if (problem.message.empty()) problem.message = "The compiler does not accept this line.";
    move_up_to_semicolon(problem, learner, error.line, name);
    if (const auto comment = problem.line.find("//");
        contains(problem.message, "semicolon") && comment != std::string::npos && comment > 0)
        problem.message =
            "// begins a comment, and what stands behind it is not read. A division that rounds down is "
            "std::floor(a / b).";
    if (problem.compiler.size() > 160) problem.compiler = problem.compiler.substr(0, 157) + "...";
    return problem;
}

std::string Sheets::named(const std::string& file) const {
    const auto parent = rooms_.answers.parent_path().string() + "/";
    return starts_with(file, parent) ? file.substr(parent.size()) : file;
}

}  // namespace nutshell::judge
