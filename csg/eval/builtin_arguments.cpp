#include "csg/eval/builtin_arguments.h"

#include <algorithm>

namespace whittle {

Arranged arrange(const BuiltinFunction& function, const std::vector<NameId>& given, const Names& names) {
    const std::vector<std::string_view> parameters = split_names(function.parameters);
    Arranged out;
    const auto complain = [&out](const std::string& text) {
        if (out.complaints.find(text) == std::string::npos) out.complaints += (out.complaints.empty() ? "" : "\n") + text;
    };
    std::size_t next = 0;
    for (const NameId name : given) {
        if (name == kNoName) {
            if (next >= function.positional) complain("Too many unnamed arguments supplied");
            out.goals.push_back(next < function.positional ? next++ : parameters.size());
            continue;
        }
        const std::string& text = names.text(name);
        const std::size_t goal = static_cast<std::size_t>(std::find(parameters.begin(), parameters.end(), text) - parameters.begin());
        if (goal == parameters.size() && !names.is_dynamic(name)) complain("variable " + text + " not specified as parameter");
        if (goal < parameters.size() && std::find(out.goals.begin(), out.goals.end(), goal) != out.goals.end()) complain("argument " + text + " supplied more than once");
        out.goals.push_back(goal);
    }
    return out;
}

}  // namespace whittle
