#include "modeler/mesh/weld.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>
#include <unordered_map>

#include "modeler/arrange/edge_order.h"

namespace whittle {
namespace {

using Bits = std::array<std::uint64_t, 3>;

Bits bits_of(const Vec3& p) {  // -0 and 0 are one
    return {std::bit_cast<std::uint64_t>(p.x + 0.0), std::bit_cast<std::uint64_t>(p.y + 0.0), std::bit_cast<std::uint64_t>(p.z + 0.0)};
}
struct BitsHash {
    std::size_t operator()(const Bits& b) const {
        std::uint64_t h = 0x9E3779B97F4A7C15ULL;
        for (const std::uint64_t x : b) h = (h ^ x) * 0xD6E8FEB86659FD93ULL, h ^= h >> 32;
        return h;
    }
};

// Which triangles are halves of opposite pairs on the same three corners.
std::vector<bool> folded(const std::vector<Triangle>& triangles, std::size_t points) {
    struct Entry {
        Triangle corners;
        bool odd;
        std::uint32_t index;
    };
    std::vector<Entry> entries;
    entries.reserve(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        Triangle t = triangles[i];
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        const bool odd = t[1] > t[2];
        if (odd) std::swap(t[1], t[2]);
        entries.push_back({t, odd, static_cast<std::uint32_t>(i)});
    }
    sort_edges(entries, points, [](const Entry& e) { return e.corners[0]; },
               [](const Entry& a, const Entry& b) { return a.corners != b.corners ? a.corners < b.corners : a.index < b.index; });
    std::vector<bool> gone(triangles.size(), false);
    for (std::size_t i = 0, j; i < entries.size(); i = j) {
        for (j = i + 1; j < entries.size() && entries[j].corners == entries[i].corners;) ++j;
        if (j - i == 1) continue;
        std::vector<std::uint32_t> even, odd;
        for (std::size_t k = i; k < j; ++k) (entries[k].odd ? odd : even).push_back(entries[k].index);
        for (std::size_t k = 0; k < std::min(even.size(), odd.size()); ++k) gone[even[k]] = gone[odd[k]] = true;
    }
    return gone;
}

}  // namespace

void weld(Mesh& mesh) {
    std::unordered_map<Bits, std::uint32_t, BitsHash> index;
    index.reserve(mesh.points.size());
    std::vector<std::uint32_t> joined;
    joined.reserve(mesh.points.size());
    std::vector<Vec3> distinct;
    for (const Vec3& p : mesh.points) {
        const auto [at, fresh] = index.try_emplace(bits_of(p), static_cast<std::uint32_t>(distinct.size()));
        if (fresh) distinct.push_back(p + 0.0);
        joined.push_back(at->second);
    }
    for (Triangle& t : mesh.triangles)
        for (std::uint32_t& v : t) v = joined[v];
    const std::vector<bool> gone = folded(mesh.triangles, distinct.size());
    const bool tagged = !mesh.leaf.empty();
    Mesh out;
    constexpr auto kUnused = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> renamed(distinct.size(), kUnused);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        Triangle t = mesh.triangles[i];
        if (gone[i] || t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
        for (std::uint32_t& v : t) {
            if (renamed[v] == kUnused) {
                renamed[v] = static_cast<std::uint32_t>(out.points.size());
                out.points.push_back(distinct[v]);
            }
            v = renamed[v];
        }
        out.triangles.push_back(t);
        if (tagged) out.leaf.push_back(mesh.leaf[i]);
    }
    mesh = std::move(out);
}

std::uint64_t count_open_edges(const std::vector<Triangle>& triangles) {
    std::vector<std::uint64_t> edges;  // (smaller, larger, direction)
    edges.reserve(triangles.size() * 3);
    std::size_t points = 0;
    for (const Triangle& t : triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            points = std::max<std::size_t>(points, t[k] + std::size_t{1});
            const std::uint64_t a = t[k], b = t[(k + 1) % 3];
            edges.push_back(a < b ? a << 33 | b << 1 : b << 33 | a << 1 | 1);
        }
    sort_edges(edges, points, [](std::uint64_t e) { return e >> 33; }, std::less<>());
    std::uint64_t open = 0;
    for (std::size_t i = 0, j; i < edges.size(); i = j) {
        std::int64_t balance = 0;
        for (j = i; j < edges.size() && edges[j] >> 1 == edges[i] >> 1; ++j) balance += (edges[j] & 1) != 0 ? -1 : 1;
        if (balance != 0) open += static_cast<std::uint64_t>(balance < 0 ? -balance : balance);
    }
    return open;
}

}  // namespace whittle
