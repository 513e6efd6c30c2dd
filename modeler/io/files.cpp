// files.cpp — see files.h.
#include "modeler/io/files.h"

#include <cstdlib>
#include <filesystem>

#include "csg/base/file.h"
#include "modeler/io/fonts.h"
#include "modeler/mesh/outside_mesh.h"

namespace whittle {

Result<std::string> Files::read_text(const std::string& path) { return read_whole_file(path); }

bool Files::exists(const std::string& path) {
    std::error_code fault;
    return std::filesystem::is_regular_file(path, fault);
}

void Files::add_font(const std::string& path) {
    if (const auto fonts = system_fonts()) (*fonts)->add(path);
}

Result<TextOutline> Files::text(const TextRequest& request, GlyphGrid grid) {
    const auto fonts = system_fonts();
    if (!fonts) return tl::unexpected(fonts.error());
    return (*fonts)->text(request, grid);
}

Result<FontMetrics> Files::font_metrics(const std::string& font, double size) {
    const auto fonts = system_fonts();
    if (!fonts) return tl::unexpected(fonts.error());
    return (*fonts)->metrics(font, size);
}

Result<std::shared_ptr<const FacetList>> Files::mesh(const Solid& solid, const Use& use) { return facets_by_mesh(solid, use, mesh_); }

Result<SectionOutline> Files::section(const Solid& solid, const Use& use) { return section_by_mesh(solid, use, mesh_); }

Result<std::shared_ptr<const FacetList>> Files::straight_roof(const FlatContours& floor) { return roof_by_skeleton(floor); }

std::vector<std::string> library_paths() {
    std::vector<std::string> candidates;
    if (const char* listed = std::getenv("OPENSCADPATH")) {
        std::string rest = listed;
        while (!rest.empty()) {
            const auto colon = rest.find(':');
            if (colon != 0) candidates.push_back(rest.substr(0, colon));
            rest = colon == std::string::npos ? std::string() : rest.substr(colon + 1);
        }
    }
    if (const char* home = std::getenv("HOME")) candidates.push_back(std::string(home) + "/.local/share/OpenSCAD/libraries");
    candidates.emplace_back("/usr/share/openscad/libraries");
    std::vector<std::string> found;
    for (auto& candidate : candidates) {
        std::error_code fault;
        if (std::filesystem::is_directory(candidate, fault)) found.push_back(std::move(candidate));
    }
    return found;
}

}  // namespace whittle
