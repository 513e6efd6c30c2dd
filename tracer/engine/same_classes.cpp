#include "tracer/engine/same_classes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <map>

#include "tracer/engine/program.h"

namespace whittle {

namespace {

// All of a support but its frame.
std::array<std::uint64_t, 11> key_of(const Support& s) {
    std::array<std::uint64_t, 11> key;
    std::transform(s.p.begin(), s.p.end(), key.begin(), [](double x) { return std::bit_cast<std::uint64_t>(x + 0.0); });  // -0 is 0
    key.back() = static_cast<std::uint64_t>(s.kind) << 8 | s.axis;
    return key;
}

}  // namespace

std::vector<ClassId> same_classes(const Program& part, const Program& whole) {
    const auto still = [](const Program& program, const Support& s) { return has_polynomial(s.kind) && program.frames[s.frame].motion == 0; };
    std::multimap<std::array<std::uint64_t, 11>, ClassId> known;
    for (ClassId id = 0; id < whole.classes.size(); ++id)
        if (still(whole, whole.classes[id])) known.emplace(key_of(whole.classes[id]), id);
    std::vector<ClassId> same(part.classes.size(), kNoClass);
    for (std::size_t id = 0; id < same.size(); ++id) {
        const Support& own = part.classes[id];
        if (!still(part, own)) continue;
        const auto [from, to] = known.equal_range(key_of(own));
        const auto found = std::find_if(from, to, [&](const auto& other) { return stand_alike(part.frames[own.frame], whole.frames[whole.classes[other.second].frame]); });
        if (found != to) same[id] = found->second;
    }
    return same;
}

}  // namespace whittle
