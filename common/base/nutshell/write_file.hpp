// Files that are whole or absent.
#pragma once
#include <filesystem>
#include <string_view>

namespace nutshell {

/// Writes `text` to `path`: to a temporary file beside it first, then renamed, so a reader never meets half a
/// file. Makes the folder if it is missing. @throws std::runtime_error with the path and the reason if it
/// cannot be written
void write_file(const std::filesystem::path& path, std::string_view text);

}  // namespace nutshell
