// builtin_records.cpp — object() and its like (of later versions): values under names.
#include <fmt/format.h>

#include "csg/eval/builtin_function_parts.h"
#include "csg/eval/json_value.h"
#include "csg/eval/machine.h"
#include "csg/eval/record_builder.h"

namespace whittle {
namespace {

constexpr std::string_view kEntryHelp = "an entry is [name, value] to set a member or [name] to take it away";

// Members of a list of entries; the complaint where one is none.
std::string add_entries(RecordBuilder& builder, const Value& list) {
    for (std::uint32_t i = 0; i < list.size(); ++i) {
        const Value& entry = list[i];
        if (!entry.is_vector() || entry.size() < 1 || entry.size() > 2) return fmt::format("object() entry {} is no list of one or two elements", i);
        if (!entry[0].is_string()) return fmt::format("object() entry {} has a name of type {}", i, type_name(entry[0].type()));
        if (entry.size() == 1) builder.erase(entry[0].string());
        else builder.set(entry[0], entry[1]);
    }
    return {};
}

void add_members(RecordBuilder& builder, const RecordObject& record) {
    for (std::uint32_t i = 0; i < record.size; ++i) builder.set(record.names()[i], record.values()[i]);
}

}  // namespace

// Names and values in turn. A later member of a name replaces the value of an earlier one at its place.
Value function_object(FunctionCall& call) {
    RecordBuilder builder(call.machine.heap());
    for (std::size_t i = 0; i + 1 < call.count(); i += 2) {
        const Value &name = call[i], &value = call[i + 1];
        std::string complaint;
        if (name.is_string()) builder.set(name, value);
        else if (value.is_record()) add_members(builder, value.record());
        else if (value.is_vector()) complaint = add_entries(builder, value);
        else complaint = fmt::format("object() argument {} is neither name = value nor an object nor a list of entries, it is of type {}", i / 2, type_name(value.type()));
        if (complaint.empty()) continue;
        call.machine.warn(call.place, complaint, std::string(kEntryHelp));
        return {};
    }
    Value made = builder.finish();
    if (made.nesting() > kMaxValueNesting) call.machine.fail(call.place, "Lists are nested too deeply");
    return made;
}

Value function_has_key(FunctionCall& call) {
    if (call.count() != 2) return wrong_count(call);
    if (!call[0].is_record() || !call[1].is_string()) return wrong_type(call);
    return Value(call[0].record().find(call[1].string()) != nullptr);
}

Value function_is_object(FunctionCall& call) {
    if (call.count() != 1) return wrong_count(call);
    return Value(call[0].is_record());
}

// What a JSON file holds.
Value function_import(FunctionCall& call) {
    // file | type, complaints
    tell_complaints(call, call[2]);
    if (!call[0].is_string() || call[0].string().empty()) {
        call.machine.warn(call.place, "import() names no file", signature_hint(call.name));
        return {};
    }
    const std::string_view name = call[0].string();
    const bool is_json = call[1].is_string() ? call[1].string() == "json" : name.size() > 5 && name.substr(name.size() - 5) == ".json";
    if (!is_json) {
        call.machine.warn(call.place, fmt::format("Unsupported file type while trying to import '{}'", name), "import() as a function reads .json; as a module, meshes and drawings");
        return {};
    }
    const std::string path = call.machine.find_file(call.place, name);
    const auto text = call.machine.outside().read_text(path);
    if (!text) {
        call.machine.warn(call.place, fmt::format("Could not read file '{}'", call.machine.name_of_file(path)), text.error().message);
        return {};
    }
    auto value = json_value(call.machine.heap(), *text);
    if (value) return std::move(*value);
    call.machine.warn(call.place, fmt::format("Failed to parse file '{}'", call.machine.name_of_file(path)), value.error().message);
    return {};
}

}  // namespace whittle
