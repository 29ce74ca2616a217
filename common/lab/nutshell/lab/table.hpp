// Tables: one list of typed cells, rounded for the eye, exact as data.
#pragma once
#include <concepts>
#include <string>
#include <variant>
#include <vector>

namespace nutshell::lab {

/// A number with as many digits as it needs to be read back exactly.
std::string exact_digits(double value);

/// A number for the eye: printf's format, "%.3g" unless said.
std::string rounded(double value, const char* format = "%.3g");

/// What stands in one place of a table: words, a whole number or a number.
class Cell {
  public:
    Cell(std::string words = {}) : value_(std::move(words)) {}
    Cell(const char* words) : value_(std::string(words)) {}
    Cell(double number) : value_(number) {}
    template <std::integral Whole>
    Cell(Whole number) : value_(static_cast<long>(number)) {}

    std::string shown(const char* format) const;  ///< for the eye; a number that is none is "-"
    std::string exact() const;                    ///< for data: with all its digits
    bool is_number() const { return !std::holds_alternative<std::string>(value_); }

  private:
    std::variant<std::string, long, double> value_;
};

/// A column: its name, with the unit, and how its numbers are rounded for the eye.
struct Column {
    std::string name;
    const char* format;
    Column(std::string words, const char* numbers = "%.3g") : name(std::move(words)), format(numbers) {}
    Column(const char* words, const char* numbers = "%.3g") : name(words), format(numbers) {}
};

/// Printed with its numbers rounded as their column says, or written as CSV with all their digits.
struct Table {
    std::vector<Column> columns;
    std::vector<std::vector<Cell>> rows;

    void add(std::vector<Cell> cells);  ///< a row
    template <class Words>
    requires std::same_as<Words, std::vector<std::string>>
    void add(const Words& words) { add(std::vector<Cell>(words.begin(), words.end())); }
    std::string csv() const;   ///< cells quoted where they need it
    std::string text() const;  ///< columns aligned for the terminal, numbers to the right
};

}  // namespace nutshell::lab
