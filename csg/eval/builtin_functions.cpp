// The table of built-in functions and the short ones among them.
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <sleef.h>

#include "csg/base/degrees.h"
#include "csg/eval/builtin.h"
#include "csg/eval/builtin_function_parts.h"
#include "csg/eval/machine.h"

namespace whittle {

Value wrong_count(FunctionCall& call) {
    call.machine.warn(call.place, fmt::format("{}() number of parameters does not match", call.name), signature_hint(call.name));
    return {};
}

Value wrong_type(FunctionCall& call) {
    call.machine.warn(call.place, fmt::format("{}() parameter could not be converted", call.name), signature_hint(call.name));
    return {};
}

std::string signature_hint(std::string_view name) {
    for (const BuiltinFunction& f : builtin_functions())
        if (f.name == name) return "expected " + std::string(f.signature);
    return {};
}

namespace {

// A function of one number.
template <double (*F)(Machine&, double)>
Value called_with_number(FunctionCall& call) {
    if (call.count() != 1) return wrong_count(call);
    return call[0].is_number() ? Value(F(call.machine, call[0].number())) : wrong_type(call);
}

double sine(Machine& machine, double degrees) { return machine.sine(degrees); }
double cosine(Machine& machine, double degrees) { return machine.cosine(degrees); }

template <double (*F)(double)>
double plain(Machine&, double x) {
    return F(x);
}

// Its entry in the table.
template <double (*F)(Machine&, double)>
constexpr BuiltinFunction of_number(std::string_view name, std::string_view signature) {
    return {name, called_with_number<F>, signature, {}, 0, F};
}

// The whole degree near `degrees` if the forward function of it gives x again.
template <double (*Forward)(double)>
double whole_degree(double degrees, double x) {
    const double whole = std::round(degrees);
    return Forward(whole) == x ? whole : degrees;
}

double absolute(double x) { return std::fabs(x); }
double sign_of(double x) { return x < 0 ? -1 : x > 0 ? 1 : 0; }
double tangent(double x) {
    if (!(std::fabs(x) < 0x1p52 * 360)) return std::nan("");
    const double turns = std::floor(x / 180);
    x -= 180 * turns;
    const bool obtuse = x > 90;
    if (obtuse) x = 180 - x;
    double t = 0;
    if (x == 0) t = obtuse ? -0.0 : 0.0;
    else if (x == 30) t = 0.57735026918962576451;
    else if (x == 45) t = 1;
    else if (x == 60) t = 1.73205080756887729353;
    else if (x == 90) t = std::fmod(turns, 2) == 0 ? HUGE_VAL : -HUGE_VAL;
    else t = Sleef_cinz_tand1_u10purec(x * kRadiansPerDegree);
    return obtuse ? -t : t;
}
double arc_sine(double x) { return whole_degree<sind>(Sleef_cinz_asind1_u10purec(x) / kRadiansPerDegree, x); }
double arc_cosine(double x) { return whole_degree<cosd>(Sleef_cinz_acosd1_u10purec(x) / kRadiansPerDegree, x); }
double arc_tangent(double x) { return whole_degree<tangent>(Sleef_cinz_atand1_u10purec(x) / kRadiansPerDegree, x); }
double round_away(double x) { return std::round(x); }
double up(double x) { return std::ceil(x); }
double down(double x) { return std::floor(x); }
double root(double x) { return std::sqrt(x); }
double exponential(double x) { return Sleef_cinz_expd1_u10purec(x); }
double natural_log(double x) { return Sleef_cinz_logd1_u10purec(x); }

Value arc_tangent_2(FunctionCall& call) {
    if (call.count() != 2) return wrong_count(call);
    if (!call[0].is_number() || !call[1].is_number()) return wrong_type(call);
    const double degrees = Sleef_cinz_atan2d1_u10purec(call[0].number(), call[1].number()) / kRadiansPerDegree;
    const double whole = std::round(degrees);
    return Value(std::fabs(degrees - whole) < 3.0e-14 ? whole : degrees);
}

Value power(FunctionCall& call) {
    if (call.count() != 2) return wrong_count(call);
    if (!call[0].is_number() || !call[1].is_number()) return wrong_type(call);
    return Value(Sleef_cinz_powd1_u10purec(call[0].number(), call[1].number()));
}

Value logarithm(FunctionCall& call) {
    if (call.count() != 1 && call.count() != 2) return wrong_count(call);
    for (const Value& v : call.arguments)
        if (!v.is_number()) return wrong_type(call);
    if (call.count() == 1) return Value(Sleef_cinz_log10d1_u10purec(call[0].number()));
    return Value(natural_log(call[1].number()) / natural_log(call[0].number()));
}

// Least of the numbers, or of one list by `<`. The first of equals; an element that cannot be compared never wins.
template <bool Greatest>
Value extreme(FunctionCall& call) {
    if (call.count() == 0) return wrong_count(call);
    const bool list = call.count() == 1 && call[0].is_vector();
    if (list && call[0].size() == 0) return wrong_type(call);
    if (!list) {
        for (const Value& v : call.arguments)
            if (!v.is_number()) return wrong_type(call);
    }
    const Value* best = list ? &call[0][0] : &call[0];
    const std::size_t count = list ? call[0].size() : call.count();
    for (std::size_t i = 1; i < count; ++i) {
        const Value& v = list ? call[0][i] : call[i];
        std::string ignored;
        if (binary_operation(call.machine.heap(), Greatest ? ast::Op::kGreater : ast::Op::kLess, v, *best, ignored).truth()) best = &v;
    }
    return *best;
}

template <class Test>
Value is_type(FunctionCall& call, Test test) {
    if (call.count() != 1) return wrong_count(call);
    return Value(static_cast<bool>(test(call[0])));
}
Value is_undef(FunctionCall& call) { return is_type(call, [](const Value& v) { return v.is_undef(); }); }
Value is_bool(FunctionCall& call) { return is_type(call, [](const Value& v) { return v.is_bool(); }); }
Value is_num(FunctionCall& call) { return is_type(call, [](const Value& v) { return v.is_number() && !std::isnan(v.number()); }); }
Value is_string(FunctionCall& call) { return is_type(call, [](const Value& v) { return v.is_string(); }); }
Value is_list(FunctionCall& call) { return is_type(call, [](const Value& v) { return v.is_vector(); }); }
Value is_function(FunctionCall& call) { return is_type(call, [](const Value& v) { return v.is_function(); }); }

Value version(FunctionCall& call) {
    const double parts[3] = {2021, 1, 0};
    return call.machine.heap().numbers(parts, 3);
}
Value version_num(FunctionCall& call) {
    return call.count() == 0 ? Value(20210100.0) : Value();
}

Value parent_module(FunctionCall& call) {
    if (call.count() > 1) return wrong_count(call);
    double which = 1;
    if (call.count() == 1) {
        if (!call[0].is_number()) return {};
        which = std::trunc(call[0].number());
    }
    const std::vector<NameId>& stack = call.machine.module_names();
    if (which < 0) {
        call.machine.warn(call.place, fmt::format("Negative parent module index ({}) not allowed", which));
        return {};
    }
    if (!(which < static_cast<double>(stack.size()))) {
        call.machine.warn(call.place, fmt::format("Parent module index ({}) greater than the number of modules on the stack", which));
        return {};
    }
    return call.machine.heap().string(call.machine.names().text(stack[stack.size() - 1 - static_cast<std::size_t>(which)]));
}

constexpr std::array kFunctions = std::to_array<BuiltinFunction>({
    of_number<plain<absolute>>("abs", "abs(number) -> number"),
    of_number<plain<sign_of>>("sign", "sign(number) -> -1, 0 or 1"),
    {"rands", function_rands, "rands(min, max, count [, seed]) -> list of numbers"},
    {"min", extreme<false>, "min(number, ...) or min(list) -> number"},
    {"max", extreme<true>, "max(number, ...) or max(list) -> number"},
    of_number<sine>("sin", "sin(degrees) -> number"),
    of_number<cosine>("cos", "cos(degrees) -> number"),
    of_number<plain<tangent>>("tan", "tan(degrees) -> number"),
    of_number<plain<arc_sine>>("asin", "asin(number) -> degrees"),
    of_number<plain<arc_cosine>>("acos", "acos(number) -> degrees"),
    of_number<plain<arc_tangent>>("atan", "atan(number) -> degrees"),
    {"atan2", arc_tangent_2, "atan2(y, x) -> degrees"},
    of_number<plain<round_away>>("round", "round(number) -> number"),
    of_number<plain<up>>("ceil", "ceil(number) -> number"),
    of_number<plain<down>>("floor", "floor(number) -> number"),
    {"pow", power, "pow(base, exponent) -> number"},
    of_number<plain<root>>("sqrt", "sqrt(number) -> number"),
    of_number<plain<exponential>>("exp", "exp(number) -> number"),
    {"log", logarithm, "log(number) or log(base, number) -> number"},
    of_number<plain<natural_log>>("ln", "ln(number) -> number"),
    {"len", function_len, "len(string or list) -> number"},
    {"str", function_str, "str(value, ...) -> string"},
    {"chr", function_chr, "chr(number, list or range, ...) -> string"},
    {"ord", function_ord, "ord(string) -> number"},
    {"concat", function_concat, "concat(list or value, ...) -> list"},
    {"lookup", function_lookup, "lookup(key, [[key, value], ...]) -> number"},
    {"search", function_search, "search(what, in [, hits per element [, column]]) -> list of indices"},
    {"version", version, "version() -> list"},
    {"version_num", version_num, "version_num() -> number"},
    {"norm", function_norm, "norm(list of numbers) -> number"},
    {"cross", function_cross, "cross([x, y, z], [x, y, z]) -> list, or cross([x, y], [x, y]) -> number"},
    {"parent_module", parent_module, "parent_module(number) -> string"},
    {"dxf_dim", function_dxf_dim, "dxf_dim(file=, layer=, name=, origin=, scale=) -> number", "file layer name origin scale"},
    {"dxf_cross", function_dxf_cross, "dxf_cross(file=, layer=, origin=, scale=) -> list", "file layer name origin scale"},
    {"is_undef", is_undef, "is_undef(value) -> boolean"},
    {"is_list", is_list, "is_list(value) -> boolean"},
    {"is_num", is_num, "is_num(value) -> boolean"},
    {"is_bool", is_bool, "is_bool(value) -> boolean"},
    {"is_string", is_string, "is_string(value) -> boolean"},
    {"is_function", is_function, "is_function(value) -> boolean"},
    {"is_object", function_is_object, "is_object(value) -> boolean"},
    {"object", function_object, "object(name = value, ..., object, [[name, value], [name], ...]) -> object", "*"},
    {"has_key", function_has_key, "has_key(object, name) -> boolean"},
    {"import", function_import, "import(file [, type=\"json\"]) -> value", "file type", 1},
    {"textmetrics", function_textmetrics, "textmetrics(text, size, font, direction=, language=, script=, halign=, valign=, spacing=) -> object",
     "text size font direction language script halign valign spacing", 3},
    {"fontmetrics", function_fontmetrics, "fontmetrics(size, font) -> object", "size font", 2},
});

}  // namespace

std::span<const BuiltinFunction> builtin_functions() { return kFunctions; }

}  // namespace whittle
