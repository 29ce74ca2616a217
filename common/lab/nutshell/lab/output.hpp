// Where a chapter's program puts its results: files that are whole or absent, and numbers the book can quote.
#pragma once
#include <filesystem>
#include <nutshell/lab/table.hpp>
#include <nutshell/write_file.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace nutshell::chart {
struct Chart;
}

namespace nutshell::lab {

/// Machine, compiler and command, one `# key: value` line each: the first lines of every data file.
std::string provenance(const std::string& command);

/// A chapter's results: prints as it goes, collects the numbers of the book, writes files into one folder.
class Report {
  public:
    /// @param folder  made if missing       @param command  what was typed, for the provenance
    Report(std::filesystem::path folder, std::string command);

    void heading(const std::string& title);  ///< a new part of the printed report
    void say(const std::string& line);       ///< one printed line
    void print(const Table& table);          ///< a table, indented
    /// Keeps a number for numbers.csv, where the book finds it as NN_name/`name`. Prints nothing. One that no
    /// page quotes is listed by `book/build.sh --unquoted`, unless `shown` says which chart or table has it.
    void number(const std::string& name, double value, const std::string& unit = "",
                const std::string& shown = "");
    template <std::integral Whole>
    void number(const std::string& name, Whole value, const std::string& unit = "",
                const std::string& shown = "") {
        number(name, static_cast<double>(value), unit, shown);
    }
    void data(const std::string& file, const Table& table);  ///< writes a CSV with provenance on top
    /// Writes KEY.svg, and its points as KEY.csv: series, x, y.
    void draw(const std::string& key, const chart::Chart& chart);
    /// The path of a result of this name, listed at the end; pictures and charts are written there by their
    /// own functions.
    std::filesystem::path path(const std::string& file);
    const std::string& command() const { return command_; }
    void finish();  ///< writes numbers.csv and lists what was written

  private:
    std::filesystem::path folder_;
    std::string command_;
    Table numbers_{{"name", "value", "unit", "shown"}, {}};
    std::set<std::string> names_;
    std::vector<std::string> files_;
};

}  // namespace nutshell::lab
