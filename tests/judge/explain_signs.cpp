// What a compiler's message and the learner's line mean together, where no name need be looked up.
#include <array>
#include <regex>
#include "explain.hpp"
#include "explain_line.hpp"
#include "text.hpp"

namespace nutshell::judge {

namespace {

/// Regular expressions for the compiler's message with its notes, and for the line; an empty one fits all. In
/// the meaning $1 is what the first caught, %1 what the second did.
struct Rule {
    const char *message, *line, *means;
};
// first match wins
constexpr Rule rules[] = {
    {R"(before 'x')", R"([\w)] x [\w(])",
     "x is no product in C++. Of numbers and matrices it is *, of vectors a.cross(b), of rotations "
     "product(a, b)."},
    {"", R"(\b(AND|OR|NOT)\b)", "and, or and not are written &&, || and ! in C++."},
    {"", R"([^=!<>+]=\+ )", "=+ is not +=: it assigns what follows, with a plus in front. Write +=."},
    {"expected", R"(([-+*/]) =[^=])", "%1= is one sign: no space in it."},
    {R"(invalid types|operator\[\])", R"(\w\[\w+\]\[)",
     "An entry of a matrix is written m(row, column), both counted from 0."},
    {"", R"(^(?:\} ?)?(?:else )?(?:if|while) \([\w.]+ ?= ?[^=])", "= assigns; to compare, write ==."},
    {"", R"(= if ?\()", "An if is no value: write  condition ? one : other , or assign inside of the if."},
    {R"(declaration of '[^']*\b(\w+)' shadows a parameter)", "",
     "$1 is handed in already: what is new needs a name of its own, or no type in front."},
    {R"(operator/.*'(?:int|double)' and '(?:const )?(?:Matrix3|Quaternion))", "",
     "Nothing can be divided by this: take its inverse."},
    {"expected", R"(\{[^{}]*;\s*\})",
     "Inside these braces values are separated by commas; the ; stands behind."},
    {"expected ';'", R"(^[^;={<]*,[^;={<]*,[^;={<]*[\w)]$)",
     "At the end of this line a sign is missing: a comma if the list goes on, a semicolon if it ends."},
    {"", R"(\bMatrix3\([^)]*,[^)]*,)",
     "A matrix is filled row by row:  Matrix3 m; m << a, b, c, d, e, f, g, h, i;"},
    {"expression|vector|BRACKET", R"(\b([A-Z])\[\d\])",
     "A matrix is not asked with [ ]: an entry is %1(row, column), a column %1.col(0), both counted from 0."},
    {R"(cannot convert '.*(expression of vectors|Vector3)' to 'double')", R"(\.cross\()",
     "The cross product is a vector; a number is its length, a.cross(b).norm(), or one of its components."},
    {R"(function for call to '(inverse|rotate|product|logarithm)\((?:const )?Matrix3)", "",
     "$1 takes a Quaternion. A rotation matrix turns a vector as R * v, and R.transpose() turns it back."},
    {"", R"(\w\( ?:|, ?: ?\))", "A column of a matrix is m.col(0), a row m.row(0), both counted from 0."},
    {"", R"((?:^|[^\w])(?!if\b|while\b|for\b|switch\b|return\b)[a-zA-Z]\w*\((\w+) ?= ?[^=])",
     "C++ has no arguments by name: leave out %1= and give the values in the order of the function's first "
     "line."},
    {"", R"((?:=|return) [^;]*\.normalize\(\))",
     "normalize() changes the vector itself and gives nothing back; v.normalized() is a vector of length "
     "one."},
    {R"(operator[!=]=.*'(?:const )?(?:Vector3|an expression of vectors)' and '(?:int|double)')", "",
     "A vector cannot be compared with a number: compare its length, v.norm(), or ask v.isZero()."},
    {"", R"(\w\[\w*:\w*\])",
     "Parts of a vector are y.head<4>(), the first four, y.tail<3>(), the last three, and y.segment<3>(4), "
     "three from the fifth on."},
    {"", R"(\[[^\]]*;[^\]]*\])",
     "A matrix is filled row by row:  Matrix3 m; m << a, b, c, d, e, f, g, h, i;  as in rotation_x."},
    {"stray '\\\\|stray .*134", "",
     "\\ is no division in C++: write /. An equation with a matrix is solved by m.inverse() * v, or "
     "m.ldlt().solve(v)."},
    {"", "π|θ|ω|φ|α|β|μ|τ|Δ|λ|γ", "Names are written in plain letters here: pi, theta, omega."},
    {R"(numeric literal operator.*"i)", "", "The imaginary unit is Complex{0, 1}."},
    {"", R"(\be ?\^)", "^ is no power in C++: e to the power x is std::exp(x)."},
    {"", R"((\w+) ?\^ ?\(?-1)",
     "^ is no power in C++: the inverse of a matrix is %1.inverse(), of a number 1 / %1."},
    {R"('operator\^' \(operand types are '(?:const )?(?:an expression of vectors|Vector3)')",
     R"(([\w.()]+) ?\^)",
     "^ is no power in C++. The square of a number is x * x, of a vector's length v.squaredNorm()."},
    {"", R"(\b(?:Math|math|np|Mathf|M)[._](?:PI|pi|Pi)\b)", "pi is called pi here."},
    {"", R"(^for \([^;:]* in )",
     "In C++ a colon stands where other languages write in: for (const auto& each : list)."},
    {"", R"(^(?:\} )?(?:else )?(if|while) [^(c!].*[^:]$)",
     "Round brackets belong round the condition, and no then: %1 (s >= 0) return 0;"},
    {"does not name a type|expected", R"(^const (\w+) =)",
     "A declaration needs a type: const double %1 = ..., or const auto %1."},
    {"could not convert|cannot convert|conversion|invalid initialization", R"(return [^(){};]*,[^(){};]*;)",
     "Of several values behind return only the last counts. Together they stand in braces: return {a, b};"},
    {R"(expected ';')", R"(<<.*,.*[\w)]$)",
     "At the end of this line a comma is missing: the list goes on in the next."},
    {"",
     R"(\b(Quaternion|Vector3|Matrix3)[.](Slerp|Lerp|Cross|Dot|Distance|Inverse|LookRotation|AngleAxis|Angle|Euler|Normalize|Project|Reflect|Rotate)\b)",
     "%1.%2 is another engine's. Here you have Eigen's a.dot(b), a.cross(b), v.norm(), and this course's own "
     "functions, such as product, inverse, exponential and logarithm."},
    {R"('([a-z]\w*)' is not a member of '(Vector3|Matrix3|Quaternion)')", "",
     "A type's own names begin with a capital letter: $2::Identity(), Vector3::Zero()."},
    {R"(operator=' \(operand types are '(Vector3|Matrix3)' and '(?:int|double)')", "",
     "That is a number. One of zeros is $1::Zero()."},
    {R"(operator==' \(operand types are '(?:const )?(\w+)' and 'const char)", "\"(\\w+)\"",
     "That is no text: its values are written with the type in front and without quotation marks, $1::%1."},
    {R"(call to 'Quaternion::slerp)", "", "slerp takes the part of the way first, then where the way leads."},
    {R"(from '(?:const )?std::optional<)", "",
     "It may find nothing, so what it gives is in a std::optional: its value is *found, or "
     "found.value_or(something else)."},
    {R"(operator<<.*Quaternion|operator,.*Quaternion)", "",
     "The four numbers of a Quaternion are q.coeffs()."},
    {R"(call to '(?:std::)?(a?sin|a?cos|a?tan|sqrt|exp|log|abs|floor|ceil|l?round|trunc|hypot|pow|cbrt)\((?:const )?(?:Vector3|an expression of vectors))",
     "",
     "std::$1 takes a number, and here it is given a vector: take its length, v.norm(), or one component."},
    {R"(^expression cannot be used as a function)", R"((\w+[.]\w+)\(\))",
     "%1 is a number and no function here: leave out the brackets ()."},
    {R"(invalid types '.*' for array subscript)", "",
     "This is one number: it has no entries to ask for with [ ]."},
    {"", R"(\*\*)", "** is no power in C++: write x * x, or std::pow(x, 3)."},
    {R"(^(?!expected '))", R"(\^)",
     "^ is no power in C++ but an operation on bits: write x * x, or std::pow(x, 3)."},
    {"", R"(^for \w+ in |^for \(\w+ in |^for \w+,|^while [^(]|^if [^(c].*:$|^else:$|^elif )",
     "That is another language's form. In C++: for (int i = 0; i < n; ++i) { ... }, for (const auto& each : "
     "list) { ... }, if (...) { ... } else { ... }."},
    {"expected ';'|expected '\\)'|expected primary", R"(^for \([^;]*(;[^;]*)?\)|^for \([^;:]*,[^;]*,[^;]*\))",
     "The three parts in the head of a for stand between semicolons: for (int i = 0; i < n; ++i)."},
    {"", R"(\bnew ([A-Z]\w*))",
     "No new here: it gives a pointer. A value is made by its type alone: %1(...) or %1{...}."},
    {"", R"(\bstd[.]\w|\bstd:\w|\b(Math|math|np|Mathf)[.]\w)",
     "Names of the standard library are written std::sqrt, std::cos, std::abs, ..., with two colons."},
    {"", R"((return|=) ?\[[^\]&=]*,[^\]]*\] ?;)", "A list of values stands in braces: {a, b, c}."},
    {R"(no match for 'operator<<' \(operand types are 'const )", "", says_const},
    {R"(call to 'Quaternion::Quaternion|call to constructor of 'Quaternion|initializer list>' to '(?:const )?Quaternion)",
     "",
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
    {R"(wrong type argument to unary|cannot resolve overloaded function|invalid use of member function|invalid use of non-static member function|must be called|the name of a function|<unresolved overloaded function type>|cannot convert '.*::\w+' from type '.*\(.*\).*' to)",
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
    {R"(expected unqualified-id before '(const|double|int|auto)')", "",
     "Behind a comma a declaration goes on with the next name, without a type; a new one begins behind a ;"},
    {R"(expected unqualified-id before numeric)", "",
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
     "A number and a vector cannot be added, nor a number and a matrix: is one of them to be multiplied with "
     "a "
     "direction or with Matrix3::Identity(), or a norm to be taken?"},
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
    std::smatch found, in_line;
    for (const Rule& rule : rules) {
        const bool with_notes = std::string(rule.message).find("conflicting") != std::string::npos ||
                                std::string(rule.message).find("argument") != std::string::npos;
        const std::string all = with_notes ? message + "\n" + notes : message;
        if (rule.line[0] && !std::regex_search(line, in_line, std::regex(rule.line))) continue;
        if (!std::regex_search(all, found, std::regex(rule.message))) continue;
        std::string meaning = rule.message[0] ? found.format(rule.means) : std::string(rule.means);
        for (std::size_t i = 1; rule.line[0] && i < in_line.size(); ++i)
            meaning = replaced(meaning, "%" + std::to_string(i), in_line[i].str());
        return meaning;
    }
    return "";
}

}  // namespace nutshell::judge
