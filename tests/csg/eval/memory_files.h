// memory_files.h — files of a test, held in memory or read from the source tree, and the shortest way to evaluate a text.
#pragma once

#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "csg/eval/dump_csg.h"
#include "csg/eval/evaluate.h"

namespace whittle::test {

class MemoryFiles : public Outside {
public:
    MemoryFiles() = default;
    explicit MemoryFiles(std::map<std::string, std::string> files) : files_(std::move(files)) {}
    Result<std::string> read_text(const std::string& path) override {
        if (const auto it = files_.find(path); it != files_.end()) return it->second;
        return fail(Fault::kWorld, "no such file: " + path);
    }
    bool exists(const std::string& path) override { return files_.count(path) > 0; }

private:
    std::map<std::string, std::string> files_;
};

class DiscFiles : public MemoryFiles {
public:
    Result<std::string> read_text(const std::string& path) override {
        std::ifstream in(path, std::ios::binary);
        if (!in) return fail(Fault::kWorld, "no such file: " + path);
        std::stringstream text;
        text << in.rdbuf();
        return text.str();
    }
    bool exists(const std::string& path) override { return std::ifstream(path).good(); }
};

inline Evaluated run(const std::string& text, EvaluateInput input = {}, std::map<std::string, std::string> files = {}) {
    MemoryFiles outside(std::move(files));
    if (input.path.empty()) input.path = "main.scad";
    input.text = text;
    return *evaluate(input, outside);
}

// All messages, as in an .echo file.
inline std::string echo_of(const std::string& text, EvaluateInput input = {}, std::map<std::string, std::string> files = {}) {
    const Evaluated made = run(text, std::move(input), std::move(files));
    return echo_text(made.diagnostics, made.sources);
}

inline std::string csg_of(const std::string& text) { return dump_csg(run(text).scene); }

}  // namespace whittle::test
