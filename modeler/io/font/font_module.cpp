// font_module.cpp — the door of whittle_font.so: texts as outlines, measures of fonts.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <mutex>

#include "modeler/io/font/font_face.h"
#include "modeler/io/fonts.h"

namespace whittle {
namespace {

// Points of an em: 72 of them are an inch, of which FreeType is told that it has 100 dots.
constexpr double kEmPerSize = 100.0 / 72;
constexpr double kOpenScadUnits = 1e5;

// What the ink covers, from the outlines' own points and control points.
struct Ink {
    Vec2 lo{HUGE_VAL}, hi{-HUGE_VAL};
    double ascent = 0, descent = 0;
    void add(Vec2 p, Vec2 at) {
        lo = glm::min(lo, p + at);
        hi = glm::max(hi, p + at);
        ascent = std::max(ascent, p.y);
        descent = std::min(descent, p.y);
    }
};

class SystemFonts : public Fonts {
public:
    bool start() {
        config_ = FcInitLoadConfig();
        if (!config_ || FT_Init_FreeType(&library_) != 0) return false;
        if (const char* home = std::getenv("HOME")) add_folder(std::string(home) + "/.fonts");
        if (const char* listed = std::getenv("OPENSCAD_FONT_PATH")) {
            std::string rest = listed;
            while (!rest.empty()) {
                const auto colon = rest.find(':');
                add_folder(rest.substr(0, colon));
                rest = colon == std::string::npos ? std::string() : rest.substr(colon + 1);
            }
        }
        return FcConfigBuildFonts(config_) == FcTrue;
    }

    void add(const std::string& path) override {
        const std::lock_guard lock(mutex_);
        if (FcConfigAppFontAddFile(config_, reinterpret_cast<const FcChar8*>(path.c_str())) == FcTrue) faces_.clear();
    }

    Result<TextOutline> text(const TextRequest& request, GlyphGrid grid) override {
        const std::lock_guard lock(mutex_);
        const auto face = face_of(request.font);
        if (!face) return tl::unexpected(face.error());
        const auto shaped = shape_text(**face, request);
        if (!shaped) return tl::unexpected(shaped.error());
        return outlined(**face, *shaped, request, grid);
    }

    Result<FontMetrics> metrics(const std::string& font, double size) override {
        const std::lock_guard lock(mutex_);
        const auto found = face_of(font);
        if (!found) return tl::unexpected(found.error());
        const FT_Face face = (*found)->face;
        const double unit = size * kEmPerSize / face->units_per_EM;
        FontMetrics out;
        out.nominal_ascent = face->ascender * unit;
        out.nominal_descent = face->descender * unit;
        out.max_ascent = static_cast<double>(face->bbox.yMax) * unit;
        out.max_descent = static_cast<double>(face->bbox.yMin) * unit;
        out.interline = face->height * unit;
        out.family = face->family_name ? face->family_name : "";
        out.style = face->style_name ? face->style_name : "";
        return out;
    }

private:
    void add_folder(const std::string& path) {
        std::error_code fault;
        if (!path.empty() && std::filesystem::is_directory(path, fault)) FcConfigAppFontAddDir(config_, reinterpret_cast<const FcChar8*>(path.c_str()));
    }

    Result<Face*> face_of(const std::string& font) {
        if (const auto known = faces_.find(font); known != faces_.end()) return known->second.get();
        auto face = find_face(config_, library_, font);
        if (!face) return tl::unexpected(face.error());
        return faces_.emplace(font, std::move(*face)).first->second.get();
    }

    static Result<TextOutline> outlined(Face& face, const ShapedText& shaped, const TextRequest& request, GlyphGrid grid) {
        TextOutline out;
        out.font = face.name;
        out.substituted = face.substituted;
        out.unit_mm = grid == GlyphGrid::kFont ? request.size * kEmPerSize / (2.0 * face.face->units_per_EM) : request.size / kOpenScadUnits;
        out.metrics.offset = text_offset(shaped, request, out.warnings);
        std::map<FT_UInt, std::size_t> known;
        Vec2 pen(0);
        Ink ink;
        for (const ShapedGlyph& g : shaped.glyphs) {
            const auto [at, is_new] = known.emplace(g.index, out.outlines.size());
            if (is_new) {
                auto outline = glyph_outline(face, g.index, grid);
                if (!outline) return tl::unexpected(outline.error());
                out.outlines.push_back(std::move(*outline));
            }
            const Vec2 place = out.metrics.offset + pen + g.offset * request.size;
            for (const DrawnContour& contour : out.outlines[at->second].contours)
                for (const DrawnSide& step : contour.sides)
                    for (int i = 0; i < step.degree; ++i) ink.add(step.p[static_cast<std::size_t>(i)] * out.unit_mm, place);
            if (!out.outlines[at->second].contours.empty()) out.glyphs.push_back({at->second, place});
            pen += g.advance * (request.spacing * request.size);
        }
        out.metrics.advance = pen;
        if (out.glyphs.empty()) return out;
        out.metrics.position = ink.lo;
        out.metrics.size = ink.hi - ink.lo;
        out.metrics.ascent = ink.ascent;
        out.metrics.descent = ink.descent;
        return out;
    }

    FcConfig* config_ = nullptr;
    FT_Library library_ = nullptr;
    std::map<std::string, std::unique_ptr<Face>> faces_;
    std::mutex mutex_;
};

}  // namespace
}  // namespace whittle

// The one set of fonts of a process; null where fontconfig or FreeType cannot be started.
extern "C" whittle::Fonts* whittle_fonts() {
    static whittle::SystemFonts* const fonts = [] {
        auto* made = new whittle::SystemFonts;
        return made->start() ? made : nullptr;
    }();
    return fonts;
}
