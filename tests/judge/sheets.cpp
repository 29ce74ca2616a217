#include "sheets.hpp"
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <regex>
#include <stdexcept>
#include <utility>
#include "judge_config.hpp"
#include "text.hpp"

namespace nutshell::judge {

namespace fs = std::filesystem;

namespace {

/// A program made by a command out of files: made again when the command or one of the files has changed.
struct Product {
    fs::path file;
    std::vector<std::string>
        command;  ///< writes the names of what it read to file + ".d", as make likes them
    Limits limits;

    bool is_fresh() const {
        std::error_code problem;
        const auto made = fs::last_write_time(note(), problem);  // when its making began
        if (problem || !fs::exists(file) || read_text(note()) != joined(command, "\n")) return false;
        for (const fs::path& source : sources()) {
            const auto changed = fs::last_write_time(source, problem);
            if (problem || changed >= made) return false;
        }
        return true;
    }
    Ran make() const {
        fs::create_directories(file.parent_path());
        std::error_code ignored;
        fs::remove(file, ignored);
        write_text(note(),
                   joined(command, "\n"));  // before: what is saved while it is compiled makes it stale again
        return run(command, limits);
    }

  private:
    fs::path note() const { return file.string() + ".command"; }
    std::vector<fs::path> sources() const {
        std::vector<fs::path> all;
        std::error_code problem;
        const fs::path list = file.string() + ".d";
        if (!fs::exists(list, problem)) return {list};  // unknown: not fresh
        std::string text = replaced(read_text(list), "\\\n", " "), word;
        for (std::size_t i = text.find(": ") + 1; i < text.size(); ++i) {
            if (text[i] == '\\' && i + 1 < text.size())
                word += text[++i];
            else if (text[i] != ' ' && text[i] != '\n')
                word += text[i];
            else if (!word.empty())
                all.emplace_back(std::exchange(word, ""));
        }
        return all;
    }
};

/// What the sheet and the precompiled header have in common.
std::vector<std::string> compiler_words(const Rooms& rooms) {
    std::vector<std::string> words{CONFIG_COMPILER};
    for (const auto& flag : {"-std=c++20", "-O1", "-fno-finite-loops", "-ffp-contract=off",
                             "-fdiagnostics-color=never", "-DEIGEN_DONT_VECTORIZE",
                             "-DEIGEN_INITIALIZE_MATRICES_BY_NAN", "-DNUTSHELL_SHEET", "-Werror=return-type"})
        words.emplace_back(flag);
    for (const auto& folder : lines_of(CONFIG_EIGEN_FOLDERS)) words.insert(words.end(), {"-isystem", folder});
    for (const char* room : {"common/base", "common/math"})
        words.push_back("-I" + (rooms.course / room).string());
    return words;
}

fs::path precompiled(const Rooms& rooms) {
    return rooms.shared / "everywhere.hpp";
}

}  // namespace

bool Sheets::prepare(const Rooms& rooms) {
    const Lock lock(rooms.shared);
    const fs::path source = rooms.course / "tests/judge/everywhere.hpp";
    auto words = compiler_words(rooms);
    words.insert(words.end(),
                 {"-x", "c++-header", source.string(), "-MMD", "-MF", precompiled(rooms).string() + ".gch.d",
                  "-o", precompiled(rooms).string() + ".gch"});
    const Product product{precompiled(rooms).string() + ".gch", words, {.wall_seconds = 300}};
    if (product.is_fresh()) return false;
    // the compiler looks for the precompiled header beside a file of this name, and falls back to the file
    // itself
    write_text(precompiled(rooms), "#include \"" + source.string() + "\"\n");
    const Ran ran = product.make();
    if (ran.exit_code != 0) throw std::runtime_error("the precompiled header could not be made:\n" + ran.err);
    return true;
}

Sheet Sheets::compile(const std::vector<Number>& numbers, bool one_state) const {
    prepare(rooms_);
    // only exercises of one sheet in one file, so that another set does not make this one stale
    std::string name = std::to_string(chapter_.number);
    if (numbers.size() != chapter_.exercises.size())
        for (const Number number : numbers) name += "_" + std::to_string(number.exercise);
    if (one_state) name += "_one_state";
    if (!overlay_.empty()) name += "_overlay";
    const fs::path list = rooms_.work / ("sheet_" + name + ".hpp"), program = rooms_.work / ("sheet_" + name);
    std::string text;
    for (const Number number : numbers)
        text += "#include \"" + questions_file(rooms_, chapter_, number).string() + "\"\n";
    if (!fs::exists(list) || read_text(list) != text) write_text(list, text);

    auto words = compiler_words(rooms_);
    words.insert(words.end(), {"-include", precompiled(rooms_).string(),
                               "-DNUTSHELL_EXERCISES=\"" + list.string() + "\""});
    if (one_state) words.emplace_back("-DNUTSHELL_ONE_STATE");
    if (!overlay_.empty()) words.push_back("-I" + overlay_.string());
    words.push_back("-I" + (rooms_.answers / chapter_.folder).string());
    for (const Chapter& chapter : chapters_of(rooms_))
        if (chapter.number <= chapter_.number)
            words.push_back("-I" + (rooms_.course / "chapters" / chapter.folder).string());
    words.push_back("-I" + (rooms_.course / "tests/judge").string());
    words.insert(words.end(),
                 {"-Wuninitialized", "-Wmaybe-uninitialized", "-Wunused-value", "-Wparentheses"});
    words.insert(words.end(), {(rooms_.course / "tests/judge/sheet.cpp").string(), "-MMD", "-MF",
                               program.string() + ".d", "-o", program.string()});

    Sheet sheet{program, {}, {}, false};
    const fs::path said = program.string() + ".said";
    const Product product{
        program,
        words,
        {.wall_seconds = 60, .cpu_seconds = 60, .memory = std::size_t{4} << 30, .printed = 1 << 20}};
    if (!product.is_fresh()) {
        const Ran ran = product.make();
        sheet.compiled = true;
        write_text(said, ran.err);
        if (ran.exit_code != 0) {
            sheet.problem = explain(ran.out_of_time || ran.signal ? "" : ran.err, numbers);
            return sheet;
        }
    }
    static const std::regex warning(R"(^(.*):(\d+):\d+: warning: (.*?)( \[-W.*\])?$)");
    std::smatch found;
    for (const auto& line : lines_of(read_text(said)))
        if (std::regex_match(line, found, warning) && starts_with(found[1].str(), rooms_.answers.string()))
            sheet.warnings.push_back(fs::path(found[1].str()).filename().string() + ":" + found[2].str() +
                                     ": " + found[3].str());
    return sheet;
}

SheetAnswer Sheets::ask(const Sheet& sheet, Number number) const {
    SheetAnswer answer;
    answer.ran = run({sheet.program.string(), number.text(), std::to_string(pipe_number)},
                     {.wall_seconds = 5, .cpu_seconds = 2, .memory = std::size_t{256} << 20});
    const std::string& bytes = answer.ran.pipe;
    for (std::size_t at = 0; at + 5 <= bytes.size();) {
        std::uint32_t length;
        std::memcpy(&length, bytes.data() + at + 1, sizeof length);
        const char letter = bytes[at];
        at += 5;
        if (at + length > bytes.size()) break;
        const std::string data = bytes.substr(at, length);
        at += length;
        if (letter == 'v') {
            std::vector<double> values(length / sizeof(double));
            if (!values.empty()) std::memcpy(values.data(), data.data(), values.size() * sizeof(double));
            answer.outputs.push_back(std::move(values));
        } else if (letter == 'u') {
            answer.unanswered = number_of(data);
        } else if (letter == 'x') {
            answer.threw = data;
        } else if (letter == 'e') {
            answer.ended = true;
        }
    }
    return answer;
}

}  // namespace nutshell::judge
