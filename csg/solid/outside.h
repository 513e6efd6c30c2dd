// outside.h — what reading a scene needs from outside the language: one interface, served by modeler (files, glyphs, meshes) and by tests.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "csg/base/result.h"
#include "csg/solid/solid.h"

namespace whittle {

class Imports;  // csg/solid/imported.h

class Outside {
public:
    virtual ~Outside() = default;
    // Whole text of a file, for include and use. `path` is absolute or relative to the working folder.
    virtual Result<std::string> read_text(const std::string& path) = 0;
    virtual bool exists(const std::string& path) = 0;
    // Readers of meshes, drawings and heights; null where there are none.
    virtual Imports* imports() { return nullptr; }
    // A mesh where no exact form exists (hull, minkowski, shadow projection ...): kScene fault when not served.
    virtual Result<std::shared_ptr<const FacetList>> hull(const Solid& solid, const std::vector<Use>& operands) = 0;
    virtual Result<std::shared_ptr<const FacetList>> minkowski(const Solid& solid, const std::vector<Use>& operands) = 0;
};

}  // namespace whittle
