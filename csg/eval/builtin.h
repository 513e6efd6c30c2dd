// builtin.h — the two tables of what the language has built in: functions and modules.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "csg/eval/scene.h"
#include "csg/eval/value.h"

namespace whittle {

class Machine;

// A call of a built-in function: its arguments in the author's order, names ignored; where the table names parameters, as builtin_arguments.h arranges them.
struct FunctionCall {
    Machine& machine;
    std::string_view name;
    SourcePlace place;
    std::span<Value> arguments;

    std::size_t count() const { return arguments.size(); }
    const Value& operator[](std::size_t i) const { return arguments[i]; }
};

struct BuiltinFunction {
    std::string_view name;
    Value (*run)(FunctionCall& call);
    std::string_view signature;
    std::string_view parameters = {};  // "file layer": the names that arguments go by; "*": any
    std::size_t positional = 0;        // how many of these an argument without a name may mean
    double (*of_number)(Machine& machine, double x) = nullptr;  // where it makes a number of one number: the same without a call's trimmings
};

// A call of a built-in module: one value a parameter of its table entry, undef where not given.
struct ModuleUse {
    Machine& machine;
    SourcePlace place;
    std::span<const Value> arguments;
    std::string_view signature;
    bool takes_children = true;  // set to false by a module whose arguments stand for them

    // With what the module expects as the hint.
    void warn(std::string text) const;

    const Value& operator[](std::size_t i) const { return arguments[i]; }
};

struct BuiltinModule {
    std::string_view name;
    std::string_view positional;  // "size center": in order
    std::string_view named;       // "r d": by name only
    bool takes_children;
    std::optional<scene::What> (*run)(ModuleUse& use);  // before its children are made; nothing: no node
    std::string_view signature;
};

std::span<const BuiltinFunction> builtin_functions();
std::span<const BuiltinModule> builtin_modules();

// Does that built-in module read Machine::placement()? Where no text names one, it is not kept.
bool asks_placement(std::string_view name);

// The modules that steer evaluation itself: for, if, children ...
bool is_control_module(std::string_view name);

// Names in "a b c".
std::vector<std::string_view> split_names(std::string_view list);

// The name among `known` that `name` most likely was meant to be, if one is near enough (Damerau-Levenshtein, a third of its length).
std::optional<std::string> nearest_name(std::string_view name, const std::vector<std::string>& known);

}  // namespace whittle
