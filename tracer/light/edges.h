// edges.h — the lines of --edges: where the visible surface of the picture changes.
#pragma once

#include <array>

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
    struct Seen {
        std::array<Hit, MetTogether::kMost> hits;
        std::array<bool, MetTogether::kMost> met;
    };
    void look(const Vec2* places, int count, Vec2 offset, Seen& seen);
    bool differ(std::size_t i) const;
    bool stepped(const Hit& a, const Hit& b) const;

    const Stage& stage_;
    Scratch& scratch_;
    std::array<Ray, MetTogether::kMost> rays_;
    Seen first_, second_;
};

}  // namespace whittle
