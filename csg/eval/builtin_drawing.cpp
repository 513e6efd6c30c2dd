// builtin_drawing.cpp — dxf_dim and dxf_cross: numbers out of a drawing. Their arguments go by name only.
#include "csg/eval/builtin_function_parts.h"
#include "csg/eval/machine.h"
#include "csg/solid/imported.h"

namespace whittle {
namespace {

// "file layer name origin scale" of the table.
enum Parameter : std::size_t { kFile, kLayer, kName, kOrigin, kScale };

// A function value of that name hands its arguments on as they are: there may be fewer.
Value argument(const FunctionCall& call, Parameter which) { return which < call.count() ? call[which] : Value(); }

std::string text_of(const Value& v) { return v.is_string() ? std::string(v.string()) : std::string(); }

struct Asked {
    std::string path;
    DrawingRequest request;
};

// Nothing where no file is named.
std::optional<Asked> asked(FunctionCall& call) {
    if (!argument(call, kFile).is_string()) {
        call.machine.warn(call.place, std::string(call.name) + "() names no file", signature_hint(call.name));
        return std::nullopt;
    }
    Asked out;
    out.path = call.machine.find_file(call.place, text_of(argument(call, kFile)));
    out.request.layer = text_of(argument(call, kLayer));
    const Value origin = argument(call, kOrigin);
    if (origin.is_vector() && origin.size() == 2 && origin[0].is_number() && origin[1].is_number()) out.request.origin = {origin[0].number(), origin[1].number()};
    if (const Value scale = argument(call, kScale); scale.is_number()) out.request.scale = scale.number();
    return out;
}

template <class Read>
auto read(FunctionCall& call, Read reader) -> std::optional<typename decltype(reader(std::declval<Imports&>(), std::declval<const Asked&>()))::value_type> {
    const auto what = asked(call);
    if (!what) return std::nullopt;
    if (!call.machine.outside().exists(what->path)) {
        call.machine.warn(call.place, "Can't open DXF file '" + call.machine.name_of_file(what->path) + "'!");
        return std::nullopt;
    }
    Imports* imports = call.machine.outside().imports();
    if (!imports) return std::nullopt;
    auto found = reader(*imports, *what);
    if (found) return *found;
    call.machine.warn(call.place, found.error().message);
    return std::nullopt;
}

}  // namespace

Value function_dxf_dim(FunctionCall& call) {
    const auto length = read(call, [&](Imports& imports, const Asked& a) { return imports.dxf_dimension(a.path, a.request, text_of(argument(call, kName))); });
    return length ? Value(*length) : Value();
}

Value function_dxf_cross(FunctionCall& call) {
    const auto at = read(call, [](Imports& imports, const Asked& a) { return imports.dxf_crossing(a.path, a.request); });
    if (!at) return {};
    const double numbers[2] = {at->x, at->y};
    return call.machine.heap().numbers(numbers, 2);
}

}  // namespace whittle
