// job_render.h — drawing, for the verb `render` and for OpenSCAD's form.
#pragma once

#include "modeler/cli/session.h"

namespace whittle {

// One rendering into all of `paths`.
Exit render_outputs(Session& session, const std::vector<std::string>& paths, Preview preview);

}  // namespace whittle
