// ./course live N --mine: the page's moving figures on the learner's answers.
#include <unistd.h>
#include <chrono>
#include <iostream>
#include <thread>
#include "check.hpp"
#include "judge_config.hpp"
#include "text.hpp"

namespace nutshell::judge {

namespace fs = std::filesystem;

namespace {

/// Words inside a JavaScript string.
std::string in_javascript(const std::string& words) {
    std::string out = "\"";
    for (const char c : words) {
        if (c == '"' || c == '\\') out += '\\';
        if (c == '\n')
            out += "\\n";
        else if (c == '<')
            out += "\\x3c";
        else
            out += c;
    }
    return out + "\"";
}

}  // namespace

int verb_live(const Rooms& rooms, const std::string& which, const fs::path& book, const fs::path& out,
              bool once) {
    const Chapter chapter = chapter_of(rooms, "live", which);
    const fs::path module = fs::path(CONFIG_LIVE) / (chapter.folder + ".js");
    if (std::string(CONFIG_LIVE_MISSING) != "")
        throw std::runtime_error(std::string("figures do not move here: missing ") + CONFIG_LIVE_MISSING);
    if (!fs::exists(book / "live" / (chapter.folder + ".js")))
        throw std::runtime_error("no figure of chapter " + std::to_string(chapter.number) + " moves in " +
                                 book.string() + ": ./course run makes the book");
    for (int file = 3; file < 64; ++file)
        close(file);  // ./course's lock among them: others may work meanwhile

    // the book again, with a script that asks once a second whether there is something new
    fs::remove_all(out), fs::create_directories(out.parent_path());
    fs::copy(book, out, fs::copy_options::recursive);
    write_if_changed(out / "live/live.js",
                     "window.live_is_mine = true;\n" + read_text(book / "live/live.js"));
    const fs::path shown = out / "live" / (chapter.folder + ".js");
    const auto show = [&] { fs::copy_file(module, shown, fs::copy_options::overwrite_existing); };
    if (fs::exists(module)) show();  // the last that worked
    std::cout << "Your figures: file://" << (out / (chapter.folder + ".html")).string() << "\n";

    int failed = 0;
    for (std::string seen;;) {
        const std::string now = state_of(rooms.answers);
        if (now != seen) {
            seen = now;
            std::string sentence;
            try {
                const Lock lock(CONFIG_MINE);
                stock_mine(rooms, chapter, Broken::stops);
                build_mine(rooms, chapter, "live_mine_" + chapter.folder);
                show();
                std::cout << "The page has it.\n";
            } catch (const MachineFault&) {
                throw;
            } catch (const std::exception& problem) {
                sentence = problem.what();
                std::cout << sentence << "\nThe page keeps the last that worked.\n";
                ++failed;
            }
            const std::string stamp =
                std::to_string(std::chrono::system_clock::now().time_since_epoch().count());
            write_if_changed(out / "live/mine.js",
                             "live_mine(" + in_javascript(stamp) + ", " + in_javascript(sentence) + ");\n");
            if (once) return failed ? 1 : 0;
            std::cout << "Watching answers/: save a file to see it move, Ctrl-C to end.\n" << std::flush;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
}

}  // namespace nutshell::judge
