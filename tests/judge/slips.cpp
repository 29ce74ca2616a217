#include "slips.hpp"
#include <algorithm>
#include <regex>
#include "desk.hpp"
#include "gates.hpp"
#include "text.hpp"
#include "tokens.hpp"

namespace nutshell::judge {

namespace {

/// A learner's headers, and one body among them.
struct Own {
    std::vector<Marked> sources;
    const Body* body = nullptr;
    std::string first_line;

    Own(const Rooms& rooms, const Chapter& chapter, Number number) {
        for (const auto& header : chapter.headers)
            sources.push_back(marked(own_text(rooms, chapter, header).value_or(header.reference.text())));
        for (const Marked& source : sources)
            if (const Body* found = source.body(number)) {
                body = found;
                first_line = signature(source, number);
            }
    }
};

/// Processor time for all that is tried on one answer [s], the compiler's included.
constexpr double all_seconds = 4;

/// The first of the bodies that passes. What there is no time for is not tried.
/// @param safe  so many, from the first on, compile
std::optional<Mutant> first_passing(const Rooms& rooms, const Chapter& chapter, const Own& own, Number number,
                                    const std::vector<Mutant>& mutants, std::size_t safe) try {
    const exercises::Record reference = record_of(exercise_of(number).reference, false);
    double seconds = 0;
    std::optional<Mutant> right;
    // as many at once as compile in most of the time, beside what the questions take
    std::size_t count = std::clamp<std::size_t>(32000 / (own.body->text.size() + 1), 24, 120);
    for (std::size_t from = 0; from < mutants.size() && !right;) {
        const std::size_t to = std::min(from < safe ? safe : mutants.size(), from + count);
        const auto at = [&](std::size_t i) { return mutants.begin() + static_cast<std::ptrdiff_t>(i); };
        Herd herd{{{number, {at(from), at(to)}}}, {}, all_seconds - seconds};
        herd.ask(rooms, chapter, own.sources, "slips", [&](Number, std::size_t i, const SheetAnswer& answer) {
            if (!right && passes(reference, answer)) right = mutants[from + i];
        });
        seconds += herd.seconds;
        if (all_seconds - seconds < herd.seconds / 2) break;  // no time for one more
        from = to;
    }
    return right;
} catch (const MachineFault&) {
    return std::nullopt;  // it would have been a help only
}

/// The slips of the pen that learners make, the likeliest first; and how many of them surely compile.
std::pair<std::vector<Mutant>, std::size_t> likely_slips(const Own& own) {
    auto all = slips_of(own.body->text, own.first_line);
    for (auto& more : more_slips_of(own.body->text, own.first_line)) all.push_back(std::move(more));
    const auto has = [](const std::string& name, std::initializer_list<const char*> parts) {
        return std::any_of(parts.begin(), parts.end(),
                           [&](const char* part) { return contains(name, part); });
    };
    std::erase_if(all, [&](const Mutant& each) {
        return has(each.name, {"0.999", "at 0.8", "at 1.25", "an int for", "expm1", "cbrt", "log10", "Ones",
                               "to eval", "< 0.001", "statements "}) &&
               !starts_with(each.name, "statements in");
    });
    const bool fills = contains(own.body->text, "<<");  // a matrix, entry by entry
    const auto rank = [&](const Mutant& each) {
        if (has(each.name, {"statement"})) return 5;
        if (has(each.name, {"to twice it", "to half of it", "handed to product"})) return 0;
        if (has(each.name, {"no minus there"})) return fills ? 1 : 3;
        if (has(each.name, {"a factor too many", "- to /", "/ to -", "brackets", " to 0", "+ 1"})) return 3;
        if (has(each.name, {"<", ">", "==", "!=", "&&", "||", "*= to", "/= to"})) return 4;
        // what may not compile, and then costs the time of all that is compiled with it, comes from 2 on
        return has(each.name, {"half of what", "twice what", "log to", "exp to", "* to /", "/ to *", "side",
                               "handed to", "before it is read", "norm to", "quaredNorm to"})
                   ? 2
                   : 1;
    };
    std::stable_sort(all.begin(), all.end(),
                     [&](const Mutant& a, const Mutant& b) { return rank(a) < rank(b); });
    const auto safe =
        std::count_if(all.begin(), all.end(), [&](const Mutant& each) { return rank(each) < 2; });
    return {all, static_cast<std::size_t>(safe)};
}

/// Mutants in which the expression behind `auto name =` is evaluated at once.
std::vector<Mutant> evaluated_autos(const std::string& body) {
    std::vector<Mutant> all;
    const auto tokens = tokens_of(body);
    for (std::size_t i = 0; i + 2 < tokens.size(); ++i) {
        if (tokens[i].word != "auto" || tokens[i + 2].word != "=") continue;
        std::size_t end = i + 3;
        while (end < tokens.size() && tokens[end].word != ";" && tokens[end].word != ",") {
            const bool open = tokens[end].word == "(" || tokens[end].word == "[" || tokens[end].word == "{";
            end = (open ? closing(tokens, end) : end) + 1;
        }
        if (end >= tokens.size()) continue;
        const std::size_t from = tokens[i + 3].at, to = tokens[end].at;
        all.push_back(
            {std::string(tokens[i + 1].word),
             body.substr(0, from) + "(" + body.substr(from, to - from) + ").eval()" + body.substr(to),
             tokens[i].at});
    }
    return all;
}

/// What is wrong in the line, by the change that mends it.
std::string what_of(std::string change) {
    static const std::regex count(R"(, \d+$)");  // of changes of this name
    change = std::regex_replace(change, count, "");
    const auto is = [&](const char* start) { return starts_with(change, start); };
    if (is("no statement")) return "it is one statement too many, as far as the numbers tell";
    if (is("statements ")) return "it stands in the wrong place among the statements";
    if (is("a factor too many")) return "a factor in it, or something it is divided by, is too many";
    if (is("a half lost")) return "a dt in it is not the time that belongs there";
    if (is("brackets missing")) return "brackets are missing: * and / go before + and -";
    if (is("divisor without"))
        return "* and / go from left to right: put brackets round all that is divided by";
    if (contains(change, "in the other order") || is("the two sides"))
        return "two things in it stand in the wrong order";
    if (is("half of what") || is("twice what"))
        return std::string(is("half") ? "a half is missing" : "a half is too many") +
               " in what is handed to `" + change.substr(change.rfind(' ') + 1) + "`";
    if (is("the step's start"))
        return "the time in it is " + change.substr(0, change.find(',')) + "; it must be that of its" +
               change.substr(change.rfind(' '));
    if (contains(change, "changed before it is read"))
        return "`" + change.substr(0, change.find(" changed")) +
               "` is overwritten here, and what stands below needs it as it was before";
    if (is("abs")) return "an abs() in it takes a sign away that is needed";
    if (is("no normalized") || is("no conjugate") || is("no inverse"))
        return "`." + change.substr(3, change.find(',') - 3) + "()` is too much in it";
    if (is("- to /") || is("/ to -")) return "the two parts of it are not joined in the right way";
    if (is("no minus") || is("+ to -") || is("- to +") || is("+= to") || is("-= to") || is("*= to") ||
        is("/= to"))
        return "a sign in it is the wrong one";
    if (is("* to /") || is("/ to *"))
        return "something is multiplied that should be divided, or the other way round";
    if (is("<") || is(">") || is("==") || is("!=") || is("&&") || is("||") || is("no !"))
        return "a comparison in it is not quite the right one";
    if (contains(change, "+ 1") || contains(change, " to 0") || contains(change, "0.999") ||
        contains(change, "point"))
        return "a number in it is the wrong one";
    const std::string from = change.substr(0, change.find(" to "));
    return "`" + from + "` is not what belongs there";
}

}  // namespace

std::optional<Clue> dangling_auto(const Rooms& rooms, const Chapter& chapter, Number number) {
    const Own own(rooms, chapter, number);
    if (!own.body) return std::nullopt;
    auto mutants = evaluated_autos(own.body->text);
    if (mutants.size() > 1) {  // and all at once
        Mutant all = mutants.back();
        for (std::size_t i = mutants.size() - 1; i-- > 0;) all.body = evaluated_autos(all.body)[i].body;
        mutants.push_back({"all", all.body, 0});
    }
    if (const auto right = first_passing(rooms, chapter, own, number, mutants, mutants.size()))
        return {
            {"an expression kept by auto",
             "The formula is right. But `auto " + right->name +
                 "` keeps the expression, not its value: what it was made of is gone, or has changed, when "
                 "the value is needed. Write the type: Vector3 " +
                 right->name + "."}};
    return std::nullopt;
}

std::optional<std::string> one_slip_away(const Rooms& rooms, const Chapter& chapter, Number number) {
    const Own own(rooms, chapter, number);
    if (!own.body) return std::nullopt;
    const auto [slips, safe] = likely_slips(own);
    const auto right = first_passing(rooms, chapter, own, number, slips, safe);
    if (!right) return std::nullopt;
    const auto before = std::count(own.body->text.begin(),
                                   own.body->text.begin() + static_cast<std::ptrdiff_t>(right->at), '\n');
    const std::string line = trimmed(lines_of(own.body->text)[static_cast<std::size_t>(before)]);
    return "It is one slip away from right, in the line  " + line + "  : " + what_of(right->name) + ".";
}

}  // namespace nutshell::judge
