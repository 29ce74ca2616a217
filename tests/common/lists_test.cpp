// A method that a header names stands on a list there; the tests of orders and limits go through the lists.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include "check.hpp"

namespace {

/// The methods that a *_methods.hpp defines and that stand in no list (a std::tuple) of the same file.
std::vector<std::string> on_no_list(const std::string& text) {
    std::string lists;
    for (std::size_t at = 0; (at = text.find("constexpr std::tuple ", at)) != std::string::npos; ++at)
        lists += text.substr(at, text.find(';', at) - at);
    std::vector<std::string> missing;
    const std::regex value("inline constexpr Method (\\w+)\\{");
    for (std::sregex_iterator at(text.begin(), text.end(), value), end; at != end; ++at)
        if (!std::regex_search(lists, std::regex("methods::" + (*at)[1].str() + "\\b")))
            missing.push_back((*at)[1]);
    return missing;
}

}  // namespace

TEST_CASE("every method of every chapter stands on a list of its header") {
    int headers = 0;
    for (const auto& file : std::filesystem::recursive_directory_iterator(PROJECT_DIR "/chapters")) {
        const std::string name = file.path().filename().string();
        if (name.size() < 12 || name.substr(name.size() - 12) != "_methods.hpp") continue;
        std::ifstream stream(file.path());
        const std::string text{std::istreambuf_iterator<char>(stream), {}};
        if (text.find("inline constexpr Method ") == std::string::npos) continue;
        ++headers;
        INFO(file.path().string());
        CHECK(on_no_list(text) == std::vector<std::string>{});
    }
    CHECK(headers >= 4);
}

TEST_CASE("a method on no list is found") {
    CHECK(on_no_list("inline constexpr Method a{\"A\"};\ninline constexpr Method ab{\"B\"};\n"
                     "inline constexpr std::tuple all{methods::ab};\n") == std::vector<std::string>{"a"});
}
