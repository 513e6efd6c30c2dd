// self_intersections.cpp — asks the module for CGAL's count.
#include "csg/base/module_file.h"
#include "modeler/mesh/cgal/queries_module.h"
#include "modeler/mesh/mesh_queries.h"

namespace whittle {

Result<std::uint64_t> count_self_intersections(const Mesh& mesh) {
    const auto entry = module_entry("whittle_cgal.so", "whittle_cgal_crossings_2", "the part that asks CGAL about meshes");
    if (!entry) return tl::unexpected(entry.error());
    std::uint64_t count = 0;
    std::string fault;
    if (!reinterpret_cast<decltype(&whittle_cgal_crossings_2)>(*entry)(mesh.points, mesh.triangles, count, fault)) return fail(Fault::kWorld, "CGAL: " + fault);
    return count;
}

}  // namespace whittle
