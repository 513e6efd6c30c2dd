#include "csg/solid/clean_paths.h"

#include <algorithm>
#include <map>

namespace whittle {
namespace {

using ClipperLib::IntPoint;
using ClipperLib::Path;
using ClipperLib::Paths;
__extension__ typedef __int128 Int128;

using Pair = std::pair<ClipperLib::cInt, ClipperLib::cInt>;
using Edge = std::pair<Pair, Pair>;

Int128 cross(const IntPoint& u, const IntPoint& v) { return static_cast<Int128>(u.X) * v.Y - static_cast<Int128>(u.Y) * v.X; }
Int128 dot(const IntPoint& u, const IntPoint& v) { return static_cast<Int128>(u.X) * v.X + static_cast<Int128>(u.Y) * v.Y; }
IntPoint minus(const IntPoint& a, const IntPoint& b) { return {a.X - b.X, a.Y - b.Y}; }
Pair pair_of(const IntPoint& p) { return {p.X, p.Y}; }
IntPoint point_of(const Pair& p) { return {p.first, p.second}; }

bool turns_back(const IntPoint& a, const IntPoint& b, const IntPoint& c) {
    const IntPoint u = minus(b, a), v = minus(c, b);
    return cross(u, v) == 0 && dot(u, v) <= 0;
}

Path without_spikes(const Path& path) {
    Path out;
    for (const IntPoint& p : path) {
        while (out.size() >= 2 && turns_back(out[out.size() - 2], out.back(), p)) out.pop_back();
        if (out.empty() || out.back() != p) out.push_back(p);
    }
    std::size_t first = 0;
    while (out.size() - first >= 3) {  // where the ends of the list meet
        if (turns_back(out[out.size() - 2], out.back(), out[first])) {
            out.pop_back();
        } else if (turns_back(out.back(), out[first], out[first + 1])) {
            ++first;
        } else {
            break;
        }
    }
    out.erase(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(first));
    return out;
}

// Contours whose sides go through every corner that lies within a step of them, seen across their longer extent.
class Router {
public:
    explicit Router(const Paths& paths) : paths_(paths) {
        for (const Path& path : paths)
            for (const IntPoint& p : path) corners_.push_back(pair_of(p));
        std::sort(corners_.begin(), corners_.end());
        corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    }

    Paths routed() const {
        Paths out;
        for (const Path& path : paths_) {
            out.emplace_back();
            for (std::size_t i = 0; i < path.size(); ++i) {
                out.back().push_back(path[i]);
                add_corners_between(path[i], path[i + 1 == path.size() ? 0 : i + 1], out.back());
            }
        }
        return out;
    }

private:
    void add_corners_between(const IntPoint& a, const IntPoint& b, Path& out) const {
        const IntPoint way = minus(b, a);
        const Int128 reach = std::max(std::abs(way.X), std::abs(way.Y)), length2 = dot(way, way);
        const auto [left, right] = std::minmax(a.X, b.X);
        const auto [low, high] = std::minmax(a.Y, b.Y);
        std::vector<std::pair<Int128, Pair>> found;
        for (auto at = std::lower_bound(corners_.begin(), corners_.end(), Pair{left - 1, low - 1}); at != corners_.end() && at->first <= right + 1; ++at) {
            if (at->second < low - 1 || at->second > high + 1) continue;
            const IntPoint to = minus(point_of(*at), a);
            const Int128 along = dot(way, to), off = cross(way, to);
            if (along > 0 && along < length2 && off <= reach && -off <= reach) found.emplace_back(along, *at);
        }
        std::sort(found.begin(), found.end());
        for (const auto& [along, p] : found) out.push_back(point_of(p));
    }

    const Paths& paths_;
    std::vector<Pair> corners_;
};

// 0: straight back, then clockwise: less than half a turn, half a turn, more.
int sector(const IntPoint& back, const IntPoint& way) {
    const Int128 c = cross(back, way);
    return c < 0 ? 1 : c > 0 ? 3 : dot(back, way) > 0 ? 0 : 2;
}

// Sides that are left where opposite ones cancel, by where they begin.
class Sides {
public:
    explicit Sides(const Paths& paths) {
        std::map<Edge, int> count;
        for (const Path& path : paths)
            for (std::size_t i = 0; i < path.size(); ++i) {
                const Pair p = pair_of(path[i]), q = pair_of(path[i + 1 == path.size() ? 0 : i + 1]);
                if (const auto back = count.find({q, p}); back != count.end() && back->second > 0) {
                    --back->second;
                    any_cancelled_ = true;
                } else {
                    ++count[{p, q}];
                }
            }
        for (const auto& [edge, times] : count)
            for (int i = 0; i < times; ++i) from_[edge.first].push_back(edge.second);
    }
    bool any_cancelled() const { return any_cancelled_; }

    // Walks with the set on the left; where contours touch, round the part of it that the walk is in.
    Paths loops() {
        Paths out;
        for (auto at = from_.begin(); at != from_.end(); ++at)
            while (!at->second.empty()) out.push_back(loop(at->first));
        return out;
    }

private:
    Path loop(const Pair& start) {
        Path out{point_of(start)};
        Pair before = start, at = from_[start].back();
        from_[start].pop_back();
        while (at != start) {
            out.push_back(point_of(at));
            const Pair next = taken(before, at);
            before = at;
            at = next;
        }
        return out;
    }
    // The first way clockwise from the one back.
    Pair taken(const Pair& before, const Pair& at) {
        auto& ways = from_[at];
        const IntPoint back = minus(point_of(before), point_of(at));
        const auto sooner = [&](const Pair& a, const Pair& b) {
            const IntPoint u = minus(point_of(a), point_of(at)), v = minus(point_of(b), point_of(at));
            const int s = sector(back, u), t = sector(back, v);
            return s != t ? s < t : cross(u, v) < 0;
        };
        const auto best = std::min_element(ways.begin(), ways.end(), sooner);
        const Pair next = *best;
        ways.erase(best);
        return next;
    }

    std::map<Pair, std::vector<Pair>> from_;
    bool any_cancelled_ = false;
};

}  // namespace

ClipperLib::Paths clean_paths(const ClipperLib::Paths& paths) {
    Paths out = paths;
    if (Sides sides(Router(paths).routed()); sides.any_cancelled()) out = sides.loops();
    for (Path& path : out) path = without_spikes(path);
    std::erase_if(out, [](const Path& path) { return path.size() < 3; });
    return out;
}

}  // namespace whittle
