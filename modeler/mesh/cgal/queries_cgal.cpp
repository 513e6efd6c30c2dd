// queries_cgal.cpp — CGAL's answer to whether a mesh crosses itself; a second opinion on crossings.h.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <exception>
#include <string>

#include "modeler/mesh/cgal/queries_module.h"

namespace whittle {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

std::vector<Point> as_points(const std::vector<Vec3>& points) {
    std::vector<Point> out;
    out.reserve(points.size());
    for (const Vec3& p : points) out.emplace_back(p.x, p.y, p.z);
    return out;
}

// Do two triangles meet beyond the vertices and the edge they share by position?
class CrossingTest {
public:
    CrossingTest(const std::vector<Point>& points, const std::vector<Triangle>& triangles) : points_(points), triangles_(triangles) {}

    bool operator()(std::size_t i, std::size_t j) const {
        const Triangle &a = triangles_[i], &b = triangles_[j];
        std::array<int, 3> in_b{};  // for each corner of a: which corner of b has its place, plus 1
        int shared = 0;
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t l = 0; l < 3; ++l)
                if (points_[a[k]] == points_[b[l]]) in_b[k] = static_cast<int>(l) + 1, ++shared;
        if (shared == 3) return true;
        if (shared == 2) return folded(a, b, in_b);
        if (shared == 1) return pierced(a, b, in_b);
        return CGAL::do_intersect(triangle(a), triangle(b));
    }

private:
    Kernel::Triangle_3 triangle(const Triangle& t) const { return {points_[t[0]], points_[t[1]], points_[t[2]]}; }

    // Two triangles on one edge cross only when they lie on each other.
    bool folded(const Triangle& a, const Triangle& b, const std::array<int, 3>& in_b) const {
        std::size_t k = 0, l = 0;
        while (in_b[k] != 0) ++k;
        while (in_b[0] == static_cast<int>(l) + 1 || in_b[1] == static_cast<int>(l) + 1 || in_b[2] == static_cast<int>(l) + 1) ++l;
        const Point &p = points_[a[(k + 1) % 3]], &q = points_[a[(k + 2) % 3]], &r = points_[a[k]], &s = points_[b[l]];
        return CGAL::orientation(p, q, r, s) == CGAL::COPLANAR && CGAL::coplanar_orientation(p, q, r, s) == CGAL::POSITIVE;
    }
    // Two triangles at one corner cross when the opposite side of one meets the other.
    bool pierced(const Triangle& a, const Triangle& b, const std::array<int, 3>& in_b) const {
        std::size_t k = 0;
        while (in_b[k] == 0) ++k;
        const auto l = static_cast<std::size_t>(in_b[k] - 1);
        const Kernel::Segment_3 side_a(points_[a[(k + 1) % 3]], points_[a[(k + 2) % 3]]), side_b(points_[b[(l + 1) % 3]], points_[b[(l + 2) % 3]]);
        return CGAL::do_intersect(side_a, triangle(b)) || CGAL::do_intersect(side_b, triangle(a));
    }

    const std::vector<Point>& points_;
    const std::vector<Triangle>& triangles_;
};

}  // namespace
}  // namespace whittle

extern "C" __attribute__((visibility("default"))) bool whittle_cgal_crossings_2(const std::vector<whittle::Vec3>& points,
                                                                                const std::vector<whittle::Triangle>& triangles, std::uint64_t& count,
                                                                                std::string& fault) {
    using namespace whittle;
    try {
        const std::vector<Point> at = as_points(points);
        using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;
        std::vector<Box> boxes;
        boxes.reserve(triangles.size());
        for (std::size_t i = 0; i < triangles.size(); ++i)
            boxes.emplace_back(at[triangles[i][0]].bbox() + at[triangles[i][1]].bbox() + at[triangles[i][2]].bbox(), i);
        const CrossingTest cross(at, triangles);
        count = 0;
        CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& x, const Box& y) { count += cross(x.info(), y.info()) ? 1U : 0U; });
        return true;
    } catch (const std::exception& e) {
        fault = e.what();
        return false;
    }
}
