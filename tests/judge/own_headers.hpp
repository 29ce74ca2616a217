// A learner's headers of one chapter as they stand: what their text alone tells, and what is compiled of
// them.
#pragma once
#include <optional>
#include <string>
#include <vector>
#include "desk.hpp"
#include "sheets.hpp"

namespace nutshell::judge {

struct OwnHeaders {
    struct File {
        std::filesystem::path path;
        std::optional<std::string> text;
        Marked source;
    };

    OwnHeaders(const Rooms& rooms, const Chapter& chapter);

    const File& file_of(Number number) const;
    const Body* body_of(Number number) const { return file_of(number).source.body(number); }

    /// The exercises of this chapter that the learner's body of `number` calls.
    std::vector<Number> called_by(Number number) const;

    /// The first line of code outside the exercises that the learner's file has no longer; empty if all are
    /// there.
    std::string changed_line(Number number) const;

    /// What goes before the learner's headers: theirs without what is broken, and if they fit what is
    /// compiled ahead, as declarations; for a grader the course's own with the learner's bodies in them, and
    /// nothing else of theirs.
    Overlay overlay(const std::vector<Number>& broken, bool for_a_grader) const;

    /// Whether one of these files is the course's own header although the learner has one: by include_next or
    /// the like.
    bool reference_among(const std::vector<std::filesystem::path>& sources, Number number) const;

    const Rooms& rooms;
    const Chapter& chapter;
    std::vector<File> files;  ///< in the order of the chapter's headers
};

bool among(const std::vector<Number>& numbers, Number number);

}  // namespace nutshell::judge
