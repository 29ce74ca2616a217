// Text that holds some pieces in their order.
#pragma once
#include <string>
#include <vector>
#include "check.hpp"

namespace book_test {

/// CHECKs that the pieces stand in `text`, in this order.
inline void check_in_order(const std::string& text, const std::vector<std::string>& pieces) {
    std::size_t from = 0;
    for (const std::string& piece : pieces) {
        const std::size_t at = text.find(piece, from);
        INFO("looking for: " << piece << "\nafter: " << text.substr(from, 600));
        CHECK(at != std::string::npos);
        if (at != std::string::npos) from = at + piece.size();
    }
}

}  // namespace book_test
