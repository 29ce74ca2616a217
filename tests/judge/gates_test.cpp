// The gates of every exercise of every chapter: what DESIGN asks of exercises, held for all of them at once.
#include "gates.hpp"
#include <algorithm>
#include <regex>
#include "../check.hpp"
#include "diagnosis.hpp"
#include "learner.hpp"

using namespace nutshell::judge;
using nutshell::exercises::Exercise;
using nutshell::exercises::Record;

namespace {

const Rooms rooms{CONFIG_COURSE, "/nonexistent/answers", "/nonexistent/work", CONFIG_SHARED};

std::vector<Values> values_of(const Record& record) {
    std::vector<Values> values;
    for (const auto& output : record.outputs) values.push_back(output.values);
    return values;
}

}  // namespace

TEST_CASE("Every marked body has an exercise, and every exercise a marked body") {
    std::vector<std::string> marked_ids, entered_ids;
    for (const Chapter& chapter : chapters_of(rooms))
        for (const Number number : chapter.exercises) {
            marked_ids.push_back(number.text());
            CHECK(number.chapter == chapter.number);
            CHECK_NOTHROW(questions_file(rooms, chapter, number));
        }
    for (const Exercise& exercise : all_exercises()) entered_ids.push_back(exercise.id);
    CHECK(marked_ids == entered_ids);
    CHECK(marked_ids.size() >= 8);
}

TEST_CASE("Marks that do not pair up are complained about") {
    const auto complaint = [](const std::string& text) {
        const Marked source = marked(text);
        return source.complaints.empty() ? "none" : source.complaints.begin()->second;
    };
    const std::string open = "// exercise 1.1\n", close = "// end 1.1\n";
    CHECK(complaint(open + "return;\n" + close) == "none");
    CHECK_THAT(complaint(open + "return;\n"), ContainsSubstring("`// end 1.1` is gone"));
    CHECK_THAT(complaint("return;\n" + close), ContainsSubstring("`// exercise 1.1` is gone"));
    CHECK_THAT(complaint(open + open + "return;\n" + close),
               ContainsSubstring("stands 2 times, in lines 1 and 2"));
    CHECK_THAT(complaint(close + "return;\n" + open), ContainsSubstring("stands above"));
    CHECK_THAT(complaint(open + "// exercise 1.2\n// end 1.2\n" + close),
               ContainsSubstring("stands inside the body of 1.1"));
    CHECK(chapters_of(rooms).size() >= 1);  // which throws if the reference's own marks do not pair up
}

TEST_CASE("Exercises can be stripped: explicit return types, whole statements, and a signature that stays") {
    for (const Chapter& chapter : chapters_of(rooms))
        for (const Number number : chapter.exercises) {
            const Marked& reference = chapter.header_of(number).reference;
            const std::string head = signature(reference, number), function = exercise_of(number).function;
            INFO(number.text() << ": " << head);
            CHECK_FALSE(
                std::regex_search(head, std::regex(R"(\b(constexpr|consteval|noexcept|explicit)\b)")));
            CHECK_FALSE(std::regex_search(head, std::regex(R"((^|> )auto\b|->)")));
            CHECK(std::regex_search(head, std::regex(R"([\w>&:*\]] (\w+::)*)" + function +
                                                     R"(\()")));  // a type stands before the name
            const std::string body = bare_code(reference.body(number)->text);
            CHECK(std::count(body.begin(), body.end(), '{') == std::count(body.begin(), body.end(), '}'));
            CHECK((body.back() == ';' || body.back() == '}'));
            CHECK(is_unanswered(*marked(skeleton(reference.text())).body(number)));
        }
}

TEST_CASE(
    "Words: a title, three hints, three mistakes with name, origin, symptom and sentence, an alternative") {
    for (const Exercise& exercise : all_exercises()) {
        INFO(exercise.id);
        CHECK(!exercise.title.empty());
        CHECK(exercise.mistakes.size() >= 3);
        CHECK(!exercise.alternatives.empty());
        for (const auto& hint : exercise.hints) CHECK(hint.size() > 20);
        for (const auto& mistake : exercise.mistakes)
            for (const auto& words : {mistake.name, mistake.origin, mistake.symptom, mistake.sentence})
                CHECK(!words.empty());
    }
}

TEST_CASE("No hint holds a line of the solution") {
    const auto squeezed = [](const std::string& text) { return replaced(bare_code(text), " ", ""); };
    for (const Chapter& chapter : chapters_of(rooms))
        for (const Number number : chapter.exercises)
            for (const auto& line : lines_of(chapter.header_of(number).reference.body(number)->text)) {
                std::string code = squeezed(line);
                if (!code.empty() && code.back() == ';') code.pop_back();
                const std::string value = starts_with(code, "return") ? code.substr(6) : code;
                if (value.size() < 8) continue;  // "return state" is no secret
                for (const auto& hint : exercise_of(number).hints) {
                    INFO(number.text() << ": " << line << "\n" << hint);
                    CHECK_FALSE(contains(squeezed(hint), value));
                }
            }
}

TEST_CASE("In the judge: solutions and alternatives pass, every mistake is called by its name") {
    for (const Exercise& exercise : all_exercises()) {
        const Record reference = record_of(exercise.reference);
        INFO(exercise.id);
        CHECK(diagnose(exercise, reference, values_of(reference)).right);
        for (const auto& alternative : exercise.alternatives) {
            INFO(alternative.name);
            const auto diagnosis = diagnose(exercise, reference, values_of(record_of(alternative.attempt)));
            INFO(diagnosis.name << " " << diagnosis.output << " " << diagnosis.yours << " "
                                << diagnosis.expected);
            CHECK(diagnosis.right);
        }
        for (const auto& mistake : exercise.mistakes) {
            const auto diagnosis = diagnose(exercise, reference, values_of(record_of(mistake.attempt)));
            CHECK_FALSE(diagnosis.right);
            CHECK(diagnosis.name == mistake.name);
            CHECK(diagnosis.words.front() == mistake.sentence);
        }
    }
}

TEST_CASE("Mistakes differ from the truth and from each other by at least 1e-4 of the scale") {
    for (const Exercise& exercise : all_exercises()) {
        const Record reference = record_of(exercise.reference);
        std::vector<std::pair<std::string, Record>> all{{"the truth", reference}};
        for (const auto& mistake : exercise.mistakes)
            all.emplace_back(mistake.name, record_of(mistake.attempt));
        for (std::size_t i = 0; i < all.size(); ++i)
            for (std::size_t k = 0; k < i; ++k) {
                INFO(exercise.id << ": " << all[i].first << " and " << all[k].first);
                CHECK(difference(reference, all[i].second, all[k].second) >= telling);
            }
    }
}

TEST_CASE("Every single number counts: moved by 2e-9 of its scale it fails, by 5e-10 it passes") {
    for (const Exercise& exercise : all_exercises()) {
        const Record reference = record_of(exercise.reference);
        for (std::size_t i = 0; i < reference.outputs.size(); ++i) {
            const auto& output = reference.outputs[i];
            INFO(exercise.id << ": " << output.name << ", input " << reference.inputs[output.input].words);
            double largest = 0;
            for (const double value : output.values) largest = std::max(largest, std::abs(value));
            CHECK(std::isfinite(output.scale));
            CHECK(output.scale > 0);
            CHECK((largest == 0 ||
                   output.scale <= 1e3 * largest));  // terms that cancel to almost nothing would hide slips
            CHECK(largest <= 1e3 * output.scale);  // and scales that are too small would reject right answers
            for (std::size_t c = 0; c < output.values.size(); ++c) {
                auto values = values_of(reference);
                values[i][c] += 2e-9 * output.scale;
                CHECK_FALSE(diagnose(exercise, reference, values).right);
                values[i][c] = output.values[c] + 5e-10 * output.scale;
                CHECK(diagnose(exercise, reference, values).right);
            }
        }
    }
}

TEST_CASE("As sheets: every skeleton is not answered yet, every solution passes") {
    const Learner learner("all skeletons");
    for (const Chapter& chapter : chapters_of(learner.rooms)) {
        const Sheets sheets(learner.rooms, chapter);
        const Sheet sheet = sheets.compile(chapter.exercises);
        INFO(chapter.folder);
        REQUIRE_FALSE(sheet.problem);
        for (const Number number : chapter.exercises) {
            const SheetAnswer answer = sheets.ask(sheet, number);
            INFO(number.text());
            CHECK(answer.unanswered.has_value());  // itself, or one that its questions need
            CHECK(answer.outputs.size() < record_of(exercise_of(number).reference).outputs.size());
        }
        for (const Number number : chapter.exercises) learner.solve(number);
        for (const Verdict& verdict : learner.check_chapter(chapter.number)) {
            INFO(verdict.number.text() << " " << verdict.name << "\n" << verdict.words);
            CHECK(verdict.outcome == Outcome::passed);
            CHECK(verdict.notes.empty());
        }
    }
}

TEST_CASE("No half-right answer passes: every mutant of every reference fails, or is argued to be equal") {
    const Learner learner("mutants");
    std::size_t made = 0, failed = 0, equal = 0;
    for (const Chapter& chapter : chapters_of(learner.rooms))
        for (const Gate& gate : gates_of(learner.rooms, chapter)) {
            INFO(gate.number.text());
            CHECK(gate.made >= 5);
            CHECK(gate.made == gate.failed + gate.equal);
            CHECK(joined(gate.passed, "; ") == "");  // these pass, and should not
            CHECK(joined(gate.stale, "; ") == "");   // these are argued, and do not pass
            made += gate.made, failed += gate.failed, equal += gate.equal;
        }
    CHECK(made >= 500);
    CHECK(failed + equal == made);
    for (const Exercise& exercise : all_exercises())
        for (const auto& survivor : exercise.survivors) CHECK(survivor.reason.size() > 10);
}
