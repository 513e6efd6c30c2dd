// simplify_openmesh.cpp — the one translation unit of OpenMesh's decimation.
//
// Sources: Garland, Heckbert, Surface simplification using quadric error metrics (1997); Klein, Liebich, Strasser, Mesh reduction with error control (1996).
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModBaseT.hh>
#include <OpenMesh/Tools/Decimater/ModHausdorffT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include <algorithm>
#include <exception>

#include "modeler/mesh/openmesh/simplify_module.h"

namespace whittle {
namespace {

struct Traits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};
using Surface = OpenMesh::TriMesh_ArrayKernelT<Traits>;

// No facet's normal turns by more in one collapse.
constexpr double kLargestTurnDeg = 20;

// Declines collapses whose new facets stray in their middles. The corners that go are watched by others, but a wall of long facets has none between its
// ends: it would cave in where its ends' corners are joined askew.
template <class MeshT>
class ModNear : public OpenMesh::Decimater::ModBaseT<MeshT> {
public:
    DECIMATING_MODULE(ModNear, MeshT, Near);
    explicit ModNear(MeshT& mesh) : Base(mesh, true) {}
    void set_test(const std::function<bool(const Vec3&)>& is_near) { is_near_ = &is_near; }

    float collapse_priority(const CollapseInfo& collapse) override {
        const MeshT& mesh = Base::mesh();
        const auto is_near = [&](const OpenMesh::Vec3d& p) { return (*is_near_)({p[0], p[1], p[2]}); };
        const OpenMesh::Vec3d to = collapse.p1;
        for (const auto h : mesh.voh_range(collapse.v0)) {
            const auto one = mesh.to_vertex_handle(h), other = mesh.opposite_vh(h);
            if (one == collapse.v1) continue;
            if (one != collapse.vl && one != collapse.vr && !is_near((to + mesh.point(one)) / 2)) return Base::ILLEGAL_COLLAPSE;
            if (other != collapse.v1 && !is_near((to + mesh.point(one) + mesh.point(other)) / 3)) return Base::ILLEGAL_COLLAPSE;
        }
        return Base::LEGAL_COLLAPSE;
    }

private:
    const std::function<bool(const Vec3&)>* is_near_ = nullptr;
};

double distance_to_segment(const OpenMesh::Vec3d& p, const OpenMesh::Vec3d& a, const OpenMesh::Vec3d& b) {
    const OpenMesh::Vec3d way = b - a;
    const double square = way.sqrnorm(), at = square > 0 ? std::clamp(((p - a) | way) / square, 0.0, 1.0) : 0.0;
    return (p - (a + at * way)).norm();
}

// Lets a border between two groups give up corners along itself, as long as all that it gave up stay near the edges that stand for them; what lies between
// two of them then does too, and so does the new edge. Corners where borders meet or end stay.
template <class MeshT>
class ModBorders : public OpenMesh::Decimater::ModBaseT<MeshT> {
public:
    DECIMATING_MODULE(ModBorders, MeshT, Borders);
    explicit ModBorders(MeshT& mesh) : Base(mesh, true) { mesh.add_property(gone_); }
    ~ModBorders() override { Base::mesh().remove_property(gone_); }
    ModBorders(const ModBorders&) = delete;
    ModBorders& operator=(const ModBorders&) = delete;

    template <class GroupOf>
    void set_borders(double most, GroupOf group_of) {
        most_ = most;
        is_border_ = [this, group_of](HalfedgeHandle h) {
            const MeshT& mesh = Base::mesh();
            return group_of(mesh.face_handle(h)) != group_of(mesh.opposite_face_handle(h));
        };
        for (const auto v : Base::mesh().vertices())
            if (const auto n = borders_at(v, HalfedgeHandle()); n == 1 || n > 2) Base::mesh().status(v).set_locked(true);
    }

    float collapse_priority(const CollapseInfo& collapse) override {
        HalfedgeHandle on;
        const std::size_t borders = borders_at(collapse.v0, collapse.v0v1, &on);
        if (borders == 0) return Base::LEGAL_COLLAPSE;
        if (borders != 2 || !is_border_(collapse.v0v1)) return Base::ILLEGAL_COLLAPSE;
        const MeshT& mesh = Base::mesh();
        const auto next = mesh.to_vertex_handle(on);
        if (next == collapse.vl || next == collapse.vr) return Base::ILLEGAL_COLLAPSE;
        const OpenMesh::Vec3d a = collapse.p1, b = mesh.point(next);
        const auto strays = [&](const OpenMesh::Vec3d& p) { return distance_to_segment(p, a, b) > most_; };
        const auto& before = mesh.property(gone_, mesh.edge_handle(collapse.v0v1));
        const auto& behind = mesh.property(gone_, mesh.edge_handle(on));
        const bool far = strays(collapse.p0) || std::any_of(before.begin(), before.end(), strays) || std::any_of(behind.begin(), behind.end(), strays);
        return far ? Base::ILLEGAL_COLLAPSE : Base::LEGAL_COLLAPSE;
    }

    void preprocess_collapse(const CollapseInfo& collapse) override {
        HalfedgeHandle on;
        next_.invalidate();
        if (borders_at(collapse.v0, collapse.v0v1, &on) != 2) return;
        const MeshT& mesh = Base::mesh();
        next_ = mesh.to_vertex_handle(on);
        kept_ = mesh.property(gone_, mesh.edge_handle(collapse.v0v1));
        const auto& behind = mesh.property(gone_, mesh.edge_handle(on));
        kept_.insert(kept_.end(), behind.begin(), behind.end());
        kept_.push_back(collapse.p0);
    }

    void postprocess_collapse(const CollapseInfo& collapse) override {
        if (!next_.is_valid()) return;
        const auto h = Base::mesh().find_halfedge(collapse.v1, next_);
        if (h.is_valid()) Base::mesh().property(gone_, Base::mesh().edge_handle(h)) = std::move(kept_);
    }

private:
    using HalfedgeHandle = typename MeshT::HalfedgeHandle;

    // How many border edges a vertex has; `other`: one of them that is not `but`.
    std::size_t borders_at(typename MeshT::VertexHandle v, HalfedgeHandle but, HalfedgeHandle* other = nullptr) {
        std::size_t n = 0;
        for (const auto h : Base::mesh().voh_range(v)) {
            if (!is_border_(h)) continue;
            ++n;
            if (other && h != but) *other = h;
        }
        return n;
    }

    double most_ = 0;
    std::function<bool(HalfedgeHandle)> is_border_;
    OpenMesh::EPropHandleT<std::vector<OpenMesh::Vec3d>> gone_;  // by edge: corners of the border that it stands for
    typename MeshT::VertexHandle next_;
    std::vector<OpenMesh::Vec3d> kept_;
};

bool surface_of(const Mesh& in, Surface& s, const OpenMesh::FPropHandleT<std::uint32_t>& number) {
    std::vector<Surface::VertexHandle> at;
    for (const Vec3& p : in.points) at.push_back(s.add_vertex({p.x, p.y, p.z}));
    for (std::uint32_t i = 0; i < in.triangles.size(); ++i) {
        const Triangle& t = in.triangles[i];
        const auto f = s.add_face(at[t[0]], at[t[1]], at[t[2]]);
        if (!f.is_valid()) return false;
        s.property(number, f) = i;
    }
    return true;
}

bool simplified(const Mesh& in, const std::vector<std::uint32_t>& groups, double distance_mm, const std::function<bool(const Vec3&)>& is_near, Mesh& out) {
    Surface s;
    s.request_vertex_status();
    s.request_edge_status();
    s.request_halfedge_status();
    s.request_face_status();
    s.request_face_normals();
    OpenMesh::FPropHandleT<std::uint32_t> number;
    s.add_property(number);
    if (!surface_of(in, s, number)) return false;
    s.update_face_normals();
    OpenMesh::Decimater::DecimaterT<Surface> decimater(s);
    OpenMesh::Decimater::ModQuadricT<Surface>::Handle quadric;
    OpenMesh::Decimater::ModHausdorffT<Surface>::Handle hausdorff;
    OpenMesh::Decimater::ModNormalFlippingT<Surface>::Handle flipping;
    decimater.add(quadric);
    decimater.add(hausdorff);
    ModNear<Surface>::Handle near;
    decimater.add(flipping);
    decimater.add(near);
    ModBorders<Surface>::Handle borders;
    decimater.add(borders);
    decimater.module(quadric).unset_max_err();
    decimater.module(hausdorff).set_tolerance(distance_mm);
    decimater.module(flipping).set_max_normal_deviation(kLargestTurnDeg);
    decimater.module(near).set_test(is_near);
    decimater.module(borders).set_borders(distance_mm, [&](Surface::FaceHandle f) { return groups[s.property(number, f)]; });
    if (!decimater.initialize()) return false;
    decimater.decimate();
    s.garbage_collection();
    for (const auto v : s.vertices()) out.points.emplace_back(s.point(v)[0], s.point(v)[1], s.point(v)[2]);
    for (const auto f : s.faces()) {
        Triangle t{};
        std::size_t k = 0;
        for (const auto v : s.fv_range(f))
            if (k < 3) t[k++] = static_cast<std::uint32_t>(v.idx());
        out.triangles.push_back(t);
        out.leaf.push_back(in.leaf[s.property(number, f)]);
    }
    return true;
}

}  // namespace
}  // namespace whittle

extern "C" __attribute__((visibility("default"))) bool whittle_openmesh_simplify_2(const whittle::Mesh& in, const std::vector<std::uint32_t>& groups,
                                                                                   double distance_mm, const std::function<bool(const whittle::Vec3&)>& is_near,
                                                                                   whittle::Mesh& out, std::string& fault) {
    try {
        if (whittle::simplified(in, groups, distance_mm, is_near, out)) return true;
        fault = "the mesh is not a manifold";
    } catch (const std::exception& e) {
        fault = e.what();
    }
    return false;
}
