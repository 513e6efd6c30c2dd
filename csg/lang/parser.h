// parser.h — tokens → syntax tree, going on after an error to find the next one.
//
// Recursive descent with precedence climbing over OpenSCAD's grammar (docs/language.md). After an error the parser skips to the end of the
// statement, minding brackets, so that one typo is one message. Source: Pratt, Top down operator precedence (1973); Wirth's panic mode.
#pragma once

#include <vector>

#include "csg/lang/ast.h"
#include "csg/lang/diagnostics.h"
#include "csg/lang/names.h"
#include "csg/lang/token.h"

namespace whittle {

// Brackets, calls and blocks may nest this deep. Walks over a tree need stack for that many frames (csg/eval/large_stack.h).
inline constexpr std::uint32_t kMaxNesting = 8000;
// Errors said before the parser gives up.
inline constexpr int kMaxSyntaxErrors = 20;

struct ParseOptions {
    const SourceTable* sources = nullptr;         // where the tokens' files are named
    std::uint32_t main_file = 0;                  // overwriting a value that an included file set is no mistake
    std::uint32_t definitions_file = ast::kNone;  // -D: overwriting is their purpose
    std::uint32_t deepest = 2 * kMaxNesting;      // of a tree's depth, which chains of operators reach without brackets: a + b + c ...
};

// `tokens` end with kEnd and hold no kInclude. `strings` moves into the tree. True when no error was found; the tree is whole only then.
// Requires: runs on a stack that carries kMaxNesting levels; walks over the tree need one that carries options.deepest.
bool parse_tokens(const std::vector<Token>& tokens, std::vector<std::string> strings, const Names& names, const ParseOptions& options,
                  Diagnostics& diagnostics, ast::Ast& out);

}  // namespace whittle
