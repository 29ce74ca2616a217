#include <algorithm>
#include <cctype>
#include <regex>
#include "explain.hpp"
#include "text.hpp"

namespace nutshell::judge {

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
    text = replaced(text, "template arguments", "arguments in angle brackets");
    return replaced(replaced(text, "nutshell::exercises::", ""), "nutshell::", "");
}

namespace {

struct Rule {
    const char* says;   ///< of the compiler: a regular expression
    const char* means;  ///< $1, $2: what the expression caught
};
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
    {R"(in read-only object|is read-only|discards qualifiers|cannot assign to|no match for 'operator[-+*/]?=' \(operand types are 'const )",
     says_const},
    {R"(no match for '(operator.*?)' \(operand types are '(.*)' and '(.*)'\)|invalid operands of types '(.*)' and '(.*)')",
     "These two cannot be joined like this: $2$4 and $3$5."},
    {R"(invalid operands to binary expression \('(.*)' and '(.*)'\))",
     "These two cannot be joined like this: $1 and $2."},
    {R"(YOU_MIXED_MATRICES_OF_DIFFERENT_SIZES|INVALID_MATRIX_PRODUCT|INVALID_VECTOR_VECTOR_PRODUCT)",
     "Vectors or matrices of sizes that do not fit are joined here. For two vectors: .dot() gives a number, "
     ".cross() a vector, .cwiseProduct() the products of their components."},
    {R"(from '<brace-enclosed initializer list>' to '(?:const )?(\w+))",
     "No $1 can be made of what stands in these braces: there are too many or too few values, in another "
     "order, "
     "or of other types."},
    {R"(wrong number of arguments in angle brackets \((\d+), should be (?:at least )?(\d+)\))",
     "In angle brackets stand $1 things, and this type takes $2: a std::array has a type and a size, and "
     "double "
     "is the type."},
    {R"(cannot convert '(.*)' to '(.*)'|conversion from '(.*)' to non-scalar type '(.*)'|could not convert from '(.*)' to '(.*)'|no viable conversion from (?:returned value of type )?'(.*)' to (?:function return type )?'(.*)')",
     "A value of type $1$3$5$7 stands where a $2$4$6$8 is needed."},
    {R"(invalid initialization of (?:non-const )?reference of type '(?:const )?(\w+)&' from (?:an rvalue|expression) of type '(.*)')",
     "A value of type $2 stands where a $1 is needed."},
    {R"(too (few|many) arguments to function)",
     "This function is called with too $1 values: look at its line in the header."},
    {R"(no match for call to)",
     "This is called with other values than it takes (forces is called as forces(state, t), a spin as "
     "spin(pose, t)): see the comment above the function."},
    {R"(no matching function for call to '(.*)'|no matching function for call to)",
     "No function can be called with these values: look at its line in the header."},
    {R"(redefinition of '(.*)'|redeclaration of '(.*)')", "$1$2 is defined twice."},
};

}  // namespace

std::string meaning_of(const std::string& message) {
    std::smatch found;
    for (const Rule& rule : rules)
        if (std::regex_search(message, found, std::regex(rule.says)))
            return std::regex_replace(replaced(found.format(rule.means), "const ", ""),
                                      std::regex("where a (?:(an )|(?=[AEIOaeio]))"), "where an ");
    return "";
}

}  // namespace nutshell::judge
