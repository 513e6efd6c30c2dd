// lower_section.cpp — polygons that are the section of a solid: the solid's own formula, in frames that a point enters by way of the section's plane.
//
// A point (x, y, z) of what is swept along z is inside where (x, y, 0) is inside the solid. So the spans of a ray are those of its image in that plane, and each
// half-space of the solid keeps its polynomial.
#include "tracer/engine/dyadic.h"
#include "tracer/engine/formula_builder.h"

namespace whittle {

namespace {

using exact::Dyadic;

// The sign of a plane that has the same value at all points of the frame's section: of a face in the section's plane that of what is just above. Nothing where
// values differ.
std::optional<int> constant_sign(const Support& plane, const Frame& frame) {
    const Dyadic zero(0.0);
    LinePolynomial<Dyadic> line;
    for (int i = 0; i < 3; ++i) {
        Vec3 way(0);
        way[i] = 1;
        line = support_polynomial(plane, line_in_frame<Dyadic>(frame, {zero, zero, zero}, way));
        if (line.c[1].sign() != 0) return std::nullopt;
    }
    if (line.c[0].sign() != 0) return line.c[0].sign();
    const FrameLine<Dyadic> up = detail::line_under<Dyadic>(frame.placement, frame.determinant_sign < 0, {zero, zero, zero}, {zero, zero, Dyadic(1.0)});
    return support_polynomial(plane, up).c[1].sign();
}

}  // namespace

bool FormulaBuilder::drop_constant_planes(std::vector<HalfSpaceRef>& half_spaces) const {
    bool inside = true;
    std::erase_if(half_spaces, [&](const HalfSpaceRef& h) {
        const Support& s = out_.table.supports[h.support];
        const Frame& frame = out_.table.frames[s.frame];
        if (!frame.section || !is_plane(s.kind)) return false;
        const auto sign = constant_sign(s, frame);
        if (!sign) return false;
        inside = inside && (*sign < 0) != h.inverted;
        return true;
    });
    return inside;
}

FormulaId FormulaBuilder::section(NodeId solid, const Site& site) {
    const std::size_t nodes = out_.nodes.size(), prisms = out_.prisms.size(), meshes = out_.meshes.size();
    const std::string failure = failure_;
    Site within = site;
    within.chain = site.chain.within_section(site.heights);
    within.heights = {-HUGE_VAL, HUGE_VAL};
    const FormulaId made = node(solid, within);
    if (failure_ == failure && out_.prisms.size() == prisms && out_.meshes.size() == meshes) return made;
    failure_ = failure;
    out_.nodes.resize(nodes);
    out_.prisms.resize(prisms);
    out_.meshes.resize(meshes);
    return kNoFormula;
}

FormulaId FormulaBuilder::operator_shape(const shape::Polygon& s, const Site& site) {
    Site within = site;
    if (s.section != kEmptyNode) {
        if (const FormulaId made = section(s.section, site); made != kNoFormula) return made;
        within.exact = false;
    }
    return prism(*s.contours, within);
}

}  // namespace whittle
