#include "modeler/mesh/exact_kernel.h"

#include "csg/base/module_file.h"

namespace whittle {
namespace {

Result<const ExactKernel*> opened() {
    const auto entry = module_entry("whittle_cgal.so", "whittle_cgal_kernel", "the part that combines meshes");
    if (!entry) return tl::unexpected(entry.error());
    return reinterpret_cast<const ExactKernel* (*)()>(*entry)();
}

}  // namespace

Result<const ExactKernel*> exact_kernel() {
    static const Result<const ExactKernel*> kernel = opened();
    return kernel;
}

}  // namespace whittle
