#include "csg/eval/match_arguments.h"

#include <algorithm>
#include <string>
#include <unordered_map>

namespace whittle {

using namespace code;

namespace {

Passed goal_of(NameId name, const Callee& callee, const Names& names, const std::function<std::uint32_t(NameId)>& dynamic_of) {
    Passed passed;
    const auto found = std::find_if(callee.parameters.begin(), callee.parameters.end(), [name](const Parameter& p) { return p.name == name; });
    const auto& extras = callee.layout.extras;
    const auto extra = std::find_if(extras.begin(), extras.end(), [name](const Layout::Extra& e) { return e.name == name; });
    if (found != callee.parameters.end()) {
        passed.to = found->dynamic ? Passed::To::kDynamic : Passed::To::kParameter;
        passed.target = found->target;
        passed.parameter = static_cast<std::uint32_t>(found - callee.parameters.begin());
    } else if (names.is_dynamic(name)) {
        passed.to = Passed::To::kDynamic;
        passed.target = dynamic_of(name);
    } else if (extra != extras.end()) {
        passed.to = Passed::To::kSlot;
        passed.target = extra->slot;
    }
    return passed;
}

}  // namespace

// OpenSCAD evaluates the arguments in the order of its hash map of names, which shows when they echo; a map of the same library, filled in the same order, has
// the same order.
Matched match_arguments(const std::vector<NameId>& arguments, const Callee& callee, const Names& names,
                        const std::function<std::uint32_t(NameId)>& dynamic_of) {
    Matched out;
    std::unordered_map<std::string, Passed> by_name;
    std::size_t next = 0;
    bool too_many = false;
    for (std::uint32_t i = 0; i < arguments.size(); ++i) {
        NameId name = arguments[i];
        if (name == kNoName) {
            if (next == callee.skipped) ++next;
            if (next >= callee.positional) {
                if (!too_many) out.complaints.push_back({"Too many unnamed arguments supplied"});
                too_many = true;
                continue;
            }
            name = callee.parameters[next++].name;
        } else {
            const auto same = [name](const Parameter& p) { return p.name == name; };
            if (!names.is_dynamic(name) && std::none_of(callee.parameters.begin(), callee.parameters.end(), same))
                out.complaints.push_back({"variable " + names.text(name) + " not specified as parameter", name});
            if (by_name.count(names.text(name))) out.complaints.push_back({"argument " + names.text(name) + " supplied more than once"});
        }
        Passed passed = goal_of(name, callee, names, dynamic_of);
        passed.value = i;
        by_name[names.text(name)] = passed;
    }
    for (const auto& [name, passed] : by_name) {
        out.passed.push_back(passed);
        if (passed.to == Passed::To::kParameter && passed.parameter < 64) out.given |= std::uint64_t{1} << passed.parameter;
    }
    return out;
}

void note_plain(Matched& matched, const std::vector<Parameter>& parameters) {
    matched.plain = matched.complaints.empty() && parameters.size() <= 64;
    for (std::size_t i = 0; i < parameters.size() && matched.plain; ++i) {
        const Parameter& p = parameters[i];
        matched.plain = p.constant && !p.dynamic;
        if (matched.plain && !(matched.given >> i & 1)) matched.defaults.push_back({p.target, p.value});
    }
    for (const Passed& p : matched.passed) matched.plain &= p.to == Passed::To::kParameter || p.to == Passed::To::kSlot;
}

}  // namespace whittle
