// verbs.h — the jobs of the program, one function and one file each.
#pragma once

#include "modeler/cli/session.h"

namespace whittle {

Exit run_render(Session& session);
Exit run_mesh(Session& session);
Exit run_check(Session& session);
Exit run_measure(Session& session);
Exit run_spans(Session& session);
Exit run_merge(Session& session);
// OpenSCAD's own form: each output's suffix (or --export-format) chooses the job.
Exit run_convert(Session& session);
// Becomes whittle-bench; returns only when it cannot.
Exit run_bench(const Request& request, Console& console);

}  // namespace whittle
