// builtin_arguments.h — the arguments of a built-in function whose table entry names parameters. Internal to csg/eval.
//
// Calls of a built-in by its name are arranged once, when they are lowered (T is a term), calls through a variable that holds no function when they run
// (T is a value).
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "csg/eval/builtin.h"
#include "csg/lang/names.h"

namespace whittle {

// Which parameter each argument goes to: an index, or parameters.size() for none. `complaints` in OpenSCAD's words, a line each.
struct Arranged {
    std::vector<std::size_t> goals;
    std::string complaints;
};
Arranged arrange(const BuiltinFunction& function, const std::vector<NameId>& given, const Names& names);

// One T a parameter and one of the complaints; where the parameters are any ("*"), name and value in turn. `made` makes a T of a text, and undef of none.
template <class T>
std::vector<T> arranged_arguments(const BuiltinFunction& function, const std::vector<NameId>& given, std::vector<T> values, const Names& names,
                                  const std::function<T(std::string_view)>& made) {
    if (function.parameters.empty()) return values;
    std::vector<T> out;
    if (function.parameters == "*") {
        for (std::size_t i = 0; i < values.size(); ++i) {
            out.push_back(made(names.text(given[i])));
            out.push_back(std::move(values[i]));
        }
        return out;
    }
    const Arranged plan = arrange(function, given, names);
    for (std::size_t i = 0; i < split_names(function.parameters).size(); ++i) out.push_back(made({}));
    for (std::size_t i = 0; i < values.size(); ++i)
        if (plan.goals[i] < out.size()) out[plan.goals[i]] = std::move(values[i]);
    out.push_back(made(plan.complaints));
    return out;
}

}  // namespace whittle
