// machine_files.cpp — where a file that the author names is found.
#include <algorithm>
#include <filesystem>

#include "csg/eval/machine.h"

namespace whittle {

namespace fs = std::filesystem;

std::string Machine::find_file(SourcePlace place, std::string_view name) {
    const auto joined = [&](const fs::path& folder) { return folder.empty() ? std::string(name) : (folder / name).lexically_normal().string(); };
    std::string path(name);
    if (!fs::path(name).is_absolute()) {
        const fs::path beside_main = fs::path(input_.path).parent_path();
        fs::path folder = beside_main;
        if (place.line != 0 && place.file < files_.sources.files.size() && !files_.sources.files[place.file].path.empty())
            folder = fs::path(files_.sources.files[place.file].path).parent_path();
        path = joined(folder);
        if (!files_.outside.exists(path)) {
            if (const std::string there = joined(beside_main); there != path && files_.outside.exists(there)) {
                say(Severity::kDeprecated, {},
                    "Imported file (" + std::string(name) + ") found in document root instead of relative to the importing module. This behavior is deprecated");
                path = there;
            } else {
                for (const std::string& library : input_.library_paths)
                    if (const std::string found = joined(library); files_.outside.exists(found)) {
                        path = found;
                        break;
                    }
            }
        }
    }
    if (std::find(files_.read.begin(), files_.read.end(), path) == files_.read.end()) files_.read.push_back(path);
    return path;
}

Outside& Machine::fonts() {
    if (!fonts_known_)
        for (const std::string& font : files_.fonts) files_.outside.add_font(font);
    fonts_known_ = true;
    return files_.outside;
}

void Machine::add_child(SourcePlace place, scene::What what) {
    SceneNode node;
    node.what = std::move(what);
    node.place = place;
    node.facets = facets();
    scene_->nodes.push_back(std::move(node));
    pending_.push_back(static_cast<SceneNodeId>(scene_->nodes.size() - 1));
}

std::string Machine::name_of_file(const std::string& path) const {
    const fs::path folder = fs::path(input_.path).parent_path();
    if (folder.empty()) return path;
    const fs::path relative = fs::path(path).lexically_relative(folder);
    return relative.empty() ? path : relative.string();
}

}  // namespace whittle
