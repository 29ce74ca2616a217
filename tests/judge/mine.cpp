// ./course run N --mine: the chapter's program, compiled on the learner's answers. What is not answered falls
// back to the reference.
#include <algorithm>
#include <iostream>
#include <map>
#include <stdexcept>
#include "check.hpp"
#include "judge_config.hpp"
#include "text.hpp"
#include "touched.hpp"

namespace nutshell::judge {

namespace fs = std::filesystem;

namespace {

/// "1.1, 1.3 to 1.5"
std::string ranges(std::vector<Number> numbers) {
    std::sort(numbers.begin(), numbers.end());
    std::string text;
    for (std::size_t i = 0; i < numbers.size();) {
        std::size_t k = i;
        while (k + 1 < numbers.size() && numbers[k + 1].exercise == numbers[k].exercise + 1) ++k;
        text += (i ? ", " : "") + numbers[i].text() +
                (k > i ? (k > i + 1 ? " to " : ", ") + numbers[k].text() : "");
        i = k + 1;
    }
    return text;
}

struct Stock {
    std::vector<Number> own, reference;
};

/// The learner's header with the reference's bodies where there is no answer.
std::string engine(const fs::path& own_file, const std::string& own_text, const Marked& reference,
                   const std::vector<Number>& cannot_run, Stock& stock) {
    const Marked own = marked(own_text);
    std::map<Number, std::string> bodies;
    for (const Body& body : reference.bodies) {
        const Body* answer = own.body(body.number);
        const bool broken = std::find(cannot_run.begin(), cannot_run.end(), body.number) != cannot_run.end(),
                   missing = answer && is_unanswered(*answer);
        if (!broken) (missing ? stock.reference : stock.own).push_back(body.number);
        if (broken || missing)
            bodies[body.number] = touch_line(body.number) + body.text;
        else if (answer)
            bodies[body.number] = touch_line(body.number) + "#line " + std::to_string(answer->begin + 2) +
                                  " \"" + own_file.string() + "\"\n" + answer->text;
    }
    return "#include <nutshell/lab/touched.hpp>\n" + with_stand_ins(own, bodies, own_file.string());
}

}  // namespace

std::vector<Number> stock_mine(const Rooms& rooms, const Chapter& chapter, Broken broken) {
    const fs::path answers = rooms.answers / chapter.folder;
    if (!fs::exists(answers))
        throw std::runtime_error("there is no " + named(rooms, answers) + " yet: ./course start makes it");

    // what would not come to an end is found here, where it does no harm
    std::string wrong;
    std::vector<Number> cannot_run;
    for (const Verdict& verdict : check(rooms, chapter, chapter.exercises)) {
        if (verdict.outcome == Outcome::not_compiled || verdict.outcome == Outcome::failed) {
            if (broken == Broken::stops)
                throw std::runtime_error("your answer to " + verdict.number.text() +
                                         " cannot be run: " + verdict.name + "\n" + verdict.words);
            std::cout << folded("Your answer to " + verdict.number.text() + " cannot be run (" +
                                    verdict.name + "; ./course check " + verdict.number.text() +
                                    " says more): the reference stands in for it.",
                                0);
            cannot_run.push_back(verdict.number);
        }
        if (verdict.outcome == Outcome::wrong)
            wrong += (wrong.empty() ? "" : ", ") + verdict.number.text() + " (" + verdict.name + ")";
    }

    std::vector<Number> all_own;
    for (const Chapter& each : chapters_of(rooms)) {
        if (each.number > chapter.number) continue;
        Stock stock;
        for (const auto& header : each.headers) {
            const auto own = own_text(rooms, each, header);
            const std::string text =
                own ? engine(own_path(rooms, each, header), *own, header.reference, cannot_run, stock)
                    : header.reference.text();
            write_if_changed(fs::path(CONFIG_MINE) / each.folder / header.path, text);
            if (!own)
                for (const Body& body : header.reference.bodies) stock.reference.push_back(body.number);
        }
        // headers that the learner added are found beside them
        const fs::path added = rooms.answers / each.folder / "nutshell";
        if (fs::is_directory(added))
            for (const auto& entry : fs::directory_iterator(added))
                if (const fs::path name = fs::path("nutshell") / entry.path().filename();
                    entry.is_regular_file() &&
                    std::none_of(each.headers.begin(), each.headers.end(),
                                 [&](const auto& header) { return header.path == name; }))
                    write_if_changed(fs::path(CONFIG_MINE) / each.folder / name, read_text(entry.path()));
        all_own.insert(all_own.end(), stock.own.begin(), stock.own.end());
        if (!stock.own.empty()) std::cout << "Yours: " << ranges(stock.own) << ". ";
        if (!stock.reference.empty())
            std::cout << (stock.own.empty() ? "None is yours: the" : "The") << " reference stands in for "
                      << ranges(stock.reference) << ", not answered yet. ";
        std::cout << '\n';
    }
    if (!wrong.empty()) std::cout << "Not right yet, so look at what it does: " << wrong << '\n';
    std::cout << "Compiling chapter " << chapter.number << " on it ...\n" << std::flush;
    return all_own;
}

void build_mine(const Rooms& rooms, const Chapter& chapter, const std::string& target) {
    const Ran built = run({CONFIG_CMAKE, "--build", CONFIG_BUILD, "--target", target},
                          {.wall_seconds = 1800, .printed = 1 << 20});
    if (built.exit_code == 0) return;
    const CompileProblem problem = Sheets(rooms, chapter).explain(built.out + built.err, chapter.exercises);
    throw std::runtime_error(
        "chapter " + std::to_string(chapter.number) +
        " does not compile on your answers: " + (problem.where.empty() ? "" : problem.where + ": ") +
        problem.message + "\n  The compiler says: " + problem.compiler);
}

Chapter chapter_of(const Rooms& rooms, const std::string& verb, const std::string& which) {
    const auto chosen = meant(rooms, which);
    if (which.empty() || number_of(which))
        throw std::invalid_argument(verb + " --mine needs a chapter, such as ./course " + verb + " 1 --mine");
    return chosen.front();
}

int verb_mine(const Rooms& rooms, const std::string& which, const fs::path& wanted_out) {
    const Chapter chapter = chapter_of(rooms, "run", which);
    const fs::path out = wanted_out.empty() ? rooms.course / "out/mine" / chapter.folder : wanted_out;
    const Lock lock(CONFIG_MINE);
    const std::vector<Number> own = stock_mine(rooms, chapter, Broken::has_a_stand_in);
    const std::string target = "mine_" + chapter.folder;
    Anew anew = anew_for(rooms, chapter, out);
    if (!anew.all && anew.parts.empty()) {
        std::cout
            << "No part of the chapter runs what has changed since the last time: nothing to draw anew.\n";
        write_text(touched_file(chapter), "");
        remember(rooms, chapter, out, anew);
        return 0;
    }
    if (anew.all || !build_sources(target, anew.sources)) anew = {}, build_mine(rooms, chapter, target);
    if (!anew.all)
        std::cout << folded(
            "Only what runs the changed answer is made anew: " + joined(anew.parts, ", ") + ".", 0);

    // the reference's curves, as ghosts; they are drawn again only if its program is newer
    const fs::path reference = fs::path(CONFIG_BIN) / chapter.folder,
                   points = fs::path(CONFIG_MINE) / "points" / chapter.folder;
    std::error_code problem;
    if (fs::exists(reference) &&
        (!fs::exists(points / "made") ||
         fs::last_write_time(points / "made", problem) < fs::last_write_time(reference, problem))) {
        const Ran ran =
            run({reference.string(), "--out", (points / "out").string(), "--points", points.string()},
                {.wall_seconds = 600, .printed = 1 << 20});
        if (ran.exit_code == 0) write_text(points / "made", "");
        fs::remove_all(points / "out", problem);
    }
    std::vector<std::string> words{(fs::path(CONFIG_BIN) / target).string(), "--out", out.string()};
    if (!own.empty())
        words.insert(words.end(), {"--beside", points.string(), "--yours", "your " + ranges(own)});
    write_text(touched_file(chapter), "");
    words.insert(words.end(), {"--touched", touched_file(chapter).string()});
    if (!anew.all) words.insert(words.end(), {"--only", joined(anew.parts, ",")});
    const Ran ran = run(words, {.wall_seconds = 600, .printed = 1 << 20});
    std::cout << ran.out << std::flush;
    std::cerr << ran.err;
    if (ran.exit_code == 0 && !ran.signal && !ran.out_of_time)
        remember(rooms, chapter, out, anew);
    else
        forget(chapter);
    if (ran.out_of_time || ran.signal)
        throw std::runtime_error(ran.out_of_time ? "it did not come to an end within ten minutes: stopped"
                                                 : "it crashed on your answers (signal " +
                                                       std::to_string(ran.signal) + ")");
    return ran.exit_code;
}

}  // namespace nutshell::judge
