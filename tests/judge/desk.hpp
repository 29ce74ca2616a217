// The learner's folder answers/: made by start, read by check, and nothing in it is ever lost.
#pragma once
#include <map>
#include <optional>
#include <string>
#include "rooms.hpp"

namespace nutshell::judge {

/// What is remembered of each exercise, in answers/.progress: one line each, "1.3 passed 1 hints 2".
struct Progress {
    struct Entry {
        bool passed = false;  ///< at some time
        int hints = 0;        ///< shown so far
    };
    std::map<Number, Entry> entries;

    static Progress read(const Rooms& rooms);
    void write(const Rooms& rooms) const;
};

/// A chapter's header as the learner has it; nothing if it is missing.
std::optional<std::string> own_text(const Rooms& rooms, const Chapter& chapter,
                                    const Chapter::Header& header);
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

/// The chapter that holds this exercise. @throws std::runtime_error that lists those there are
Chapter chapter_of(const Rooms& rooms, Number number);

}  // namespace nutshell::judge
