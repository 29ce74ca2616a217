#include "sheets.hpp"
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>
#include <regex>
#include <stdexcept>
#include "compiler.hpp"
#include "judge_config.hpp"
#include "product.hpp"
#include "text.hpp"

namespace nutshell::judge {

namespace fs = std::filesystem;

std::vector<std::string> Sheets::words_for(const std::vector<fs::path>& folders, bool optimised) const {
    auto words = compiler_words(rooms_, optimised);
    for (const auto& word : precompiled(rooms_, optimised)) words.push_back(word);
    for (const auto& folder : folders) words.push_back("-I" + folder.string());
    for (const auto& folder : chapter_folders(rooms_, chapter_.number))
        words.push_back("-I" + folder.string());
    words.push_back("-I" + (rooms_.course / "tests/judge").string());
    return words;
}

fs::path Sheets::questions(const std::string& name, const std::string& exercises, bool beyond) const {
    const fs::path file = overlay_.ahead->for_questions.string() + "_" + name + ".o",
                   list = file.string() + ".hpp";
    auto words = words_for({overlay_.ahead->for_questions}, true);
    words.push_back("-DNUTSHELL_EXERCISES=\"" + list.string() + "\"");
    if (!beyond) words.emplace_back("-DNUTSHELL_ESSENTIALS");
    words.insert(words.end(), {"-w", "-c", (rooms_.course / "tests/judge/sheet.cpp").string(), "-MMD", "-MF",
                               file.string() + ".d", "-o", file.string()});
    const Lock lock(rooms_.shared);
    write_if_changed(list, exercises);
    const Product product{file, words, {.wall_seconds = 300}};
    if (!product.is_fresh())
        if (const Ran ran = product.make(); ran.exit_code != 0)
            throw MachineFault("the questions could not be compiled:\n" + ran.err);
    return file;
}

Product Sheets::product(const std::vector<Number>& numbers, bool beyond, bool optimised) const {
    // only exercises of one sheet in one file, so that another set does not make this one stale
    std::string name = std::to_string(chapter_.number);
    if (numbers.size() != chapter_.exercises.size())
        for (const Number number : numbers) name += "_" + std::to_string(number.exercise);
    if (!beyond) name += "_essentials";
    const fs::path program =
        rooms_.work /
        ("sheet_" + name + (overlay_.folder.empty() ? "" : "_" + overlay_.folder.filename().string()));
    std::string exercises;
    for (const Number number : numbers)
        exercises += "#include \"" + questions_file(rooms_, chapter_, number).string() + "\"\n";

    std::vector<fs::path> folders;
    if (!overlay_.folder.empty()) folders.push_back(overlay_.folder);
    if (!overlay_.only) folders.push_back(rooms_.answers / chapter_.folder);
    if (overlay_.ahead) folders.push_back(overlay_.ahead->for_sheet);
    auto words = words_for(folders, optimised);
    std::vector<std::string> objects;
    if (overlay_.ahead && overlay_.ahead->can_be_asked_from_outside(numbers)) {
        objects.push_back(questions(name, exercises, beyond).string());
        const fs::path answers = program.string() + ".cpp";
        write_if_changed(answers, overlay_.ahead->headers_for(numbers));
        words.push_back(answers.string());
    } else {
        const fs::path list = program.string() + ".hpp";
        write_if_changed(list, exercises);
        words.push_back("-DNUTSHELL_EXERCISES=\"" + list.string() + "\"");
        if (!beyond) words.emplace_back("-DNUTSHELL_ESSENTIALS");
        words.push_back((rooms_.course / "tests/judge/sheet.cpp").string());
    }
    if (overlay_.ahead) objects.insert(objects.end(), {overlay_.ahead->bodies.string(), "-Wl,--gc-sections"});
    words.insert(words.end(),
                 {"-Wuninitialized", "-Wmaybe-uninitialized", "-Wunused-value", "-Wparentheses",
                  "-Wfloat-conversion", "-MMD", "-MF", program.string() + ".d", "-o", program.string()});
    for (const auto& object : objects) words.push_back(object);
    for (const auto& library : lines_of(CONFIG_LIBRARIES)) words.push_back(library);
    return {program,
            words,
            {.wall_seconds = 180, .cpu_seconds = 60, .memory = std::size_t{4} << 30, .printed = 1 << 20}};
}

Sheet Sheets::compile(const std::vector<Number>& numbers, bool beyond) const {
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
    Product made = product(numbers, budget == 0, budget == 0);
    made.command.emplace_back("-w");
    made.limits.printed = std::size_t{64} << 20;
    made.limits.cpu_seconds =
        budget > 0 ? static_cast<unsigned>(std::ceil(budget)) + 1 : 600;  // a herd is long
    made.limits.wall_seconds = 1200;
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
    for (const auto& folder : chapter_folders(rooms, chapter.number)) words.push_back("-I" + folder.string());
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
