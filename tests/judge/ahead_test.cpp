// What is compiled ahead of the sheets: that it fits, that it is used, and that a verdict is the same with it
// and without.
#include <algorithm>
#include "../check.hpp"
#include "compiled_ahead.hpp"
#include "learner.hpp"
#include "own_headers.hpp"

using namespace nutshell::judge;
namespace fs = std::filesystem;

namespace {

/// A learner's headers of the chapter of an exercise, against what is compiled ahead.
bool fits(const Learner& learner, Number number) {
    const Chapter chapter = chapter_of(learner.rooms, number);
    return OwnHeaders(learner.rooms, chapter).overlay({}, false).ahead.has_value();
}

}  // namespace

TEST_CASE("Ahead: a sheet has declarations for all that the course gave, line for line") {
    const Learner learner("ahead");
    const Number spin_of{6, 4};
    const Chapter chapter = chapter_of(learner.rooms, spin_of);
    const auto ahead = OwnHeaders(learner.rooms, chapter).overlay({}, false).ahead;
    REQUIRE(ahead);
    CHECK(ahead->templates.empty());
    for (std::size_t i = 0; i < chapter.headers.size(); ++i)
        CHECK(ahead->skeletons[i].lines.size() ==
              marked(skeleton(chapter.headers[i].reference.text())).lines.size());
    const auto header = &chapter.header_of(spin_of) - chapter.headers.data();
    const std::string text = ahead->skeletons[static_cast<std::size_t>(header)].text();
    CHECK_THAT(text, ContainsSubstring("\nMatrix3 parallel_axis(double mass, const Vector3& offset);\n"));
    CHECK_FALSE(contains(text, "return point_inertia(mass, offset);"));
    CHECK_THAT(text, ContainsSubstring("\nMatrix3 point_inertia(double mass, const Vector3& r) {\n"));

    // and nothing of the course's is compiled with the answer but these
    learner.solve(spin_of);
    const Sheets sheets(learner.rooms, chapter, OwnHeaders(learner.rooms, chapter).overlay({}, false));
    const Sheet sheet = sheets.compile({spin_of});
    CHECK_FALSE(sheet.problem);
    for (const fs::path& source : sheet.sources)
        CHECK_FALSE(starts_with(source.string(), CONFIG_COURSE + std::string("/chapters/")));
    CHECK(learner.check_one(spin_of).name == "passed");
}

TEST_CASE("Ahead: what the course gave calls the learner's exercises") {
    const Learner learner("ahead, calls");
    const Number point_inertia{6, 2}, inertia_about{6, 5};  // by way of parallel_axis
    learner.solve(inertia_about);
    CHECK(learner.check_one(inertia_about).name == "blocked by 6.2");
    learner.answer(point_inertia,
                   "return mass * (r.squaredNorm() * Matrix3::Identity() + r * r.transpose());");
    CHECK(learner.check_one(inertia_about).outcome == Outcome::wrong);
    learner.solve(point_inertia);
    CHECK(learner.check_one(inertia_about).name == "passed");
}

TEST_CASE("Ahead: a line changed outside the exercises is what is judged, a comment changes nothing") {
    const Learner learner("ahead, changes");
    const Number point_inertia{6, 2}, inertia_about{6, 5};
    learner.solve(point_inertia), learner.solve(inertia_about);
    learner.replace(inertia_about, "inline Matrix3 parallel_axis",
                    "// Steiner,\n\n/* 1840 */ inline Matrix3  parallel_axis");
    CHECK(fits(learner, inertia_about));
    CHECK(learner.check_one(inertia_about).name == "passed");
    learner.answer(inertia_about, "return body.inertia + parallel_axis(body.mass, point - body.center);");
    const Verdict verdict = learner.check_one(inertia_about);
    const Marked own = marked(learner.text(inertia_about));
    CHECK_THAT(verdict.words,
               ContainsSubstring("inertia.hpp:" + std::to_string(own.body(inertia_about)->begin + 2)));
    learner.solve(inertia_about);

    learner.replace(inertia_about, "return point_inertia(mass, offset);",
                    "return 2 * point_inertia(mass, offset);");
    CHECK_FALSE(fits(learner, inertia_about));
    CHECK(learner.check_one(inertia_about).outcome == Outcome::wrong);
    learner.replace(inertia_about, "return 2 * point_inertia", "return point_inertia");
    CHECK(fits(learner, inertia_about));

    // a header beside them may go before the course's
    const fs::path beside = learner.file(inertia_about).parent_path() / "moments.hpp";
    write_text(beside, "#error read\n");
    CHECK_FALSE(fits(learner, inertia_about));
    CHECK(learner.check_one(inertia_about).outcome == Outcome::not_compiled);
    fs::remove(beside);
    CHECK(learner.check_one(inertia_about).name == "passed");
}

TEST_CASE("Ahead: exercises that are templates are asked within the sheet, beside the others") {
    const Learner learner("ahead, templates");
    const Number visit_pairs{7, 12}, softness{7, 11};
    const Chapter chapter = chapter_of(learner.rooms, visit_pairs);
    const auto ahead = OwnHeaders(learner.rooms, chapter).overlay({}, false).ahead;
    REQUIRE(ahead);
    CHECK_FALSE(ahead->can_be_asked_from_outside({visit_pairs, softness}));
    CHECK(ahead->can_be_asked_from_outside({softness}));
    learner.solve(visit_pairs), learner.solve(softness);
    for (const Verdict& verdict : check(learner.rooms, chapter, {softness, visit_pairs}))
        CHECK(verdict.name == "passed");
}
