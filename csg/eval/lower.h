// lower.h — syntax trees → code: every name becomes a slot, every known call is matched to its parameters.
#pragma once

#include <memory>
#include <vector>

#include "csg/eval/code.h"
#include "csg/lang/ast.h"
#include "csg/lang/names.h"

namespace whittle {

struct FileSyntax {
    std::string path;
    ast::Ast ast;
    std::vector<std::uint32_t> uses;  // files, in the author's order
    bool good = true;
};

// Strings of the code live on `heap`. `files` must outlive the program. Never fails: what is unknown is said when it is evaluated.
code::Program lower(const std::vector<std::unique_ptr<FileSyntax>>& files, Names& names, Heap& heap);

}  // namespace whittle
