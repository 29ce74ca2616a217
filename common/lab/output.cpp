#include <unistd.h>
#include <algorithm>
#include <cstring>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <nutshell/chart/beside.hpp>
#include <nutshell/chart/chart.hpp>
#include <nutshell/lab/parts.hpp>
#include <nutshell/lab/touched.hpp>
#include <nutshell/require.hpp>
#include <sstream>
#include <utility>

namespace nutshell::lab {

namespace {

std::string processor_name() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
    return "unknown processor";
}

std::string compiler_name() {
#if defined(__clang__)
    return "clang " __clang_version__;
#else
    return "g++ " __VERSION__;
#endif
}

}  // namespace

std::string provenance(const std::string& command) {
    return "# command: " + command + "\n# machine: " + processor_name() + "\n# compiler: " + compiler_name() +
           "\n";
}

Report::Report(std::filesystem::path folder, std::string command)
    : folder_(std::move(folder)), command_(std::move(command)) {}

void Report::heading(const std::string& title) {
    std::cout << '\n' << title << '\n';
}

void Report::say(const std::string& line) {
    std::cout << "  " << line << '\n';
}

void Report::print(const Table& table) {
    std::cout << table.text();
}

void Report::number(const std::string& name, double value, const std::string& unit,
                    const std::string& shown) {
    require(names_.insert(name).second, "the number " + name + " is reported twice");
    numbers_.add({name, value, unit, shown});
}

void Report::data(const std::string& file, const Table& table) {
    write_file(path(file), provenance(command_) + table.csv());
}

void Report::draw(const std::string& key, const chart::Chart& chart) {
    chart::write_svg(chart, path(key + ".svg"));
    Table points{{"series", chart.x.name, chart.y.name}, {}};
    for (const auto& series : chart.series)
        for (std::size_t i = 0; i < series.x.size(); ++i) points.add({series.name, series.x[i], series.y[i]});
    data(key + ".csv", points);
}

std::filesystem::path Report::path(const std::string& file) {
    if (std::find(files_.begin(), files_.end(), file) == files_.end()) files_.push_back(file);
    return folder_ / file;
}

void Report::finish() {
    data("numbers.csv", numbers_);
    std::cout << "\nWritten to " << folder_.string() << ":";
    for (const auto& file : files_) std::cout << ' ' << file;
    std::cout << '\n' << std::flush;
}

namespace {

/// A line for each body that ran since the last call.
std::string touched_by(const std::string& part) {
    std::string lines;
    for (Touched* source : all_touched())
        for (std::size_t i = 0; i < source->bodies.size(); ++i)
            if (std::exchange(source->bodies[i], false))
                lines += part + "|" + source->file + "|" + std::to_string(i / 32) + "." +
                         std::to_string(i % 32) + "\n";
    return lines;
}

/// Puts the numbers of an earlier numbers.csv that the present one lacks behind it.
void keep_numbers(const std::filesystem::path& file, const std::string& earlier) {
    std::ifstream stream(file);
    std::string now{std::istreambuf_iterator<char>(stream), {}};
    std::istringstream lines(earlier);
    for (std::string line; std::getline(lines, line);)
        if (line[0] != '#' && now.find("\n" + line.substr(0, line.find(',') + 1)) == std::string::npos)
            now += line + '\n';
    write_file(file, now);
}

}  // namespace

int program(int argc, char** argv, const std::string& name, const std::vector<Part>& parts) {
    std::map<std::string, std::string> options{{"--out", (std::filesystem::path("out") / name).string()}};
    for (const auto* option : {"--points", "--beside", "--yours", "--touched", "--only"}) options[option];
    for (int i = 1; i < argc; i += 2) {
        if (i + 1 >= argc || !options.count(argv[i])) {
            std::cerr << name << ": unknown argument '" << argv[i] << "'. Usage: " << name
                      << " [--out DIR] [--points DIR] [--beside DIR --yours WORDS] [--touched FILE] [--only "
                         "PARTS]\n";
            return 2;
        }
        options[argv[i]] = argv[i + 1];
    }
    const std::filesystem::path folder = options["--out"];
    const bool carries_on = !options["--yours"].empty();
    if (!options["--points"].empty()) chart::keep_points(options["--points"]);
    if (carries_on) chart::draw_beside(options["--beside"], options["--yours"]);
    try {
        write_file(folder / ".writable", "");  // an unwritable folder is found before the work, not after it
        std::filesystem::remove(folder / ".writable");
        Report report(folder, "./course run " + name.substr(1, 1));
        const std::string only = "," + options["--only"] + ",";
        std::string touched;
        for (const Part& part : parts) try {
                if (only != ",," && only.find("," + std::string(part.name) + ",") == std::string::npos)
                    continue;
                part.run(report);
                touched += touched_by(part.name);
            } catch (const std::exception& problem) {
                touched += touched_by(part.name);
                if (!carries_on) throw;
                report.say(std::string("With ") + options["--yours"] + " this cannot be measured (" +
                           part.name + "): " + problem.what());
            }
        std::ostringstream earlier;
        if (only != ",,") earlier << std::ifstream(folder / "numbers.csv").rdbuf();
        report.finish();
        if (only != ",,") keep_numbers(folder / "numbers.csv", earlier.str());
        if (!options["--touched"].empty()) write_file(options["--touched"], touched);
        return 0;
    } catch (const std::exception& problem) {
        std::cerr << name << ": " << problem.what() << '\n';
        return 1;
    }
}

}  // namespace nutshell::lab
