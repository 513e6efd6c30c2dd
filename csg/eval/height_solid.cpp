// height_solid.cpp — see imports.h.
#include <algorithm>
#include <cmath>

#include "csg/eval/imports.h"

namespace whittle {
namespace {

using Index = std::uint32_t;

class HeightBuilder {
public:
    HeightBuilder(const HeightMap& map, Vec2 offset) : map_(map), columns_(map.columns), rows_(map.rows) {
        for (const double z : map.z) floor_ = std::min(floor_, z - 1);
        for (Index r = 0; r < rows_; ++r)
            for (Index c = 0; c < columns_; ++c) mesh_.points.push_back({c + offset.x, r + offset.y, map_.z[at(c, r)]});
        means_ = static_cast<Index>(mesh_.points.size());
        for (Index r = 0; r + 1 < rows_; ++r)
            for (Index c = 0; c + 1 < columns_; ++c) {
                const double mean = (map_.z[at(c, r)] + map_.z[at(c + 1, r)] + map_.z[at(c, r + 1)] + map_.z[at(c + 1, r + 1)]) / 4;
                mesh_.points.push_back({c + 0.5 + offset.x, r + 0.5 + offset.y, mean});
            }
    }

    FacetList mesh() {
        top();
        walls();
        bottom();
        return std::move(mesh_);
    }

private:
    Index at(Index c, Index r) const { return r * columns_ + c; }

    void top() {
        for (Index r = 0; r + 1 < rows_; ++r)
            for (Index c = 0; c + 1 < columns_; ++c) {
                const Index m = means_ + r * (columns_ - 1) + c;
                const Index a = at(c, r), b = at(c + 1, r), d = at(c + 1, r + 1), e = at(c, r + 1);
                for (const auto& [p, q] : {std::pair(a, b), {b, d}, {d, e}, {e, a}}) mesh_.facets.push_back({p, q, m});
            }
    }

    // The border, counter-clockwise seen from above, and the same points on the floor.
    void walls() {
        std::vector<Index> border;
        for (Index c = 0; c + 1 < columns_; ++c) border.push_back(at(c, 0));
        for (Index r = 0; r + 1 < rows_; ++r) border.push_back(at(columns_ - 1, r));
        for (Index c = columns_ - 1; c > 0; --c) border.push_back(at(c, rows_ - 1));
        for (Index r = rows_ - 1; r > 0; --r) border.push_back(at(0, r));
        floor_of_.assign(map_.z.size(), 0);
        for (const Index i : border) {
            floor_of_[i] = static_cast<Index>(mesh_.points.size());
            mesh_.points.push_back({mesh_.points[i].x, mesh_.points[i].y, floor_});
        }
        for (std::size_t i = 0; i < border.size(); ++i) {
            const Index a = border[i], b = border[(i + 1) % border.size()];
            mesh_.facets.push_back({floor_of_[a], floor_of_[b], b, a});
        }
    }

    // Strips along y; the outer two take the points of their walls along.
    void bottom() {
        for (Index c = 0; c + 1 < columns_; ++c) {
            std::vector<Index> facet{floor_of_[at(c + 1, 0)], floor_of_[at(c, 0)]};
            if (c == 0)
                for (Index r = 1; r + 1 < rows_; ++r) facet.push_back(floor_of_[at(0, r)]);
            facet.push_back(floor_of_[at(c, rows_ - 1)]);
            facet.push_back(floor_of_[at(c + 1, rows_ - 1)]);
            if (c + 2 == columns_)
                for (Index r = rows_ - 2; r > 0; --r) facet.push_back(floor_of_[at(columns_ - 1, r)]);
            mesh_.facets.push_back(std::move(facet));
        }
    }

    const HeightMap& map_;
    Index columns_, rows_, means_ = 0;
    double floor_ = 0;
    std::vector<Index> floor_of_;
    FacetList mesh_;
};

}  // namespace

FacetList height_solid(const HeightMap& map, Vec2 offset) {
    if (map.columns < 2 || map.rows < 2) return {};
    return HeightBuilder(map, offset).mesh();
}

}  // namespace whittle
