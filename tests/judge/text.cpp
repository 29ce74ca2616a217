#include "text.hpp"
#include <sys/ioctl.h>
#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <nutshell/write_file.hpp>
#include <sstream>
#include <stdexcept>
#include "machine.hpp"

namespace nutshell::judge {

std::string read_text(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file || std::filesystem::is_directory(path))
        throw std::runtime_error("cannot read " + path.string());
    return {std::istreambuf_iterator<char>(file), {}};
}

void write_text(const std::filesystem::path& path, std::string_view text) try {
    write_file(path, text);
} catch (const std::exception& problem) {
    throw MachineFault(problem.what());
}

void write_if_changed(const std::filesystem::path& path, std::string_view text) {
    if (!std::filesystem::exists(path) || read_text(path) != text) write_text(path, text);
}

std::vector<std::string> lines_of(std::string_view text) {
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        std::string_view line = text.substr(begin, end - begin);
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        lines.emplace_back(line);
        begin = end + 1;
    }
    return lines;
}

std::string joined(const std::vector<std::string>& parts, std::string_view between) {
    std::string all;
    for (std::size_t i = 0; i < parts.size(); ++i) all.append(i ? between : "").append(parts[i]);
    return all;
}

std::string trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return "";
    return std::string(text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1));
}

std::string replaced(std::string text, std::string_view what, std::string_view with) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size())
        text.replace(at, what.size(), with);
    return text;
}

bool starts_with(std::string_view text, std::string_view start) {
    return text.substr(0, start.size()) == start;
}

bool contains(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

std::string bare_code(std::string_view source) {
    std::string bare;
    const auto space = [&] {
        if (!bare.empty() && bare.back() != ' ') bare += ' ';
    };
    for (std::size_t i = 0; i < source.size(); ++i) {
        const char c = source[i], next = i + 1 < source.size() ? source[i + 1] : '\0';
        if (c == '/' && next == '/') {
            i = std::min(source.find('\n', i), source.size() - 1);
            space();
        } else if (c == '/' && next == '*') {
            const auto end = source.find("*/", i + 2);
            i = end == std::string_view::npos ? source.size() : end + 1;
            space();
        } else if (c == '"') {
            bare += c;
            for (++i; i < source.size() && source[i] != '"'; ++i) {
                bare += source[i];
                if (source[i] == '\\' && i + 1 < source.size()) bare += source[++i];
            }
            bare += '"';
        } else if (std::isspace(static_cast<unsigned char>(c))) {
            space();
        } else {
            bare += c;
        }
    }
    return trimmed(bare);
}

namespace {

/// Where `name` stands as a word of its own, from `at` on.
std::size_t word_at(std::string_view code, std::string_view name, std::size_t at) {
    const auto letter = [&](std::size_t i) {
        return i < code.size() && (std::isalnum(static_cast<unsigned char>(code[i])) || code[i] == '_');
    };
    for (at = code.find(name, at); at != std::string_view::npos; at = code.find(name, at + 1))
        if (!(at > 0 && letter(at - 1)) && !letter(at + name.size())) break;
    return at;
}

}  // namespace

bool names(std::string_view code, std::string_view name) {
    return word_at(code, name, 0) != std::string_view::npos;
}

bool calls(std::string_view code, std::string_view name) {
    for (std::size_t at = word_at(code, name, 0); at != std::string_view::npos;
         at = word_at(code, name, at + 1)) {
        std::size_t next = at + name.size();
        while (next < code.size() && code[next] == ' ') ++next;
        if (next < code.size() && (code[next] == '(' || code[next] == '<')) return true;
    }
    return false;
}

std::size_t text_width() {
    winsize size{};
    if (ioctl(1, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 100;
    return std::clamp<std::size_t>(size.ws_col, 40, 100);
}

std::string folded(std::string_view words, std::size_t indent, std::size_t width) {
    std::istringstream stream{std::string(words)};
    std::string all, line(indent, ' '), word;
    const auto columns = [](std::string_view text) {
        std::size_t count = 0;
        for (const char c : text) count += (c & 0xC0) != 0x80;
        return count;
    };
    while (stream >> word) {
        if (columns(line) > indent && columns(line) + 1 + columns(word) > width) {
            all += line + '\n';
            line = std::string(indent, ' ');
        }
        line += (columns(line) > indent ? " " : "") + word;
    }
    return all + line + '\n';
}

std::vector<std::string> excerpt(std::string_view printed, std::size_t most) {
    std::vector<std::string> shown;
    for (std::string line : lines_of(printed)) {
        if (shown.size() == most) {
            shown.emplace_back("...");
            break;
        }
        for (char& c : line)
            if (static_cast<unsigned char>(c) < 32 || c == 127) c = ' ';
        if (line.size() > 100 && !contains(line, "Assertion `")) line = line.substr(0, 97) + "...";
        shown.push_back(line);
    }
    return shown;
}

}  // namespace nutshell::judge
