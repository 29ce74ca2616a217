// Where mutants of one body are made: its text, its tokens, its arguments.
#pragma once
#include <algorithm>
#include <array>
#include <map>
#include "mutants.hpp"
#include "text.hpp"
#include "tokens.hpp"

namespace nutshell::judge {

using Tokens = std::vector<Token>;

/// Collects mutants of one body and gives them names.
class Workshop {
  public:
    Workshop(std::string_view body, std::string_view signature)
        : body_(body), tokens_(tokens_of(body)), parameters_(parameters_of(signature)) {}

    /// The same text with a piece replaced.
    void put(const std::string& name, Span piece, const std::string& text) {
        if (piece.of(body_) == text) return;
        std::string all(body_.substr(0, piece.begin));
        add(name, all + text + std::string(body_.substr(piece.end)), piece.begin);
    }
    void add(const std::string& name, const std::string& body, std::size_t at) {
        const int count = ++counts_[name];
        mutants.push_back({count == 1 ? name : name + ", " + std::to_string(count), body, at, false});
    }
    std::string_view word(std::size_t i) const { return i < tokens_.size() ? tokens_[i].word : ""; }
    Span piece(std::size_t i) const { return {tokens_[i].at, tokens_[i].at + tokens_[i].word.size()}; }
    /// The operand on the right of the token at i: to the bracket, comma or weaker operator that ends it.
    Span right_of(std::size_t i) const {
        std::size_t end = i + 1;
        while (end < tokens_.size() && !ends_operand(word(end)))
            end = (opens(word(end)) ? closing(tokens_, end) : end) + 1;
        return {tokens_[i + 1].at, tokens_[end - 1].at + word(end - 1).size()};
    }

    std::vector<Mutant> mutants;

    const std::string_view body_;
    const Tokens tokens_;
    const std::vector<Parameter> parameters_;

    static bool opens(std::string_view word) { return word == "(" || word == "[" || word == "{"; }
    static bool ends_operand(std::string_view word) {
        constexpr std::array<std::string_view, 9> ends{")", "]", "}", ",", ";", "?", ":", "&&", "||"};
        return std::find(ends.begin(), ends.end(), word) != ends.end();
    }
    /// Whether the token at i, + or -, stands between two operands.
    bool is_binary(std::size_t i) const {
        if (i == 0) return false;
        const Token& before = tokens_[i - 1];
        if (before.kind == Token::name) return before.word != "return";
        return before.kind == Token::number || before.word == ")" || before.word == "]";
    }

  private:
    std::map<std::string, int> counts_;
};

}  // namespace nutshell::judge
