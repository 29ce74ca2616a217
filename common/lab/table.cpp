#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <nutshell/lab/table.hpp>
#include <nutshell/require.hpp>

namespace nutshell::lab {

namespace {

std::size_t width(const std::string& text) {  // in characters, not bytes
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

bool looks_like_a_number(const std::string& text) {
    return !text.empty() && text.find_first_not_of("0123456789+-.,einfa x%") == std::string::npos &&
           text.find_first_of("0123456789") != std::string::npos;
}

std::string quoted(std::string cell) {
    if (cell.find_first_of(",\"\n") == std::string::npos) return cell;
    for (std::size_t at = 0; (at = cell.find('"', at)) != std::string::npos; at += 2) cell.insert(at, 1, '"');
    return '"' + cell + '"';
}

}  // namespace

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

std::string Cell::shown(const char* format) const {
    const double* number = std::get_if<double>(&value_);
    if (!number) return exact();
    return std::isnan(*number) ? "-" : rounded(*number, format);
}

std::string Cell::exact() const {
    if (const auto* words = std::get_if<std::string>(&value_)) return *words;
    if (const long* whole = std::get_if<long>(&value_)) return std::to_string(*whole);
    return exact_digits(std::get<double>(value_));
}

void Table::add(std::vector<Cell> cells) {
    require(cells.size() == columns.size(), "a row of " + std::to_string(cells.size()) +
                                                " cells in a table of " + std::to_string(columns.size()) +
                                                " columns");
    rows.push_back(std::move(cells));
}

std::string Table::csv() const {
    std::string out;
    for (std::size_t c = 0; c < columns.size(); ++c) out += (c ? "," : "") + quoted(columns[c].name);
    out += '\n';
    for (const auto& row : rows) {
        for (std::size_t c = 0; c < row.size(); ++c) out += (c ? "," : "") + quoted(row[c].exact());
        out += '\n';
    }
    return out;
}

std::string Table::text() const {
    std::vector<std::string> lines(rows.size() + 1, "  ");
    for (std::size_t c = 0; c < columns.size(); ++c) {
        std::vector<std::string> cells{columns[c].name};
        bool numbers = true;
        for (const auto& row : rows) {
            cells.push_back(row[c].shown(columns[c].format));
            numbers =
                numbers && (row[c].is_number() || cells.back().empty() || looks_like_a_number(cells.back()));
        }
        std::size_t widest = 0;
        for (const auto& cell : cells) widest = std::max(widest, width(cell));
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const std::string space(widest - width(cells[i]), ' ');
            lines[i] += (c ? "   " : "") + (numbers ? space + cells[i] : cells[i] + space);
        }
    }
    std::string out;
    for (const auto& line : lines) out += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
    return out;
}

}  // namespace nutshell::lab
