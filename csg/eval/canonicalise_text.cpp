// canonicalise_text.cpp — text(): glyphs as polygons with OpenSCAD's chords, or with their own curves where true ones are meant.

#include <cmath>

#include <fmt/format.h>

#include "csg/eval/canonicaliser.h"
#include "csg/eval/imports.h"

namespace whittle {

Made Canonicaliser::primitive(const SceneNode& node, const scene::Text& what) {
    const TextRequest& request = what.request;
    if (!std::isfinite(request.size) || !std::isfinite(request.spacing)) return left_out(node.place, "text() has a size or spacing that is not finite, left out");
    if (request.text.empty() || request.size == 0) return {};
    if (!outside_) return left_out(node.place, "text() needs fonts, left out");
    if (!fonts_known_)
        for (const std::string& font : scene_.fonts) outside_->add_font(font);
    fonts_known_ = true;
    const int facets = facets_of_circle(node, request.size);
    const auto text = outside_->text(request, facets > 0 ? GlyphGrid::kOpenScad : GlyphGrid::kFont);
    if (!text) return left_out(node.place, "text() cannot be made, left out", text.error().message);
    for (const std::string& warning : text->warnings) diagnostics_.add(Severity::kWarning, node.place, warning);
    if (text->substituted)
        diagnostics_.add(Severity::kWarning, node.place, fmt::format("Font '{}' is not installed, '{}' stands in for it", request.font, text->font));

    std::vector<Use> glyphs;
    for (const DrawnFigure& outline : text->outlines) glyphs.push_back(drawn_set(builder_, Drawing{{outline}, {}}, [facets](double) { return facets; }));
    std::vector<Use> uses;
    for (const TextGlyph& glyph : text->glyphs) {
        if (glyphs[glyph.outline].node == kEmptyNode) continue;
        uses.push_back(builder_.placed({{text->unit_mm, 0, 0, glyph.at.x, 0, text->unit_mm, 0, glyph.at.y, 0, 0, 1, 0}}, glyphs[glyph.outline]));
    }
    Made made = with_dimension(Dimension::kFlat, builder_.combine(SetOp::kUnion, std::move(uses)));
    if (profile_depth_ == 0 && made.dimension == Dimension::kFlat) made.use = builder_.labelled({{}, node.place, {}}, made.use);
    return made;
}

}  // namespace whittle
