// Built-in functions on lists, strings and random numbers.
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "csg/eval/builtin_function_parts.h"
#include "csg/eval/machine.h"

namespace whittle {

std::vector<std::string_view> code_points(std::string_view text) {
    std::vector<std::string_view> out;
    for (std::size_t i = 0; i < text.size();) {
        std::size_t end = i + 1;
        while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) ++end;
        out.push_back(text.substr(i, end - i));
        i = end;
    }
    return out;
}

std::uint32_t first_code_point(std::string_view s) {
    const unsigned char lead = static_cast<unsigned char>(s[0]);
    std::uint32_t code = lead < 0x80 ? lead : lead < 0xE0 ? lead & 0x1F : lead < 0xF0 ? lead & 0x0F : lead & 0x07;
    for (std::size_t i = 1; i < s.size() && (static_cast<unsigned char>(s[i]) & 0xC0) == 0x80; ++i) code = (code << 6) | (static_cast<unsigned char>(s[i]) & 0x3F);
    return code;
}

Value function_len(FunctionCall& call) {
    if (call.count() != 1) return wrong_count(call);
    if (call[0].is_vector()) return Value(static_cast<double>(call[0].size()));
    if (call[0].is_string()) return Value(static_cast<double>(call[0].string_object().points));
    if (call[0].is_record()) return Value(static_cast<double>(call[0].record().size));
    return wrong_type(call);
}

Value function_str(FunctionCall& call) {
    // A long text that is added to is not copied.
    constexpr std::size_t kLong = 128;
    const bool grows = call.count() > 1 && call[0].is_string() && call[0].string().size() >= kLong;
    std::string out;
    for (const Value& v : call.arguments.subspan(grows ? 1 : 0)) {
        if (v.is_string()) out += v.string();
        else call.machine.append_text(out, v);
    }
    return grows ? call.machine.heap().appended(call[0].string_object(), out) : call.machine.heap().string(out);
}

namespace {

void append_code_point(std::string& out, double number) {
    if (!(number >= 1 && number < 1114112)) return;
    const unsigned long c = static_cast<unsigned long>(number);
    if (c >= 0xD800 && c < 0xE000) return;
    const auto put = [&out](unsigned long byte) { out.push_back(static_cast<char>(byte)); };
    if (c < 0x80) return put(c);
    if (c < 0x800) {
        put(0xC0 | (c >> 6));
    } else {
        if (c < 0x10000) {
            put(0xE0 | (c >> 12));
        } else {
            put(0xF0 | (c >> 18));
            put(0x80 | ((c >> 12) & 0x3F));
        }
        put(0x80 | ((c >> 6) & 0x3F));
    }
    put(0x80 | (c & 0x3F));
}

constexpr std::uint32_t kMaxCharacters = 10000;  // of a range in chr()

// The characters of a number, a range, or a list of those, however deep.
void append_characters(FunctionCall& call, std::string& out, const Value& v) {
    call.machine.tick();
    if (v.is_number()) append_code_point(out, v.number());
    if (v.is_vector())
        for (std::uint32_t i = 0; i < v.size(); ++i) append_characters(call, out, v[i]);
    if (!v.is_range()) return;
    const std::uint32_t count = range_count(v.range());
    if (count >= kMaxCharacters) return call.machine.warn({}, fmt::format("Bad range parameter in for statement: too many elements ({}).", count));
    for (std::uint32_t i = 0; i < count; ++i) append_code_point(out, range_at(v.range(), i));
}

}  // namespace

Value function_chr(FunctionCall& call) {
    std::string out;
    for (const Value& v : call.arguments) append_characters(call, out, v);
    return call.machine.heap().string(out);
}

Value function_ord(FunctionCall& call) {
    if (call.count() == 0) return {};
    if (call.count() != 1) {
        call.machine.warn(call.place, fmt::format("ord() called with {} arguments, only 1 argument expected", call.count()));
        return {};
    }
    if (!call[0].is_string()) {
        call.machine.warn(call.place, fmt::format("ord() argument {} is not of type string", call.machine.text_of(call[0])));
        return {};
    }
    const std::string_view s = call[0].string();
    if (s.empty()) return {};
    return Value(static_cast<double>(first_code_point(s)));
}

Value function_concat(FunctionCall& call) {
    std::size_t count = 0;
    for (const Value& v : call.arguments) count += v.is_vector() ? v.size() : 1;
    std::vector<Value> out;
    out.reserve(count);
    for (const Value& v : call.arguments) {
        if (v.is_vector()) out.insert(out.end(), v.vector().data(), v.vector().data() + v.size());
        else out.push_back(v);
    }
    return call.machine.heap().vector(std::move(out));
}

namespace {

bool is_number_pair(const Value& row, LookupPair& pair) {
    if (!row.is_vector() || row.size() != 2 || !row[0].is_number() || !row[1].is_number()) return false;
    pair = {row[0].number(), row[1].number()};
    return true;
}

// The pairs around p: the greatest key up to it and the least from it on, the first of equals. Where there is none, one on the other side of p.
struct Neighbours { LookupPair low, high; };

Neighbours neighbours_in(const Value& table, const LookupPair& first, double p) {
    LookupPair low = first, high = first, pair;
    for (std::uint32_t i = 1; i < table.size(); ++i) {
        if (!is_number_pair(table[i], pair)) continue;
        if (pair.key <= p && (pair.key > low.key || low.key > p)) low = pair;
        if (pair.key >= p && (pair.key < high.key || high.key < p)) high = pair;
    }
    return {low, high};
}

Neighbours neighbours_in(std::span<const LookupPair> sorted, double p) {
    const auto from = std::lower_bound(sorted.begin(), sorted.end(), p, [](const LookupPair& pair, double key) { return pair.key < key; });
    if (from == sorted.end()) return {sorted.back(), sorted.back()};
    if (from == sorted.begin() || from->key == p) return {*from, *from};
    return {from[-1], *from};
}

}  // namespace

// Between the nearest keys on either side, linearly; beyond the ends, the end's value. The table need not be sorted.
Value function_lookup(FunctionCall& call) {
    if (call.count() != 2) return wrong_count(call);
    if (!call[0].is_number() || !std::isfinite(call[0].number())) {
        call.machine.warn(call.place, fmt::format("lookup({}, ...) first argument is not a number", call.machine.text_of(call[0])));
        return {};
    }
    if (!call[1].is_vector()) return {};
    const Value& table = call[1];
    const double p = call[0].number();
    LookupPair first;
    if (table.size() == 0 || !is_number_pair(table[0], first)) return {};
    const std::span<const LookupPair> sorted = call.machine.lookup_memo().pairs(table, is_number_pair);
    const auto [low, high] = sorted.empty() ? neighbours_in(table, first, p) : neighbours_in(sorted, p);
    if (p <= low.key) return Value(high.value);
    if (p >= high.key) return Value(low.value);
    const double f = (p - low.key) / (high.key - low.key);
    return Value(high.value * f + low.value * (1 - f));
}

Value function_norm(FunctionCall& call) {
    if (call.count() != 1) return wrong_count(call);
    const Value& v = call[0];
    double sum = 0;
    bool good = v.is_vector();
    for (std::uint32_t i = 0; good && i < v.size(); ++i) {
        good = v[i].is_number();
        if (good) sum += v[i].number() * v[i].number();
    }
    if (good) return Value(std::sqrt(sum));
    if (v.is_vector()) call.machine.warn(call.place, "Incorrect arguments to norm()", signature_hint("norm"));
    return {};
}

Value function_cross(FunctionCall& call) {
    const auto refuse = [&call](const char* text) {
        call.machine.warn(call.place, text, signature_hint("cross"));
        return Value();
    };
    if (call.count() != 2) return refuse("Invalid number of parameters for cross()");
    const Value &a = call[0], &b = call[1];
    if (!a.is_vector() || !b.is_vector()) return refuse("Invalid type of parameters for cross()");
    const bool flat = a.size() == 2 && b.size() == 2;
    if (!flat && (a.size() != 3 || b.size() != 3)) return refuse("Invalid vector size of parameter for cross()");
    for (std::uint32_t i = 0; i < a.size() && !flat; ++i)
        for (const Value* v : {&a[i], &b[i]}) {
            if (!v->is_number()) return refuse("Invalid value in parameter vector for cross()");
            if (std::isnan(v->number())) return refuse("Invalid value (NaN) in parameter vector for cross()");
            if (std::isinf(v->number())) return refuse("Invalid value (INF) in parameter vector for cross()");
        }
    const auto n = [](const Value& v) { return v.is_number() ? v.number() : 0; };
    if (flat) return Value(n(a[0]) * n(b[1]) - n(a[1]) * n(b[0]));
    const double out[3] = {n(a[1]) * n(b[2]) - n(a[2]) * n(b[1]), n(a[2]) * n(b[0]) - n(a[0]) * n(b[2]), n(a[0]) * n(b[1]) - n(a[1]) * n(b[0])};
    return call.machine.heap().numbers(out, 3);
}

namespace {

// A double as 32 bits, integers below 2^31 as themselves. Source: Python's numeric hash for a modulus of 2^31-1 (Language reference, hash of numeric types).
std::uint32_t seed_of(double number) {
    constexpr int kBits = 31;
    constexpr std::uint32_t kModulus = (std::uint32_t{1} << kBits) - 1;
    if (!std::isfinite(number)) return std::isnan(number) ? 0 : number > 0 ? 314159u : static_cast<std::uint32_t>(-314159);
    int exponent = 0;
    double m = std::frexp(number, &exponent);
    const bool negative = m < 0;
    m = std::fabs(m);
    std::uint32_t x = 0;
    while (m != 0) {
        x = ((x << 28) & kModulus) | (x >> (kBits - 28));
        m *= 268435456.0;
        exponent -= 28;
        const std::uint32_t digit = static_cast<std::uint32_t>(m);
        m -= digit;
        x += digit;
        if (x >= kModulus) x -= kModulus;
    }
    exponent = exponent >= 0 ? exponent % kBits : kBits - 1 - ((-1 - exponent) % kBits);
    x = ((x << exponent) & kModulus) | (x >> (kBits - exponent));
    return negative ? 0u - x : x;
}

}  // namespace

Value function_rands(FunctionCall& call) {
    if (call.count() != 3 && call.count() != 4) return wrong_count(call);
    for (const Value& v : call.arguments)
        if (!v.is_number()) return {};
    double low = call[0].number(), high = call[1].number(), wanted = call[2].number();
    constexpr double kHalf = std::numeric_limits<double>::max() / 2;
    const auto bounded = [&](double& end, const char* which, double otherwise) {
        if (std::isfinite(end)) return;
        call.machine.warn(call.place, fmt::format("rands() range {} cannot be infinite", which));
        end = otherwise;
        call.machine.warn({}, fmt::format("resetting to {:f}", end));
    };
    bounded(low, "min", -kHalf);
    bounded(high, "max", kHalf);
    if (high < low) std::swap(low, high);
    if (!std::isfinite(wanted)) {
        call.machine.warn(call.place, "rands() cannot create an infinite number of results");
        call.machine.warn({}, "resetting number of results to 1");
        wanted = 1;
    }
    if (call.count() == 4) call.machine.random().seed(seed_of(call[3].number()));
    const std::size_t count = static_cast<std::size_t>(std::min(std::fabs(wanted), 1e9));
    std::vector<Value> out;
    for (std::size_t i = 0; i < count; ++i) {
        call.machine.tick();
        out.emplace_back(low >= high ? low : call.machine.random().next(low, high));
    }
    return call.machine.heap().vector(std::move(out));
}

}  // namespace whittle
