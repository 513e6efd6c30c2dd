// search(): its many forms.
#include <algorithm>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "csg/eval/builtin_function_parts.h"
#include "csg/eval/machine.h"

namespace whittle {
namespace {

struct Question {
    FunctionCall& call;
    std::uint32_t hits;    // 0: all
    std::uint32_t column;
};

// Indices as a list value.
Value list_of(Heap& heap, const std::vector<double>& indices) { return heap.numbers(indices.data(), indices.size()); }

// Places of `what` among the code points of a string.
std::vector<double> in_string(std::string_view what, const std::vector<std::string_view>& table, std::uint32_t hits) {
    std::vector<double> found;
    for (std::size_t i = 0; i < table.size() && (hits == 0 || found.size() < hits); ++i)
        if (table[i] == what) found.push_back(static_cast<double>(i));
    return found;
}

// Is row i the thing, or does it have it in the asked column?
bool matches(const Value& what, const Value& row, std::uint32_t column) {
    if (column == 0 && equal(row, what)) return true;
    return row.is_vector() && column < row.size() && equal(row[column], what);
}

// Is the value this text? Asked of whole tables: lengths and last letters differ first.
bool is_text(const Value& value, std::string_view text) {
    if (!value.is_string()) return false;
    const std::string_view other = value.string();
    return other.size() == text.size() && (text.empty() || (other.back() == text.back() && std::memcmp(other.data(), text.data(), text.size()) == 0));
}

std::vector<double> text_in_list(std::string_view text, const Value& table, const Question& q) {
    std::vector<double> found;
    for (std::uint32_t i = 0; i < table.size() && (q.hits == 0 || found.size() < q.hits); ++i) {
        const Value& row = table[i];
        if ((q.column == 0 && is_text(row, text)) || (row.is_vector() && q.column < row.size() && is_text(row[q.column], text))) found.push_back(i);
    }
    return found;
}

std::vector<double> in_list(const Value& what, const Value& table, const Question& q) {
    if (what.is_string()) return text_in_list(what.string(), table, q);
    std::vector<double> found;
    for (std::uint32_t i = 0; i < table.size() && (q.hits == 0 || found.size() < q.hits); ++i)
        if (matches(what, table[i], q.column)) found.push_back(i);
    return found;
}

Value search_number(const Value& what, const Value& table, const Question& q) {
    return list_of(q.call.machine.heap(), table.is_vector() ? in_list(what, table, q) : std::vector<double>{});
}

bool is_ascii(std::string_view text) {
    return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

// Characters in a string: a flat list of first places, or a list a character.
Value search_string_in_string(std::string_view what, std::string_view where, const Question& q) {
    if (q.hits == 1 && is_ascii(what) && is_ascii(where)) {
        std::vector<double> places;
        for (const char c : what)
            if (const std::size_t at = where.find(c); at != std::string_view::npos) places.push_back(static_cast<double>(at));
        return list_of(q.call.machine.heap(), places);
    }
    const std::vector<std::string_view> table = code_points(where);
    std::vector<Value> out;
    for (const std::string_view character : code_points(what)) {
        const std::vector<double> found = in_string(character, table, q.hits);
        if (q.hits != 1) out.push_back(list_of(q.call.machine.heap(), found));
        else if (!found.empty()) out.emplace_back(found[0]);
    }
    return q.call.machine.heap().vector(std::move(out));
}

// Characters in the columns of a table, every row of which must have the column.
Value search_string_in_table(std::string_view what, const Value& table, const Question& q) {
    Machine& machine = q.call.machine;
    std::vector<Value> out;
    for (const std::string_view character : code_points(what)) {
        std::vector<double> found;
        for (std::uint32_t i = 0; i < table.size() && (q.hits == 0 || found.size() < q.hits); ++i) {
            const Value& row = table[i];
            if (!row.is_vector() || row.size() <= q.column) {
                machine.warn(q.call.place, fmt::format("Invalid entry in search vector at index {}, required number of values in the entry: {}. Invalid entry: {}",
                                                       i, q.column + 1, machine.text_of(row)));
                return machine.heap().vector(std::vector<Value>{});
            }
            if (row[q.column].is_string() && code_points(row[q.column].string()).size() > 0 && code_points(row[q.column].string())[0] == character)
                found.push_back(i);
        }
        if (found.empty()) machine.warn(q.call.place, "search term not found: \"" + std::string(character) + "\"");
        if (q.hits != 1) out.push_back(list_of(machine.heap(), found));
        else if (!found.empty()) out.emplace_back(found[0]);
    }
    return machine.heap().vector(std::move(out));
}

// Each element of a list: its first place, [] where there is none, or a list an element.
Value search_list(const Value& what, const Value& table, const Question& q) {
    Heap& heap = q.call.machine.heap();
    std::vector<Value> out;
    for (std::uint32_t i = 0; i < what.size(); ++i) {
        std::vector<double> found = table.is_vector() ? in_list(what[i], table, q) : std::vector<double>{};
        if (q.hits == 1 && !found.empty()) out.emplace_back(found[0]);
        else out.push_back(list_of(heap, found));
    }
    return heap.vector(std::move(out));
}

std::uint32_t whole(const FunctionCall& call, std::size_t index, std::uint32_t otherwise) {
    if (call.count() <= index || !call[index].is_number()) return otherwise;
    const double n = call[index].number();
    return n >= 0 && n < 4294967296.0 ? static_cast<std::uint32_t>(n) : 0;
}

}  // namespace

Value function_search(FunctionCall& call) {
    if (call.count() < 2) return wrong_count(call);
    const Question q{call, whole(call, 2, 1), whole(call, 3, 0)};
    const Value &what = call[0], &table = call[1];
    if (what.is_number()) return search_number(what, table, q);
    if (what.is_string() && table.is_string()) return search_string_in_string(what.string(), table.string(), q);
    if (what.is_string()) {
        if (table.is_vector()) return search_string_in_table(what.string(), table, q);
        return search_string_in_table(what.string(), call.machine.heap().vector(std::vector<Value>{}), q);
    }
    if (what.is_vector()) return search_list(what, table, q);
    return {};
}

}  // namespace whittle
