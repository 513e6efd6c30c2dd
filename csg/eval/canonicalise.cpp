// canonicalise.cpp — containers, set operations, placements and labels; primitives and maps are in canonicalise_shapes.cpp and canonicalise_maps.cpp.

#include "csg/eval/canonicalise.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "csg/eval/canonicaliser.h"
#include "csg/eval/large_stack.h"
#include "csg/solid/placement.h"

namespace whittle {
namespace {

// OpenSCAD's preview colours.
const Vec4 kHighlightColour{1, 81 / 255.0, 81 / 255.0, 0.5};
const Vec4 kBackgroundColour{180 / 255.0, 180 / 255.0, 180 / 255.0, 0.5};
// $fn from which "facets" and "true curve" look alike and the author may have meant the latter.
constexpr int kManyFacets = 32;
// Above it the chord error is below 2^-30 of the radius: no one meant facets, and they would fill the memory.
constexpr int kMostFacets = 1 << 16;
// The determinant's forward error: ten roundings on terms whose sizes add up to the permanent.
constexpr double kDeterminantError = 16 * 0x1p-53;

bool is_container(const scene::What& what) {
    return std::holds_alternative<scene::Group>(what) || std::holds_alternative<scene::Union>(what) || std::holds_alternative<scene::Render>(what);
}

bool is_finite(const Placement& a) {
    return std::all_of(a.m.begin(), a.m.end(), [](double x) { return std::isfinite(x); });
}

// Certainly invertible?
bool is_regular(const Placement& a) {
    Placement sizes = a;
    for (double& x : sizes.m) x = std::fabs(x);
    const auto& s = sizes.m;
    const double permanent = s[0] * (s[5] * s[10] + s[6] * s[9]) + s[1] * (s[4] * s[10] + s[6] * s[8]) + s[2] * (s[4] * s[9] + s[5] * s[8]);
    return std::fabs(determinant(a)) > kDeterminantError * permanent;
}

// What a placement does within the plane z = 0: heights and tilts of 2D objects mean nothing, as in OpenSCAD.
Placement flattened(const Placement& a) { return {{a.m[0], a.m[1], 0, a.m[3], a.m[4], a.m[5], 0, a.m[7], 0, 0, 1, 0}}; }

}  // namespace

Canonicaliser::Canonicaliser(const Scene& scene, const CanonicaliseOptions& options, Outside* outside, Diagnostics& diagnostics)
    : scene_(scene), options_(options), outside_(outside), diagnostics_(diagnostics), builder_(options.passes) {}

Canonical Canonicaliser::run() {
    const Made made = scene_.nodes.empty() ? Made{} : make(scene_.root);
    note_facets();
    note_fallbacks();
    Canonical result;
    result.is_2d = made.dimension == Dimension::kFlat;
    result.something_left_out = something_left_out_;
    Use root = made.use;
    std::vector<Use> shown;  // ghosts first: on a highlighted part the highlight is what is seen
    if (made.dimension == Dimension::kNone && !ghosts_.empty()) result.is_2d = builder_.is_2d(ghosts_[0].node);
    for (const Use& ghost : ghosts_)
        if (builder_.is_2d(ghost.node) == result.is_2d) shown.push_back(ghost);
    if (!shown.empty()) {
        shown.push_back(root);
        root = Use{};
        root.node = builder_.combine(SetOp::kUnion, shown);
    }
    for (const auto& [module, count] : fallbacks_) result.mesh_fallbacks += static_cast<std::uint64_t>(count);
    result.skipped = builder_.skipped();
    result.solid = builder_.finish(root);
    return result;
}

Made Canonicaliser::make(SceneNodeId id) {
    const Made made = make_what(id);
    if (scene_.nodes[id].modifiers & kHighlight) add_ghost(made, kHighlightColour);
    return made;
}

struct Canonicaliser::Visit {
    Canonicaliser& c;
    SceneNodeId id;
    const SceneNode& node;

    Made operator()(const scene::Group&) { return c.united(id); }
    Made operator()(const scene::Union&) { return c.united(id); }
    Made operator()(const scene::Render&) { return c.united(id); }
    Made operator()(const scene::Difference&) { return c.combined(id, SetOp::kDifference); }
    Made operator()(const scene::Intersection&) { return c.combined(id, SetOp::kIntersection); }
    Made operator()(const scene::Hull&) { return c.hulled(id); }
    Made operator()(const scene::Minkowski&) { return c.summed(id); }
    Made operator()(const scene::Transform& what) { return c.transformed(id, what.placement); }
    Made operator()(const scene::Color& what) {
        Label label;
        label.material.color = what.rgba;
        return c.labelled(id, std::move(label));
    }
    Made operator()(const scene::Matter& what) { return c.labelled(id, {what.material, {}, {}}); }
    Made operator()(const scene::Part& what) { return c.labelled(id, {{}, {}, what.name}); }
    Made operator()(const scene::Moving& what) { return c.moving(id, what); }
    Made operator()(const scene::Resize& what) { return c.resized(id, what); }
    Made operator()(const scene::LinearExtrude& what) { return c.extruded(id, what); }
    Made operator()(const scene::RotateExtrude& what) { return c.revolved(id, what); }
    Made operator()(const scene::Offset& what) { return c.offset(id, what); }
    Made operator()(const scene::Projection& what) { return c.projected(id, what); }
    Made operator()(const scene::Fill&) { return c.filled(id); }
    Made operator()(const scene::Roof& what) { return c.roofed(id, what); }
    Made operator()(const scene::Unsupported& what) { return c.left_out(node.place, what.name + "() is not supported yet, left out"); }
    template <class T>
    Made operator()(const Boxed<T>& what) { return (*this)(what.get()); }
    Made operator()(const auto& what) { return c.primitive(node, what); }
};

Made Canonicaliser::make_what(SceneNodeId id) {
    const SceneNode& node = scene_.nodes[id];
    return std::visit(Visit{*this, id, node}, node.what);
}

bool Canonicaliser::accept(Operands& operands, Dimension dimension, SourcePlace place) {
    if (dimension == Dimension::kNone) return false;
    if (operands.dimension == Dimension::kNone) operands.dimension = dimension;
    if (operands.dimension == dimension) return true;
    if (!operands.mixed)
        diagnostics_.add(Severity::kWarning, place, "Mixing 2D and 3D objects is not supported",
                         dimension == Dimension::kFlat ? "linear_extrude(height) makes a solid of a flat shape" : "projection() makes a flat shape of a solid");
    operands.mixed = true;
    left_out(place, dimension == Dimension::kFlat ? "Ignoring 2D child object for 3D operation" : "Ignoring 3D child object for 2D operation");
    return false;
}

bool Canonicaliser::is_background(SceneNodeId id) {
    if (!(scene_.nodes[id].modifiers & kBackground)) return false;
    if (options_.preview) add_ghost(make_what(id), kBackgroundColour);
    return true;
}

// Containers within containers add to one list; each decides its own dimension first.
void Canonicaliser::collect_union(SceneNodeId id, Operands& operands) {
    for (const SceneNodeId child : scene_.nodes[id].children) {
        const SceneNode& node = scene_.nodes[child];
        if (is_background(child)) continue;
        if (node.modifiers == 0 && is_container(node.what)) {
            Operands inner;
            inner.uses.swap(operands.uses);
            const std::size_t before = inner.uses.size();
            collect_union(child, inner);
            if (!accept(operands, inner.dimension, node.place)) inner.uses.resize(before);
            operands.uses.swap(inner.uses);
        } else {
            const Made made = make(child);
            if (accept(operands, made.dimension, node.place)) operands.uses.push_back(made.use);
        }
    }
}

Made Canonicaliser::united(SceneNodeId id) {
    Operands operands;
    collect_union(id, operands);
    if (operands.uses.size() == 1) return {operands.uses[0], operands.dimension};
    return with_dimension(operands.dimension, builder_.combine(SetOp::kUnion, std::move(operands.uses)));
}

// An empty child is an operand: it empties an intersection, and a difference whose first it is.
Made Canonicaliser::combined(SceneNodeId id, SetOp op) {
    const Operands operands = collect_each(id);
    if (operands.uses.size() == 1) return {operands.uses[0], operands.dimension};
    return with_dimension(operands.dimension, builder_.combine(op, operands.uses));
}

Canonicaliser::Operands Canonicaliser::collect_each(SceneNodeId id) {
    Operands operands;
    for (const SceneNodeId child : scene_.nodes[id].children) {
        if (is_background(child)) continue;
        const Made made = make(child);
        if (made.dimension == Dimension::kNone || accept(operands, made.dimension, scene_.nodes[child].place)) operands.uses.push_back(made.use);
    }
    return operands;
}

Made Canonicaliser::with_dimension(Dimension dimension, NodeId node) {
    if (node == kEmptyNode) return {};
    Made made;
    made.use.node = node;
    made.dimension = dimension;
    return made;
}

Made Canonicaliser::transformed(SceneNodeId id, const Placement& placement) {
    const std::size_t ghosts_before = ghosts_.size();
    Made made = united(id);
    const SourcePlace place = scene_.nodes[id].place;
    if (!is_finite(placement)) return left_out(place, "Transform matrix contains Not-a-Number and/or Infinity - removing object");
    const bool flat = made.dimension == Dimension::kFlat;
    const Placement used = flat ? flattened(placement) : placement;
    if (!is_regular(used)) {
        ghosts_.resize(ghosts_before);
        if (made.dimension == Dimension::kNone) return {};
        return left_out(place, flat ? "Scaling a 2D object with 0 - removing object" : "Scaling a 3D object with 0 - removing object");
    }
    place_ghosts(ghosts_before, used);
    made.use = builder_.placed(used, made.use);
    return made;
}

Made Canonicaliser::moving(SceneNodeId id, const scene::Moving& what) {
    Made made = united(id);
    const SourcePlace place = scene_.nodes[id].place;
    if (made.dimension == Dimension::kNone) return made;
    if (made.dimension == Dimension::kFlat) return left_out(place, "moving() of a 2D object is not supported, left out");
    if (!is_finite(what.start) || !is_finite(what.end) || !is_regular(what.start) || !is_regular(what.end))
        return left_out(place, "moving() flattens its children or moves them beyond all numbers, left out");
    made.use.node = node_of(made.use);
    made.use = Use{made.use.node, kNoLabel, builder_.motion({what.start, what.end}), {}};
    return made;
}

Made Canonicaliser::labelled(SceneNodeId id, Label label) {
    Made made = united(id);
    if (profile_depth_ == 0) made.use = builder_.labelled(label, made.use);
    return made;
}

Made Canonicaliser::left_out(SourcePlace place, std::string text, std::string hint) {
    diagnostics_.add(Severity::kWarning, place, std::move(text), std::move(hint));
    something_left_out_ = true;
    return {};
}

void Canonicaliser::add_ghost(const Made& made, Vec4 colour) {
    if (!options_.preview || made.dimension == Dimension::kNone) return;
    Label label;
    label.material.color = colour;
    ghosts_.push_back(builder_.labelled(label, made.use));
}

void Canonicaliser::place_ghosts(std::size_t first, const Placement& placement) {
    for (std::size_t i = first; i < ghosts_.size(); ++i) ghosts_[i] = builder_.placed(placement, ghosts_[i]);
}

NodeId Canonicaliser::node_of(const Use& use) { return builder_.combine(SetOp::kUnion, {use}); }

int Canonicaliser::facets_of_circle(const SceneNode& node, double r) {
    const double fn = node.facets.fn;
    const bool asked = fn > 0 || std::isnan(fn);
    if (!asked && options_.curves != Curves::kFaceted) return 0;
    const int n = fragments(r, resolution(node));
    if (options_.curves == Curves::kExact && n >= options_.exact_threshold) return 0;
    if (n > kMostFacets) {
        diagnostics_.add(Severity::kWarning, node.place, fmt::format("More than {} facets asked for, made a true curve", kMostFacets));
        return 0;
    }
    if (options_.curves == Curves::kAuto && n >= kManyFacets) {
        ++faceted_solids_;
        largest_fn_ = std::max(largest_fn_, fn);
    }
    return n;
}

void Canonicaliser::note_facets() {
    if (faceted_solids_ == 0) return;
    diagnostics_.add(Severity::kNote, {},
                     fmt::format("$fn={:g} asks for facets ({} {}); --curves=exact shows true curves", largest_fn_, faceted_solids_,
                                 faceted_solids_ == 1 ? "solid" : "solids"));
}

Canonical canonicalise(const Scene& scene, const CanonicaliseOptions& options, Outside* outside, Diagnostics& diagnostics) {
    Canonical result;
    const bool done = run_on_large_stack([&] { result = Canonicaliser(scene, options, outside, diagnostics).run(); });
    if (done) return result;
    diagnostics.add(Severity::kError, {}, "Not enough memory for the stack that making the solid needs");
    result.solid = SolidBuilder().finish({});
    result.something_left_out = true;
    return result;
}

}  // namespace whittle
