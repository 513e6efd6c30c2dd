#include "modeler/mesh/mend.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <queue>

#include <fmt/format.h>

#include "csg/solid/polyhedron.h"
#include "modeler/arrange/crossings.h"
#include "modeler/mesh/weld.h"

namespace whittle {
namespace {

using Index = std::uint32_t;

// Rounding to float32 moves a coordinate by 2^-24 of its size at most; two borders that were one are twice that apart, a little more after a rotation.
constexpr double kRoundingShare = 0x1p-22;

struct Edge {
    Index from, to, triangle;
    std::uint64_t key() const { return std::uint64_t{std::min(from, to)} << 32 | std::max(from, to); }
};

// Sorted by undirected edge, then triangle.
std::vector<Edge> edges_of(const std::vector<Triangle>& triangles) {
    std::vector<Edge> edges;
    edges.reserve(triangles.size() * 3);
    for (Index i = 0; i < triangles.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) edges.push_back({triangles[i][k], triangles[i][(k + 1) % 3], i});
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.key() != b.key() ? a.key() < b.key() : a.triangle < b.triangle; });
    return edges;
}

template <class Run>
void for_each_edge(const std::vector<Edge>& edges, Run run) {
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t j = i;
        while (j < edges.size() && edges[j].key() == edges[i].key()) ++j;
        run(i, j);
        i = j;
    }
}

// Directed edges that lack an opposite one, as often as they lack it.
std::vector<Edge> border_of(const std::vector<Triangle>& triangles) {
    const auto edges = edges_of(triangles);
    std::vector<Edge> border;
    for_each_edge(edges, [&](std::size_t i, std::size_t j) {
        std::vector<Edge> up, down;
        for (std::size_t k = i; k < j; ++k) (edges[k].from < edges[k].to ? up : down).push_back(edges[k]);
        const auto& more = up.size() > down.size() ? up : down;
        border.insert(border.end(), more.begin() + static_cast<std::ptrdiff_t>(std::min(up.size(), down.size())), more.end());
    });
    return border;
}

std::size_t drop_copies(Mesh& mesh) {
    std::vector<std::pair<Triangle, Index>> sorted;
    for (Index i = 0; i < mesh.triangles.size(); ++i) {
        Triangle t = mesh.triangles[i];
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        sorted.emplace_back(t, i);
    }
    std::sort(sorted.begin(), sorted.end());
    std::vector<bool> copy(mesh.triangles.size());
    for (std::size_t i = 1; i < sorted.size(); ++i) copy[sorted[i].second] = sorted[i].first == sorted[i - 1].first;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < copy.size(); ++i)
        if (!copy[i]) mesh.triangles[kept++] = mesh.triangles[i];
    mesh.triangles.resize(kept);
    return copy.size() - kept;
}

// Points of the border that are a rounding apart become one: the first. Sorted by x, each looks ahead as far as the tolerance reaches.
std::size_t join_border(Mesh& mesh, double& farthest) {
    std::vector<Index> points;
    for (const Edge& e : border_of(mesh.triangles)) points.push_back(e.from), points.push_back(e.to);
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    const Bounds box = mesh_bounds(mesh);
    const Vec3 reach = glm::max(glm::abs(box.lo), glm::abs(box.hi));
    const double tolerance = kRoundingShare * std::max({reach.x, reach.y, reach.z});
    std::sort(points.begin(), points.end(), [&](Index a, Index b) { return mesh.points[a].x != mesh.points[b].x ? mesh.points[a].x < mesh.points[b].x : a < b; });
    std::vector<Index> onto(mesh.points.size());
    std::iota(onto.begin(), onto.end(), 0U);
    std::size_t joined = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (onto[points[i]] != points[i]) continue;
        for (std::size_t k = i + 1; k < points.size() && mesh.points[points[k]].x - mesh.points[points[i]].x <= tolerance; ++k) {
            const double apart = glm::length(mesh.points[points[k]] - mesh.points[points[i]]);
            if (onto[points[k]] != points[k] || apart > tolerance) continue;
            onto[points[k]] = points[i];
            farthest = std::max(farthest, apart);
            ++joined;
        }
    }
    for (Triangle& t : mesh.triangles)
        for (Index& v : t) v = onto[v];
    if (joined > 0) weld(mesh);
    return joined;
}

// Neighbours over edges of exactly two triangles agree afterwards; the larger side of a disagreement keeps its orientation.
std::size_t turn_facets(Mesh& mesh) {
    const auto edges = edges_of(mesh.triangles);
    std::vector<std::vector<std::pair<Index, bool>>> neighbours(mesh.triangles.size());  // and whether they disagree
    for_each_edge(edges, [&](std::size_t i, std::size_t j) {
        if (j - i != 2) return;
        const bool disagree = edges[i].from == edges[i + 1].from;
        neighbours[edges[i].triangle].emplace_back(edges[i + 1].triangle, disagree);
        neighbours[edges[i + 1].triangle].emplace_back(edges[i].triangle, disagree);
    });
    std::size_t turned = 0;
    std::vector<std::int8_t> state(mesh.triangles.size(), -1);
    for (Index start = 0; start < mesh.triangles.size(); ++start) {
        if (state[start] >= 0) continue;
        std::vector<Index> shell{start};
        state[start] = 0;
        std::size_t flipped = 0;
        for (std::size_t at = 0; at < shell.size(); ++at)
            for (const auto& [next, disagree] : neighbours[shell[at]]) {
                if (state[next] >= 0) continue;
                state[next] = static_cast<std::int8_t>(state[shell[at]] ^ static_cast<int>(disagree));
                flipped += static_cast<std::size_t>(state[next]);
                shell.push_back(next);
            }
        const bool rest = flipped * 2 > shell.size();
        for (const Index i : shell)
            if ((state[i] == 1) != rest) std::swap(mesh.triangles[i][1], mesh.triangles[i][2]), ++turned;
    }
    return turned;
}

// Closed walks along the border, each from its first point back to it, cut wherever a walk meets itself.
std::vector<std::vector<Index>> loops_of(const std::vector<Edge>& border) {
    std::map<Index, std::vector<Index>> next;
    for (const Edge& e : border) next[e.from].push_back(e.to);
    std::vector<std::vector<Index>> loops;
    for (auto& [start, targets] : next)
        while (!targets.empty()) {
            std::vector<Index> walk{start};
            std::map<Index, std::size_t> met{{start, 0}};
            while (true) {
                auto& out = next[walk.back()];
                if (out.empty()) break;
                const Index to = out.back();
                out.pop_back();
                const auto seen = met.find(to);
                if (seen == met.end()) {
                    met[to] = walk.size();
                    walk.push_back(to);
                    continue;
                }
                loops.emplace_back(walk.begin() + static_cast<std::ptrdiff_t>(seen->second), walk.end());
                for (std::size_t i = seen->second + 1; i < walk.size(); ++i) met.erase(walk[i]);
                walk.resize(seen->second + 1);
            }
        }
    return loops;
}

struct Patches { std::size_t holes = 0, edges = 0, largest = 0; };

Patches close_holes(Mesh& mesh) {
    Patches made;
    const auto loops = loops_of(border_of(mesh.triangles));
    FacetList points;
    if (!loops.empty()) points.points = mesh.points;
    for (auto loop : loops) {
        ++made.holes;
        made.edges += loop.size();
        made.largest = std::max(made.largest, loop.size());
        if (loop.size() < 3) continue;
        std::reverse(loop.begin(), loop.end());
        for (const auto& t : triangulated(points, loop)) mesh.triangles.push_back({t[0], t[1], t[2]});
    }
    return made;
}

// ------------------------------------------------------------------------------------------------------------------ shells

class Sets {
public:
    explicit Sets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0U); }
    Index of(Index i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(Index a, Index b) { parent_[std::max(of(a), of(b))] = std::min(of(a), of(b)); }

private:
    std::vector<Index> parent_;
};

struct Shell {
    std::vector<Triangle> triangles;
    Bounds box;
    double volume = 0;
};

std::vector<Shell> shells(const Mesh& mesh) {
    Sets sets(mesh.triangles.size());
    const auto edges = edges_of(mesh.triangles);
    for_each_edge(edges, [&](std::size_t i, std::size_t j) {
        const Index first = edges[i].triangle;
        for (const Edge *e = edges.data() + i, *end = edges.data() + j; e != end; ++e) sets.join(first, e->triangle);
    });
    std::map<Index, Shell> by_first;
    for (Index i = 0; i < mesh.triangles.size(); ++i) by_first[sets.of(i)].triangles.push_back(mesh.triangles[i]);
    std::vector<Shell> out;
    for (auto& [first, shell] : by_first) {
        const Vec3 o = mesh.points[shell.triangles[0][0]];
        shell.box = {o, o};
        for (const Triangle& t : shell.triangles) {
            for (const Index v : t) shell.box.lo = glm::min(shell.box.lo, mesh.points[v]), shell.box.hi = glm::max(shell.box.hi, mesh.points[v]);
            shell.volume += glm::dot(mesh.points[t[0]] - o, glm::cross(mesh.points[t[1]] - o, mesh.points[t[2]] - o)) / 6;
        }
        out.push_back(std::move(shell));
    }
    return out;
}

bool holds(const Bounds& a, const Bounds& b) {
    return a.lo.x <= b.lo.x && a.lo.y <= b.lo.y && a.lo.z <= b.lo.z && a.hi.x >= b.hi.x && a.hi.y >= b.hi.y && a.hi.z >= b.hi.z;
}
bool meet(const Bounds& a, const Bounds& b) {
    return a.lo.x <= b.hi.x && a.lo.y <= b.hi.y && a.lo.z <= b.hi.z && a.hi.x >= b.lo.x && a.hi.y >= b.lo.y && a.hi.z >= b.lo.z;
}
double room(const Bounds& b) {
    const Vec3 s = b.hi - b.lo;
    return s.x * s.y * s.z;
}
void turn(Shell& shell) {
    for (Triangle& t : shell.triangles) std::swap(t[1], t[2]);
    shell.volume = -shell.volume;
}

// Cavities join the smallest shell around them; what has none around it was inside out.
std::vector<Shell> with_cavities(std::vector<Shell> all, std::size_t& turned) {
    const auto largest = std::max_element(all.begin(), all.end(), [](const Shell& a, const Shell& b) { return std::fabs(a.volume) < std::fabs(b.volume); });
    if (largest->volume < 0) {
        for (Shell& s : all) turn(s);
        turned += all.size();
    }
    std::stable_partition(all.begin(), all.end(), [](const Shell& s) { return s.volume > 0; });
    std::vector<Shell> out;
    std::vector<Bounds> boxes;
    for (Shell& s : all) {
        std::size_t home = boxes.size();
        if (s.volume < 0)
            for (std::size_t i = 0; i < boxes.size(); ++i)
                if (holds(boxes[i], s.box) && (home == boxes.size() || room(boxes[i]) < room(boxes[home]))) home = i;
        if (home < boxes.size()) {
            out[home].triangles.insert(out[home].triangles.end(), s.triangles.begin(), s.triangles.end());
            continue;
        }
        if (s.volume < 0) turn(s), ++turned;
        boxes.push_back(s.box);
        out.push_back(std::move(s));
    }
    return out;
}

std::shared_ptr<const FacetList> facets_of(const Mesh& mesh, const std::vector<Triangle>& triangles) {
    auto list = std::make_shared<FacetList>();
    constexpr Index kUnused = 0xFFFFFFFF;
    std::vector<Index> number(mesh.points.size(), kUnused);
    list->facets.reserve(triangles.size());
    for (const Triangle& t : triangles) {
        std::vector<Index> facet;
        for (const Index v : t) {
            if (number[v] == kUnused) {
                number[v] = static_cast<Index>(list->points.size());
                list->points.push_back(mesh.points[v]);
            }
            facet.push_back(number[v]);
        }
        list->facets.push_back(std::move(facet));
    }
    return list;
}

std::vector<Triangle> triangles_of(const FacetList& list) {
    std::vector<Triangle> triangles;
    for (const auto& f : list.facets) triangles.push_back({f[0], f[1], f[2]});
    return triangles;
}

}  // namespace

void close_mesh(Mesh& mesh, std::vector<std::string>& remarks) {
    mesh.leaf.clear();
    if (const std::size_t copies = drop_copies(mesh); copies > 0) remarks.push_back(fmt::format("{} facets were there twice, dropped", copies));
    const std::uint64_t open = count_open_edges(mesh.triangles);
    if (open == 0) return;
    double farthest = 0;
    if (const std::size_t joined = join_border(mesh, farthest); joined > 0)
        remarks.push_back(fmt::format("{} points on open borders joined with others at most {:.3g} away", joined, farthest));
    if (count_open_edges(mesh.triangles) == 0) return;
    if (const std::size_t turned = turn_facets(mesh); turned > 0) remarks.push_back(fmt::format("{} facets faced the other way than their neighbours, turned", turned));
    if (const Patches made = close_holes(mesh); made.holes > 0)
        remarks.push_back(fmt::format("is not closed: {} open edges around {} holes, closed by patches (the largest has {} edges)", made.edges, made.holes, made.largest));
    weld(mesh);
}

std::vector<std::shared_ptr<const FacetList>> shells_of(const Mesh& mesh, std::vector<std::string>& remarks) {
    std::vector<Shell> all = shells(mesh);
    const std::size_t before = all.size();
    all.erase(std::remove_if(all.begin(), all.end(), [](const Shell& s) { return s.volume == 0; }), all.end());
    if (all.size() < before) remarks.push_back(fmt::format("{} shells enclose nothing, dropped", before - all.size()));
    if (all.empty()) return {};
    std::size_t turned = 0;
    all = with_cavities(std::move(all), turned);
    if (turned > 0) remarks.push_back(fmt::format("{} shells were inside out, turned", turned));
    // Layers of shells whose boxes are apart: one polyhedron each.
    std::vector<std::vector<std::size_t>> layers;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto fits = [&](const std::vector<std::size_t>& layer) { return std::none_of(layer.begin(), layer.end(), [&](std::size_t k) { return meet(all[i].box, all[k].box); }); };
        const auto home = std::find_if(layers.begin(), layers.end(), fits);
        if (home == layers.end()) layers.push_back({i});
        else home->push_back(i);
    }
    std::vector<std::shared_ptr<const FacetList>> out;
    for (const auto& layer : layers) {
        std::vector<Triangle> triangles;
        for (const std::size_t i : layer) triangles.insert(triangles.end(), all[i].triangles.begin(), all[i].triangles.end());
        out.push_back(facets_of(mesh, triangles));
    }
    return out;
}

ImportedMesh mended(Mesh mesh) {
    ImportedMesh out;
    weld(mesh);
    if (mesh.triangles.empty()) return out;
    close_mesh(mesh, out.remarks);
    std::uint64_t crossings = 0;
    for (auto& solid : shells_of(mesh, out.remarks)) {
        crossings += count_crossings(solid->points, triangles_of(*solid));
        out.solids.push_back({std::move(solid), {}, {}});
    }
    if (crossings > 0) out.remarks.push_back(fmt::format("crosses itself: {} pairs of facets; inside is where an odd number of crossings leads", crossings));
    return out;
}

}  // namespace whittle
