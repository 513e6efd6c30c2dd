#include "modeler/io/file_imports.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include <fmt/format.h>

#include "csg/base/file.h"
#include "modeler/io/dxf.h"
#include "modeler/io/heights.h"
#include "modeler/io/svg.h"
#include "modeler/mesh/mend.h"
#include "modeler/mesh/mesh_files.h"
#include "modeler/mesh/package_reader.h"

namespace whittle {
namespace {

std::string suffix_of(const std::string& path) {
    std::string suffix = std::filesystem::path(path).extension().string();
    std::transform(suffix.begin(), suffix.end(), suffix.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return suffix;
}

ImportedMesh solids_of(Package package) {
    ImportedMesh out;
    out.remarks = std::move(package.remarks);
    for (PackageObject& object : package.objects) {
        ImportedMesh one = mended(std::move(object.mesh));
        for (ImportedSolid& solid : one.solids) {
            solid.color = object.color;
            solid.name = object.name;
            out.solids.push_back(std::move(solid));
        }
        for (const std::string& remark : one.remarks) out.remarks.push_back(fmt::format("object '{}': {}", object.name, remark));
    }
    return out;
}

}  // namespace

Result<ImportedMesh> FileImports::mesh(const std::string& path) {
    const auto bytes = read_whole_file(path);
    if (!bytes) return tl::unexpected(bytes.error());
    const std::string suffix = suffix_of(path);
    if (suffix == ".3mf" || suffix == ".amf") {
        auto package = suffix == ".3mf" ? read_3mf(*bytes) : read_amf(*bytes);
        if (!package) return fail(Fault::kWorld, fmt::format("not a whole {} file: {}", suffix.substr(1), package.error().message));
        return solids_of(std::move(*package));
    }
    auto mesh = read_mesh(*bytes, path);
    if (!mesh) return tl::unexpected(mesh.error());
    return mended(std::move(*mesh));
}

Result<Drawing> FileImports::drawing(const std::string& path, const DrawingRequest& request) {
    const auto text = read_whole_file(path);
    if (!text) return tl::unexpected(text.error());
    return suffix_of(path) == ".svg" ? read_svg(*text, request) : read_dxf(*text, request);
}

Result<HeightMap> FileImports::heights(const std::string& path, bool invert) {
    if (suffix_of(path) == ".png") {
        const auto image = images_.read(path);
        if (!image) return tl::unexpected(image.error());
        return heights_of_picture(*image, invert);
    }
    const auto text = read_whole_file(path);
    if (!text) return tl::unexpected(text.error());
    return read_heights(*text);
}

Result<double> FileImports::dxf_dimension(const std::string& path, const DrawingRequest& request, const std::string& name) {
    const auto text = read_whole_file(path);
    if (!text) return tl::unexpected(text.error());
    return read_dxf_dimension(*text, path, request, name);
}

Result<Vec2> FileImports::dxf_crossing(const std::string& path, const DrawingRequest& request) {
    const auto text = read_whole_file(path);
    if (!text) return tl::unexpected(text.error());
    return read_dxf_crossing(*text, path, request);
}

}  // namespace whittle
