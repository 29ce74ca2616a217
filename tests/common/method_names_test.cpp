// A method's name is written once, in its value: no text of a chapter's program or live figure repeats it.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nutshell/newton_methods.hpp>
#include <nutshell/sentence.hpp>
#include <regex>
#include "check.hpp"

using namespace nutshell;

namespace {

namespace fs = std::filesystem;

/// "as printed" says of anything in the course that it follows the source, not only of the way to bounce.
const std::vector<std::string> plain_words{"as printed"};

std::string text_of(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// The strings of a C++ text; comments, included files and single characters are none.
std::vector<std::string> strings_of(const std::string& text) {
    static const std::regex token(R"re(//.*|#include.*|\d[\d']*|'(?:[^'\\]|\\.)+'|"((?:[^"\\]|\\.)*)")re");
    std::vector<std::string> all;
    for (std::sregex_iterator at(text.begin(), text.end(), token), end; at != end; ++at)
        if ((*at)[1].matched) all.push_back((*at)[1]);
    return all;
}

/// The names of the methods that a header defines, and the same as keys.
std::vector<std::string> names_in(const std::string& header) {
    static const std::regex value(R"re(constexpr Method \w+\{\s*"([^"]+)")re");
    std::vector<std::string> all;
    for (std::sregex_iterator at(header.begin(), header.end(), value), end; at != end; ++at)
        if (std::find(plain_words.begin(), plain_words.end(), (*at)[1]) == plain_words.end())
            all.push_back((*at)[1]), all.push_back(key_of(all.back()));
    return all;
}

std::string lower(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

/// Whether `words` hold the name, large or small, as words of their own or with an s: "Both Eulers".
bool holds(const std::string& words, const std::string& name) {
    const std::string in = lower(words), wanted = lower(name);
    const auto part_of_a_word = [&](std::size_t i) {
        return i < in.size() && (std::isalnum(static_cast<unsigned char>(in[i])) || in[i] == '_');
    };
    for (std::size_t at = 0; (at = in.find(wanted, at)) != std::string::npos; ++at) {
        std::size_t after = at + wanted.size();
        if (after < in.size() && in[after] == 's') ++after;
        if ((at == 0 || !part_of_a_word(at - 1)) && !part_of_a_word(after)) return true;
    }
    return false;
}

/// The strings of a program that hold one of the names.
std::vector<std::string> repeated(const std::string& program, const std::vector<std::string>& names) {
    std::vector<std::string> found;
    for (const std::string& words : strings_of(program))
        if (std::any_of(names.begin(), names.end(), [&](const auto& name) { return holds(words, name); }))
            found.push_back(words);
    return found;
}

std::vector<fs::path> sources(const fs::path& folder) {
    std::vector<fs::path> found;
    if (!fs::exists(folder)) return found;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".hpp" || entry.path().extension() == ".cpp")
            found.push_back(entry.path());
    return found;
}

}  // namespace

TEST_CASE("no text of a chapter's program or live figure repeats a method's name") {
    std::vector<fs::path> chapters;
    for (const auto& entry : fs::directory_iterator(PROJECT_DIR "/chapters"))
        if (entry.is_directory()) chapters.push_back(entry.path());
    std::sort(chapters.begin(), chapters.end());
    std::vector<std::string> names;  // of this chapter and those before it
    for (const fs::path& chapter : chapters) {
        for (const fs::path& header : sources(chapter / "nutshell"))
            for (const std::string& name : names_in(text_of(header))) names.push_back(name);
        for (const fs::path& folder : {chapter, chapter / "live"})
            for (const fs::path& file : sources(folder)) {
                INFO(file.string() << ": write phrase(\"... {} ...\", methods::...), method.name or "
                                      "method.key() instead");
                CHECK(repeated(text_of(file), names) == std::vector<std::string>{});
            }
    }
    CHECK(names.size() >= 60);  // two of each
}

TEST_CASE("a method's name in a text is found, in a comment or a longer word it is not") {
    const auto names = names_in("inline constexpr Method euler{\"Euler\",\n");
    REQUIRE(names == std::vector<std::string>{"Euler", "euler"});
    const auto found = [&](const std::string& program) { return repeated(program, names); };
    for (const char* words : {"Euler", "Euler's ball", "Both Eulers", "body-frame euler", "drop.euler.K"})
        CHECK(found(std::string("long n = 1'000'000;  // \"\nsay(\"") + words + "\", 'c');") ==
              std::vector<std::string>{words});
    CHECK(found("x = \"\\\"Euler\\\"\";").size() == 1);
    CHECK(found("// \"Euler\"\n#include \"euler.hpp\"\ncall(euler, \"Eulerian\", \"euler_step\");").empty());
}

TEST_CASE("phrase puts methods' names into words, sentence begins with a capital") {
    const Method divided{"exponential {}", {}, 1, 1, 0};  // a name is not looked through
    CHECK(phrase("{} past its limit", methods::verlet) == "Verlet past its limit");
    CHECK(sentence("{} and {}", methods::semi_implicit_euler, divided) ==
          "Semi-implicit Euler and exponential {}");
    CHECK(capital("") == "");
    CHECK_THROWS_WITH(phrase("no place", methods::euler), ContainsSubstring("no {} left for Euler"));
    CHECK_THROWS_WITH(phrase("{} and {}", methods::euler), ContainsSubstring("a {} without a method"));
}
