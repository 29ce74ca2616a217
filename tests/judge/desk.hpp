// The learner's folder answers/: made by start, read by check, and nothing in it is ever lost.
#pragma once
#include <map>
#include <optional>
#include <string>
#include "rooms.hpp"

namespace nutshell::judge {

/// What is remembered of each exercise, in answers/.progress: one line each,
/// "1.3 passed 1 hints 2 gave_up 0".
struct Progress {
    struct Entry {
        bool passed = false;   ///< at some time
        int hints = 0;         ///< shown so far
        bool gave_up = false;  ///< the solution was shown before it passed
    };
    std::map<Number, Entry> entries;

    static Progress read(const Rooms& rooms);
    void write(const Rooms& rooms) const;
};

/// A chapter's header as the learner has it; nothing if it is missing. @throws MachineFault if it is no file
/// or no text
std::optional<std::string> own_text(const Rooms& rooms, const Chapter& chapter,
                                    const Chapter::Header& header);
/// Where a file leads if it is, by links, not inside answers/; empty if it is.
std::string leads_out(const Rooms& rooms, const std::filesystem::path& file);
std::filesystem::path own_path(const Rooms& rooms, const Chapter& chapter, const Chapter::Header& header);
/// "answers/01_newton/nutshell/newton.hpp", as a learner would say it.
std::string named(const Rooms& rooms, const std::filesystem::path& file);

/// Makes what is missing of answers/ and says so, and what to do first. Overwrites nothing.
std::string start(const Rooms& rooms);
/// The next of three hints.
std::string hint(const Rooms& rooms, Number number);
/// The reference's lines. @throws std::runtime_error, with what to do, if it has not passed yet and `give_up`
/// is false
std::string solution(const Rooms& rooms, Number number, bool give_up);
/// Puts the skeleton's body back, after saving the old one in answers/saved/.
std::string reset(const Rooms& rooms, Number number);

/// How far the learner is, chapter by chapter.
std::string progress(const Rooms& rooms);
/// "Chapter 1 · Newton"
std::string title_of(const Chapter& chapter);
/// Said once all of a chapter's exercises have passed, with the picture that shows it; else empty.
std::string celebration(const Chapter& chapter, const Progress& progress);

/// The chapter that holds this exercise. @throws std::runtime_error that lists those there are
Chapter chapter_of(const Rooms& rooms, Number number);

}  // namespace nutshell::judge
