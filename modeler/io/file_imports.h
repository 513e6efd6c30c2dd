// file_imports.h — Imports served from the file system.
#pragma once

#include "csg/solid/imported.h"
#include "tracer/image/image_file.h"

namespace whittle {

class FileImports : public Imports {
public:
    Result<ImportedMesh> mesh(const std::string& path) override;
    Result<Drawing> drawing(const std::string& path, const DrawingRequest& request) override;
    Result<HeightMap> heights(const std::string& path, bool invert) override;
    Result<double> dxf_dimension(const std::string& path, const DrawingRequest& request, const std::string& name) override;
    Result<Vec2> dxf_crossing(const std::string& path, const DrawingRequest& request) override;

private:
    ImageFiles images_;
};

}  // namespace whittle
