// match_arguments.h — which argument of a call goes to which parameter. Internal to csg/eval.
//
// Calls of known functions and modules are matched once when they are lowered, calls of function values when they first meet a function.
#pragma once

#include <functional>
#include <vector>

#include "csg/eval/code.h"

namespace whittle {

struct Callee {
    const std::vector<code::Parameter>& parameters;
    const code::Layout& layout;
    std::size_t positional;  // how many parameters unnamed arguments may reach
    std::uint32_t skipped = code::kNone;  // one of them that they do not: `this` of a method
};

// Left to right: a name binds its parameter, an unnamed one the next position, counting only unnamed ones. `dynamic_of` gives the cell of a $-variable.
// In the result, `passed` has one entry a name, in the order of evaluation, and its `value` is an index into `arguments`: the last of that name.
code::Matched match_arguments(const std::vector<NameId>& arguments, const Callee& callee, const Names& names,
                              const std::function<std::uint32_t(NameId)>& dynamic_of);

// Notes whether a match is plain, and if so the parameters that are not given. Requires: the parameters know their defaults.
void note_plain(code::Matched& matched, const std::vector<code::Parameter>& parameters);

}  // namespace whittle
