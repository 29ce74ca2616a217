#include "nutshell/picture/sheet.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "nutshell/picture/render.hpp"
#include "png.hpp"
#include "words.hpp"

namespace nutshell::picture {

namespace {

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else
            out += c;
    }
    return out;
}

std::string percent(double share) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f%%", 100 * share);
    return text;
}

/// The words of a shot as text, laid out for a picture of this width; letters grow with it, in its own unit
/// cqw.
std::string words_for(const Shot& shot, int width, const char* name) {
    const Size size{width, int(std::lround(double(width) * shot.size.height / shot.size.width))};
    std::string out = "<span class=\"words " + std::string(name) + "\">";
    for (const Line& line : place_words(shot.drawing, shot.camera, size)) {
        const bool title = line.part == Line::Part::title, low = !title && line.part != Line::Part::label;
        char font[80];
        std::snprintf(font, sizeof font, ";--size:%.2fcqw", 100 * line.height / width);
        out +=
            std::string("<span class=\"") + (line.weight == Weight::bold ? "bold" : "quiet") +
            (title || low ? " long" : "") + "\" style=\"" +
            (line.ends ? "right:" + percent(1 - line.right / width) : "left:" + percent(line.left / width)) +
            (low     ? ";bottom:" + percent(1 - (line.baseline + 0.25 * line.height) / size.height)
             : title ? ";top:" + percent((line.baseline - 0.9 * line.height) / size.height)
                     : ";top:" + percent((line.baseline - 0.97 * line.height) / size.height)) +
            font + ";--light:" + web(line.ink, Theme::light) + ";--dark:" + web(line.ink, Theme::dark) +
            "\">" + escaped(line.text) + "</span>";
    }
    return out + "</span>";
}

Image of(const Shot& shot, Theme theme) {
    Drawing drawing = shot.drawing;
    return render_bare(drawing.theme(theme), shot.camera, shot.size);
}

}  // namespace

Printed print(const Sheet& sheet, const std::string& stem) {
    if (sheet.shots.empty()) throw std::invalid_argument("picture: a sheet needs at least one shot");
    const int count = int(sheet.shots.size()),
              columns = sheet.columns > 0 ? std::min(sheet.columns, count) : count;
    std::vector<Image> lit;
    Printed out;
    out.page = std::string("<span class=\"sheet") + (columns > 3 ? " strip" : "") +
               "\" style=\"--columns:" + std::to_string(columns) + "\">\n";
    for (int i = 0; i < count; ++i) {
        const Shot& shot = sheet.shots[std::size_t(i)];
        const std::string name = stem + "." + std::to_string(i + 1);
        lit.push_back(of(shot, Theme::light));
        out.files.emplace_back(name + ".jpg", jpeg(lit.back()));
        out.files.emplace_back(name + ".dark.jpg", jpeg(of(shot, Theme::dark)));
        write_words(lit.back(), place_words(shot.drawing, shot.camera, shot.size), Theme::light);
        const std::string width = std::to_string(shot.size.width), height = std::to_string(shot.size.height);
        out.page +=
            "<span class=\"shot\"><picture><source media=\"screen and (prefers-color-scheme: dark)\" "
            "srcset=\"" +
            name + ".dark.jpg\"><img src=\"" + name + ".jpg\" alt=\"\" width=\"" + width + "\" height=\"" +
            height + "\"></picture>" + words_for(shot, shot.size.width, "wide") +
            words_for(shot, 340, "narrow") + "</span>\n";
    }
    out.page += "</span>";
    const Image all =
        count == 1 ? lit.front() : filmstrip(lit, std::vector<std::string>(lit.size()), columns);
    out.png = png(all), out.width = all.width, out.height = all.height;
    return out;
}

}  // namespace nutshell::picture
