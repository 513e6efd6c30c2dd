// outside.h — what reading a scene needs from outside the language: one interface, served by modeler (files, glyphs, meshes) and by tests.
//
// What a server does not offer is a kScene fault; the caller leaves the node out and says so.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "csg/base/result.h"
#include "csg/solid/solid.h"
#include "csg/solid/text_outline.h"

namespace whittle {

class Imports;  // csg/solid/imported.h

// Contours of a flat set: outer ones counter-clockwise, holes clockwise, none crossing.
using FlatContours = std::vector<std::vector<Vec2>>;

struct SectionOutline {
    FlatContours contours;
    double deviation = 0;
};

class Outside {
public:
    virtual ~Outside() = default;
    // Whole text of a file, for include and use. `path` is absolute or relative to the working folder.
    virtual Result<std::string> read_text(const std::string& path) = 0;
    virtual bool exists(const std::string& path) = 0;
    // Readers of meshes, drawings and heights; null where there are none.
    virtual Imports* imports() { return nullptr; }

    // Glyphs. A font of the scene's own is known from then on.
    virtual void add_font(const std::string& /*path*/) {}
    virtual Result<TextOutline> text(const TextRequest& /*request*/, GlyphGrid /*grid*/) { return fail(Fault::kScene, "no fonts here"); }
    virtual Result<FontMetrics> font_metrics(const std::string& /*font*/, double /*size*/) { return fail(Fault::kScene, "no fonts here"); }

    // A mesh where no exact form exists: the facets of a 3D use, closed, in the frame above it, within the server's tolerance.
    virtual Result<std::shared_ptr<const FacetList>> mesh(const Solid& /*solid*/, const Use& /*use*/) { return fail(Fault::kScene, "no meshes here"); }
    // The outline of the part of a 3D use in the plane z = 0, and how far at most it is from the true one, about the server's tolerance.
    virtual Result<SectionOutline> section(const Solid& /*solid*/, const Use& /*use*/) { return fail(Fault::kScene, "no meshes here"); }
    // The roof of 45 degrees over each side of a floor that is not convex, by its straight skeleton.
    virtual Result<std::shared_ptr<const FacetList>> straight_roof(const FlatContours& /*floor*/) { return fail(Fault::kScene, "no meshes here"); }
};

}  // namespace whittle
