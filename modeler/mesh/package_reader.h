// package_reader.h — 3MF and AMF: objects with names and colours, in millimetres.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "csg/base/result.h"
#include "modeler/mesh/mesh.h"

namespace whittle {

struct PackageObject {
    Mesh mesh;  // as listed; not welded
    std::string name;
    std::optional<Vec4> color;
};
struct Package {
    std::vector<PackageObject> objects;
    std::vector<std::string> remarks;  // what was not read
};

// Objects of the build, placed, component by component. Faults: kWorld where it is no whole 3MF.
Result<Package> read_3mf(std::string_view bytes);
// Plain or packed; each volume of an object is an object. Constellations are not read, which is said.
Result<Package> read_amf(std::string_view bytes);

}  // namespace whittle
