// The frame of a chapter's main: parts that stand by themselves.
#pragma once
#include <functional>
#include <nutshell/lab/output.hpp>

namespace nutshell::lab {

/// A part of a chapter: runs a scene, prints what it found, writes its data, charts and pictures.
struct Part {
    const char* name;
    std::function<void(Report&)> run;
};

/// The frame of every chapter's main: reads `--out DIR` (default out/NAME), runs part by part, and turns an
/// exception into one line on stderr. For a learner's code:
/// `--points DIR` keeps the points of every chart; `--beside DIR --yours WORDS` draws every chart beside
/// those kept in DIR and says whose it is; a part that cannot be measured then is a sentence, and the others
/// run all the same. `--touched FILE` writes which bodies of exercises each part ran (touched.hpp), a line
/// `part|source|N.M` each; `--only A,B` runs these parts and keeps the numbers of the others.
/// @return the exit code: 0, 1 if the chapter failed, 2 if the arguments are wrong
int program(int argc, char** argv, const std::string& name, const std::vector<Part>& parts);

}  // namespace nutshell::lab
