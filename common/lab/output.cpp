#include <unistd.h>
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fstream>
#include <iostream>
#include <nutshell/lab/output.hpp>
#include <nutshell/require.hpp>

namespace nutshell::lab {

namespace {

std::string processor_name() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
    return "unknown processor";
}

std::string compiler_name() {
#if defined(__clang__)
    return "clang " __clang_version__;
#else
    return "g++ " __VERSION__;
#endif
}

std::size_t width(const std::string& text) {  // in characters, not bytes
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

bool is_number(const std::string& text) {
    return !text.empty() && text.find_first_not_of("0123456789+-.,einfa x%") == std::string::npos &&
           text.find_first_of("0123456789") != std::string::npos;
}

}  // namespace

std::string provenance(const std::string& command) {
    return "# command: " + command + "\n# machine: " + processor_name() + "\n# compiler: " + compiler_name() +
           "\n";
}

std::string exact_digits(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value);
    return std::string(text, end.ptr);
}

std::string rounded(double value, const char* format) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

void Table::add(std::vector<std::string> cells) {
    require(cells.size() == columns.size(), "a row of " + std::to_string(cells.size()) +
                                                " cells in a table of " + std::to_string(columns.size()) +
                                                " columns");
    rows.push_back(std::move(cells));
}

std::string Table::csv() const {
    std::string out;
    const auto line = [&](const std::vector<std::string>& cells) {
        for (std::size_t i = 0; i < cells.size(); ++i) {
            std::string cell = cells[i];
            if (cell.find_first_of(",\"\n") != std::string::npos) {
                for (std::size_t at = 0; (at = cell.find('"', at)) != std::string::npos; at += 2)
                    cell.insert(at, 1, '"');
                cell = '"' + cell + '"';
            }
            out += (i ? "," : "") + cell;
        }
        out += '\n';
    };
    line(columns);
    for (const auto& row : rows) line(row);
    return out;
}

std::string Table::text() const {
    std::vector<std::size_t> widths;
    for (std::size_t c = 0; c < columns.size(); ++c) {
        std::size_t widest = width(columns[c]);
        for (const auto& row : rows) widest = std::max(widest, width(row[c]));
        widths.push_back(widest);
    }
    std::string out;
    const auto line = [&](const std::vector<std::string>& cells) {
        std::string text = "  ";
        for (std::size_t c = 0; c < cells.size(); ++c) {
            const bool right = std::all_of(rows.begin(), rows.end(), [&](const auto& row) {
                return row[c].empty() || is_number(row[c]);
            });
            const std::string space(widths[c] - width(cells[c]), ' ');
            text += (right ? space + cells[c] : cells[c] + space) + (c + 1 < cells.size() ? "   " : "");
        }
        out += text.substr(0, text.find_last_not_of(' ') + 1) + '\n';
    };
    line(columns);
    for (const auto& row : rows) line(row);
    return out;
}

Report::Report(std::filesystem::path folder, std::string command)
    : folder_(std::move(folder)), command_(std::move(command)) {}

void Report::heading(const std::string& title) {
    std::cout << '\n' << title << '\n';
}

void Report::say(const std::string& line) {
    std::cout << "  " << line << '\n';
}

void Report::print(const Table& table) {
    std::cout << table.text();
}

void Report::number(const std::string& name, double value, const std::string& unit) {
    for (const auto& row : numbers_.rows)
        require(row[0] != name, "the number " + name + " is reported twice");
    numbers_.add({name, exact_digits(value), unit});
}

void Report::data(const std::string& file, const Table& table) {
    write_file(path(file), provenance(command_) + table.csv());
}

std::filesystem::path Report::path(const std::string& file) {
    if (std::find(files_.begin(), files_.end(), file) == files_.end()) files_.push_back(file);
    return folder_ / file;
}

void Report::finish() {
    data("numbers.csv", numbers_);
    std::cout << "\nWritten to " << folder_.string() << ":";
    for (const auto& file : files_) std::cout << ' ' << file;
    std::cout << '\n' << std::flush;
}

int program(int argc, char** argv, const std::string& name, const std::function<void(Report&)>& chapter) {
    std::filesystem::path folder = std::filesystem::path("out") / name;
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--out") == 0 && i + 1 < argc) {
            folder = argv[++i];
        } else {
            std::cerr << name << ": unknown argument '" << argv[i] << "'. Usage: " << name
                      << " [--out DIR]\n";
            return 2;
        }
    }
    try {
        write_file(folder / ".writable", "");  // an unwritable folder is found before the work, not after it
        std::filesystem::remove(folder / ".writable");
        Report report(folder, "./course run " + name.substr(1, 1));
        chapter(report);
        report.finish();
        return 0;
    } catch (const std::exception& problem) {
        std::cerr << name << ": " << problem.what() << '\n';
        return 1;
    }
}

}  // namespace nutshell::lab
