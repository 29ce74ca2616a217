#include "gates.hpp"
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <regex>
#include <stdexcept>
#include "check.hpp"
#include "compare.hpp"
#include "sheets.hpp"
#include "text.hpp"

namespace nutshell::judge {

namespace fs = std::filesystem;

namespace {

std::vector<Number> numbers_in(const Herd& herd) {
    std::vector<Number> all;
    for (const auto& [number, unused] : herd.mutants) all.push_back(number);
    return all;
}

/// The headers with the bodies of `sources`, and a switch over the mutants in each.
void write_headers(const Chapter& chapter, const std::vector<Marked>& headers,
                   const std::vector<Marked>& sources, const fs::path& folder,
                   const std::map<Number, std::vector<std::pair<std::size_t, Mutant>>>& alive) {
    write_if_changed(folder / "mutants_prelude.hpp", mutants_prelude);
    for (std::size_t i = 0; i < sources.size(); ++i) {
        std::map<Number, std::string> bodies;
        for (const Body& body : sources[i].bodies) {
            bodies[body.number] = body.text;
            const auto found = alive.find(body.number);
            if (found == alive.end()) continue;
            std::vector<Mutant> mutants;
            std::string text = "switch (nutshell_mutant) {\n";
            for (const auto& [id, mutant] : found->second)
                text += "case " + std::to_string(id) + ": {\n#line 1 \"mutant:" + std::to_string(id) +
                        "\"\n" + mutant.body + "\n} break;\n";
            bodies[body.number] = text + "default: {\n#line 1 \"mutant:none\"\n" + body.text + "\n}\n}\n";
        }
        write_if_changed(folder / chapter.headers[i].path, "#include \"" +
                                                               (folder / "mutants_prelude.hpp").string() +
                                                               "\"\n" + with_bodies(headers[i], bodies));
    }
}

}  // namespace

void Herd::ask(const Rooms& rooms, const Chapter& chapter, const std::vector<Marked>& sources,
               const std::string& name,
               const std::function<void(Number, std::size_t, const SheetAnswer&)>& hear) {
    const fs::path folder = rooms.work / chapter.folder / name;
    const auto ahead = ahead_of(rooms, chapter, sources);
    const Sheets sheets(rooms, chapter, {folder, ahead.has_value(), ahead});
    std::map<Number, std::vector<std::pair<std::size_t, Mutant>>> alive;
    std::vector<std::pair<Number, std::size_t>> by_id;
    for (const auto& [number, all] : mutants)
        for (std::size_t i = 0; i < all.size(); ++i) {
            alive[number].emplace_back(by_id.size(), all[i]);
            by_id.emplace_back(number, i);
        }
    Sheet sheet;
    for (bool compiled = false; !compiled;) {
        write_headers(chapter, ahead ? ahead->skeletons : sources, sources, folder, alive);
        if (budget > 0 && seconds >= budget) return;
        const Ran ran = sheets.compile_quietly(numbers_in(*this), sheet, budget > 0 ? budget - seconds : 0);
        compiled = ran.exit_code == 0;
        seconds += ran.seconds;
        if (compiled) break;
        std::set<std::size_t> broken;
        static const std::regex place(R"(mutant:(\d+):\d+)");
        for (const auto& line : lines_of(ran.err)) {
            std::smatch found;
            const std::string start = line.substr(0, 300);
            if (std::regex_search(start, found, place)) broken.insert(std::stoul(found[1]));
        }
        if (broken.empty() && budget > 0) return;
        if (broken.empty())
            throw std::runtime_error("the mutants do not compile:\n" + ran.err.substr(0, 3000));
        for (const std::size_t id : broken) {
            do_not_compile.insert(by_id[id]);
            std::erase_if(alive[by_id[id].first], [&](const auto& each) { return each.first == id; });
        }
    }
    for (const auto& [number, all] : alive)
        for (const auto& [id, mutant] : all) {
            if (budget > 0 && seconds >= budget + 1) break;  // what is compiled is also run
            setenv("NUTSHELL_MUTANT", std::to_string(id).c_str(), 1);
            const SheetAnswer answer = sheets.ask(sheet, number, budget > 0 ? 1 : 2);
            seconds += answer.ran.seconds;
            hear(number, by_id[id].second, answer);
        }
    unsetenv("NUTSHELL_MUTANT");
}

bool passes(const exercises::Record& reference, const SheetAnswer& answer) {
    return answer.ended && !answer.threw && !answer.unanswered && agrees(reference, answer.outputs) &&
           !remembers(answer);
}

std::vector<Gate> gates_of(const Rooms& rooms, const Chapter& chapter) {
    Herd herd;
    std::map<Number, Gate> gates;
    std::vector<Marked> sources;
    for (const auto& header : chapter.headers) {
        sources.push_back(header.reference);
        for (const Body& body : header.reference.bodies) {
            const std::string first_line = signature(header.reference, body.number);
            Gate& gate = gates[body.number];
            gate.number = body.number;
            auto all = slips_of(body.text, first_line);
            for (auto& mutant : half_answers_of(body.text, first_line)) all.push_back(std::move(mutant));
            for (auto& mutant : all)
                if (mutant.proved_equal)
                    ++gate.made, ++gate.equal;
                else
                    herd.mutants[body.number].push_back(std::move(mutant));
        }
    }
    std::map<Number, std::set<std::string>> survived;
    std::map<Number, exercises::Record> references;
    for (const auto& [number, unused] : herd.mutants)
        references[number] = record_of(exercise_of(number).reference);
    herd.ask(rooms, chapter, sources, "mutants",
             [&](Number number, std::size_t i, const SheetAnswer& answer) {
                 const bool pass = passes(references[number], answer);
                 ++gates[number].made;
                 gates[number].failed += !pass;
                 if (pass) survived[number].insert(herd.mutants[number][i].name);
             });
    std::vector<Gate> all;
    for (auto& [number, gate] : gates) {
        std::set<std::string> argued;
        for (const auto& each : exercise_of(number).survivors) argued.insert(each.mutant);
        for (const auto& name : survived[number])
            if (argued.count(name))
                ++gate.equal;
            else
                gate.passed.push_back(name);
        for (const auto& name : argued)
            if (!survived[number].count(name)) gate.stale.push_back(name);
        all.push_back(gate);
    }
    return all;
}

int verb_gates(const Rooms& rooms, const std::string& which) {
    std::size_t made = 0, failed = 0, equal = 0, open = 0;
    const auto number = number_of(which);
    std::cout << "exercise   made  failed  equal\n";
    for (const Chapter& chapter : meant(rooms, which))
        for (const Gate& gate : gates_of(rooms, chapter)) {
            if (number && gate.number != *number) continue;
            char line[80];
            std::snprintf(line, sizeof line, "  %-8s %4zu    %4zu   %4zu\n", gate.number.text().c_str(),
                          gate.made, gate.failed, gate.equal);
            std::cout << line;
            for (const auto& name : gate.passed) std::cout << "    passes, and should not: " << name << '\n';
            for (const auto& name : gate.stale)
                std::cout << "    is argued, and does not pass: " << name << '\n';
            made += gate.made, failed += gate.failed, equal += gate.equal;
            open += gate.passed.size() + gate.stale.size();
        }
    std::cout << "made " << made << ", failed " << failed << ", equal " << equal << '\n';
    return open ? 1 : 0;
}

}  // namespace nutshell::judge
