// canonicaliser.h — the walk from scene to solid, shared by the files that make it; not for others.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "csg/eval/canonicalise.h"
#include "csg/solid/convex_body.h"
#include "csg/solid/facets.h"
#include "csg/solid/imported.h"
#include "csg/solid/profile.h"

namespace whittle {

// What a scene node became. An empty one has no dimension: it fits anywhere.
enum class Dimension { kNone, kFlat, kSolid };
struct Made {
    Use use;
    Dimension dimension = Dimension::kNone;
};

class Canonicaliser {
public:
    Canonicaliser(const Scene& scene, const CanonicaliseOptions& options, Outside* outside, Diagnostics& diagnostics);
    Canonical run();

private:
    // An operation's operands as they are collected: the first that is not empty decides the dimension, others of another one are refused.
    struct Operands {
        std::vector<Use> uses;
        Dimension dimension = Dimension::kNone;
        bool mixed = false;
    };

    struct Visit;
    Made make(SceneNodeId id);
    Made make_what(SceneNodeId id);
    Made united(SceneNodeId id);
    Made combined(SceneNodeId id, SetOp op);
    Made transformed(SceneNodeId id, const Placement& placement);
    Made moving(SceneNodeId id, const scene::Moving& what);
    Made resized(SceneNodeId id, const scene::Resize& what);
    std::optional<Bounds> box_of(const Use& use);
    Made labelled(SceneNodeId id, Label label);
    void collect_union(SceneNodeId id, Operands& operands);
    Operands collect_each(SceneNodeId id);
    // Whether something of this dimension joins the operands; says why not. What is empty does not.
    bool accept(Operands& operands, Dimension dimension, SourcePlace place);
    bool is_background(SceneNodeId id);
    Made with_dimension(Dimension dimension, NodeId node);

    // Primitives (canonicalise_shapes.cpp).
    Made primitive(const SceneNode& node, const scene::Cube& what);
    Made primitive(const SceneNode& node, const scene::Sphere& what);
    Made primitive(const SceneNode& node, const scene::Cylinder& what);
    Made primitive(const SceneNode& node, const scene::Polyhedron& what);
    Made primitive(const SceneNode& node, const scene::Square& what);
    Made primitive(const SceneNode& node, const scene::Circle& what);
    Made primitive(const SceneNode& node, const scene::Polygon& what);
    Made primitive(const SceneNode& node, const scene::Torus& what);
    Made primitive(const SceneNode& node, const scene::Ellipsoid& what);
    Made primitive(const SceneNode& node, const scene::HalfSpace& what);
    Made primitive(const SceneNode& node, const scene::Quadric& what);
    Made primitive(const SceneNode& node, const scene::Capsule& what);
    Made primitive(const SceneNode& node, const scene::RoundCube& what);
    // Files (canonicalise_imports.cpp).
    Made primitive(const SceneNode& node, const scene::Import& what);
    Made primitive(const SceneNode& node, const scene::Surface& what);
    Made imported_mesh(const SceneNode& node, const scene::Import& what);
    Made imported_drawing(const SceneNode& node, const scene::Import& what);
    Made file_fault(const SceneNode& node, const std::string& module, const std::string& name, const Error& error);
    Made primitive(const SceneNode& node, const scene::Text& what);
    Made leaf(const SceneNode& node, Shape shape, const Placement& placement = {});
    bool is_positive(const SceneNode& node, const char* module, const char* what, double size);

    // Maps from 2D to 3D (canonicalise_maps.cpp).
    Made extruded(SceneNodeId id, const scene::LinearExtrude& what);
    Made extruded_upright(SceneNodeId id, const scene::LinearExtrude& what);
    Made revolved(SceneNodeId id, const scene::RotateExtrude& what);
    Use profile(SceneNodeId id);
    int slices_of(const SceneNode& node, const scene::LinearExtrude& what, const shape::Extrusion& extrusion);
    NodeId divided(const shape::Extrusion& extrusion, int segments);
    Use right_of_axis(const SceneNode& node, Use profile, bool& mirrored);
    double radius_of(const SceneNode& node, const Use& profile);
    NodeId node_of(const Use& use);

    // 2D offset (canonicalise_offset.cpp).
    Made offset(SceneNodeId id, const scene::Offset& what);
    std::optional<Use> grown(const Use& flat, double delta);
    Use grown_outline(const Use& flat, double delta);
    Use offset_by_chords(const Use& flat, double delta, Join join, int fragments);

    // Minkowski sums (canonicalise_sum.cpp).
    Result<Use> sum_of(const Use& a, const Use& b);
    Result<Use> sum_without_form(const Use& a, const Use& b);
    Result<Use> flat_sum(const Use& a, const Use& b);
    Result<Use> sum_of_each(const std::vector<Use>& parts, const Use& other);
    std::optional<std::vector<Use>> parts_of_union(const Use& use);
    std::optional<Use> rounded(const Use& a, const Use& ball);
    std::optional<Use> sum_of_covers(const Use& a, const Use& b);
    enum class Pieces { kTrue, kChords };
    std::optional<Use> body_of(const Use& a, const Use& b, double tolerance, Pieces pieces);
    std::optional<Use> sum_of_facets(const Use& convex, const Use& other);
    Result<Use> sum_of_lists(const Use& a, const Use& b);

    // Hull, projection, fill, roof (canonicalise_hull.cpp).
    Made hulled(SceneNodeId id);
    Made summed(SceneNodeId id);
    Made projected(SceneNodeId id, const scene::Projection& what);
    Made filled(SceneNodeId id);
    Made roofed(SceneNodeId id, const scene::Roof& what);
    Made owned(const SceneNode& node, Use use);
    Made owned_polygon(const SceneNode& node, Contours contours);
    Operands bare_operands(SceneNodeId id);
    std::optional<Use> convex_sum(const Use& a, const Use& b);
    std::optional<Use> convex_hull(const std::vector<Use>& operands);
    std::optional<ConvexParts> parts_of_all(const std::vector<Use>& uses) const;
    std::optional<Use> flat_body(const std::optional<ConvexParts>& parts, Contours chords);
    bool is_convex(const Use& use);
    Result<std::shared_ptr<const FacetList>> facets_of_use(const char* module, const Use& use);
    Contours outline_of(const Use& flat);
    bool has_corners_only(NodeId id) const;
    void note_fallbacks();

    // 0 where the true curve is meant, else the number of facets of a circle of radius r.
    int facets_of_circle(const SceneNode& node, double r);
    Resolution resolution(const SceneNode& node) const { return {node.facets.fn, node.facets.fa, node.facets.fs, node.facets.fe}; }

    // Says why something is not in the solid.
    Made left_out(SourcePlace place, std::string text, std::string hint = {});
    void add_ghost(const Made& made, Vec4 colour);
    void place_ghosts(std::size_t first, const Placement& placement);
    void note_facets();

    const Scene& scene_;
    CanonicaliseOptions options_;
    Outside* outside_;
    Diagnostics& diagnostics_;
    SolidBuilder builder_;
    bool something_left_out_ = false;
    int profile_depth_ = 0;        // inside an extrusion labels mean nothing
    std::vector<Use> ghosts_;      // what # and % show in a preview, in the frame of the node at work
    std::map<std::string, ImportedMesh> imported_;  // by path: each file is read once
    int faceted_solids_ = 0;       // for the note: solids of many facets, and the largest $fn
    double largest_fn_ = 0;
    bool fonts_known_ = false;     // those that the scene names have been added
    std::map<NodeId, std::shared_ptr<const FacetList>> meshes_;  // what operations without an exact form asked for
    std::map<std::pair<NodeId, NodeId>, Use> sums_;              // of two solids whose sum has no exact form: made once
    std::set<NodeId> convex_;                                    // made by hull and minkowski
    std::map<std::string, int> fallbacks_;                       // and how often, by module
};

}  // namespace whittle
