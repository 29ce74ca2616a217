// What a compiler says, in words for a learner: the learner's own line first, never a list of templates.
#include <algorithm>
#include <cctype>
#include <regex>
#include "sheets.hpp"
#include "text.hpp"

namespace nutshell::judge {

namespace {

/// "Eigen::CwiseBinaryOp<...>" and the like by names a learner knows; no namespaces, no lists of template
/// arguments.
std::string plain_types(std::string text) {
    static const std::regex with(R"( \[with .*\])"), aka(R"('[^']*' [{(]aka '([^']*)'[)}])"),
        convert(R"(could not convert '.*' (from '[^']*' to '[^']*'))");
    text = std::regex_replace(std::regex_replace(text, aka, "'$1'"), with, "");
    text = replaced(text, "Eigen::", "");
    for (std::size_t open = text.find('<'); open != std::string::npos; open = text.find('<', open + 1)) {
        std::size_t begin = open, end = open;
        while (begin > 0 &&
               (std::isalnum(static_cast<unsigned char>(text[begin - 1])) || text[begin - 1] == '_'))
            --begin;
        const std::string name = text.substr(begin, open - begin);
        const bool matrix = name == "Matrix", quaternion = name == "Quaternion",
                   expression = starts_with(name, "Cwise") || name == "Product" || name == "Transpose" ||
                                name == "Block";
        if (!matrix && !quaternion && !expression) continue;
        int depth = 0;
        do {
            depth += text[end] == '<';
            depth -= text[end] == '>';
        } while (++end < text.size() && depth > 0);
        const std::string inside = text.substr(open, end - open);
        const std::string known = quaternion                                       ? "Quaternion"
                                  : starts_with(inside, "<double, 3, 1") && matrix ? "Vector3"
                                  : starts_with(inside, "<double, 3, 3") && matrix
                                      ? "Matrix3"
                                      : "an expression of vectors";
        text.replace(begin, end - begin, known);
        open = begin;
    }
    text = replaced(text, "<unresolved overloaded function type>", "the name of a function");
    if (const auto option = text.find(" [-W"); option != std::string::npos) text.erase(option);
    text = std::regex_replace(text, convert, "could not convert $1");
    return replaced(replaced(text, "nutshell::exercises::", ""), "nutshell::", "");
}

struct Rule {
    const char* says;   ///< of the compiler: a regular expression
    const char* means;  ///< $1, $2: what the expression caught
};
constexpr const char* says_const =
    "This may not be changed: it is const. Work on a copy, or on what the function is given to change.";
// first match wins
constexpr Rule rules[] = {
    {R"(no return statement|control reaches end of non-void|non-void function does not return)",
     "The function can reach its end without giving a result: a return is missing."},
    {R"((.*): No such file or directory|'(.*)' file not found)",
     "There is no file $1$2 to include: is its name spelled right?"},
    {R"(expected '\}' at end of input|expected '\}'$)",
     "A closing brace } is missing somewhere above, or there is one { too many."},
    {R"(extraneous closing brace|expected declaration before '\}')",
     "There is one closing brace } too many, or an opening one is missing above."},
    {R"(expected ',' or ';' before '(.*)'|expected ';' before '(.*)'|expected ';')",
     "A semicolon is missing here or on the line above."},
    {R"(expected primary-expression before '(.*)' token)",
     "Something is missing in front of $1: a value or a name should stand there."},
    {R"(expected '\)'|expected '\(')", "Count the round brackets: each ( needs its )."},
    {R"('(\w+)' was not declared in this scope; did you mean '(\w+)'|use of undeclared identifier '(\w+)'; did you mean '(\w+)')",
     "Nothing is called $1$3 here. Do you mean $2$4?"},
    {R"('(\w+)' was not declared in this scope|use of undeclared identifier '(\w+)')",
     "Nothing is called $1$2 here: is it spelled right, and declared above this line?"},
    {R"('(\w+)' does not name a type|unknown type name '(\w+)'|'(\w+)' has not been declared)",
     "No type is called $1$2$3 here: is it spelled right, and is its header included?"},
    {R"('(?:const )?(?:struct |class )?([\w:]+)(?:.*)' has no member named '(\w+)'(?:; did you mean '(\w+)')?|no member named '(\w+)' in '(.*)')",
     "$1$5 has no member called $2$4."},
    {R"(in read-only object|is read-only|discards qualifiers|cannot assign to|no match for 'operator.?=' \(operand types are 'const )",
     says_const},
    {R"(no match for '(operator.*?)' \(operand types are '(.*)' and '(.*)'\)|invalid operands of types '(.*)' and '(.*)')",
     "These two cannot be joined like this: $2$4 and $3$5."},
    {R"(invalid operands to binary expression \('(.*)' and '(.*)'\))",
     "These two cannot be joined like this: $1 and $2."},
    {R"(YOU_MIXED_MATRICES_OF_DIFFERENT_SIZES|INVALID_MATRIX_PRODUCT|INVALID_VECTOR_VECTOR_PRODUCT)",
     "Vectors or matrices of sizes that do not fit are joined here. For two vectors: .dot() gives a number, "
     ".cross() a vector."},
    {R"(cannot convert '(.*)' to '(.*)'|conversion from '(.*)' to non-scalar type '(.*)'|could not convert from '(.*)' to '(.*)'|no viable conversion from (?:returned value of type )?'(.*)' to (?:function return type )?'(.*)')",
     "A value of type $1$3$5$7 stands where a $2$4$6$8 is needed."},
    {R"(invalid initialization of (?:non-const )?reference of type '(?:const )?(\w+)&' from (?:an rvalue|expression) of type '(.*)')",
     "A value of type $2 stands where a $1 is needed."},
    {R"(too (few|many) arguments to function)",
     "This function is called with too $1 values: look at its line in the header."},
    {R"(no match for call to)",
     "This is called with other values than it takes (forces is called as forces(state, t)): see the comment "
     "above the function."},
    {R"(no matching function for call to '(.*)'|no matching function for call to)",
     "No function can be called with these values: look at its line in the header."},
    {R"(redefinition of '(.*)'|redeclaration of '(.*)')", "$1$2 is defined twice."},
};

struct Said {
    std::string file, message;
    std::size_t line = 0;
};

}  // namespace

CompileProblem Sheets::explain(const std::string& said, const std::vector<Number>& numbers) const {
    CompileProblem problem;
    if (said.empty()) {
        problem.message =
            "The compiler did not come to an end within a minute, or ran out of memory. Undo the last change "
            "and try again.";
        return problem;
    }
    static const std::regex error(R"(^(.*?):(\d+)(?::\d+)?: (?:fatal )?error: (.*)$)"),
        context(
            R"(^(.*?):(\d+)(?::\d+)?: (?:  required (?:from|by)|  recursively required|note: in instantiation|note: in call).*$)"),
        place(R"(^(?:In file included from |\s+from )?(.*?):(\d+).*$)"), include(R"(#include (<[\w/.]+>))"),
        questions(R"(exercises/(\d+\.\d+)_)");
    const std::string own = (rooms_.answers / "").string();
    const auto lines = lines_of(said);
    std::smatch found;

    // The first error that is on a line of the learner's, or was called from one.
    Said first, mine;
    std::size_t first_at = 0, mine_at = 0;
    for (std::size_t i = 0; i < lines.size() && mine.file.empty(); ++i) {
        if (!std::regex_match(lines[i], found, error)) continue;
        Said here{found[1], found[3], static_cast<std::size_t>(std::stoul(found[2]))};
        if (first.file.empty()) first = here, first_at = i;
        if (starts_with(here.file, own)) {
            mine = here, mine_at = i;
            continue;
        }
        const auto called = [&](std::size_t k) {
            std::smatch call;
            if (!mine.file.empty() || !std::regex_match(lines[k], call, context) ||
                !starts_with(call[1].str(), own))
                return;
            mine = {call[1], here.message, static_cast<std::size_t>(std::stoul(call[2]))};
            mine_at = i;
        };
        std::size_t begin = i, end = i + 1;
        while (begin > 0 && !std::regex_match(lines[begin - 1], error)) --begin;
        while (end < lines.size() && !std::regex_match(lines[end], error)) ++end;
        for (std::size_t k = begin; k < i; ++k) called(k);    // g++ says it before the error,
        for (std::size_t k = i + 1; k < end; ++k) called(k);  // clang after it
    }
    const Said& chosen = mine.file.empty() ? first : mine;
    if (chosen.file.empty()) {
        problem.message = "It compiles, but does not link: something is declared and never defined.";
        problem.compiler = plain_types(lines.empty() ? "" : lines.front());
        return problem;
    }
    problem.compiler = plain_types(chosen.message);

    if (mine.file.empty()) {
        // our questions cannot call it: it is gone, or called otherwise than the chapter says
        std::string all;
        for (std::size_t i = 0; i < lines.size(); ++i)
            if (i + 60 > first_at && i < first_at + 12) all += lines[i] + "\n";
        problem.number = numbers.front();
        const std::string block = lines[first_at] + "\n" + all;
        if (std::regex_search(block, found, questions)) problem.number = number_of(found[1].str());
        const Marked& reference = chapter_.header_of(*problem.number).reference;
        problem.message = exercise_of(*problem.number).function +
                          " cannot be called as the chapter calls it. Its first line must stay as it was: " +
                          signature(reference, *problem.number);
        return problem;
    }

    problem.where = named(mine.file) + ":" + std::to_string(mine.line);
    const Marked learner = marked(read_text(mine.file));
    problem.number = learner.at_line(mine.line);
    if (mine.line >= 1 && mine.line <= learner.lines.size())
        problem.line = trimmed(learner.lines[mine.line - 1]);
    problem.point_mass_only = contains(mine.message, "Sledge");

    // braces that do not pair up inside a body are told best by counting them
    for (const Body& body : learner.bodies) {
        const std::string code = bare_code(body.text);
        const auto opened = std::count(code.begin(), code.end(), '{'),
                   closed = std::count(code.begin(), code.end(), '}');
        if (opened == closed) continue;
        problem.number = body.number;
        problem.where = named(mine.file) + ":" + std::to_string(body.begin + 2);
        problem.line = trimmed(learner.lines[body.begin + 1]);
        problem.message = "Between its marks, the answer to " + body.number.text() + " opens " +
                          std::to_string(opened) + " braces { and closes " + std::to_string(closed) + ".";
        return problem;
    }

    // a line of the skeleton's includes that is gone explains more than its consequences
    for (const auto& header : chapter_.headers) {
        const auto file = rooms_.answers / chapter_.folder / header.path;
        if (!std::filesystem::exists(file)) continue;
        const std::string text = read_text(file);
        for (const auto& line : header.reference.lines)
            if (starts_with(line, "#include ") && !contains(text, line)) {
                problem.message = "The line " + line + " is missing in " + named(file.string()) +
                                  ": put it back at the top.";
                return problem;
            }
    }
    for (std::size_t k = mine_at; k < lines.size() && k < mine_at + 8; ++k)
        if (contains(lines[k], "note:") && std::regex_search(lines[k], found, include)) {
            problem.message =
                "Something here needs the line #include " + found[1].str() + " at the top of the file.";
            return problem;
        }
    if (std::regex_search(problem.compiler, found,
                          std::regex(R"(no member named '(\w+)' in namespace 'std')"))) {
        const std::string name = found[1];
        problem.message = "Something here needs the line #include <" +
                          (name == "cout" || name == "cerr" || name == "endl" ? "iostream" : name) +
                          "> at the top of the file.";
        return problem;
    }
    // clang tells in a note why a function cannot be called
    std::string notes;
    for (std::size_t k = mine_at + 1;
         k < lines.size() && k < mine_at + 30 && !std::regex_match(lines[k], error); ++k)
        if (contains(lines[k], " note: "))
            notes += plain_types(lines[k].substr(lines[k].find(" note: "))) + "\n";
    if (contains(problem.compiler, "no viable overloaded") &&
        (contains(notes, "not marked const") || contains(notes, "conversion from 'const "))) {
        problem.message = says_const;
        return problem;
    }
    if (contains(problem.compiler, "no matching function")) {
        if (std::regex_search(notes, found, std::regex(R"(requires (\d+) arguments, but (\d+) w)")))
            problem.message = std::string("This function is called with too ") +
                              (std::stoi(found[2]) < std::stoi(found[1]) ? "few" : "many") +
                              " values: look at its line in the header.";
        else if (std::regex_search(
                     notes, found,
                     std::regex(R"(no known conversion from '(?:const )?([^']*)' to '(?:const )?([^']*)')")))
            problem.message =
                "A value of type " + found[1].str() + " stands where a " + found[2].str() + " is needed.";
        if (!problem.message.empty()) return problem;
    }
    for (const Rule& rule : rules)
        if (std::regex_search(problem.compiler, found, std::regex(rule.says))) {
            problem.message = replaced(found.format(rule.means), "const ", "");
            break;
        }
    if (problem.message.empty()) problem.message = "The compiler does not accept this line.";
    // the semicolon that is missed before a line's first word belongs to the line above
    if (contains(problem.message, "semicolon") && mine.line >= 2 && mine.line <= learner.lines.size()) {
        std::size_t above = mine.line - 1;  // counted from 1
        while (above > 1 && bare_code(learner.lines[above - 1]).empty()) --above;
        const std::string code = bare_code(learner.lines[above - 1]);
        const std::string word =
            std::regex_search(problem.compiler, found, std::regex("before '(.*)'")) ? found[1].str() : "";
        if (!word.empty() && starts_with(problem.line, word) && !code.empty() &&
            !contains(";{}", code.substr(code.size() - 1))) {
            problem.where = named(mine.file) + ":" + std::to_string(above);
            problem.line = trimmed(learner.lines[above - 1]);
            problem.message = "A semicolon is missing at the end of this line.";
        }
    }
    if (problem.compiler.size() > 160) problem.compiler = problem.compiler.substr(0, 157) + "...";
    return problem;
}

std::string Sheets::named(const std::string& file) const {
    const auto parent = rooms_.answers.parent_path().string() + "/";
    return starts_with(file, parent) ? file.substr(parent.size()) : file;
}

}  // namespace nutshell::judge
