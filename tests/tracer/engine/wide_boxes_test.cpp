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

// Items below a node whose boxes the ray meets.
void gather(const std::vector<WideNode>& nodes, std::uint32_t at, const SlabRay& ray, double begin, double end, std::vector<std::uint32_t>& out) {
    std::array<double, kWideBoxes> from;
    for (std::uint32_t left = boxes_ahead()(nodes[at], ray, begin, end, from).met; left != 0; left &= left - 1) {
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
        std::size_t met = 0;
        for (int k = 0; k < 200; ++k) {
            Ray ray = random.ray_through({Vec3(-10), Vec3(10)});
            if (k % 5 == 0) ray.direction = {0, k % 2 ? 0.0 : -0.0, k % 10 ? 1.0 : -1.0};  // along an axis
            if (k % 7 == 0) ray.origin = bounds[static_cast<std::size_t>(k % count)].lo;   // from a corner
            const SlabRay slab = slab_ray({ray.origin.x, ray.origin.y, ray.origin.z}, {ray.direction.x, ray.direction.y, ray.direction.z});
            const double begin = k % 3 == 0 ? 0.5 : 0, end = k % 4 == 0 ? HUGE_VAL : begin + 0.25 * (k % 9);
            std::vector<std::uint32_t> expected;
            double from = 0, to = 0;
            for (std::uint32_t i = 0; i < boxes.size(); ++i)
                if (slab_interval(boxes[i].lo, boxes[i].hi, slab, from, to) && to >= begin && from <= end) expected.push_back(100 + i);
            met += expected.size();
            for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
                hwy::SetSupportedTargetsForTest(target);
                std::vector<std::uint32_t> found;
                gather(nodes, root, slab, begin, end, found);
                std::sort(found.begin(), found.end());
                INFO(hwy::TargetName(target) << " " << count << " boxes, ray " << k);
                CHECK(found == expected);
            }
            hwy::SetSupportedTargetsForTest(0);
        }
        CHECK(met > 0);
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
