// The judge: the verbs of ./course that are about a learner's answers.
#include <cstdlib>
#include <exception>
#include <iostream>
#include <map>
#include <stdexcept>
#include "check.hpp"
#include "gates.hpp"
#include "judge_config.hpp"
#include "text.hpp"

using namespace nutshell::judge;

namespace {

/// {verb, arguments, what it does}
constexpr const char* verbs[][3] = {
    {"start", "",
     "makes answers/ with the exercises to be answered, and what an editor needs; overwrites nothing"},
    {"check", "[N[.M]] [--junit FILE]",
     "judges your answers: all, a chapter's, or one. Exit status 0 all right, 1 not yet, 2 wrong usage, 3 "
     "the machine's "
     "fault. --junit writes a grader's report, for which the marked bodies are taken and nothing else"},
    {"watch", "[N[.M]]", "checks whenever you save; keys: h a hint, n the next exercise, q ends"},
    {"hint", "N.M", "the next of three hints"},
    {"solution", "N.M [--give-up]",
     "the solution, once yours has passed, or if you give up; that is remembered"},
    {"reset", "N.M", "puts one exercise back as it was; your text is kept in answers/saved"},
    {"debug", "N.M", "your answer under gdb, stopped in it at the input that fails"},
    {"progress", "", "how far you are, chapter by chapter"},
    {"run", "N --mine",
     "the chapter's program on your answers; the reference stands in for those you have not given"},
    {"live", "N --mine", "the page's moving figures on your answers, made again whenever you save"},
    {"gates", "[N[.M]]", "for authors: makes mutants of every reference body and counts those that fail"},
};

std::string usage(const std::string& verb) {
    std::string text;
    for (const auto& [name, words, what] : verbs)
        if (verb.empty() || verb == name)
            text += "  ./course " + std::string(name) + " " + words + "\n" + folded(what, 6);
    return text;
}

struct Arguments {
    std::string verb, which;
    std::map<std::string, std::string> options;
};

Arguments parse(int argc, char** argv) {
    Arguments arguments;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--give-up" || word == "--mine" || word == "--once" || word == "--help" || word == "-h") {
            arguments.options[word] = "yes";
        } else if (word == "--junit" || word == "--answers" || word == "--work" || word == "--out" ||
                   word == "--book") {
            if (i + 1 >= argc) throw std::invalid_argument(word + " needs a name after it");
            arguments.options[word] = argv[++i];
        } else if (word.rfind("--", 0) == 0) {
            throw std::invalid_argument("unknown option " + word);
        } else if (arguments.verb.empty()) {
            arguments.verb = word;
        } else if (arguments.which.empty()) {
            arguments.which = word;
        } else {
            throw std::invalid_argument("one exercise or chapter at a time, not '" + arguments.which +
                                        "' and '" + word + "'");
        }
    }
    return arguments;
}

int act(const Arguments& arguments) {
    namespace fs = std::filesystem;
    const auto option = [&](const std::string& name, const std::string& otherwise) {
        const auto found = arguments.options.find(name);
        return found == arguments.options.end() ? otherwise : found->second;
    };
    if (arguments.options.count("--help") || arguments.options.count("-h")) {
        std::cout << usage(arguments.verb);
        return 0;
    }
    Rooms rooms;
    rooms.course = CONFIG_COURSE;
    rooms.answers = fs::absolute(option("--answers", (rooms.course / "answers").string())).lexically_normal();
    if (rooms.answers.filename().empty()) rooms.answers = rooms.answers.parent_path();
    rooms.work = fs::absolute(option("--work", (rooms.course / "build/answers").string()));
    rooms.shared = CONFIG_SHARED;
    const std::string& verb = arguments.verb;
    const auto exercise = [&] {
        const auto number = number_of(arguments.which);
        if (!number)
            throw std::invalid_argument(verb + " needs the number of an exercise, such as ./course " + verb +
                                        " 1.3");
        return *number;
    };
    const auto begun = [&] {
        if (!fs::exists(rooms.answers))
            throw std::runtime_error("there is no answers/ yet: begin with ./course start");
    };
    if (verb == "check") return verb_check(rooms, arguments.which, option("--junit", ""));
    if (verb == "gates") return verb_gates(rooms, arguments.which);
    if (verb == "watch") return verb_watch(rooms, arguments.which);
    if (verb == "debug") return begun(), verb_debug(rooms, exercise());
    if (verb == "live")
        return begun(),
               verb_live(rooms, arguments.which, option("--book", (rooms.course / "out/book").string()),
                         option("--out", (rooms.course / "out/mine/book").string()),
                         !option("--once", "").empty());
    if (verb == "run" && !option("--mine", "").empty())
        return begun(), verb_mine(rooms, arguments.which, option("--out", ""));
    if (verb == "start")
        std::cout << start(rooms);
    else if (verb == "hint")
        begun(), std::cout << hint(rooms, exercise());
    else if (verb == "solution")
        std::cout << solution(rooms, exercise(), !option("--give-up", "").empty());
    else if (verb == "progress")
        begun(), std::cout << progress(rooms);
    else if (verb == "reset")
        begun(), std::cout << reset(rooms, exercise());
    else
        throw std::invalid_argument(std::string("unknown verb '") + verb + "'\n" + usage(""));
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return act(parse(argc, argv));
    } catch (const std::invalid_argument& problem) {
        std::cerr << "course: " << problem.what() << '\n';
        return 2;
    } catch (const MachineFault& problem) {
        std::cerr << "course: " << problem.what() << '\n';
        return 3;
    } catch (const std::exception& problem) {
        std::cerr << "course: " << problem.what() << '\n';
        return 1;
    }
}
