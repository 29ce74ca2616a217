// obj_replay CORPUS RUNS: every file of the corpus, then RUNS mutations of them, always the same ones.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

int outcome(std::string_view text);  // obj_target.cpp

namespace {

/// Numbers without a library's randomness: the same on every machine. Source: G. Marsaglia, 2003.
struct Numbers {
    std::uint64_t state = 88172645463325252u;
    std::size_t below(std::size_t bound) {
        state ^= state << 13, state ^= state >> 7, state ^= state << 17;
        return bound == 0 ? 0 : static_cast<std::size_t>(state % bound);
    }
};

const std::vector<std::string> pieces = {
    "v ",     "f ",    "vt ", "vn ", "/",    "//", "-1", "0",  "99999999999",
    "1e308",  "-1e31", "nan", "\n",  "\r\n", " ",  "#",  "\\", std::string(1, '\0'),
    "1e-320", "+",     "."};

void mutate(std::string& text, const std::vector<std::string>& corpus, Numbers& next) {
    const std::size_t at = next.below(text.size() + 1),
                      length = next.below(std::min<std::size_t>(40, text.size() - at) + 1);
    switch (next.below(6)) {
        case 0:
            text.erase(at, length);
            break;
        case 1:
            text.insert(at, pieces[next.below(pieces.size())]);
            break;
        case 2:
            if (at < text.size()) text[at] = static_cast<char>(next.below(256));
            break;
        case 3:
            text.insert(at, text.substr(next.below(text.size() + 1), length));
            break;
        case 4:
            text.replace(at, length, pieces[next.below(pieces.size())]);
            break;
        default: {
            const std::string& other = corpus[next.below(corpus.size())];
            text = text.substr(0, at) + other.substr(next.below(other.size() + 1));
        }
    }
    text.resize(std::min<std::size_t>(text.size(), 4000));
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) return std::fprintf(stderr, "obj_replay CORPUS RUNS\n"), 2;
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(argv[1])) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<std::string> corpus;
    long count[3] = {0, 0, 0};
    for (const auto& path : files) {
        std::ifstream file(path, std::ios::binary);
        corpus.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
        ++count[outcome(corpus.back())];
    }
    if (corpus.empty()) return std::fprintf(stderr, "obj_replay: %s is empty\n", argv[1]), 1;
    std::printf("%zu files: %ld refused, %ld no body, %ld bodies\n", corpus.size(), count[0], count[1],
                count[2]);
    Numbers next;
    const long runs = std::atol(argv[2]);
    for (long run = 0; run < runs; ++run) {
        std::string text = corpus[next.below(corpus.size())];
        for (std::size_t times = 1 + next.below(4); times > 0; --times) mutate(text, corpus, next);
        ++count[outcome(text)];
    }
    std::printf("%ld mutations more: %ld refused, %ld no body, %ld bodies\n", runs, count[0], count[1],
                count[2]);
    // A run that only ever meets one of the three has tested nothing.
    return count[0] > 0 && count[1] > 0 && count[2] > 0 ? 0 : 1;
}
