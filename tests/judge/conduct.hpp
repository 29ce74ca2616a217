// How an answer behaved while it was asked: crashes, loops without end, prints.
#pragma once
#include <string>
#include "record.hpp"
#include "sheets.hpp"

namespace nutshell::judge {

/// What kept an answer from its end; no name if nothing did.
struct Conduct {
    std::string name;   ///< "endless loop": for the table
    std::string words;  ///< ready to print, with the input it was at
};
Conduct conduct_of(const SheetAnswer& answer, const exercises::Record& reference);

/// The first lines of what it printed, ready to print; empty if it printed nothing.
std::string quote_printed(const Ran& ran);

}  // namespace nutshell::judge
