#include "workshop.hpp"

namespace nutshell::judge {

namespace {

using Exchange = std::pair<std::string_view, std::string_view>;

void exchange_signs(Workshop& shop) {
    constexpr std::array<Exchange, 20> exchanges{
        {{"*", "/"},   {"/", "*"},   {"+=", "-="}, {"-=", "+="}, {"+=", "="},  {"-=", "="}, {"*=", "/="},
         {"/=", "*="}, {"*=", "="},  {"<", "<="},  {"<=", "<"},  {">", ">="},  {">=", ">"}, {"<", ">"},
         {">", "<"},   {"==", "!="}, {"!=", "=="}, {"&&", "||"}, {"||", "&&"}, {"++", "--"}}};
    const auto& tokens = shop.tokens_;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (tokens[i].kind != Token::sign) continue;
        const std::string sign(tokens[i].word);
        for (const auto& [from, to] : exchanges)
            if (sign == from) shop.put(sign + " to " + std::string(to), shop.piece(i), std::string(to));
        if (sign == "+" && shop.is_binary(i)) shop.put("+ to -", shop.piece(i), "-");
        if (sign == "-" && shop.is_binary(i)) shop.put("- to +", shop.piece(i), "+");
        if (sign == "-" && !shop.is_binary(i)) shop.put("no minus", shop.piece(i), "");
        if (sign == "!") shop.put("no !", shop.piece(i), "");
        if (sign == "<" || sign == "<=" || sign == ">" || sign == ">=")
            for (const auto* shift : {"0.8 * ", "1.25 * "}) {
                if (shop.word(i + 1) == "0") break;
                const Span right = shop.right_of(i);
                shop.put(sign + " at " + shift + std::string(right.of(shop.body_)), right,
                         shift + ("(" + std::string(right.of(shop.body_)) + ")"));
            }
        if (sign == "==" && shop.word(i + 1) == "0")
            shop.put("== 0 to < 0.001", {tokens[i].at, shop.piece(i + 1).end}, "< 0.001");
    }
}

void change_literals(Workshop& shop) {
    const auto& tokens = shop.tokens_;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (tokens[i].kind != Token::number) continue;
        const std::string number(tokens[i].word);
        shop.put(number + " to " + number + " + 1", shop.piece(i), "(" + number + " + 1)");
        if (i > 0 && shop.word(i - 1) != "[" && number != "0")
            shop.put(number + " to 0.999 of it", shop.piece(i), "(" + number + " * 0.999)");
        if (contains(number, ".") && number.back() == '.')
            shop.put(number + " without its point", shop.piece(i), number.substr(0, number.size() - 1));
        if (contains(number, ".0"))
            shop.put(number + " without its point", shop.piece(i), number.substr(0, number.find('.')));
    }
}

void exchange_functions(Workshop& shop) {
    constexpr std::array<Exchange, 19> exchanges{{{"floor", "ceil"},
                                                  {"floor", "round"},
                                                  {"ceil", "floor"},
                                                  {"ceil", "round"},
                                                  {"min", "max"},
                                                  {"max", "min"},
                                                  {"exp", "expm1"},
                                                  {"expm1", "exp"},
                                                  {"sqrt", "cbrt"},
                                                  {"cbrt", "sqrt"},
                                                  {"log", "log10"},
                                                  {"sin", "cos"},
                                                  {"cos", "sin"},
                                                  {"norm", "squaredNorm"},
                                                  {"squaredNorm", "norm"},
                                                  {"Zero", "Ones"},
                                                  {"transpose", "eval"},
                                                  {"exp", "log"},
                                                  {"log", "exp"}}};
    for (std::size_t i = 0; i < shop.tokens_.size(); ++i) {
        for (const auto& [from, to] : exchanges)
            if (shop.word(i) == from && shop.word(i + 1) == "(")
                shop.put(std::string(from) + " to " + std::string(to), shop.piece(i), std::string(to));
        if (shop.word(i) == "normalized" || shop.word(i) == "conjugate" || shop.word(i) == "inverse")
            shop.put("no " + std::string(shop.word(i)), {shop.tokens_[i].at - 1, shop.piece(i + 2).end}, "");
        if (shop.word(i) == "double" && i > 0 && shop.word(i - 1) == "const" && shop.word(i + 1) != ">")
            shop.put("an int for " + std::string(shop.word(i + 1)), shop.piece(i), "int");
    }
}

/// One argument, or a variable of the body, taken for another of the same type.
void exchange_names(Workshop& shop) {
    for (const auto& one : shop.parameters_)
        for (const auto& other : shop.parameters_) {
            if (one.name == other.name || one.name.empty() || other.name.empty() || one.type != other.type)
                continue;
            for (std::size_t i = 0; i < shop.tokens_.size(); ++i)
                if (shop.word(i) == one.name &&
                    (i == 0 || (shop.word(i - 1) != "." && shop.word(i - 1) != "::")))
                    shop.put(one.name + " to " + other.name, shop.piece(i), other.name);
        }
}

void move_statements(Workshop& shop) {
    const auto statements = statements_of(shop.body_);
    const auto text = [&](std::size_t i) { return std::string(statements[i].of(shop.body_)); };
    for (std::size_t i = 0; i < statements.size(); ++i) {
        if (!starts_with(text(i), "return ") || i + 1 < statements.size())
            shop.put("no statement " + std::to_string(i + 1), statements[i], "");
        for (std::size_t k = i + 1; k < statements.size(); ++k) {
            if (text(i) == text(k)) continue;
            std::string body(shop.body_);
            body.replace(statements[k].begin, text(k).size(), text(i));
            body.replace(statements[i].begin, text(i).size(), text(k));
            shop.add("statements " + std::to_string(i + 1) + " and " + std::to_string(k + 1) + " swapped",
                     body, statements[i].begin);
            bool equal = true;
            for (std::size_t m = i; m <= k; ++m)
                equal = equal && (m == i || independent(text(i), text(m))) &&
                        (m == k || independent(text(k), text(m)));
            shop.mutants.back().proved_equal = equal;
        }
    }
}

}  // namespace

std::vector<Mutant> slips_of(std::string_view body, std::string_view signature) {
    Workshop shop(body, signature);
    for (const auto make :
         {exchange_signs, change_literals, exchange_functions, exchange_names, move_statements})
        make(shop);
    return shop.mutants;
}

}  // namespace nutshell::judge
