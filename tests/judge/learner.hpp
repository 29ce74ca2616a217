// A learner for the judge's tests: a folder of answers of its own, and what they write into it.
#pragma once
#include <unistd.h>
#include <stdexcept>
#include <string>
#include "../check.hpp"
#include "check.hpp"
#include "judge_config.hpp"
#include "text.hpp"

namespace nutshell::judge {

struct Learner {
    Rooms rooms;
    std::filesystem::path folder;

    explicit Learner(const std::string& name)
        : folder(std::filesystem::temp_directory_path() / ("judge of " + name + std::to_string(getpid()))) {
        std::filesystem::remove_all(folder);
        rooms = {CONFIG_COURSE, folder / "answers", folder / "work", CONFIG_SHARED};
        start(rooms);
    }
    ~Learner() {
        std::error_code ignored;
        std::filesystem::remove_all(folder, ignored);
    }
    Learner(const Learner&) = delete;
    Learner& operator=(const Learner&) = delete;

    std::filesystem::path file(Number number) const {
        const Chapter chapter = chapter_of(rooms, number);
        return own_path(rooms, chapter, chapter.header_of(number));
    }
    std::string text(Number number) const { return read_text(file(number)); }
    void write(Number number, const std::string& text) const { write_text(file(number), text); }
    void answer(Number number, const std::string& body) const {
        write(number, with_bodies(marked(text(number)), {{number, body + "\n"}}));
    }
    /// Puts the reference's body in.
    void solve(Number number) const {
        answer(number, chapter_of(rooms, number).header_of(number).reference.body(number)->text);
    }
    void replace(Number number, const std::string& what, const std::string& with) const {
        const std::string before = text(number), after = replaced(before, what, with);
        if (before == after) throw std::logic_error("there is no '" + what + "' in " + file(number).string());
        write(number, after);
    }
    std::vector<Verdict> check_chapter(int chapter) const {
        for (const Chapter& each : chapters_of(rooms))
            if (each.number == chapter) return check(rooms, each, each.exercises);
        throw std::logic_error("no such chapter");
    }
    Verdict check_one(Number number) const {
        return check(rooms, chapter_of(rooms, number), {number}).front();
    }

    /// The program itself, as ./course calls it, on this learner's folder.
    Ran judge(std::vector<std::string> words) const {
        words.insert(words.begin(), std::string(CONFIG_BIN) + "/judge");
        words.insert(words.end(), {"--answers", rooms.answers.string(), "--work", rooms.work.string()});
        return run(words, {.wall_seconds = 1800, .printed = 1 << 20});
    }
};

/// The verdict on exercise 1.1 with this body.
inline Verdict on_first(const Learner& learner, const std::string& body) {
    learner.answer({1, 1}, body);
    return learner.check_one({1, 1});
}

/// Words as they were before they were folded into lines.
inline std::string flat(const std::string& words) {
    std::string text = replaced(words, "\n", " ");
    while (contains(text, "  ")) text = replaced(text, "  ", " ");
    return text;
}

/// What a learner must never see.
inline void is_plain(const Verdict& verdict) {
    for (const auto* word : {"template", "instantiation", "required from", "lambda",
                             "Eigen::", "nutshell::", "build/", "sheet", "In file included"})
        CHECK_FALSE(contains(verdict.words, word));
}

}  // namespace nutshell::judge
