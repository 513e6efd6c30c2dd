// cells.h — into which regions the small faces cut space, and which of them belong to the result.
//
// The two sides of every face are joined to regions by going round each edge; every operand's winding number changes from one side of a face to the
// other by what lies on it, so one walk over the regions gives all of them, beginning where a ray has told. A point is in an operand where the
// winding number is not zero.
// Source: Zhou et al., Mesh Arrangements for Solid Geometry (2016).
#pragma once

#include "modeler/arrange/expression.h"
#include "modeler/arrange/small_faces.h"

namespace whittle {

struct FaceSides {
    bool front = false, back = false;             // in the result?
    // Where asked for: the matter of the side that is, and the facet that shows.
    std::uint32_t filled = OperandMatter::kNone, shown = kLeast;
    static constexpr std::uint32_t kLeast = 0xFFFFFFFF;  // that of the operand of the least number
};

enum class Matters { kLeaveOut, kTell };

// For every small face. kScene fault where the faces do not close.
Result<std::vector<FaceSides>> classify(const Patches& patches, const BoxTree& tree, const SmallFaces& small, const Buried& buried,
                                        std::span<const Operand> operands, Matters matters, Expression& expression);

// The same for one operand that is a piece of a closed surface. Nothing is known of the rest, but that facets whose tags are `sound` cross nothing: the outside
// is in front of them and the inside behind. kScene fault where a part of the piece is not reached from there.
Result<std::vector<FaceSides>> classify_piece(const Patches& patches, const SmallFaces& small, std::span<const Operand> operands, const std::vector<bool>& sound,
                                              Expression& expression);

// Winding numbers other than zero in front of a face, by operand. Nothing where no ray through the face is general enough.
std::optional<std::vector<std::pair<std::uint32_t, int>>> windings_in_front(const Patches& patches, const BoxTree& tree, const SmallFaces& small,
                                                                            const SmallFace& face);

}  // namespace whittle
