// job_export.h — a solid as a scene of another program (.pov) and a 2D set as a drawing (.svg, .dxf, .pdf), for OpenSCAD's form and for `mesh`.
#pragma once

#include <string>
#include <vector>

#include "modeler/cli/session.h"

namespace whittle {

bool is_scene_format(const std::string& format);    // "pov"
bool is_drawing_format(const std::string& format);  // "svg", "dxf", "pdf"

// One reading of the scene into all of `outputs`: path and format, all of one of the two kinds above.
Exit export_outputs(Session& session, const std::vector<std::pair<std::string, std::string>>& outputs);

}  // namespace whittle
