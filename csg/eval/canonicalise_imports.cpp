// canonicalise_imports.cpp — import() and surface(): what the readers found, as solids and 2D sets.

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

#include "csg/eval/canonicaliser.h"
#include "csg/eval/imports.h"
#include "csg/solid/polyhedron.h"

namespace whittle {

std::string suffix_of(std::string_view path) {
    const std::size_t dot = path.rfind('.'), slash = path.rfind('/');
    if (dot == std::string_view::npos || (slash != std::string_view::npos && dot < slash)) return {};
    std::string suffix(path.substr(dot));
    for (char& c : suffix) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return suffix;
}

bool is_mesh_suffix(std::string_view suffix) {
    return suffix == ".stl" || suffix == ".off" || suffix == ".obj" || suffix == ".ply" || suffix == ".3mf" || suffix == ".amf" || suffix == ".om";
}

bool is_drawing_suffix(std::string_view suffix) { return suffix == ".svg" || suffix == ".dxf"; }

namespace {

Placement scaled_to_centre(const FacetList& mesh) {
    Vec3 lo(HUGE_VAL), hi(-HUGE_VAL);
    for (const Vec3& p : mesh.points) lo = glm::min(lo, p), hi = glm::max(hi, p);
    return Placement::translation(-(lo + hi) / 2.0);
}

}  // namespace

// Why a file gave nothing, in OpenSCAD's words first.
Made Canonicaliser::file_fault(const SceneNode& node, const std::string& module, const std::string& name, const Error& error) {
    return left_out(node.place, fmt::format("Can't open {} file '{}', left out", module, name), error.message);
}

Made Canonicaliser::primitive(const SceneNode& node, const scene::Import& what) {
    if (what.path.empty()) return left_out(node.place, "import() names no file, left out");
    const std::string suffix = suffix_of(what.path);
    if (is_mesh_suffix(suffix)) return imported_mesh(node, what);
    if (is_drawing_suffix(suffix)) return imported_drawing(node, what);
    return left_out(node.place, fmt::format("Unsupported file format while trying to import file '{}', left out", what.name),
                    "known are stl off obj ply 3mf amf svg dxf");
}

Made Canonicaliser::imported_mesh(const SceneNode& node, const scene::Import& what) {
    Imports* imports = outside_ ? outside_->imports() : nullptr;
    if (!imports) return left_out(node.place, "import() is not supported here, left out");
    auto known = imported_.find(what.path);
    if (known == imported_.end()) {
        auto read = imports->mesh(what.path);
        if (!read) return file_fault(node, "import", what.name, read.error());
        for (const std::string& remark : read->remarks)
            diagnostics_.add(Severity::kWarning, node.place, fmt::format("import(\"{}\"): {}", what.name, remark));
        known = imported_.emplace(what.path, std::move(*read)).first;
    }
    std::vector<Use> uses;
    FacetList all;  // its points only: what the box is made of
    for (const ImportedSolid& solid : known->second.solids) {
        Made made = leaf(node, shape::Polyhedron{solid.mesh});
        if (made.dimension == Dimension::kNone) continue;
        if (what.center) all.points.insert(all.points.end(), solid.mesh->points.begin(), solid.mesh->points.end());
        if (solid.color || !solid.name.empty()) {
            Label label;
            label.material.color = solid.color;
            label.part = solid.name;
            if (profile_depth_ == 0) made.use = builder_.labelled(label, made.use);
        }
        uses.push_back(made.use);
    }
    if (uses.empty()) return left_out(node.place, fmt::format("import(\"{}\") holds no solid, left out", what.name));
    Made made{uses[0], Dimension::kSolid};
    if (uses.size() > 1) made = with_dimension(Dimension::kSolid, builder_.combine(SetOp::kUnion, std::move(uses)));
    if (what.center) made.use = builder_.placed(scaled_to_centre(all), made.use);
    return made;
}

Made Canonicaliser::imported_drawing(const SceneNode& node, const scene::Import& what) {
    Imports* imports = outside_ ? outside_->imports() : nullptr;
    if (!imports) return left_out(node.place, "import() is not supported here, left out");
    DrawingRequest request;
    request.layer = what.layer;
    request.origin = what.origin;
    request.scale = what.scale;
    request.center = what.center;
    request.dpi = what.dpi;
    const auto drawing = imports->drawing(what.path, request);
    if (!drawing) return file_fault(node, "import", what.name, drawing.error());
    for (const std::string& remark : drawing->remarks)
        diagnostics_.add(Severity::kWarning, node.place, fmt::format("import(\"{}\"): {}", what.name, remark));
    Made made;
    made.use = drawn_set(builder_, *drawing, [&](double r) { return facets_of_circle(node, r); });
    if (made.use.node == kEmptyNode) return left_out(node.place, fmt::format("import(\"{}\") holds no area, left out", what.name));
    made.dimension = Dimension::kFlat;
    if (profile_depth_ == 0) made.use = builder_.labelled({{}, node.place, {}}, made.use);
    return made;
}

Made Canonicaliser::primitive(const SceneNode& node, const scene::Surface& what) {
    if (what.path.empty()) return left_out(node.place, "surface() names no file, left out");
    Imports* imports = outside_ ? outside_->imports() : nullptr;
    if (!imports) return left_out(node.place, "surface() is not supported here, left out");
    const auto map = imports->heights(what.path, what.invert);
    if (!map) return file_fault(node, "surface", what.name, map.error());
    const Vec2 offset = what.center ? Vec2(-(map->columns - 1.0) / 2, -(map->rows - 1.0) / 2) : Vec2(0);
    FacetList mesh = height_solid(*map, offset);
    if (mesh.facets.empty()) return left_out(node.place, fmt::format("surface(\"{}\") has fewer than 2 x 2 heights, left out", what.name));
    return leaf(node, shape::Polyhedron{std::make_shared<const FacetList>(with_flat_facets(mesh))});
}

}  // namespace whittle
