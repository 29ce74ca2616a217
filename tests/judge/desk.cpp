#include "desk.hpp"
#include <algorithm>
#include <cctype>
#include <sstream>
#include <stdexcept>
#include "machine.hpp"
#include "sheets.hpp"
#include "text.hpp"

namespace nutshell::judge {

namespace fs = std::filesystem;

Progress Progress::read(const Rooms& rooms) {
    Progress progress;
    const fs::path file = rooms.answers / ".progress";
    if (!fs::exists(file)) return progress;
    for (const auto& line : lines_of(read_text(file))) {
        std::istringstream words(line);
        std::string id, passed, hints;
        Entry entry;
        std::string gave_up;
        if (words >> id >> passed >> entry.passed >> hints >> entry.hints &&
            (words >> gave_up >> entry.gave_up, true))
            if (const auto number = number_of(id)) progress.entries[*number] = entry;
    }
    return progress;
}

void Progress::write(const Rooms& rooms) const {
    std::ostringstream text;
    for (const auto& [number, entry] : entries)
        text << number.text() << " passed " << entry.passed << " hints " << entry.hints << " gave_up "
             << entry.gave_up << '\n';
    write_text(rooms.answers / ".progress", text.str());
}

fs::path own_path(const Rooms& rooms, const Chapter& chapter, const Chapter::Header& header) {
    return rooms.answers / chapter.folder / header.path;
}

std::optional<std::string> own_text(const Rooms& rooms, const Chapter& chapter,
                                    const Chapter::Header& header) {
    const fs::path file = own_path(rooms, chapter, header);
    std::error_code problem;
    const fs::file_status status = fs::status(file, problem);
    if (!fs::exists(status)) return std::nullopt;
    if (!fs::is_regular_file(status))
        throw MachineFault(named(rooms, file) + " is no file that can be read, but a " +
                           (fs::is_directory(status) ? "folder"
                            : fs::is_fifo(status)    ? "FIFO"
                                                     : "device or socket") +
                           ": move it away; ./course start makes the file anew");
    std::string text = read_text(file);
    if (contains(text, std::string_view("\0", 1)))
        throw MachineFault(named(rooms, file) +
                           " is no text: there are zero bytes in it. Was it saved as UTF-16, or is "
                           "it a program?");
    return text;
}

std::string leads_out(const Rooms& rooms, const fs::path& file) {
    std::error_code problem;
    const fs::path real = fs::canonical(file, problem), room = fs::canonical(rooms.answers, problem);
    return problem || starts_with(real.string(), (room / "").string()) ? "" : real.string();
}

std::string named(const Rooms& rooms, const fs::path& file) {
    const std::string parent = rooms.answers.parent_path().string() + "/";
    return starts_with(file.string(), parent) ? file.string().substr(parent.size()) : file.string();
}

Chapter chapter_of(const Rooms& rooms, Number number) {
    std::string there;
    for (const Chapter& chapter : chapters_of(rooms)) {
        for (const Number other : chapter.exercises)
            if (other == number) return chapter;
        there += (there.empty() ? "" : ", ") + chapter.exercises.front().text() + " to " +
                 chapter.exercises.back().text();
    }
    throw std::runtime_error("there is no exercise " + number.text() + "; there are: " + there);
}

std::string title_of(const Chapter& chapter) {
    std::string name = chapter.folder.substr(chapter.folder.find('_') + 1);
    bool begins = true;  // a word
    for (char& c : name) {
        if (begins) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        begins = c == '_';
        if (begins) c = ' ';
    }
    return "Chapter " + std::to_string(chapter.number) + " · " + name;
}

std::string celebration(const Chapter& chapter, const Progress& progress) {
    std::string picture;
    for (const Number number : chapter.exercises) {
        const auto found = progress.entries.find(number);
        if (found == progress.entries.end() || !found->second.passed) return "";
        if (const auto& own = exercise_of(number).picture; !own.empty()) picture = own;
    }
    return title_of(chapter) +
           " is yours, from first line to last. See it run on your own answers: ./course run " +
           std::to_string(chapter.number) + " --mine" +
           (picture.empty() ? "" : ", then open out/mine/" + chapter.folder + "/" + picture);
}

std::string progress(const Rooms& rooms) {
    const Progress known = Progress::read(rooms);
    std::ostringstream said;
    for (const Chapter& chapter : chapters_of(rooms)) {
        std::string row, aside;
        std::size_t passed = 0;
        for (const Number number : chapter.exercises) {
            const auto found = known.entries.find(number);
            const Progress::Entry entry = found == known.entries.end() ? Progress::Entry{} : found->second;
            passed += entry.passed;
            row += entry.passed ? "■" : "□";
            if (entry.gave_up) aside += (aside.empty() ? "  solution seen: " : ", ") + number.text();
        }
        said << title_of(chapter) << "\n  " << row << "  " << passed << " of " << chapter.exercises.size()
             << aside << '\n';
        if (const std::string done = celebration(chapter, known); !done.empty()) said << folded(done, 2);
    }
    return said.str();
}

std::string start(const Rooms& rooms) {
    std::ostringstream said;
    std::size_t made = 0, kept = 0, exercises = 0;
    const auto chapters = chapters_of(rooms);
    for (const Chapter& chapter : chapters) {
        exercises += chapter.exercises.size();
        for (const auto& header : chapter.headers) {
            const fs::path file = own_path(rooms, chapter, header);
            if (fs::exists(file)) {
                ++kept;
            } else {
                write_text(file, skeleton(header.reference.text()));
                said << "made " << named(rooms, file) << '\n';
                ++made;
            }
        }
    }
    for (const Chapter& chapter : chapters)  // for editors: clangd reads it
        write_if_changed(rooms.answers / chapter.folder / "compile_flags.txt",
                         joined(editor_flags(rooms, chapter), "\n") + "\n");
    if (kept)
        said << (kept == 1 ? "one file is" : std::to_string(kept) + " files are")
             << " yours already and left as " << (kept == 1 ? "it is" : "they are") << '\n';
    if (made == 0) {
        said << "Nothing to do. Where you are: ./course check\n";
        return said.str();
    }
    const auto begins = std::find_if(chapters.begin(), chapters.end(),
                                     [](const Chapter& chapter) { return chapter.number > 0; });
    const Chapter& first = begins == chapters.end() ? chapters.front() : *begins;  // 0 is the toolbox
    const Number one = first.exercises.front();
    said << '\n'
         << exercises << " exercises wait for you. For the first one, open\n"
         << "  " << named(rooms, own_path(rooms, first, first.header_of(one))) << '\n'
         << "and look for `// exercise " << one.text() << "`. Put your answer in place of the line "
         << unanswered(one) << '\n'
         << "and leave the two marks round it as they are. Then\n"
         << "  ./course check " << one.text() << "      is it right?\n"
         << "  ./course hint " << one.text() << "       three of them, one at a time\n"
         << "  ./course watch 1         checks again whenever you save\n";
    return said.str();
}

std::string hint(const Rooms& rooms, Number number) {
    chapter_of(rooms, number);
    const auto& exercise = exercise_of(number);
    Progress progress = Progress::read(rooms);
    auto& entry = progress.entries[number];
    std::ostringstream said;
    const auto say = [&](int which) {
        said << "Hint " << which + 1 << " of 3 for " << number.text() << ", " << exercise.title << ":\n"
             << folded(exercise.hints[static_cast<std::size_t>(which)], 2);
    };
    if (entry.hints >= 3) {
        for (int which = 0; which < 3; ++which) say(which);
        said << "There are no more. The solution: ./course solution " << number.text()
             << (entry.passed ? "\n" : " --give-up\n");
        return said.str();
    }
    say(entry.hints++);
    if (entry.hints < 3) said << "The next one: ./course hint " << number.text() << '\n';
    progress.write(rooms);
    return said.str();
}

std::string solution(const Rooms& rooms, Number number, bool give_up) {
    const Chapter chapter = chapter_of(rooms, number);
    Progress progress = Progress::read(rooms);
    auto& entry = progress.entries[number];
    if (give_up && !entry.passed && !entry.gave_up && fs::exists(rooms.answers)) {
        entry.gave_up = true;
        progress.write(rooms);
    }
    if (!give_up && !entry.passed && !entry.gave_up)
        throw std::runtime_error("exercise " + number.text() + " has not passed yet: ./course check " +
                                 number.text() + ", or ./course hint " + number.text() +
                                 "; to see the solution all the same: ./course solution " + number.text() +
                                 " --give-up");
    const Chapter::Header& header = chapter.header_of(number);
    std::ostringstream said;
    said << number.text() << ", " << exercise_of(number).title << ": one right answer, chapters/"
         << chapter.folder << '/' << header.path << '\n'
         << '\n'
         << signature(header.reference, number) << " {\n";
    for (const auto& line : lines_of(unindented(header.reference.body(number)->text)))
        said << "    " << line << '\n';
    said << "}\n";
    return said.str();
}

namespace {

/// A name in answers/saved/ that is not taken.
fs::path free_name(const Rooms& rooms, const std::string& stem) {
    for (int i = 1;; ++i)
        if (const fs::path file = rooms.answers / "saved" / (stem + "_" + std::to_string(i) + ".hpp");
            !fs::exists(file))
            return file;
}

}  // namespace

std::string reset(const Rooms& rooms, Number number) {
    const Chapter chapter = chapter_of(rooms, number);
    const Chapter::Header& header = chapter.header_of(number);
    const fs::path file = own_path(rooms, chapter, header);
    const auto text = own_text(rooms, chapter, header);
    if (!text) throw std::runtime_error(named(rooms, file) + " is missing: ./course start makes it");
    const Marked own = marked(*text);
    const std::string fresh = skeleton(header.reference.text());
    const Marked fresh_marks = marked(fresh);
    std::ostringstream said;
    if (const Body* body = own.body(number)) {
        if (is_unanswered(*body))
            return number.text() + " is as ./course start made it: nothing to put back.\n";
        const fs::path saved = free_name(rooms, number.text());
        write_text(saved, "// exercise " + number.text() + " of " + named(rooms, file) + "\n" + body->text);
        write_text(file, with_bodies(own, {{number, fresh_marks.body(number)->text}}));
        said << number.text() << " is as it was at the start. Your old answer is in " << named(rooms, saved)
             << '\n';
        return said.str();
    }
    // without its marks the body cannot be told from the rest: a fresh file, with all other answers carried
    // over
    const fs::path saved = free_name(rooms, fs::path(header.path).stem().string());
    write_text(saved, *text);
    std::map<Number, std::string> bodies;
    for (const Body& body : own.bodies) bodies[body.number] = body.text;
    write_text(file, with_bodies(fresh_marks, bodies));
    said << folded("The marks of " + number.text() + " were not to be found, so " + named(rooms, file) +
                       " is made anew, with your answers to the " + std::to_string(bodies.size()) +
                       " other exercises whose marks were whole. Your old file is kept as " +
                       named(rooms, saved),
                   0);
    return said.str();
}

}  // namespace nutshell::judge
