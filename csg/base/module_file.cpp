#include "csg/base/module_file.h"

#include <dlfcn.h>

#include <filesystem>
#include <vector>

#include <fmt/format.h>

namespace whittle {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> places_of(const std::string& name) {
    std::error_code ignored;
    const fs::path here = fs::read_symlink("/proc/self/exe", ignored).parent_path();
    return {here / "lib" / "whittle" / name, here / ".." / "lib" / "whittle" / name, here / name, here / ".." / name};
}

}  // namespace

Result<void*> module_entry(const std::string& name, const std::string& entry, std::string_view purpose) {
    std::string reason = "not installed";
    for (const fs::path& place : places_of(name)) {
        std::error_code ignored;
        if (!fs::exists(place, ignored)) continue;
        void* handle = dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (!handle) {
            reason = dlerror();
            continue;
        }
        if (void* found = dlsym(handle, entry.c_str())) return found;
        reason = fmt::format("{} belongs to another version", place.string());
    }
    return fail(Fault::kWorld, fmt::format("Can't open {}, {}: {}", name, purpose, reason));
}

}  // namespace whittle
