// Text in a chart: how wide it is, how it is broken, escaped and how numbers are written. No locale is
// consulted.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "chart_parts.hpp"

namespace nutshell::chart::parts {
namespace {

// Advance widths of Lato Bold, thousandths of its size, for the characters 32 to 126.
constexpr std::array<short, 95> lato_bold{
    243, 281, 396, 580, 580, 820, 724, 212, 274, 274, 425, 580, 234, 373, 238, 466, 580, 580,  580,
    580, 580, 580, 580, 580, 580, 580, 258, 270, 580, 580, 580, 460, 844, 694, 658, 662, 760,  575,
    566, 726, 770, 296, 430, 686, 520, 945, 770, 808, 619, 808, 643, 548, 600, 742, 694, 1051, 670,
    648, 606, 314, 466, 314, 580, 466, 400, 508, 568, 482, 568, 534, 358, 528, 564, 254, 254,  534,
    248, 838, 564, 574, 568, 568, 373, 440, 372, 564, 528, 802, 522, 528, 460, 306, 261, 306,  580};
constexpr short other_character =
    640;  // Greek letters, signs; narrower ones get too much room, which does no harm
constexpr double other_fonts = 1.04;  // where Lato is missing

std::string written(double value, std::chars_format format, int digits) {
    std::array<char, 512> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format, digits);
    return {buffer.data(), end.ptr};
}

}  // namespace

double text_width(std::string_view utf8, double size) {
    double thousandths = 0;
    for (const char c : utf8) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 32 && byte < 127) thousandths += lato_bold[byte - 32U];
        if (byte >= 0xC0) thousandths += other_character;  // first byte of a longer character
    }
    return thousandths / 1000 * size * other_fonts;
}

std::vector<std::string> wrapped(std::string_view utf8, double size, double width) {
    std::vector<std::string> lines;
    std::string line;
    const auto fitting = [&](std::string_view word) {  // how many bytes of it fit, at least one character
        std::size_t end = 0;
        while (end < word.size()) {
            std::size_t next = end + 1;
            while (next < word.size() && (static_cast<unsigned char>(word[next]) & 0xC0U) == 0x80U) ++next;
            if (end > 0 && text_width(word.substr(0, next), size) > width) break;
            end = next;
        }
        return end;
    };
    for (std::size_t start = 0; start < utf8.size();) {
        std::size_t end = std::min(utf8.find(' ', start), utf8.size());
        std::string word(utf8.substr(start, end - start));
        const std::size_t part = fitting(word);
        const bool broken = part < word.size();
        if (broken) word.resize(part), end = start + part;
        const std::string longer = line.empty() ? word : line + ' ' + word;
        if (!line.empty() && text_width(longer, size) > width) {
            lines.push_back(line);
            line = word;
        } else {
            line = longer;
        }
        start = broken ? end : end + 1;
    }
    if (!line.empty()) lines.push_back(line);
    return lines;
}

std::vector<std::string> balanced(std::string_view utf8, double size, double width) {
    double longest_word = 0;
    for (std::size_t start = 0; start < utf8.size();) {
        const std::size_t end = std::min(utf8.find(' ', start), utf8.size());
        longest_word = std::max(longest_word, text_width(utf8.substr(start, end - start), size));
        start = end + 1;
    }
    if (longest_word <= 1.5 * width) width = std::max(width, longest_word);  // rather than broken
    auto lines = wrapped(utf8, size, width);
    for (double narrower = width - 4; narrower >= longest_word; narrower -= 4) {
        auto tried = wrapped(utf8, size, narrower);
        if (tried.size() > lines.size()) break;
        lines = std::move(tried);
    }
    return lines;
}

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            case '\'':
                result += "&#39;";
                break;
            default:  // XML forbids the other control characters
                result += static_cast<unsigned char>(c) < 32 && c != '\n' ? ' ' : c;
        }
    }
    return result;
}

std::string unit(double length) {
    std::string text = written(length, std::chars_format::fixed, 1);
    if (text.ends_with(".0")) text.resize(text.size() - 2);
    return text == "-0" ? "0" : text;
}

std::string decimal(double value, int decimals) {
    std::string digits = written(std::abs(value), std::chars_format::fixed, decimals);
    const std::size_t point = std::min(digits.find('.'), digits.size());
    if (point > 4)
        for (std::size_t i = point - 3; i > 0 && i<point; i = i> 3 ? i - 3 : 0) digits.insert(i, "\u2009");
    const bool negative = value < 0 && digits.find_first_of("123456789") != std::string::npos;
    return (negative ? "\u2212" : "") + digits;
}

std::string spoken(double value) {
    if (!std::isfinite(value))
        return std::isnan(value) ? "not a number" : value < 0 ? "\u2212infinity" : "infinity";
    std::string text = written(value, std::chars_format::general, 4);
    if (const auto zero = text.find("e-0"); zero != std::string::npos) text.erase(zero + 2, 1);
    if (const auto plus = text.find("e+"); plus != std::string::npos)
        text.erase(plus + 1, text[plus + 2] == '0' ? 2 : 1);
    if (text[0] == '-') text.replace(0, 1, "\u2212");
    return text;
}

std::string power_of_ten(double mantissa, int exponent) {
    const std::string sign = exponent < 0 ? "\u2212" : "";
    const std::string factor = mantissa == 1 ? "" : mantissa == -1 ? "\u2212" : spoken(mantissa) + "\u00d7";
    return factor + "10<tspan class='sup' dy='-6'>" + sign + std::to_string(std::abs(exponent)) + "</tspan>";
}

double width_of_markup(std::string_view markup, double size) {
    std::string shown;
    bool tag = false;
    for (const char c : markup) {
        if (c == '<') tag = true;
        if (!tag) shown += c;
        if (c == '>') tag = false;
    }
    return text_width(shown, size);
}

}  // namespace nutshell::chart::parts
