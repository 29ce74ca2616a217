// Small things done with text and files.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace nutshell::judge {

std::string read_text(const std::filesystem::path& path);  ///< throws std::runtime_error if it cannot be read
/// Whole or not at all: written beside it, then renamed. Throws MachineFault with path and reason.
void write_text(const std::filesystem::path& path, std::string_view text);
void write_if_changed(const std::filesystem::path& path, std::string_view text);

std::vector<std::string> lines_of(std::string_view text);  ///< without their ends; CR LF counts as one end
std::string joined(const std::vector<std::string>& parts, std::string_view between);
std::string trimmed(std::string_view text);
std::string replaced(std::string text, std::string_view what, std::string_view with);
bool starts_with(std::string_view text, std::string_view start);
bool contains(std::string_view text, std::string_view part);

/// C++ source without comments, and with every run of white space as one space: what the compiler sees of it.
std::string bare_code(std::string_view source);
/// Whether `name` stands in `code` as a word of its own.
bool names(std::string_view code, std::string_view name);
/// Whether a function of this name is called in `code`.
bool calls(std::string_view code, std::string_view name);

/// Columns to fold at: those of the terminal, 100 at most, and 100 where there is none.
std::size_t text_width();
/// Words folded at `width` columns, each line after `indent`.
std::string folded(std::string_view words, std::size_t indent, std::size_t width = text_width());
/// The first lines of what a program printed, made safe to show: at most `most` lines and 100 columns.
std::vector<std::string> excerpt(std::string_view printed, std::size_t most = 5);

}  // namespace nutshell::judge
