#include "sheets.hpp"
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>
#include <regex>
#include <stdexcept>
#include "judge_config.hpp"
#include "product.hpp"
#include "text.hpp"

namespace nutshell::judge {

namespace fs = std::filesystem;

namespace {

/// The build's own flags, and the folders that no chapter owns.
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

/// What the sheet and the precompiled header have in common: the build's own flags, and the sheet's.
std::vector<std::string> compiler_words(const Rooms& rooms, bool optimised) {
    std::vector<std::string> words{CONFIG_COMPILER};
    for (const auto& flag : build_flags(rooms)) words.push_back(flag);
    for (const auto& flag : {optimised ? "-O1" : "-O0", "-fno-finite-loops", "-fdiagnostics-color=never",
                             "-DNUTSHELL_SHEET", "-DEIGEN_INITIALIZE_MATRICES_BY_NAN", "-Werror=return-type"})
        words.emplace_back(flag);
    return words;
}

/// The course's own folders up to this chapter.
std::vector<std::string> chapter_folders(const Rooms& rooms, int last) {
    std::vector<std::string> words;
    for (const Chapter& chapter : chapters_of(rooms))
        if (chapter.number <= last)
            words.push_back("-I" + (rooms.course / "chapters" / chapter.folder).string());
    return words;
}

fs::path precompiled(const Rooms& rooms, bool optimised) {
    return rooms.shared / (optimised ? "everywhere.hpp" : "everywhere_plain.hpp");
}

}  // namespace

bool Sheets::prepare(const Rooms& rooms, bool optimised) {
    const Lock lock(rooms.shared);
    const fs::path source = rooms.course / "tests/judge/everywhere.hpp";
    const fs::path header = precompiled(rooms, optimised);
    auto words = compiler_words(rooms, optimised);
    words.insert(words.end(), {"-x", "c++-header", source.string(), "-MMD", "-MF", header.string() + ".gch.d",
                               "-o", header.string() + ".gch"});
    const Product product{header.string() + ".gch", words, {.wall_seconds = 300}};
    if (product.is_fresh()) return false;
    // the compiler looks for the precompiled header beside a file of this name, and falls back to the file
    // itself
    write_text(header, "#include \"" + source.string() + "\"\n");
    const Ran ran = product.make();
    if (ran.exit_code != 0) throw MachineFault("the precompiled header could not be made:\n" + ran.err);
    return true;
}

Product Sheets::product(const std::vector<Number>& numbers, bool beyond, bool optimised) const {
    // only exercises of one sheet in one file, so that another set does not make this one stale
    std::string name = std::to_string(chapter_.number);
    if (numbers.size() != chapter_.exercises.size())
        for (const Number number : numbers) name += "_" + std::to_string(number.exercise);
    if (!beyond) name += "_essentials";
    if (!overlay_.empty()) name += "_" + overlay_.filename().string();
    const fs::path list = rooms_.work / ("sheet_" + name + ".hpp"), program = rooms_.work / ("sheet_" + name);
    std::string text;
    for (const Number number : numbers)
        text += "#include \"" + questions_file(rooms_, chapter_, number).string() + "\"\n";
    write_if_changed(list, text);

    auto words = compiler_words(rooms_, optimised);
    words.insert(words.end(), {"-include", precompiled(rooms_, optimised).string(),
                               "-DNUTSHELL_EXERCISES=\"" + list.string() + "\""});
    if (!beyond) words.emplace_back("-DNUTSHELL_ESSENTIALS");
    if (!overlay_.empty()) words.push_back("-I" + overlay_.string());
    if (!overlay_only_) words.push_back("-I" + (rooms_.answers / chapter_.folder).string());
    for (const auto& folder : chapter_folders(rooms_, chapter_.number)) words.push_back(folder);
    words.push_back("-I" + (rooms_.course / "tests/judge").string());
    for (const auto* warning : {"-Wuninitialized", "-Wmaybe-uninitialized", "-Wunused-value", "-Wparentheses",
                                "-Wfloat-conversion"})
        words.emplace_back(warning);
    words.insert(words.end(), {(rooms_.course / "tests/judge/sheet.cpp").string(), "-MMD", "-MF",
                               program.string() + ".d", "-o", program.string()});
    for (const auto& library : lines_of(CONFIG_LIBRARIES)) words.push_back(library);
    return {program,
            words,
            {.wall_seconds = 180, .cpu_seconds = 60, .memory = std::size_t{4} << 30, .printed = 1 << 20}};
}

Sheet Sheets::compile(const std::vector<Number>& numbers, bool beyond) const {
    prepare(rooms_);
    const Product made = product(numbers, beyond);
    Sheet sheet{made.file, {}, {}, false};
    const fs::path said = made.file.string() + ".said";
    if (!made.is_fresh()) {
        Ran ran = made.make();
        if (contains(ran.err, "internal compiler error")) ran = made.make();  // by chance?
        sheet.compiled = true;
        write_text(said, ran.err);
        if (ran.exit_code != 0) {
            const bool no_end = ran.out_of_time || contains(ran.err, "CPU time limit exceeded") ||
                                contains(ran.err, "out of memory");
            sheet.problem = explain(no_end ? "" : ran.err, numbers);
            return sheet;
        }
    }
    static const std::regex warning(R"(^(.{0,500}?):(\d+):\d+: warning: (.{0,300}?)( \[-W(.*)\])?$)");
    std::smatch found;
    for (const auto& line : lines_of(read_text(said)))
        if (line.size() < 1000 && std::regex_match(line, found, warning) &&
            starts_with(found[1].str(), rooms_.answers.string()))
            sheet.warnings.push_back(
                {fs::path(found[1].str()).filename().string() + ":" + found[2].str(), found[3], found[5]});
    sheet.sources = made.sources();
    return sheet;
}

Ran Sheets::compile_quietly(const std::vector<Number>& numbers, Sheet& sheet, double budget) const {
    prepare(rooms_, budget == 0);
    Product made = product(numbers, budget == 0, budget == 0);
    made.command.emplace_back("-w");
    made.limits.printed = std::size_t{64} << 20;
    if (budget > 0) made.limits.cpu_seconds = static_cast<unsigned>(std::ceil(budget)) + 1;
    sheet.program = made.file;
    return made.make();
}

SheetAnswer Sheets::ask(const Sheet& sheet, Number number, unsigned cpu_seconds) const {
    SheetAnswer answer;
    std::random_device device;
    std::string secret(8, '\0');
    for (char& byte : secret) byte = static_cast<char>(device());
    answer.ran = run({sheet.program.string(), number.text(), std::to_string(pipe_number)},
                     {.wall_seconds = 5,
                      .cpu_seconds = cpu_seconds,
                      .memory = std::size_t{256} << 20,
                      .reply = secret,
                      .caged = true});
    const std::string& bytes = answer.ran.pipe;
    constexpr std::size_t head = 1 + 8 + 4;
    for (std::size_t at = 1; at + head <= bytes.size();) {  // after the one that says it is ready
        std::uint32_t length;
        std::memcpy(&length, bytes.data() + at + 9, sizeof length);
        const char letter = bytes[at];
        if (bytes.compare(at + 1, 8, secret) != 0 || at + head + length > bytes.size()) break;
        const std::string data = bytes.substr(at + head, length);
        at += head + length;
        if (letter == 'v' || letter == 'w') {
            std::vector<double> values(length / sizeof(double));
            if (!values.empty()) std::memcpy(values.data(), data.data(), values.size() * sizeof(double));
            (letter == 'v' ? answer.outputs : answer.once_more).push_back(std::move(values));
        } else if (letter == 'u') {
            answer.unanswered = number_of(data);
        } else if (letter == 'x') {
            answer.threw = data;
        } else if (letter == 'e') {
            answer.ended = answer.ran.exit_code == 0;
        }
    }
    return answer;
}

Sheet Sheets::compile_for_debugging(Number number) const {
    prepare(rooms_);
    Product made = product({number}, true);
    made.file += "_debug";
    for (std::string& word : made.command) {
        if (word == "-O1") word = "-O0";  // the precompiled header does not fit, and is read as it is
        if (word == made.file.string().substr(0, made.file.string().size() - 6) + ".d")
            word = made.file.string() + ".d";
    }
    *std::find(made.command.begin(), made.command.end(),
               made.file.string().substr(0, made.file.string().size() - 6)) = made.file.string();
    made.command.emplace_back("-g");
    Sheet sheet{made.file, {}, {}, false};
    if (const Ran ran = made.make(); ran.exit_code != 0) sheet.problem = explain(ran.err, {number});
    return sheet;
}

std::vector<std::string> editor_flags(const Rooms& rooms, const Chapter& chapter) {
    std::vector<std::string> words{"-xc++"};
    for (const auto& flag : build_flags(rooms)) words.push_back(flag);
    words.push_back("-I" + (rooms.answers / chapter.folder).string());
    for (const auto& folder : chapter_folders(rooms, chapter.number)) words.push_back(folder);
    words.emplace_back("-Wno-pragma-once-outside-header");
    return words;
}

bool remembers(const SheetAnswer& answer) {
    for (std::size_t i = 0; i < answer.once_more.size() && i < answer.outputs.size(); ++i) {
        const auto &before = answer.outputs[i], &now = answer.once_more[i];
        if (before.size() != now.size() ||
            std::memcmp(before.data(), now.data(), before.size() * sizeof(double)) != 0)
            return true;
    }
    return false;
}

}  // namespace nutshell::judge
