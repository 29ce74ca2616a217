#include "tokens.hpp"
#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include "text.hpp"

namespace nutshell::judge {

namespace {

bool is_letter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

/// Where the token that begins at `at` ends.
std::size_t end_of(std::string_view source, std::size_t at, Token::Kind kind) {
    std::size_t end = at + 1;
    if (kind == Token::name) {
        while (end < source.size() && is_letter(source[end])) ++end;
    } else if (kind == Token::number) {
        while (end < source.size() && (is_letter(source[end]) || source[end] == '.' || source[end] == '\'' ||
                                       ((source[end] == '-' || source[end] == '+') &&
                                        (source[end - 1] == 'e' || source[end - 1] == 'E'))))
            ++end;
    } else if (kind == Token::text) {
        while (end < source.size() && source[end] != source[at]) end += source[end] == '\\' ? 2 : 1;
        ++end;
    } else {
        constexpr std::array<std::string_view, 18> pairs{
            "<=", ">=", "==", "!=", "+=", "-=", "*=", "/=", "&&",
            "||", "++", "--", "::", "->", "<<", ">>", "%=", "^="};
        if (std::find(pairs.begin(), pairs.end(), source.substr(at, 2)) != pairs.end()) ++end;
    }
    return std::min(end, source.size());
}

}  // namespace

std::vector<Token> tokens_of(std::string_view source) {
    std::vector<Token> tokens;
    for (std::size_t at = 0; at < source.size();) {
        const char c = source[at], next = at + 1 < source.size() ? source[at + 1] : '\0';
        if (std::isspace(static_cast<unsigned char>(c))) {
            ++at;
        } else if (c == '/' && (next == '/' || next == '*')) {
            const auto end = source.find(next == '/' ? "\n" : "*/", at + 2);
            at = end == std::string_view::npos ? source.size() : end + (next == '/' ? 1 : 2);
        } else {
            const bool digit = std::isdigit(static_cast<unsigned char>(c)) ||
                               (c == '.' && std::isdigit(static_cast<unsigned char>(next)));
            const auto kind = digit                   ? Token::number
                              : is_letter(c)          ? Token::name
                              : c == '"' || c == '\'' ? Token::text
                                                      : Token::sign;
            const std::size_t end = end_of(source, at, kind);
            tokens.push_back({kind, source.substr(at, end - at), at});
            at = end;
        }
    }
    return tokens;
}

std::size_t closing(const std::vector<Token>& tokens, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < tokens.size(); ++i) {
        const auto word = tokens[i].word;
        if (tokens[i].kind != Token::sign) continue;
        if (word == "(" || word == "{" || word == "[") ++depth;
        if (word == ")" || word == "}" || word == "]")
            if (--depth == 0) return i;
    }
    return tokens.size();
}

std::vector<Span> statements_of(std::string_view body) {
    std::vector<Span> all;
    const auto tokens = tokens_of(body);
    const auto word = [&](std::size_t i) { return i < tokens.size() ? tokens[i].word : std::string_view(); };
    for (std::size_t i = 0; i < tokens.size();) {
        const std::size_t begin = tokens[i].at;
        const bool block = word(i) == "if" || word(i) == "for" || word(i) == "while" || word(i) == "switch";
        for (bool ended = false; !ended && i < tokens.size(); ++i) {
            const bool open = word(i) == "(" || word(i) == "{" || word(i) == "[";
            const bool brace = word(i) == "{";
            if (open) i = closing(tokens, i);
            ended = word(i) == ";" || (brace && block);
            if (ended && word(i + 1) == "else") ended = false;
        }
        const Token& last = tokens[std::min(i, tokens.size()) - 1];
        all.push_back({begin, last.at + last.word.size()});
    }
    return all;
}

namespace {

/// The names that a statement writes, and the whole left-hand sides.
struct Written {
    std::set<std::string_view> names, places;
    bool returns = false;
};

Written written_by(std::string_view statement) {
    Written written;
    const auto tokens = tokens_of(statement);
    constexpr std::array<std::string_view, 8> writes{"=", "+=", "-=", "*=", "/=", "<<", "++", "--"};
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const bool declares = i > 1 && tokens[i].word == ";" && tokens[i - 1].kind == Token::name &&
                              tokens[i - 2].kind == Token::name;
        written.returns = written.returns || tokens[i].word == "return";
        if (!declares && std::find(writes.begin(), writes.end(), tokens[i].word) == writes.end()) continue;
        std::size_t begin = i;  // back over  name.member(0, 1)
        for (int depth = 0; begin > 0; --begin) {
            const auto word = tokens[begin - 1].word;
            if (word == ")" || word == "]") ++depth;
            if (depth == 0 && tokens[begin - 1].kind != Token::name && word != ".") break;
            if (depth == 0 && begin < i && tokens[begin - 1].kind == Token::name &&
                tokens[begin].kind == Token::name)
                break;
            if (word == "(" || word == "[") --depth;
        }
        if (begin >= i) return {{}, {}, true};  // ++x and the like: not understood
        written.names.insert(tokens[begin].word);
        written.places.insert(statement.substr(tokens[begin].at, tokens[i].at - tokens[begin].at));
    }
    if (written.names.empty() && tokens.size() > 1 && tokens[0].kind == Token::name && tokens[1].word == "(")
        for (const Token& token : tokens)
            if (token.kind == Token::name) written.names.insert(token.word);
    return written;
}

}  // namespace

bool independent(std::string_view one, std::string_view other) {
    const Written first = written_by(one), second = written_by(other);
    if (first.returns || second.returns) return false;
    const auto names_in = [](std::string_view statement, std::string_view name) {
        const auto tokens = tokens_of(statement);
        return std::count_if(tokens.begin(), tokens.end(),
                             [&](const Token& token) { return token.word == name; });
    };
    const auto element = [](const Written& written) {  // r(0, 1): a place of its own
        return written.places.size() == 1 && contains(*written.places.begin(), "(") &&
               written.places.begin()->find_first_not_of(
                   "0123456789(), ", written.places.begin()->find('(')) == std::string_view::npos;
    };
    const bool apart = element(first) && element(second) && first.places != second.places;
    const auto disturbs = [&](const Written& written, std::string_view statement) {
        return std::any_of(written.names.begin(), written.names.end(), [&](std::string_view name) {
            return names_in(statement, name) > (apart && *written.names.begin() == name ? 1 : 0);
        });
    };
    return !disturbs(first, other) && !disturbs(second, one);
}

std::vector<Parameter> parameters_of(std::string_view signature) {
    std::vector<Parameter> all;
    const auto tokens = tokens_of(signature);
    std::size_t open = tokens.size();
    for (std::size_t i = tokens.size(); i-- > 0;)  // the last round bracket at the outermost level
        if (tokens[i].word == "(" && closing(tokens, i) + 1 >= tokens.size()) open = i;
    if (open == tokens.size()) return all;
    std::vector<std::string_view> words;
    int angles = 0;
    for (std::size_t i = open + 1; i < tokens.size(); ++i) {
        angles += tokens[i].word == "<";
        angles -= tokens[i].word == ">";
        if (!(i + 1 == tokens.size() || (tokens[i].word == "," && angles == 0))) {
            words.push_back(tokens[i].word);
            continue;
        }
        words.erase(std::find(words.begin(), words.end(), "="), words.end());
        if (words.empty()) continue;
        const bool reference = std::find(words.begin(), words.end(), "&") != words.end(),
                   constant = words.front() == "const";
        std::string name(words.back());
        if (words.size() < 2 || !is_letter(name[0]) || words[words.size() - 2] == "const" ||
            words[words.size() - 2] == "::")
            name.clear();
        std::string type;
        for (std::size_t k = constant; k + !name.empty() < words.size(); ++k)
            if (words[k] != "&") type += (words[k] == "const" ? "const " : std::string(words[k]));
        all.push_back({type, name, reference && !constant, constant});
        words.clear();
    }
    return all;
}

}  // namespace nutshell::judge
