// What a compiler's message and the learner's line mean together, where no name need be looked up.
#include <array>
#include <regex>
#include "explain.hpp"
#include "explain_line.hpp"

namespace nutshell::judge {

namespace {

/// Regular expressions for the compiler's message with its notes, and for the line; an empty one fits all.
struct Rule {
    const char *message, *line, *means;
};
// first match wins
constexpr Rule rules[] = {
    {"", R"(\*\*)", "** is no power in C++: write x * x, or std::pow(x, 3)."},
    {R"(^(?!expected '))", R"(\^)",
     "^ is no power in C++ but an operation on bits: write x * x, or std::pow(x, 3)."},
    {"", R"(^for \w+ in |^for \(\w+ in |^for \w+,|^while [^(]|^if [^(c].*:$|^else:$|^elif )",
     "That is another language's form. In C++: for (int i = 0; i < n; ++i) { ... }, for (const auto& each : "
     "list) { ... }, if (...) { ... } else { ... }."},
    {"expected ';'|expected '\\)'|expected primary", R"(^for \([^;]*(;[^;]*)?\)|^for \([^;:]*,[^;]*,[^;]*\))",
     "The three parts in the head of a for stand between semicolons: for (int i = 0; i < n; ++i)."},
    {"", R"(\bnew (Vector|Matrix|Quaternion|Complex))",
     "No new here: it gives a pointer. A value is made by its type alone: Vector3(1, 2, 3)."},
    {"", R"(\bstd[.]\w|\bstd:\w|\b(Math|math|np)[.]\w)",
     "Names of the standard library are written std::sqrt, std::abs, ..., with two colons."},
    {"", R"((return|=) ?\[[^\]&=]*,[^\]]*\] ?;)", "A list of values stands in braces: {a, b, c}."},
    {R"(no match for 'operator<<' \(operand types are 'const )", "", says_const},
    {R"(call to 'Quaternion::Quaternion|call to constructor of 'Quaternion')", "",
     "A Quaternion is not made of these: four_vector(u, w) makes it of its vector part and w, and Eigen's "
     "constructor takes four numbers, w first."},
    {R"(cannot convert '.*(expression of vectors|Vector3)' to 'double')", R"(\w \* \w)",
     "A vector stands where a number is needed. The product of two vectors that is a number is a.dot(b)."},
    {R"(cannot convert '.*(expression of vectors|Vector3)' to 'int')", "",
     "auto x = 0 makes x an int. A sum of vectors begins with  Vector3 x = Vector3::Zero();"},
    {"invalid preprocessing|stray '#'", "", "A comment begins with //, not with #."},
    {"unterminated comment", "", "A comment is opened by /* and never closed by */."},
    {"missing terminating|unterminated", "[\"']", "A quotation mark is opened and not closed."},
    {"stray|unexpected character|non-ASCII|extended character|source file is not valid", "",
     "There is a sign in this line that C++ does not know. Pasted from a page, a minus or a quotation mark "
     "may be another character than that on the keyboard: type it anew."},
    {R"(base operand of '->'|is not a pointer; did you mean to use '\.')", "",
     "It is no pointer: write a point, not ->."},
    {R"(THE_BRACKET_OPERATOR_IS_ONLY_FOR_VECTORS)", "",
     "An entry of a matrix is written m(row, column), in round brackets, both counted from 0."},
    {R"(no match for 'operator\[\]' \(operand types are '(?:const )?Quaternion)", "",
     "The numbers of a quaternion are q.w(), q.x(), q.y(), q.z(), or q.coeffs()[0]: x, y, z, w in that "
     "order."},
    {R"('operator[-+*/].*Quaternion)", "",
     "Quaternions are multiplied with one another and nothing else. To add or scale, take their numbers: "
     "0.5 * q.coeffs()."},
    {R"(invalid use of member function|invalid use of non-static member function|must be called|the name of a function|<unresolved overloaded function type>|cannot convert '.*::\w+' from type '.*\(.*\).*' to)",
     "", "The brackets () of a call are missing: d.norm is the function, d.norm() its value."},
    {R"(request for member '(\w+)' in '(.*)', which is of non-class type '(?:const )?(\w+))", "",
     "$2 is a number ($3) and has no member $1."},
    {R"(member reference base type '(?:const )?(double|int))", "",
     "That is a number ($1) and has no members."},
    {R"(void value not ignored|invalid use of void|from 'void' to|'void' to non-scalar|type 'void')", "",
     "What is called here gives nothing back, it changes what it is given: write it as a line of its own, "
     "such as drift(state, dt);"},
    {R"(return-statement with a value, in function returning 'void'|void function '.*' should not return)",
     "", "This function gives nothing back: it changes what it is given. Leave out the value."},
    {R"(return-statement with no value|should return a value)", "",
     "This return gives nothing back: write what the function shall give."},
    {R"(types '(const )?(double|float|Vector3)' and '.*' to binary 'operator ?%'|invalid operands to binary expression .*double)",
     "%",
     "% is for whole numbers. The rest of a double is std::fmod(x, y); std::remainder(x, y) the nearest."},
    {R"(expected identifier before '\[' token|expected body of lambda|expected variable name or 'this' in lambda)",
     R"(\[)",
     "[ ] makes no list and no matrix here. A Matrix3 is declared first and filled: m << a, b, c, and so "
     "on row by row; a list is std::vector{a, b}."},
    {R"('(accumulate|iota)' is not a member of 'std')", "",
     "Something here needs the line #include <numeric> at the top of the file."},
    {R"('(?:std::)?numbers' (has not been declared|is not a member))", "",
     "Something here needs the line #include <numbers> at the top of the file."},
    {R"(operands to '\?:' have different types.*'(const )?(int|double|long int)'|incompatible operand types \('(int|double)' |incompatible operand types .*'(int|double)'\))",
     "", "One side of ? : is a number, the other is none. The zero of vectors is Vector3::Zero()."},
    {R"(operands to '\?:' have different types|incompatible operand types)", "",
     "The two sides of ? : are expressions of different kinds, although both would give a vector: write if "
     "... return, or Vector3(...) round each."},
    {R"(function for call to '(?:std::)?(\w+)(<.*>)?\((const )?(int|long|long int)&?, (const )?(double|float)|function for call to '(?:std::)?(\w+)(<.*>)?\((const )?(double|float)&?, (const )?(int|long|long int)&?\)|conflicting types|deduced conflicting)",
     "",
     "This function of the standard library wants its values to be of one type. 1 is an int; a double is "
     "written 1.0."},
    {R"((could not convert|is not contextually convertible|cannot convert).*bool)", "=",
     "= assigns; to compare, write ==."},
    {R"('int' and '(const )?(std::)?(complex|Complex))", "",
     "A whole number and a complex number cannot be joined: write it with a point, 1.0."},
    {R"('(std::)?(complex<double>|Complex)' and '(const )?int)", "",
     "A whole number and a complex number cannot be joined: write it with a point, 1.0."},
    {R"('else' without a previous 'if')", "",
     "An else without its if: is there a ; right behind the brackets of the if, or a { } missing?"},
    {"expected expression", "else",
     "An else without its if: is there a ; right behind the brackets of the if, or a { } missing?"},
    {R"(lvalue required as left operand|expression is not assignable)", "",
     "Only a variable can stand to the left of =. To compare, write ==."},
    {R"(assignment of (?:read-only|function) (?:variable|reference|parameter|location|member)? ?'([^']*)'|cannot assign to variable '(\w+)')",
     "", "$1$2 may not be changed: it is const. Put the new value into a variable of its own."},
    {R"(cannot bind non-const lvalue reference)", "",
     "What is handed over here shall be changed, so it must be a variable of its own that is not const."},
    {R"('(\w+)' cannot be used as a function|called object type '(?:double|int)' is not a function)", "",
     "Before the brackets ( stands a number and no function: is a * missing there?"},
    {R"(no match for call to '\((?:const )?(?:Vector3|Matrix|Quaternion|double)[^)]*\) \(\))", "",
     "That is a member and no function: leave out the brackets ()."},
    {R"('(\w+)' is not captured|variable '(\w+)' cannot be implicitly captured)", "",
     "A function inside a function sees $1$2 only if it begins with [&]."},
    {R"(a function-definition is not allowed here|function definition is not allowed here)", "",
     "A function inside a function is written  const auto f = [&](double x) { return ...; };"},
    {R"(expected unqualified-id before numeric|expected unqualified-id before 'const)", "",
     "A name is missing here, or begins with a digit, which none may."},
    {R"(expected (?:primary-expression|unqualified-id|expression).* before '\.'|expected unqualified-id$|unexpected type name)",
     R"(\b([A-Z]\w*)\.\w)",
     "A type's own names are written with two colons: Vector3::Zero(), Kicked::after_drift."},
    {R"(expected primary-expression before '(double|int|auto|const|bool)')", "",
     "The type stands only where a variable is declared, not where it is used or handed over."},
    {R"(expected primary-expression before '[)\]},;]' token|expected expression)", R"([-+*/=,] ?[),;])",
     "Something is missing behind the last sign: a value or a name."},
    {R"(to '(?:const )?(?:Vector3|class Vector3)'|non-scalar type 'Vector3')", R"(= ?0|return 0|= ?\{?0)",
     "0 is a number. A vector of zeros is Vector3::Zero()."},
    {R"(operator[+-].*('(?:const )?(?:Vector3|an expression of vectors)' and '(?:double|int)'|'(?:double|int)' and '(?:const )?(?:Vector3|an expression of vectors)'))",
     "",
     "A number and a vector cannot be added: is one of them to be multiplied with a direction, or a norm "
     "to be taken?"},
    {R"(operator/.*'(?:const )?(?:Vector3|an expression of vectors)' and '(?:const )?(?:Vector3|an expression of vectors))",
     "",
     "These two cannot be joined like this: a vector cannot be divided by a vector. By its length, "
     "v.norm(), it can."},
    {R"(operator[<>]=?' \(operand types are '(?:const )?(?:Vector3|an expression of vectors))", "",
     "Vectors have no order: compare their lengths, v.norm()."},
    {R"(THIS_METHOD_IS_ONLY_FOR_VECTORS_OF_A_SPECIFIC_SIZE|COEFFICIENT_ACCESSOR|THIS_METHOD_IS_ONLY_FOR_VECTORS)",
     "", "That number of components, or that function, does not fit this vector or matrix."},
    {R"(YOU_MIXED_DIFFERENT_NUMERIC_TYPES)", "",
     "Numbers of different types are mixed, float and double perhaps: all vectors here are of double."},
    {R"(jump to case label|crosses initialization)", "",
     "A variable declared inside a case needs braces round that case: case ...: { ... }."},
    {"", R"(^[^|]*\|[^|]*$|\|[^|]+\|)",
     "| is no sign for a length in C++: the length of a vector is v.norm(), of a number std::abs(x)."},
    {R"(no known conversion for argument (\d+) from '(?:const )?([^']*)' to '(?:const )?([^']*)')",
     R"(\bforces\b(?! ?\())", "forces is a function and no force: the force is forces(state, t)."},
};

}  // namespace

std::string by_signs(const std::string& message, const std::string& notes, const std::string& line) {
    std::smatch found;
    for (const Rule& rule : rules) {
        const bool with_notes = std::string(rule.message).find("conflicting") != std::string::npos ||
                                std::string(rule.message).find("argument") != std::string::npos;
        const std::string all = with_notes ? message + "\n" + notes : message;
        if (rule.line[0] && !std::regex_search(line, std::regex(rule.line))) continue;
        if (!std::regex_search(all, found, std::regex(rule.message))) continue;
        return rule.message[0] ? found.format(rule.means) : std::string(rule.means);
    }
    return "";
}

}  // namespace nutshell::judge
