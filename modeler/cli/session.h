// session.h — one run of the program: what was asked, and what every verb needs to answer it.
#pragma once

#include <string>

#include "csg/base/result.h"
#include "csg/eval/canonicalise.h"
#include "csg/eval/evaluate.h"
#include "modeler/cli/console.h"
#include "modeler/cli/request.h"
#include "modeler/cli/stats.h"
#include "modeler/cli/summary.h"
#include "modeler/cli/watchdog.h"
#include "tracer/engine/engine.h"

namespace whittle {

struct Session {
    const Request& request;
    Console& console;
    Stats& stats;
    Watchdog& watchdog;
    Summary& summary;
};

// How a verb ended. Several parts of one run: the worse code counts.
enum class Exit { kDone = 0, kScene = 1, kCommand = 2, kWorld = 3, kDisagree = 4, kInterrupted = 130 };
Exit worse(Exit a, Exit b);

// Tells the fault and gives its code.
Exit give_up(Session& session, const Error& error);

// A scene as read: evaluated and made canonical, its messages told.
struct ReadScene {
    Evaluated evaluated;
    Canonical canonical;
    Exit verdict = Exit::kDone;  // kScene when geometry was dropped or a warning is hard; the rest can still be shown
};

// What of OpenSCAD's preview a verb shows.
struct Preview {
    bool variable = false;   // $preview
    bool modifiers = false;  // # and %
};

// Text → scene only, its messages told and the -d file written. A run that stopped early is no error here: see `stop`.
Result<Evaluated> read_text_of_scene(Session& session, Preview preview);

// The syntax only: nothing is run, what is wrong with the text is told. An error where it is no program.
Result<Parsed> read_syntax_of_scene(Session& session);

// Reads the scene of the request, --clip applied. An error means that nothing can be made; its message is empty where all was told.
Result<ReadScene> read_scene(Session& session, Preview preview = {});

// kScene with OpenSCAD's words where the scene is empty: nothing to draw.
Result<void> check_something(const Canonical& canonical);

// kWorld where the folder of an output is not there: said before the work, not after it.
Result<void> check_folders(const std::vector<std::string>& outputs);

// kScene with OpenSCAD's words, and what to do about it, where the scene is flat.
Result<void> check_not_flat(const Canonical& canonical);

// The same where it is flat or empty: nothing to mesh.
Result<void> check_solid(const Canonical& canonical);

// For verbs whose answer must be whole (mesh, check, measure): refuses what dropped geometry (unless --allow-missing), is empty or is 2D.
Result<ReadScene> read_whole_solid(Session& session);

// compile() with the request's options, timed.
Result<std::shared_ptr<const Program>> compile_scene(Session& session, const Solid& solid);

// Notes the solid and how it is looked at for --summary, where it is asked for.
Result<void> summarise(Session& session, const ReadScene& scene);

// Name of an output nobody named: the scene's, with `suffix` ("part.scad" -> "part.png"), in the current folder.
std::string default_output(const std::string& input, const std::string& suffix);

// Writes a file whole or not at all; "-" is standard output.
Result<void> write_output(const std::string& path, std::string_view bytes);

}  // namespace whittle
