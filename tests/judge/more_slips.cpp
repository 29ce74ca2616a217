// Slips that a learner's body may have and the reference's mutants cannot: something lost or added.
#include "workshop.hpp"

namespace nutshell::judge {

namespace {

/// a / b * c for a / (b * c): what stands behind the divisor is multiplied.
void bracket_divisors(Workshop& shop) {
    for (std::size_t i = 0; i + 3 < shop.tokens_.size(); ++i) {
        if (shop.word(i) != "/" || shop.word(i + 2) != "*") continue;
        std::size_t end = i + 3;
        while (end < shop.tokens_.size() && shop.word(end + 1) == "(") end = closing(shop.tokens_, end + 1);
        while (shop.word(end + 1) == "*" && end + 2 < shop.tokens_.size()) end += 2;
        const Span all{shop.tokens_[i + 1].at, shop.piece(end).end};
        shop.put("divisor without brackets", all, "(" + std::string(all.of(shop.body_)) + ")");
    }
}

/// The two sides of a product or the two arguments of a call change places: no matter for numbers, all of it
/// for rotations and cross products.
void exchange_sides(Workshop& shop) {
    const auto& tokens = shop.tokens_;
    for (std::size_t i = 0; i + 3 < tokens.size(); ++i) {
        if (shop.word(i + 1) != "(" || tokens[i].kind != Token::name) continue;
        const std::size_t close = closing(tokens, i + 1);
        if (close >= tokens.size()) continue;
        std::size_t comma = 0, depth = 0, commas = 0;
        for (std::size_t k = i + 2; k < close; ++k) {
            if (Workshop::opens(shop.word(k))) ++depth;
            if (shop.word(k) == ")" || shop.word(k) == "]" || shop.word(k) == "}") --depth;
            if (depth == 0 && shop.word(k) == ",") comma = k, ++commas;
        }
        const auto text = [&](std::size_t from, std::size_t to) {
            return std::string(Span{tokens[from].at, shop.piece(to).end}.of(shop.body_));
        };
        if (commas == 1 && comma + 1 < close)
            shop.put("the two handed to " + std::string(shop.word(i)) + " in the other order",
                     {tokens[i + 2].at, shop.piece(close - 1).end},
                     text(comma + 1, close - 1) + ", " + text(i + 2, comma - 1));
        if (i >= 2 && shop.word(i - 1) == "." && tokens[i - 2].kind == Token::name && commas == 0 &&
            (shop.word(i) == "cross" || shop.word(i) == "dot") && close > i + 2)
            shop.put("the two sides of a cross product", {tokens[i - 2].at, shop.piece(close).end},
                     "(" + text(i + 2, close - 1) + ").cross(" + std::string(shop.word(i - 2)) + ")");
    }
    for (std::size_t i = 1; i + 1 < tokens.size(); ++i)
        if (shop.word(i) == "*" && tokens[i - 1].kind == Token::name && tokens[i + 1].kind == Token::name &&
            shop.word(i + 2) != "(" && shop.word(i + 2) != ".")
            shop.put("the two sides of a product", {tokens[i - 1].at, shop.piece(i + 1).end},
                     std::string(shop.word(i + 1)) + " * " + std::string(shop.word(i - 1)));
}

/// The half of an angle or of anything that is handed to a function, forgotten or one too many.
void halve_angles(Workshop& shop) {
    for (std::size_t i = 0; i + 2 < shop.tokens_.size(); ++i) {
        if (shop.tokens_[i].kind != Token::name || shop.word(i + 1) != "(") continue;
        const std::size_t close = closing(shop.tokens_, i + 1);
        if (close >= shop.tokens_.size() || close == i + 2) continue;
        const Span inside{shop.tokens_[i + 2].at, shop.tokens_[close].at};
        for (const auto* factor : {"0.5 * ", "2 * "})
            if (!contains(inside.of(shop.body_), ","))
                shop.put((factor[0] == '2' ? "twice what goes into " : "half of what goes into ") +
                             std::string(shop.word(i)),
                         inside, factor + ("(" + std::string(inside.of(shop.body_)) + ")"));
    }
}

/// Another time in the step.
void shift_times(Workshop& shop) {
    for (std::size_t i = 1; i + 1 < shop.tokens_.size(); ++i) {
        if (shop.word(i) != "t" || (shop.word(i + 1) != ")" && shop.word(i + 1) != ",")) continue;
        shop.put("the step's start, not its end", shop.piece(i), "t + dt");
        shop.put("the step's start, not its middle", shop.piece(i), "t + dt / 2");
    }
}

/// What a later statement reads as it was before a statement changed it.
void read_before_changed(Workshop& shop) {
    const auto statements = statements_of(shop.body_);
    for (const Span& changing : statements) {
        const std::string text(changing.of(shop.body_));
        const auto tokens = tokens_of(text);
        std::size_t sign = 0;
        while (sign < tokens.size() && tokens[sign].word != "=" && tokens[sign].word != "+=" &&
               tokens[sign].word != "-=" && tokens[sign].word != "*=" && tokens[sign].word != "/=" &&
               tokens[sign].word != "(")
            ++sign;
        if (sign + 2 < tokens.size() && tokens[sign].word == "(" && tokens[sign + 1].word == ")") sign += 2;
        if (sign == 0 || sign >= tokens.size() || tokens[sign].word == "(") continue;
        bool declares = false;
        for (std::size_t k = 0; k + 1 < sign; ++k)
            declares = declares || (tokens[k].kind == Token::name && tokens[k + 1].kind == Token::name);
        const std::string target = trimmed(text.substr(0, tokens[sign].at));
        const std::size_t after = changing.end;
        std::string rest(shop.body_.substr(after));
        if (declares || !contains(rest, target)) continue;
        // reads, not writes: what stands in front of an assignment stays
        std::string read;
        for (std::size_t from = 0;;) {
            const std::size_t at = rest.find(target, from);
            if (at == std::string::npos) {
                read += rest.substr(from);
                break;
            }
            const std::string behind = trimmed(rest.substr(at + target.size(), 4));
            const bool writes = (starts_with(behind, "=") && !starts_with(behind, "==")) ||
                                (behind.size() > 1 && behind[1] == '=' && behind[0] != '=');
            read += rest.substr(from, at - from) + (writes ? target : "as_it_was");
            from = at + target.size();
        }
        if (read == rest) continue;
        std::string body(shop.body_.substr(0, changing.begin));
        body += "const std::decay_t<decltype(" + target + ")> as_it_was = " + target + ";\n" + text + read;
        shop.add(target + " changed before it is read", body, changing.begin);
    }
}

/// What a learner adds or leaves out: a factor, a sign, brackets, a function round a value; a statement that
/// stands too early or too late.
void lose_and_add(Workshop& shop) {
    const auto& tokens = shop.tokens_;
    const bool fills = contains(shop.body_, "<<");  // a matrix, entry by entry
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
        const Token &here = tokens[i], &next = tokens[i + 1];
        const bool operand = next.kind == Token::name || next.kind == Token::number;
        std::size_t last = i + 1;  // of an operand such as universe.mass
        while (shop.word(last + 1) == "." && last + 2 < tokens.size()) last += 2;
        const auto ends_at = [&](std::size_t k) {
            return k + 1 >= tokens.size() || (shop.word(k + 1) != "(" && shop.word(k + 1) != "." &&
                                              shop.word(k + 1) != "::" && shop.word(k + 1) != "[");
        };
        const bool ends = ends_at(i + 1);
        if ((here.word == "/" || here.word == "*") && operand && ends_at(last))
            shop.put("a factor too many", {here.at, shop.piece(last).end}, "");
        if (operand && shop.word(i + 2) == "*" && (here.kind == Token::sign || here.word == "return"))
            shop.put("a factor too many", {next.at, shop.piece(i + 2).end}, "");
        if (here.word == "(" || here.word == "return" || here.word == "=" ||
            (here.word == "," && fills && next.kind == Token::name))
            if (next.word != "-" && next.word != ")") shop.put("no minus there", {next.at, next.at}, "-");
        if (here.kind == Token::name && ends && i > 0 && shop.word(i) == "dt" && next.word != "/")
            shop.put("a half lost", {here.at, shop.piece(i).end}, "dt / 2");
        if (here.word == "-" && shop.is_binary(i)) shop.put("- to /", shop.piece(i), "/");
        if (here.word == "/") shop.put("/ to -", shop.piece(i), "-");
        if (here.kind == Token::number) {
            const std::string number(here.word);
            shop.put(number + " to 0", shop.piece(i), "0");
            if (number != "0") shop.put(number + " to twice it", shop.piece(i), "(2 * " + number + ")");
            if (number != "0") shop.put(number + " to half of it", shop.piece(i), "(0.5 * " + number + ")");
        }
        if (here.word == "abs" && next.word == "(")
            shop.put("abs", {tokens[i].at - (i > 1 && shop.word(i - 1) == "::" ? 5 : 0), shop.piece(i).end},
                     "");
        if ((here.word == "+" || here.word == "-") && shop.is_binary(i) &&
            i >= 1) {  // a - b / c to (a - b) / c
            std::size_t begin = i - 1, end = i + 1;
            while (begin > 0 && (shop.word(begin - 1) == "." || shop.word(begin - 1) == "::")) begin -= 2;
            while (end + 2 < tokens.size() && shop.word(end + 1) == ".") end += 2;
            if (tokens[i - 1].kind == Token::name && tokens[end].kind == Token::name)
                shop.put("brackets missing", {tokens[begin].at, shop.piece(end).end},
                         "(" +
                             std::string(shop.body_.substr(tokens[begin].at,
                                                           shop.piece(end).end - tokens[begin].at)) +
                             ")");
        }
    }
    for (const auto make : {bracket_divisors, exchange_sides, halve_angles, shift_times, read_before_changed})
        make(shop);
    const auto statements = statements_of(shop.body_);
    for (std::size_t i = 0; i < statements.size(); ++i)
        for (std::size_t k = i + 2; k < statements.size(); ++k) {  // k goes up to the place before i
            std::string body(shop.body_);
            const std::string moved(statements[k].of(shop.body_));
            body.erase(statements[k].begin, moved.size());
            body.insert(statements[i].begin, moved + "\n");
            shop.add("statements in another order", body, statements[k].begin);
        }
}

}  // namespace

std::vector<Mutant> more_slips_of(std::string_view body, std::string_view signature) {
    Workshop shop(body, signature);
    lose_and_add(shop);
    return shop.mutants;
}

}  // namespace nutshell::judge
