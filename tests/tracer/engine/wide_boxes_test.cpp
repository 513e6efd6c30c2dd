// wide_boxes_test.cpp — the wide hierarchy holds what the binary one does, and meets boxes as a slab test does on every instruction set.
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <hwy/targets.h>

#include "tests/tracer/engine/rays.h"
#include "tracer/engine/wide.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

std::vector<Bounds> random_boxes(Random& random, int count) {
    std::vector<Bounds> boxes;
    for (int i = 0; i < count; ++i) {
        const Vec3 at = random.point({Vec3(-10), Vec3(10)});
        // Some are flat.
        const Vec3 size(random.between(0, 2), i % 3 == 0 ? 0 : random.between(0, 2), random.between(0, 2));
        boxes.push_back({at, at + size});
    }
    return boxes;
}

// Items of boxes that the ray meets when they are grown by so much of their distance from the origin, and of its own from 0.
std::vector<std::uint32_t> met_when_grown(const std::vector<FloatBox>& boxes, const SlabRay& ray, double begin, double end, double growth) {
    std::vector<std::uint32_t> met;
    for (std::uint32_t k = 0; k < boxes.size(); ++k) {
        std::array<double, 3> lo, hi;
        for (std::size_t i = 0; i < 3; ++i) {
            const double here = std::abs(ray.o[i]);
            lo[i] = boxes[k].lo[i] - growth * (here + std::abs(boxes[k].lo[i] - ray.o[i]));
            hi[i] = boxes[k].hi[i] + growth * (here + std::abs(boxes[k].hi[i] - ray.o[i]));
        }
        double from = 0, to = 0;
        if (slab_interval(lo, hi, ray, from, to) && to * (1 + growth) >= begin && from * (1 - growth) <= end) met.push_back(100 + k);
    }
    return met;
}

// Items below a node whose boxes the ray meets.
void gather(const std::vector<WideNode>& nodes, std::uint32_t at, const SlabRay& ray, double begin, double end, std::vector<std::uint32_t>& out) {
    std::array<float, kWideBoxes> from;
    for (std::uint32_t left = (ray.common ? boxes_ahead() : &boxes_ahead_in_double)(nodes[at], ray, begin, end, from).met; left != 0; left &= left - 1) {
        const WideChild child = nodes[at].child[static_cast<std::size_t>(__builtin_ctz(left))];
        if (child.is_item()) {
            out.push_back(child.index());
        } else {
            gather(nodes, child.index(), ray, begin, end, out);
        }
    }
}

}  // namespace

TEST_CASE("a ray meets in the wide hierarchy the items whose boxes it meets, on every instruction set") {
    Random random(7);
    for (const int count : {1, 2, 7, 8, 9, 64, 1000}) {
        const std::vector<Bounds> bounds = random_boxes(random, count);
        const Hierarchy binary = build_hierarchy(bounds, 4, 2);
        std::vector<FloatBox> boxes;
        for (const std::uint32_t i : binary.order) boxes.push_back(outward(bounds[i]));
        std::vector<WideNode> nodes;
        const std::uint32_t root = widen(binary, boxes, 100, nodes);
        std::size_t met = 0, uncommon = 0;
        for (int k = 0; k < 200; ++k) {
            Ray ray = random.ray_through({Vec3(-10), Vec3(10)});
            if (k % 5 == 0) ray.direction = {0, k % 2 ? 0.0 : -0.0, k % 10 ? 1.0 : -1.0};  // along an axis
            if (k % 7 == 0) ray.origin = bounds[static_cast<std::size_t>(k % count)].lo;   // from a corner
            if (k % 11 == 0) ray.direction *= k % 2 ? 1e-25 : 1e25;                         // not in float
            if (k % 13 == 0) ray.origin -= 1e5 * ray.direction;
            const SlabRay slab = slab_ray({ray.origin.x, ray.origin.y, ray.origin.z}, {ray.direction.x, ray.direction.y, ray.direction.z});
            const double begin = k % 3 == 0 ? 0.5 : 0, end = k % 4 == 0 ? HUGE_VAL : begin + 0.25 * (k % 9);
            const std::vector<std::uint32_t> expected = met_when_grown(boxes, slab, begin, end, 0), most = met_when_grown(boxes, slab, begin, end, 0x1p-20);
            met += expected.size();
            uncommon += slab.common ? 0 : 1;
            std::vector<std::uint32_t> first;
            for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
                hwy::SetSupportedTargetsForTest(target);
                std::vector<std::uint32_t> found;
                gather(nodes, root, slab, begin, end, found);
                std::sort(found.begin(), found.end());
                INFO(hwy::TargetName(target) << " " << count << " boxes, ray " << k);
                CHECK(std::includes(found.begin(), found.end(), expected.begin(), expected.end()));
                CHECK(std::includes(most.begin(), most.end(), found.begin(), found.end()));
                if (target != hwy::SupportedAndGeneratedTargets().front()) CHECK(found == first);
                first = found;
            }
            hwy::SetSupportedTargetsForTest(0);
        }
        CHECK(met > 0);
        CHECK(uncommon > 10);
    }
}

namespace {

// Items below a node whose boxes touch a box.
void gather(const std::vector<WideNode>& nodes, std::uint32_t at, const FloatBox& box, std::vector<std::uint32_t>& out) {
    for (std::uint32_t left = boxes_touched()(nodes[at], box); left != 0; left &= left - 1) {
        const WideChild child = nodes[at].child[static_cast<std::size_t>(__builtin_ctz(left))];
        if (child.is_item()) {
            out.push_back(child.index());
        } else {
            gather(nodes, child.index(), box, out);
        }
    }
}

bool touch(const FloatBox& a, const FloatBox& b) {
    for (std::size_t i = 0; i < 3; ++i)
        if (a.lo[i] > b.hi[i] || a.hi[i] < b.lo[i]) return false;
    return true;
}

}  // namespace

TEST_CASE("a box touches in the wide hierarchy the items whose boxes it touches, on every instruction set") {
    Random random(8);
    for (const int count : {1, 8, 9, 64, 1000}) {
        const std::vector<Bounds> bounds = random_boxes(random, count);
        const Hierarchy binary = build_hierarchy(bounds, 4, 2);
        std::vector<FloatBox> boxes;
        for (const std::uint32_t i : binary.order) boxes.push_back(outward(bounds[i]));
        std::vector<WideNode> nodes;
        const std::uint32_t root = widen(binary, boxes, 0, nodes);
        std::size_t touched = 0;
        for (int k = 0; k < 200; ++k) {
            FloatBox box = outward(random_boxes(random, 1)[0]);
            if (k % 3 == 0) box = {boxes[static_cast<std::size_t>(k % count)].hi, boxes[static_cast<std::size_t>(k % count)].hi};  // a corner
            if (k % 7 == 0) box.lo[1] = box.hi[1] = NAN;                                                                          // anywhere
            std::vector<std::uint32_t> expected;
            for (std::uint32_t i = 0; i < boxes.size(); ++i)
                if (touch(boxes[i], box)) expected.push_back(i);
            touched += expected.size();
            for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
                hwy::SetSupportedTargetsForTest(target);
                std::vector<std::uint32_t> found;
                gather(nodes, root, box, found);
                std::sort(found.begin(), found.end());
                INFO(hwy::TargetName(target) << " " << count << " boxes, box " << k);
                CHECK(found == expected);
            }
            hwy::SetSupportedTargetsForTest(0);
        }
        CHECK(touched > 0);
    }
}

TEST_CASE("a tile meets in a node the boxes that one by one it meets, on every instruction set, and no ray before it is told to") {
    Random random(9);
    std::size_t met = 0, missed = 0;
    for (int k = 0; k < 1500; ++k) {
        std::vector<Bounds> bounds = random_boxes(random, 1 + k % 8);
        const Hierarchy binary = build_hierarchy(bounds, 4, 2);
        std::vector<FloatBox> boxes;
        for (const std::uint32_t i : binary.order) boxes.push_back(outward(bounds[i]));
        std::vector<WideNode> nodes;
        const WideNode& node = nodes[widen(binary, boxes, 0, nodes)];
        // Rays that spread out, some from one point, some backward, some as good as along an axis.
        Ray middle = random.ray_through({Vec3(-10), Vec3(10)});
        if (k % 5 == 0) middle.direction = {0, 0, k % 2 ? 1.0 : -1.0};
        const double spread = k % 3 == 0 ? 0 : random.between(0, 2), turn = std::exp2(random.between(-12, -3)) * glm::length(middle.direction);
        std::vector<Ray> rays(16, middle);
        TileExtremes e;
        e.least_square = HUGE_VAL;
        for (Ray& ray : rays) {
            ray.origin += spread * random.point({Vec3(-1), Vec3(1)});
            ray.direction += turn * random.point({Vec3(-1), Vec3(1)});
            e.least_square = std::min(e.least_square, glm::dot(ray.direction, ray.direction));
            for (std::size_t i = 0; i < 3; ++i) {
                const double o = ray.origin[static_cast<int>(i)], d = ray.direction[static_cast<int>(i)];
                const bool first = &ray == rays.data();
                e.o_lo[i] = first ? o : std::min(e.o_lo[i], o), e.o_hi[i] = first ? o : std::max(e.o_hi[i], o);
                e.d_lo[i] = first ? d : std::min(e.d_lo[i], d), e.d_hi[i] = first ? d : std::max(e.d_hi[i], d);
            }
        }
        const TileBounds tile = tile_bounds(e);
        REQUIRE(tile.coherent);
        for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
            hwy::SetSupportedTargetsForTest(target);
            std::array<double, kWideBoxes> near{};
            const std::uint32_t found = boxes_met(node, tile, near);
            INFO(hwy::TargetName(target) << " tile " << k);
            CHECK(found >> node.count == 0);
            for (std::uint32_t c = 0; c < node.count; ++c) {
                const FloatBox& box = boxes[node.child[c].index()];
                double one = 0, far = 0;
                const std::array<double, 3> lo{box.lo[0], box.lo[1], box.lo[2]}, hi{box.hi[0], box.hi[1], box.hi[2]};
                const bool alone = tile.meets(lo, hi, one, far), together = (found >> c & 1) != 0;
                CHECK(alone == together);
                (together ? met : missed) += 1;
                if (together) CHECK(std::abs(near[c] - one) <= 0x1p-40 * one);
                for (const Ray& ray : rays) {
                    double from = 0, to = 0;
                    const SlabRay slab = slab_ray({ray.origin.x, ray.origin.y, ray.origin.z}, {ray.direction.x, ray.direction.y, ray.direction.z});
                    if (!slab_interval(box.lo, box.hi, slab, from, to) || to < 0) continue;
                    CHECK(together);
                    CHECK(near[c] <= std::max(from, 0.0));
                }
            }
        }
        hwy::SetSupportedTargetsForTest(0);
    }
    CHECK(met > 500);
    CHECK(missed > 500);
}
