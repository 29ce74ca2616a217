// What the sheet always needs, compiled once: most of a sheet's compile time is here.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <nutshell/require.hpp>
#include <nutshell/unanswered.hpp>
#include <nutshell/vector.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>
