// edges.h — the lines of --edges: where the visible surface of the picture changes.
#pragma once

#include <array>
#include <cmath>

#include "tracer/engine/rows.h"
#include "tracer/light/stage.h"

namespace whittle {

// Does the picture change its surface within half a pixel of a place? Silhouettes, and borders between faces that meet at an angle. Hidden faces have
// no lines. One a tile: it holds the memory of the places asked together.
class EdgeFinder {
public:
    EdgeFinder(const Stage& stage, Scratch& scratch) : stage_(stage), scratch_(scratch) {}

    // edge[i] for the places (px, py) = places[i], in pixels; at most MetTogether::kMost.
    void find(const Vec2* places, int count, bool* edge);

private:
    template <class T>
    using Row = std::array<T, MetTogether::kMost>;
    struct Seen {
        std::array<Row<double>, 3> point, normal;
        Row<double> t, t_error;
        Row<ClassId> surface;
        Row<std::uint32_t> use;
        Vec3 point_of(std::size_t i) const { return {point[0][i], point[1][i], point[2][i]}; }
        Vec3 normal_of(std::size_t i) const { return {normal[0][i], normal[1][i], normal[2][i]}; }
        bool met(std::size_t i) const { return std::isfinite(t[i]); }
    };
    void look(const Vec2* places, int count, Vec2 offset, Seen& seen);
    bool differ(std::size_t i) const;
    bool stepped(std::size_t i) const;

    const Stage& stage_;
    Scratch& scratch_;
    std::array<Row<double>, 3> origin_, direction_;
    Seen first_, second_;
};

}  // namespace whittle
