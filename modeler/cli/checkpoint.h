// checkpoint.h — the file beside a picture from which a rendering that was stopped goes on: PICTURE.part, read by --resume.
//
// It is written when a rendering ends early (an interrupt, --stop-after) and once a minute before, and removed when the picture is finished. It holds the
// film to the bit (film_file.h), so the picture in the end is the one of a run that never stopped.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "modeler/cli/session.h"
#include "tracer/image/film.h"

namespace whittle {

class Checkpoint {
public:
    // Of a rendering of `scene` as the session's request says, into `picture` ("-": nowhere, then nothing is kept).
    Checkpoint(const Session& session, const ReadScene& scene, const std::string& picture);

    const std::string& path() const { return path_; }
    // Nothing where there is none. kCommand: of another scene, other options or another version; kWorld: damaged.
    Result<std::optional<Film>> read() const;
    Result<void> write(const Film& film) const;
    void remove() const;

private:
    std::string path_;
    std::uint64_t fingerprint_ = 0;
};

}  // namespace whittle
