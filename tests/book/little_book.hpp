// A little book in a folder of its own: its pages, sources and results are written by the test, book/build.sh
// weaves it.
#pragma once
#include <filesystem>
#include <string>

namespace book_test {

std::string read_text(const std::filesystem::path& path);  ///< @throws if it cannot be read
void write_text(const std::filesystem::path& path, const std::string& text);  ///< folders are made

/// What a command said (both streams) and its exit code.
struct Said {
    int code;
    std::string text;
};
Said run(const std::string& command);

class LittleBook {
  public:
    LittleBook();  ///< with errata.csv, a source, numbers, a chart and pictures
    ~LittleBook();
    LittleBook(const LittleBook&) = delete;
    LittleBook& operator=(const LittleBook&) = delete;

    void write(const std::string& file, const std::string& text) const;  ///< file relative to the folder
    Said weave() const;                                                  ///< by book/build.sh, into out/
    std::string page(const std::string& name) const;                     ///< the woven page's HTML
    std::string file(const std::string& name) const;                     ///< any file of the woven book
    const std::filesystem::path& folder() const { return folder_; }

  private:
    std::filesystem::path folder_;
};

}  // namespace book_test
