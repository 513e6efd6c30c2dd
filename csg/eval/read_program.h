// read_program.h — finds and reads the files of a program: the main file, what it includes (textually) and what it uses (apart). Internal to csg/eval.
#pragma once

#include <map>
#include <memory>
#include <set>

#include "csg/eval/evaluate.h"
#include "csg/eval/lower.h"
#include "csg/lang/lexer.h"
#include "csg/lang/token.h"

namespace whittle {

struct ProgramText {
    Names names;
    std::vector<std::unique_ptr<FileSyntax>> files;  // main file first
    std::vector<std::string> fonts;                  // files that `use` names: their fonts are known to text()
};

// Files open at once, and files in all: an include that doubles itself ends here.
inline constexpr std::size_t kMaxIncludeDepth = 100;
inline constexpr std::size_t kMaxSources = 10000;

class ProgramReader {
public:
    ProgramReader(const EvaluateInput& input, Outside& outside, Parsed& out, ProgramText& program)
        : input_(input), outside_(outside), out_(out), program_(program) {}

    // False when the main file has a syntax error.
    bool run(std::string main_text);

private:
    std::vector<Token> tokens_of(std::uint32_t source, StringPool& strings);
    void include(const Token& token, const std::string& path, const std::string& folder, std::vector<Token>& out, StringPool& strings);
    void add_definitions(std::vector<Token>& tokens, StringPool& strings, std::uint32_t& file);
    std::uint32_t add_source(const std::string& path, std::string text);
    bool parse_file(std::uint32_t index, std::vector<Token> tokens, StringPool strings, std::uint32_t source, std::uint32_t definitions);
    std::uint32_t use(const std::string& path);
    std::string find(const std::string& path, const std::string& folder) const;
    std::string name_of(const std::string& path) const;
    void warn_missing(const char* what, const std::string& asked, SourcePlace place, const std::string& why);

    const EvaluateInput& input_;
    Outside& outside_;
    Parsed& out_;
    ProgramText& program_;
    bool too_many_ = false;
    std::set<std::string> open_;                      // files whose tokens are being read: no circles
    std::map<std::string, std::uint32_t> used_;       // path -> file
    std::vector<std::pair<std::string, SourcePlace>> wanted_;  // uses met in the file being read: resolved paths
};

}  // namespace whittle
