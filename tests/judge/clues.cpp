#include "clues.hpp"
#include <regex>
#include "text.hpp"
#include "tokens.hpp"

namespace nutshell::judge {

namespace {

bool is_whole(const Token& token) {
    return token.kind == Token::number && token.word.size() < 9 &&
           token.word.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace

std::optional<Clue> whole_division(const std::string& body) {
    const auto tokens = tokens_of(body);
    for (std::size_t i = 0; i + 2 < tokens.size(); ++i) {
        if (!is_whole(tokens[i]) || tokens[i + 1].word != "/" || !is_whole(tokens[i + 2])) continue;
        if (i > 0 && (tokens[i - 1].word == "*" || tokens[i - 1].word == "/")) continue;  // x * 1 / 2 is fine
        const std::string up(tokens[i].word), down(tokens[i + 2].word);
        const int above = std::stoi(up), below = std::stoi(down);
        if (below == 0 || above % below == 0) continue;
        return {{"a division of whole numbers",
                 up + " / " + down + " is a division of whole numbers in C++ and gives " +
                     std::to_string(above / below) + ", what is behind the point is lost: write " + up +
                     ".0 / " + down + "."}};
    }
    return std::nullopt;
}

std::optional<Clue> lost_fraction(const std::vector<Warning>& warnings, const Marked& source) {
    for (const Warning& warning : warnings) {
        if (warning.option != "float-conversion") continue;
        const std::size_t line = std::stoul(warning.where.substr(warning.where.rfind(':') + 1));
        const std::string text = trimmed(source.lines[line - 1]);
        if (contains(text, "floor") || contains(text, "ceil") || contains(text, "round") ||
            contains(text, "trunc"))
            continue;
        return {
            {"a fraction is lost", "In your line  " + text +
                                       "  a number with a fraction becomes an int, and what is behind the "
                                       "point is lost: take a double."}};
    }
    return std::nullopt;
}

std::optional<Clue> comma_between(const std::vector<Warning>& warnings, const Marked& source) {
    static const std::regex number(R"(\d,\d+)");
    for (const Warning& warning : warnings) {
        if (!contains(warning.words, "operand of comma operator")) continue;
        const std::size_t line = std::stoul(warning.where.substr(warning.where.rfind(':') + 1));
        const std::string text = trimmed(source.lines[line - 1]).substr(0, 300);
        std::smatch found;
        if (std::regex_search(text, found, number))
            return {{"a comma in a number", found.str() +
                                                " is no number in C++: of two values between which a "
                                                "comma stands the second counts. Write " +
                                                replaced(found.str(), ",", ".") + "."}};
        return {
            {"a comma between values", "In your line  " + text +
                                           "  the comma throws away what stands before it. Several values "
                                           "stand in braces."}};
    }
    return std::nullopt;
}

std::optional<Clue> two_answers(const SheetAnswer& answer) {
    if (!remembers(answer)) return std::nullopt;
    return {
        {"two answers to one question",
         "Asked the same questions once more, it gives other answers. Something is kept from call to call "
         "(a static or global variable?), or a variable is read before it has a value. What a function "
         "returns may depend on its arguments only."}};
}

}  // namespace nutshell::judge
