// Methods in sentences: a title or a caption takes a method's name from its value, as labels and keys do.
#pragma once
#include <cctype>
#include <nutshell/method.hpp>
#include <nutshell/require.hpp>
#include <string>
#include <string_view>

namespace nutshell {

/// The same words with a capital at the beginning.
inline std::string capital(std::string words) {
    if (!words.empty()) words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
    return words;
}

/// The words with each {} replaced by a method's name, in turn: phrase("{} past its limit", methods::verlet).
/// @throws std::invalid_argument unless there is one {} for each method
template <class... Methods>
std::string phrase(std::string words, const Methods&... methods) {
    std::size_t from = 0;
    for (const std::string_view name : {std::string_view(methods.name)...}) {
        const std::size_t at = words.find("{}", from);
        require(at != std::string::npos, "phrase: no {} left for " + std::string(name) + ": " + words);
        words.replace(at, 2, name);
        from = at + name.size();
    }
    require(words.find("{}", from) == std::string::npos, "phrase: a {} without a method: " + words);
    return words;
}

/// The same as a sentence or a title, with a capital at its beginning.
template <class... Methods>
std::string sentence(std::string words, const Methods&... methods) {
    return capital(phrase(std::move(words), methods...));
}

}  // namespace nutshell
