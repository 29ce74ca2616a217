// What a scene needs: the rule "model no more than a scene needs" as data.
#pragma once
#include <string>

namespace nutshell {

/// The largest error a scene bears, and why. Charts draw it as a line.
struct Need {
    double tolerance;    ///< in `unit`
    std::string unit;    ///< of the scene's error
    std::string reason;  ///< one phrase: "one pixel of the snapshot"
};

}  // namespace nutshell
