// Pictures and their notes on disk.
#include <cstdio>
#include <iostream>
#include <nutshell/write_file.hpp>

#include "nutshell/picture/save.hpp"
#include "png.hpp"

namespace nutshell::picture {

namespace {

namespace fs = std::filesystem;

std::string number(double value) {
    char digits[40];
    std::snprintf(digits, sizeof digits, "%.17g", value);
    return digits;
}

std::string words(const Note& note, const std::string& drawn_line) {
    std::string out = drawn_line + "\n";
    auto line = [&](const char* name, const std::string& value) {
        if (!value.empty()) out += std::string(name) + ": " + value + "\n";
    };
    line("command", note.command);
    line("scene", note.scene);
    line("method", note.method);
    line("dt", note.dt);
    line("states", note.states);
    for (const NotedNumber& n : note.numbers) {
        out += n.name + " = " + number(n.value) + (n.unit.empty() ? "" : " " + n.unit) + "\n";
    }
    return out;
}

fs::path note_of(const fs::path& file) {
    if (file.extension() != ".png") {
        throw std::invalid_argument("a picture's file must end in .png, not " + file.string());
    }
    return fs::path(file).replace_extension(".txt");
}

fs::path page_of(const fs::path& file) {
    return fs::path(file).replace_extension(".page.html");
}

/// Draws; without graphics, says so in the note and takes older pictures away.
bool save_or_say(const fs::path& file, const Note& note, const std::function<void()>& draw) {
    const fs::path beside = note_of(file);
    try {
        draw();
        return true;
    } catch (const NoGraphics& reason) {
        std::error_code none;
        for (const fs::path& old : {file, page_of(file)}) fs::remove(old, none);
        write_file(beside, words(note, std::string("not drawn: ") + reason.what()));
        std::cerr << file.string() << " is not drawn: " << reason.what() << "\n";
        return false;
    }
}

}  // namespace

void save(const Image& image, const fs::path& file, const Note& note) {
    const fs::path beside = note_of(file);
    if (image.width < 1 || image.height < 1 ||
        image.rgb.size() != 3 * std::size_t(image.width) * std::size_t(image.height)) {
        throw std::invalid_argument("an image to be saved as " + file.string() + " is empty");
    }
    write_file(file, png(image));
    write_file(beside,
               words(note, "drawn: " + std::to_string(image.width) + " x " + std::to_string(image.height)));
}

bool save(const fs::path& file, const Note& note, const std::function<Image()>& draw) {
    return save_or_say(file, note, [&] { save(draw(), file, note); });
}

bool save(const fs::path& file, const Note& note, const std::function<Sheet()>& draw) {
    return save_or_say(file, note, [&] {
        const Printed printed = print(draw(), file.stem().string());
        for (const auto& [name, bytes] : printed.files) write_file(file.parent_path() / name, bytes);
        write_file(page_of(file), printed.page);
        write_file(file, printed.png);
        write_file(note_of(file), words(note, "drawn: " + std::to_string(printed.width) + " x " +
                                                  std::to_string(printed.height)));
    });
}

}  // namespace nutshell::picture
