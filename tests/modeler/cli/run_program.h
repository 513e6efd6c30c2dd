// run_program.h — the built program, run as a person runs it: words in, streams and exit code out. And a folder of its own for each test.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

struct Outcome {
    int code = -1;  // exit code; 128 + the signal that ended it
    std::string out, err;
};

struct RunOptions {
    std::string input;                   // standard input
    std::string folder;                  // working folder; empty: this one
    double interrupt_after_s = 0;        // sends SIGINT then; 0: never
    std::string output_file;             // standard output goes there instead ("/dev/full")
};

// Runs whittle with `arguments`.
Outcome run_whittle(const std::vector<std::string>& arguments, const RunOptions& options = {});
// Runs any program, by its path.
Outcome run_program(const std::string& program, const std::vector<std::string>& arguments, const RunOptions& options = {});

// A fresh folder, removed at the end.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    // Writes a file and gives its path.
    std::string file(const std::string& name, const std::string& text) const;
    std::string name(const std::string& name) const { return (path_ / name).string(); }
    std::string read(const std::string& name) const;
    // Names of all files in it, sorted: nothing else may be left by a failure.
    std::vector<std::string> names() const;

private:
    std::filesystem::path path_;
};

bool contains(const std::string& text, const std::string& part);
