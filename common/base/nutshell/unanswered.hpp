// What a body that is still to be written throws. ./course start puts it there; the judge knows it by its
// type.
#pragma once

namespace nutshell {

struct Unanswered {
    const char* exercise;  ///< its number, such as "1.3"
};

}  // namespace nutshell
