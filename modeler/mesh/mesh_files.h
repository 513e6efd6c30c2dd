// mesh_files.h — meshes as files: STL (binary, ascii), OFF, OBJ, PLY, 3MF, AMF, glTF binary, OpenMesh.
//
// Writers give the whole file as bytes, the same bytes on every run; write_file_atomically (csg/base/file.h) puts them in place. Doubles are
// written with up to 17 digits, the shortest that read back to the same number; STL and glTF are float32 by their format, and their triangles are those that are
// left after rounding to it. Formats that share points give parts that only touch points of their own: every edge has two triangles.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "csg/base/result.h"
#include "modeler/mesh/mesh.h"

namespace whittle {

enum class MeshFormat { kStlBinary, kStlAscii, kOff, kObj, kPly, k3mf, kAmf, kGlb, kOm };

// Does the format know several objects with names?
bool holds_parts(MeshFormat format);

// A part with its name; "" for what has none.
struct MeshPart {
    std::string name;
    const MeshResult* result;
};

struct MeshFile {
    std::string bytes;
    MeshReport report;                  // of what was written, in the format's precision
    std::vector<std::string> warnings;  // EXPORT-WARNING texts
    std::string materials;              // of an OBJ with colours: what belongs into the file it names
};

// The format a path's suffix names (.stl is binary here unless `ascii`); kCommand fault for one that is not known.
Result<MeshFormat> mesh_format(std::string_view path, bool ascii);

// The leaves give colours where the format has them (all but STL). kScene fault where nothing has a triangle. `materials_name`: how an OBJ calls the file
// beside it. Requires: one part, unless the format holds more.
Result<MeshFile> write_mesh(const std::vector<MeshPart>& parts, MeshFormat format, const std::string& materials_name = {});
Result<MeshFile> write_mesh(const MeshResult& result, MeshFormat format);

// Reads STL, OFF, OBJ and PLY, told apart by content and suffix. Equal points are merged; nothing is repaired.
Result<Mesh> read_mesh(std::string_view bytes, std::string_view path);

}  // namespace whittle
