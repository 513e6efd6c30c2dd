// files.h — the world as a scene sees it: Outside served from the file system.
#pragma once

#include <string>
#include <vector>

#include "csg/solid/outside.h"
#include "modeler/io/file_imports.h"
#include "modeler/mesh/mesh.h"

namespace whittle {

// Meshes are made with `mesh` (CGAL is opened for them).
class Files : public Outside {
public:
    explicit Files(MeshOptions mesh = {}) : mesh_(mesh) {}
    Result<std::string> read_text(const std::string& path) override;
    bool exists(const std::string& path) override;
    Imports* imports() override { return &imports_; }
    void add_font(const std::string& path) override;
    Result<TextOutline> text(const TextRequest& request, GlyphGrid grid) override;
    Result<FontMetrics> font_metrics(const std::string& font, double size) override;
    Result<std::shared_ptr<const FacetList>> mesh(const Solid& solid, const Use& use) override;
    Result<SectionOutline> section(const Solid& solid, const Use& use) override;
    Result<std::shared_ptr<const FacetList>> straight_roof(const FlatContours& floor) override;

private:
    MeshOptions mesh_;
    FileImports imports_;
};

// Where `use <...>` looks after the including file's own folder: OPENSCADPATH, the user's library folder, the system's. Folders that exist only.
std::vector<std::string> library_paths();

}  // namespace whittle
