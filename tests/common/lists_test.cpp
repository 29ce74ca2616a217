// A method that a header names stands on a list there; the tests of its chapter go through the list or name
// the method.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include "check.hpp"

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> found(const std::string& text, const char* pattern) {
    const std::regex wanted(pattern);
    std::vector<std::string> all;
    for (std::sregex_iterator at(text.begin(), text.end(), wanted), end; at != end; ++at)
        all.push_back((*at)[1]);
    return all;
}
std::vector<std::string> methods_in(const std::string& header) {
    return found(header, "inline constexpr Method (\\w+)\\{");
}

bool names(const std::string& text, const std::string& name) {
    return std::regex_search(text, std::regex("\\b" + name + "\\b"));
}

/// The methods that a *_methods.hpp defines and that stand in no list (a std::tuple) of the same file.
std::vector<std::string> on_no_list(const std::string& header) {
    std::string lists;
    for (std::size_t at = 0; (at = header.find("constexpr std::tuple ", at)) != std::string::npos; ++at)
        lists += header.substr(at, header.find(';', at) - at);
    std::vector<std::string> missing;
    for (const auto& method : methods_in(header))
        if (!names(lists, "methods::" + method)) missing.push_back(method);
    return missing;
}

/// Those that the tests of a chapter, one text, neither name nor reach by going through a list they stand on.
std::vector<std::string> in_no_test(const std::string& header, const std::string& tests) {
    std::string reached;
    for (std::size_t at = 0; (at = header.find("constexpr std::tuple ", at)) != std::string::npos; ++at) {
        const std::string list = header.substr(at, header.find(';', at) - at);
        if (names(tests, found(list, "std::tuple (\\w+)").at(0))) reached += list;
    }
    std::vector<std::string> missing;
    for (const auto& method : methods_in(header))
        if (!names(tests + reached, "methods::" + method)) missing.push_back(method);
    return missing;
}

/// All headers of chapters that define methods.
std::vector<fs::path> headers_of_methods() {
    std::vector<fs::path> all;
    for (const auto& file : fs::recursive_directory_iterator(PROJECT_DIR "/chapters")) {
        const std::string name = file.path().filename().string();
        if (name.size() >= 12 && name.substr(name.size() - 12) == "_methods.hpp" &&
            !methods_in(text_of(file.path())).empty())
            all.push_back(file.path());
    }
    return all;
}

}  // namespace

TEST_CASE("every method of every chapter stands on a list of its header, and its chapter's tests reach it") {
    const auto headers = headers_of_methods();
    CHECK(headers.size() >= 5);
    for (const auto& header : headers) {
        const fs::path chapter = header.parent_path().parent_path().filename();
        std::string tests;
        for (const auto& file : fs::directory_iterator(fs::path(PROJECT_DIR "/tests") / chapter))
            if (file.path().extension() == ".cpp") tests += text_of(file.path());
        INFO(header.string());
        CHECK(on_no_list(text_of(header)) == std::vector<std::string>{});
        CHECK(in_no_test(text_of(header), tests) == std::vector<std::string>{});
    }
}

TEST_CASE("a method on no list, and one in no test, is found") {
    const std::string header =
        "inline constexpr Method a{\"A\"};\ninline constexpr Method ab{\"B\"};\n"
        "inline constexpr std::tuple all{methods::ab};\n";
    CHECK(on_no_list(header) == std::vector<std::string>{"a"});
    CHECK(in_no_test(header, "each(all, check);") == std::vector<std::string>{"a"});
    CHECK(in_no_test(header, "check(methods::a);") == std::vector<std::string>{"ab"});
}
