// mesh_files.h — meshes as files: STL (binary, ascii), OFF, OBJ, PLY.
//
// Writers give the whole file as bytes, the same bytes on every run; write_file_atomically (csg/base/file.h) puts them in place. Doubles are
// written with up to 17 digits, the shortest that read back to the same number; STL is float32 by its format, and its triangles are those that are left after rounding to it.
#pragma once

#include <string>
#include <string_view>

#include "csg/base/result.h"
#include "modeler/mesh/mesh.h"

namespace whittle {

enum class MeshFormat { kStlBinary, kStlAscii, kOff, kObj, kPly };

struct MeshFile {
    std::string bytes;
    MeshReport report;                  // of what was written, in the format's precision
    std::vector<std::string> warnings;  // EXPORT-WARNING texts
};

// The format a path's suffix names (.stl is binary here unless `ascii`); kCommand fault for one that is not known.
Result<MeshFormat> mesh_format(std::string_view path, bool ascii);

// `result.leaves` give colours where the format has them (OFF, PLY). kScene fault for an empty mesh.
Result<MeshFile> write_mesh(const MeshResult& result, MeshFormat format);

// Reads any of the formats above, told apart by content and suffix. Equal points are merged; nothing is repaired.
Result<Mesh> read_mesh(std::string_view bytes, std::string_view path);

}  // namespace whittle
