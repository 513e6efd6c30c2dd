#include "modeler/mesh/exact_kernel.h"

#include <dlfcn.h>

#include <filesystem>
#include <string>

#include <fmt/format.h>

namespace whittle {
namespace {

constexpr const char* kModuleName = "whittle_cgal.so";
constexpr const char* kEntry = "whittle_cgal_kernel";

// In the build tree beside the program or a folder above; installed, in ../lib/whittle or Debian's ../lib/<triplet>/whittle.
std::vector<std::filesystem::path> module_places() {
    std::error_code ignored;
    const auto here = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
    std::vector<std::filesystem::path> places{here / "lib" / "whittle" / kModuleName, here / ".." / "lib" / "whittle" / kModuleName};
#ifdef WHITTLE_MODULE_DIR
    places.emplace_back(here / ".." / WHITTLE_MODULE_DIR / kModuleName);
#endif
    places.push_back(here / kModuleName);
    return places;
}

Result<const ExactKernel*> opened() {
    std::string reason = "not installed";
    for (const auto& place : module_places()) {
        std::error_code ignored;
        if (!std::filesystem::exists(place, ignored)) continue;
        // Stays open until the program ends: meshes made by it may outlive any close.
        void* handle = dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (!handle) {
            reason = dlerror();
            continue;
        }
        const auto entry = reinterpret_cast<const ExactKernel* (*)()>(dlsym(handle, kEntry));
        if (entry) return entry();
        reason = fmt::format("{} belongs to another version", place.string());
    }
    return fail(Fault::kWorld, fmt::format("Can't open {}, the part that combines meshes: {}", kModuleName, reason));
}

}  // namespace

Result<const ExactKernel*> exact_kernel() {
    static const Result<const ExactKernel*> kernel = opened();
    return kernel;
}

}  // namespace whittle
