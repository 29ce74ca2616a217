// What check and watch print.
#include <poll.h>
#include <termios.h>
#include <unistd.h>
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include "check.hpp"
#include "slips.hpp"
#include "text.hpp"

namespace nutshell::judge {

namespace fs = std::filesystem;

namespace {

std::string padded(const std::string& text, std::size_t width) {
    return text + std::string(text.size() < width ? width - text.size() : 1, ' ');
}

std::string xml(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '&')
            safe += "&amp;";
        else if (c == '<')
            safe += "&lt;";
        else if (c == '>')
            safe += "&gt;";
        else if (c == '"')
            safe += "&quot;";
        else if (static_cast<unsigned char>(c) >= 32 || c == '\n' || c == '\t')
            safe += c;
    }
    return safe;
}

void write_junit(const std::string& file, const std::vector<std::pair<Chapter, std::vector<Verdict>>>& all) {
    std::ostringstream text;
    text << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
    for (const auto& [chapter, verdicts] : all) {
        std::size_t failures = 0;
        for (const auto& verdict : verdicts) failures += verdict.outcome != Outcome::passed;
        text << "  <testsuite name=\"" << chapter.folder << "\" tests=\"" << verdicts.size()
             << "\" failures=\"" << failures << "\">\n";
        for (const auto& verdict : verdicts) {
            text << "    <testcase classname=\"" << chapter.folder << "\" name=\"" << verdict.number.text()
                 << " " << xml(exercise_of(verdict.number).title) << "\"";
            if (verdict.outcome == Outcome::passed)
                text << "/>\n";
            else
                text << ">\n      <failure message=\"" << xml(verdict.name) << "\">" << xml(verdict.words)
                     << "</failure>\n    </testcase>\n";
        }
        text << "  </testsuite>\n";
    }
    text << "</testsuites>\n";
    write_text(file, text.str());
}

/// Whether its numbers told nothing certain: then it is worth the time to try small changes.
bool is_unnamed(const Verdict& verdict) {
    for (const auto* name :
         {"wrong formula", "wrong order", "another scheme", "right only where", "wrong where", "wrong in",
          "as wrong for", "right in one case", "right direction", "a wrong sign for some"})
        if (starts_with(verdict.name, std::string("wrong: ") + name)) return true;
    return false;
}

/// "1.1 is not right yet: multiplied by dt", "1.2 is blocked by 1.1", "1.3: endless loop"
std::string heading(const Verdict& verdict) {
    const std::string id = verdict.number.text(), wrong = "wrong: ";
    if (starts_with(verdict.name, wrong))
        return id + " is not right yet: " + verdict.name.substr(wrong.size());
    if (verdict.name == "does not compile") return id + " does not compile";
    return id + (verdict.outcome == Outcome::blocked ? " is " : ": ") + verdict.name;
}

}  // namespace

std::vector<Chapter> meant(const Rooms& rooms, const std::string& which) {
    const auto all = chapters_of(rooms);
    if (which.empty()) return all;
    const auto number = number_of(which);
    std::vector<Chapter> found;
    std::string there;
    for (const Chapter& chapter : all) {
        const std::string n = std::to_string(chapter.number);
        const bool holds = number && std::find(chapter.exercises.begin(), chapter.exercises.end(), *number) !=
                                         chapter.exercises.end();
        if (holds || which == n || which == "0" + n || which == chapter.folder) found.push_back(chapter);
        there += (there.empty() ? "" : ", ") + chapter.exercises.front().text() + " to " +
                 chapter.exercises.back().text();
    }
    if (found.empty())
        throw std::invalid_argument("there is no exercise or chapter '" + which +
                                    "'; there are the exercises " + there);
    return found;
}

int verb_check(const Rooms& rooms, const std::string& which, const std::string& junit) {
    auto chapters = meant(rooms, which);
    if (!fs::exists(rooms.answers)) {
        std::cerr << "There is no " << rooms.answers.filename().string()
                  << "/ yet. Begin with  ./course start\n";
        return 1;
    }
    const auto one = number_of(which);
    if (which.empty())  // those that were started
        std::erase_if(chapters,
                      [&](const Chapter& chapter) { return !fs::exists(rooms.answers / chapter.folder); });
    const Lock lock(rooms.work);  // one judge at a time in a folder of work
    const auto is_new = [&](const Chapter& chapter) {
        return !fs::exists(rooms.shared / "ahead" / chapter.folder);
    };
    if (isatty(1) && std::any_of(chapters.begin(), chapters.end(), is_new))
        std::cout << "The first check takes some seconds longer than the next ones.\n" << std::flush;

    Progress progress = Progress::read(rooms);
    const Progress before = progress;
    std::vector<std::pair<Chapter, std::vector<Verdict>>> all;
    const bool colour = isatty(1) && !std::getenv("NO_COLOR");
    for (const Chapter& chapter : chapters) {
        const auto verdicts =
            check(rooms, chapter, one ? std::vector<Number>{*one} : chapter.exercises, !junit.empty());
        std::cout << title_of(chapter) << '\n';
        for (const Verdict& verdict : verdicts) {
            const bool passed = verdict.outcome == Outcome::passed,
                       quiet = verdict.outcome == Outcome::unanswered;
            const char* mark = passed ? "✓" : quiet ? "·" : "✗";
            std::cout << (colour && !quiet ? passed ? "\033[32m" : "\033[31m" : "") << "  " << mark << ' '
                      << padded(verdict.number.text(), 6) << padded(exercise_of(verdict.number).title, 40)
                      << verdict.name << (colour && !quiet ? "\033[0m" : "") << '\n';
            if (passed) progress.entries[verdict.number].passed = true;
        }
        std::cout << std::flush;
        all.emplace_back(chapter, verdicts);
    }
    std::string finished;  // by this check
    for (const auto& [chapter, verdicts] : all)
        if (celebration(chapter, before).empty()) finished += celebration(chapter, progress);
    progress.write(rooms);
    if (!junit.empty()) write_junit(junit, all);

    // one thing at a time: what does not compile, else the first that is wrong, else the next to answer
    const Verdict* first = nullptr;
    const Verdict* next = nullptr;
    std::size_t passed = 0, count = 0;
    std::vector<std::string> notes;
    for (const auto& [chapter, verdicts] : all)
        for (const Verdict& verdict : verdicts) {
            ++count;
            passed += verdict.outcome == Outcome::passed;
            if (!verdict.words.empty() && (!first || (verdict.outcome == Outcome::not_compiled &&
                                                      first->outcome != Outcome::not_compiled)))
                first = &verdict;
            if (verdict.outcome == Outcome::unanswered && !next) next = &verdict;
            notes.insert(notes.end(), verdict.notes.begin(), verdict.notes.end());
        }
    if (!finished.empty()) std::cout << '\n' << folded(finished, 0);
    for (const auto& note : notes) std::cout << '\n' << folded("Note: " + note, 0);
    std::cout << '\n';
    if (first) {
        const std::string id = first->number.text();
        std::cout << heading(*first) << '\n' << first->words << std::flush;
        if (first->outcome == Outcome::wrong && junit.empty() && is_unnamed(*first))
            if (const auto slip = one_slip_away(rooms, chapter_of(rooms, first->number), first->number))
                std::cout << folded(*slip, 2);
        if (first->outcome == Outcome::wrong || first->outcome == Outcome::failed)
            std::cout << "  Then: ./course check " << id << "      a hint: ./course hint " << id << '\n';
    } else if (next) {
        const std::string id = next->number.text();
        const Chapter chapter = chapter_of(rooms, next->number);
        const auto& header = chapter.header_of(next->number);
        const Marked own = marked(own_text(rooms, chapter, header).value_or(""));
        const Body* body = own.body(next->number);
        std::cout << (passed ? std::to_string(passed) + " of " + std::to_string(count) + " passed. " : "")
                  << "Next: " << id << " " << exercise_of(next->number).title << ", in\n  "
                  << named(rooms, own_path(rooms, chapter, header))
                  << (body ? ":" + std::to_string(body->begin + 2) : "") << "\n  Put your answer in place of "
                  << unanswered(next->number) << " and type ./course check " << id << '\n';
    } else if (one) {
        std::cout << "Another right answer: ./course solution " << one->text();
        if (const auto& exercises = all.front().first.exercises; exercises.back() != *one) {
            const Number following{one->chapter, one->exercise + 1};
            std::cout << "      Next: ./course check " << following.text();
        }
        std::cout << '\n';
    } else {
        std::cout << "All " << count << " exercises pass.";
        for (const auto& [chapter, verdicts] : all)
            std::cout << " See chapter " << chapter.number << " run on your own answers: ./course run "
                      << chapter.number << " --mine";
        std::cout << '\n';
    }
    return passed == count ? 0 : 1;
}

std::string state_of(const fs::path& folder) {
    std::ostringstream state;
    std::error_code problem;
    for (fs::recursive_directory_iterator at(folder, problem), end; !problem && at != end;
         at.increment(problem))
        if (at->path().extension() == ".hpp" && at->path().parent_path().filename() != "saved")
            state << at->path().string() << at->last_write_time(problem).time_since_epoch().count() << ' '
                  << at->file_size(problem) << '\n';
    return state.str();
}

namespace {

/// Single keys, without waiting for a line, as long as it lives.
class Keys {
  public:
    Keys() {
        if (tcgetattr(0, &before_) != 0) return;
        termios raw = before_;
        raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
        terminal_ = tcsetattr(0, TCSANOW, &raw) == 0;
    }
    ~Keys() {
        if (terminal_) tcsetattr(0, TCSANOW, &before_);
    }
    Keys(const Keys&) = delete;
    Keys& operator=(const Keys&) = delete;

    /// The next key, or 0 if none comes within a tenth of a second.
    char next() {
        pollfd keyboard{open_ ? 0 : -1, POLLIN, 0};
        if (poll(&keyboard, 1, 100) <= 0 || !keyboard.revents) return 0;
        char key = 0;
        if (read(0, &key, 1) != 1) open_ = false;
        return key;
    }

  private:
    termios before_{};
    bool terminal_ = false, open_ = true;
};

/// The first exercise among those meant that has not passed; the first of all if all have.
Number at_work_on(const Rooms& rooms, const std::string& which) {
    if (const auto one = number_of(which)) return *one;
    const Progress progress = Progress::read(rooms);
    const auto chapters = meant(rooms, which);
    for (const Chapter& chapter : chapters)
        for (const Number number : chapter.exercises)
            if (const auto found = progress.entries.find(number);
                found == progress.entries.end() || !found->second.passed)
                return number;
    return chapters.front().exercises.front();
}

/// The exercise after this one, in its chapter; itself if it is the last.
Number after(const Rooms& rooms, Number number) {
    const auto all = chapter_of(rooms, number).exercises;
    const auto here = std::find(all.begin(), all.end(), number);
    return here + 1 < all.end() ? *(here + 1) : number;
}

}  // namespace

int verb_watch(const Rooms& rooms, std::string which) {
    for (int file = 3; file < 64; ++file)
        close(file);  // ./course's lock among them: others may work meanwhile
    meant(rooms, which);
    if (!fs::exists(rooms.answers))
        throw std::runtime_error("there is no answers/ yet: begin with ./course start");
    Keys keys;
    for (std::string seen;;) {
        if (const std::string now = state_of(rooms.answers); now != seen) {
            seen = now;
            std::cout << (isatty(1) ? "\033[2J\033[H" : "----\n");
            try {
                verb_check(rooms, which, "");
            } catch (const std::exception& problem) {
                std::cout << problem.what() << '\n';
            }
            std::cout
                << "\nWatching answers/: save a file to check again. Keys: h hint, n next exercise, q quit.\n"
                << std::flush;
        }
        const char key = keys.next();
        if (key == 'q') return 0;
        if (key == 'h') std::cout << '\n' << hint(rooms, at_work_on(rooms, which)) << std::flush;
        if (key == 'n') which = after(rooms, at_work_on(rooms, which)).text(), seen.clear();
    }
}

}  // namespace nutshell::judge
