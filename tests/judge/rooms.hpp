// Where things are: the course's chapters with their exercises, the learner's answers, and the judge's own
// folder.
#pragma once
#include <filesystem>
#include <string>
#include <vector>
#include "marks.hpp"
#include "record.hpp"

namespace nutshell::judge {

struct Rooms {
    std::filesystem::path course;   ///< the repository
    std::filesystem::path answers;  ///< the learner's work
    std::filesystem::path work;     ///< compiled sheets and what they were made from
    std::filesystem::path shared;   ///< the precompiled header, the same for every folder of answers
};

/// A chapter that has exercises: read from its headers' marks.
struct Chapter {
    int number;
    std::string folder;  ///< "01_newton"
    struct Header {
        std::string path;  ///< "nutshell/newton.hpp"
        Marked reference;
    };
    std::vector<Header> headers;    ///< those with marks
    std::vector<Number> exercises;  ///< in order

    const Header& header_of(Number exercise) const;
};
std::vector<Chapter> chapters_of(const Rooms& rooms);
/// The folders of all chapters up to this one, in order.
std::vector<std::filesystem::path> chapter_folders(const Rooms& rooms, int last);

/// The file that asks an exercise, chapters/NN_name/exercises/N.M_*.hpp. @throws std::runtime_error if there
/// is none
std::filesystem::path questions_file(const Rooms& rooms, const Chapter& chapter, Number number);

/// All exercises compiled into this program, in order.
const std::vector<exercises::Exercise>& all_exercises();
/// @throws std::runtime_error if that exercise has marks but no file
const exercises::Exercise& exercise_of(Number number);
/// What an attempt gives for the questions. @param beyond  with those that go beyond what it must do
exercises::Record record_of(const exercises::Attempt& attempt, bool beyond = true);

}  // namespace nutshell::judge
