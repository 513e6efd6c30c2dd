// settle_piece.h — where a mesh crosses itself: those facets and the ones around them arranged anew, the rest left alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "modeler/mesh/mesh.h"

namespace whittle {

using CrossingPairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// Takes the triangles near the pairs out of the mesh, with all that work on them can concern; the pairs are then of what was taken out. append() puts it back.
Mesh taken_out(Mesh& mesh, CrossingPairs& pairs, int exponent);

// A closed mesh, or a part that was taken out, whose points are multiples of 2^exponent, welded; `pairs` are all pairs of its triangles that cross. Afterwards
// the mesh is as above, with facets near the crossings replaced by what of them bounds a place with a winding number other than zero, rounded to such points: of a
// grid coarser by `coarser` bits, but where they hang together with the rest. Gives the pairs that cross then, of each crossing place the first `most`; nothing,
// and the mesh as it was, where the facets cannot be told inside from outside, or where the work was cancelled.
std::optional<CrossingPairs> settle_piece(Mesh& mesh, const CrossingPairs& pairs, int exponent, int coarser, std::size_t most, MeshControl& control);

}  // namespace whittle
