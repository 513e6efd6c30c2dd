// clean_paths_test.cpp — contours lose what encloses nothing, and nothing else.
#include <catch2/catch.hpp>

#include "csg/solid/clean_paths.h"

using namespace whittle;
using ClipperLib::Path;
using ClipperLib::Paths;

namespace {

double area(const Paths& paths) {
    double sum = 0;
    for (const Path& p : paths) sum += ClipperLib::Area(p);
    return sum;
}

}  // namespace

TEST_CASE("contours that share a side become one") {
    const Paths squares{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{10, 0}, {20, 0}, {20, 10}, {10, 10}}};
    const Paths clean = clean_paths(squares);
    REQUIRE(clean.size() == 1);
    CHECK(clean[0].size() == 6);
    CHECK(area(clean) == 200);
}

TEST_CASE("a side that passes a corner within a step is led through it") {
    // The lower square's top runs from (0, 1000) to (1000, 1003); the upper contour's corners lie half a step beside it.
    const Paths pair{{{0, 0}, {1000, 0}, {1000, 1003}, {0, 1000}}, {{300, 1001}, {700, 1002}, {500, 2000}}};
    const Paths clean = clean_paths(pair);
    REQUIRE(clean.size() == 1);
    CHECK(clean[0].size() == 7);
    CHECK(area(clean) == Approx(area(pair)).margin(1500));
}

TEST_CASE("spikes go, also where the list ends, and what is all spike goes whole") {
    CHECK(clean_paths({{{0, 0}, {10, 0}, {10, 10}, {10, 30}, {10, 10}, {0, 10}}}) == Paths{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}});
    const Paths at_the_end = clean_paths({{{0, -5}, {0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}}});
    REQUIRE(at_the_end.size() == 1);
    CHECK(at_the_end[0].size() == 4);
    CHECK(clean_paths({{{0, 0}, {10, 10}, {5, 5}}}).empty());
}

TEST_CASE("contours that touch in a corner, and holes, stay as they are") {
    const Paths corner{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{10, 10}, {20, 10}, {20, 20}, {10, 20}}};
    CHECK(clean_paths(corner) == corner);
    const Paths hole{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{2, 2}, {2, 8}, {8, 8}, {8, 2}}};
    CHECK(clean_paths(hole) == hole);
}
