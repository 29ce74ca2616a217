#include "compiler.hpp"
#include <algorithm>
#include "judge_config.hpp"
#include "product.hpp"
#include "text.hpp"

namespace nutshell::judge {

namespace fs = std::filesystem;

std::vector<std::string> build_flags(const Rooms& rooms) {
    std::vector<std::string> words;
    for (const auto& flag : lines_of(CONFIG_FLAGS)) words.push_back(flag);
    const auto system = lines_of(CONFIG_SYSTEM_FOLDERS);
    for (const auto& folder : system) words.insert(words.end(), {"-isystem", folder});
    const std::string chapters = (rooms.course / "chapters" / "").string();
    for (const auto& folder : lines_of(CONFIG_FOLDERS))
        if (!starts_with(folder, chapters) && std::find(system.begin(), system.end(), folder) == system.end())
            words.push_back("-I" + folder);
    return words;
}

std::vector<std::string> compiler_words(const Rooms& rooms, bool optimised) {
    std::vector<std::string> words{CONFIG_COMPILER};
    for (const auto& flag : build_flags(rooms)) words.push_back(flag);
    for (const auto& flag : lines_of(CONFIG_QUICK)) words.push_back(flag);
    for (const auto& flag : {optimised ? "-O1" : "-O0", "-fno-finite-loops", "-fdiagnostics-color=never",
                             "-DNUTSHELL_SHEET", "-DEIGEN_INITIALIZE_MATRICES_BY_NAN", "-Werror=return-type"})
        words.emplace_back(flag);
    return words;
}

std::vector<std::string> precompiled(const Rooms& rooms, bool optimised) {
    const Lock lock(rooms.shared);
    const fs::path source = rooms.course / "tests/judge/everywhere.hpp";
    const fs::path header = rooms.shared / (optimised ? "everywhere.hpp" : "everywhere_plain.hpp");
    auto words = compiler_words(rooms, optimised);
    words.insert(words.end(), {"-x", "c++-header", source.string(), "-MMD", "-MF", header.string() + ".gch.d",
                               "-o", header.string() + ".gch"});
    const Product product{header.string() + ".gch", words, {.wall_seconds = 300}};
    if (!product.is_fresh()) {
        // the compiler looks for the precompiled header beside a file of this name, and falls back to the
        // file itself
        write_text(header, "#include \"" + source.string() + "\"\n");
        const Ran ran = product.make();
        if (ran.exit_code != 0) throw MachineFault("the precompiled header could not be made:\n" + ran.err);
    }
    return {"-include", header.string()};
}

}  // namespace nutshell::judge
