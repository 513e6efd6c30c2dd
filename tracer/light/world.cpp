#include "tracer/light/world.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "csg/solid/placement.h"
#include "tracer/engine/cut_faces.h"
#include "tracer/engine/program.h"
#include "tracer/engine/same_classes.h"
#include "tracer/image/tone.h"

namespace whittle {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The reading's snap (docs/numerics.md, 3): supports nearer than this share of the extent are one.
constexpr double kSnap = 0x1p-44;

// Hidden borders in a row before a ray is given up.
constexpr int kMostHidden = 10000;

// What a cutter may say about the face it leaves on clear matter.
Material cut_face(const Material& matter, const Material& cutter) {
    Material surface;
    surface.color = cutter.color;
    surface.roughness = cutter.roughness;
    surface.metal = cutter.metal;
    return nested(surface, matter);
}

// Faces of a clear part: its own matter, cutters adding their surface.
Result<std::vector<Surface>> faces_of(const std::vector<LeafUse>& uses, const MatterPart& part) {
    if (!part.clear) return resolve_surfaces(uses);
    std::vector<LeafUse> faces = uses;
    const SharedMaterial matter(part.material);
    for (LeafUse& use : faces) use.material = use.subtracts && use.material->names_surface() ? SharedMaterial(cut_face(part.material, use.material)) : matter;
    return resolve_surfaces(faces);
}

// Is nothing of the program on the ray, since it misses the box around all of it?
bool misses(const Program& program, const SlabRay& slab) {
    if (!program.makes(EnginePass::kBoxes)) return false;
    const Bounds& b = program.bounds;
    double from = 0, to = 0;
    return !slab_interval<double>({b.lo.x, b.lo.y, b.lo.z}, {b.hi.x, b.hi.y, b.hi.z}, slab, from, to) || to < 0;
}

}  // namespace

Result<World> World::make(std::shared_ptr<const Program> whole, const Solid* solid) {
    World world;
    const Vec3 extent = program_bounds(*whole).hi - program_bounds(*whole).lo;
    world.tie_ = kSnap * std::max(extent.x, std::max(extent.y, extent.z));
    std::vector<MatterPart> parts;
    if (solid) parts = divided_by_matter(*solid);
    if (parts.size() < 2 || parts.size() > kMostParts) {
        const std::vector<LeafUse>& uses = leaf_uses(*whole);
        Result<std::vector<Surface>> surfaces = parts.size() == 1 ? faces_of(uses, parts[0]) : resolve_surfaces(uses);
        if (!surfaces) return tl::unexpected<Error>(surfaces.error());
        world.parts_.push_back({std::move(whole), std::move(*surfaces), {}, 0, false});
        return world;
    }
    for (const MatterPart& part : parts) {
        Result<std::shared_ptr<const Program>> program = compile(part.solid);
        if (!program) return tl::unexpected<Error>(program.error());
        Result<std::vector<Surface>> surfaces = faces_of(leaf_uses(**program), part);
        if (!surfaces) return tl::unexpected<Error>(surfaces.error());
        const Result<Surface> matter = resolve_surface(part.material);
        if (!matter) return tl::unexpected<Error>(matter.error());
        world.parts_.push_back({std::move(*program), std::move(*surfaces), *matter, part.priority, part.clear});
    }
    world.ranked_.resize(world.parts_.size());
    std::iota(world.ranked_.begin(), world.ranked_.end(), 0);
    // Of equal priority: the author's order.
    std::stable_sort(world.ranked_.begin(), world.ranked_.end(),
                     [&](int a, int b) { return world.parts_[static_cast<std::size_t>(a)].priority > world.parts_[static_cast<std::size_t>(b)].priority; });
    return world;
}

std::vector<Bounds> World::focusing_bounds() const {
    std::vector<Bounds> all;
    for (const Part& part : parts_) {
        const Program& program = *part.program;
        // Of leaves where no matter names how it reflects there are no bounds, and none passes light on.
        for (std::size_t i = 0; i < program.leaf_bounds.size(); ++i) {
            if (!part.surfaces[program.leaves[i].use].passes_on()) continue;
            // A leaf without end shows no more than the solid holds.
            const Bounds own = common(program.leaf_bounds[i], program.bounds);
            if (!own.empty()) all.push_back(own);
        }
    }
    return all;
}

void World::recolor(const ColorScheme& scheme) {
    for (Part& part : parts_) {
        const std::vector<LeafUse>& uses = leaf_uses(*part.program);
        part.cut_faces = part.surfaces;
        for (std::size_t i = 0; i < uses.size(); ++i) {
            const Material& material = *uses[i].material;
            if (!material.color && !material.preset) part.surfaces[i].color = srgb_to_linear(scheme.face);
            // A face that is named by its cutter has the cutter's colour.
            if (material.preset || uses[i].subtracts) part.cut_faces[i].color = part.surfaces[i].color;
            else part.cut_faces[i].color = srgb_to_linear(scheme.cut);
        }
        part.cut = classes_of_cutters(*part.program);
    }
}

void World::know_whole(const Program& whole) {
    if (!divided()) return;
    for (Part& part : parts_) part.in_whole = same_classes(*part.program, whole);
}

Departure World::departure_from_whole(const Leaving& leaving) const {
    if (!divided()) return leaving.event(0) ? *leaving.event(0) : Departure{};
    Departure all;
    for (std::size_t k = 0; k < parts_.size(); ++k) {
        const Departure* left = leaving.event(k);
        for (int i = 0; left && i < left->count; ++i) {
            const ClassId id = parts_[k].in_whole[left->classes[static_cast<std::size_t>(i)]];
            const auto end = all.classes.begin() + all.count;
            if (id != kNoClass && end != all.classes.end() && std::find(all.classes.begin(), end, id) == end) all.classes[static_cast<std::size_t>(all.count++)] = id;
        }
    }
    return all;
}

int World::owner(std::uint32_t inside) const {
    for (int part : ranked_)
        if ((inside >> part) & 1U) return part;
    return -1;
}

bool World::next(const Ray& ray, const Leaving* leaving, double t_max, Scratch& scratch, Border& border) const {
    if (divided()) return next_of_all(ray, leaving, t_max, scratch, border);
    Ray asked = ray;
    asked.departure = leaving ? leaving->event(0) : nullptr;
    Hit hit;
    if (!first_hit(*parts_[0].program, asked, t_max, scratch, hit)) return false;
    border_of(ray, hit, border);
    return true;
}

void World::meet(const Ray* rays, int count, Scratch& scratch, MetTogether& met) const {
    met.parts.resize(parts_.size());
    for (std::size_t k = 0; k < parts_.size(); ++k)
        first_hits(*parts_[k].program, rays, count, kInfinity, scratch, met.parts[k].hits.data(), met.parts[k].found.data());
}

bool World::first(const Ray& ray, const MetTogether& met, int k, Scratch& scratch, Border& border) const {
    const auto at = static_cast<std::size_t>(k);
    if (!divided()) {
        if (met.parts[0].found[at]) border_of(ray, met.parts[0].hits[at], border);
        return met.parts[0].found[at];
    }
    Meeting meeting;
    for (std::size_t part = 0; part < parts_.size(); ++part) {
        if (!met.parts[part].found[at]) continue;
        meeting.room[part].value = met.parts[part].hits[at];
        meeting.add(part);
    }
    return next_of_meeting(ray, meeting, kInfinity, scratch, border);
}

void World::border_of(const Ray& ray, const Hit& hit, Border& border) const {
    const Surface& surface = parts_[0].surfaces[hit.end.use];
    border.t = border.travelled = hit.end.t;
    border.point = hit.point;
    border.normal = glm::dot(hit.end.normal, ray.direction) > 0 ? -hit.end.normal : hit.end.normal;
    border.surface = &parts_[0].look(hit.end);
    border.before = hit.from_inside ? &surface : nullptr;
    border.after = hit.from_inside ? nullptr : &surface;
    border.certified = hit.end.certified;
    border.leaving.parts = 0;
    border.leaving.add(0, hit.departure);
}

void World::Meeting::add(std::size_t part) {
    met |= 1U << part;
    if (hit(part).from_inside) inside |= 1U << part;
    if (nearest == kMostParts || hit(part).end.t < hit(nearest).end.t) nearest = part;
}

void World::ask_all(const Ray& ray, const Leaving& left, Scratch& scratch, Meeting& meeting) const {
    Ray asked = ray;
    meeting.met = meeting.inside = 0;
    meeting.nearest = kMostParts;
    const SlabRay slab = slab_ray({ray.origin.x, ray.origin.y, ray.origin.z}, {ray.direction.x, ray.direction.y, ray.direction.z});
    for (std::size_t k = 0; k < parts_.size(); ++k) {
        asked.departure = left.event(k);
        if (!asked.departure && misses(*parts_[k].program, slab)) {
            ++scratch.counters.skipped_by(EnginePass::kBoxes);
            continue;
        }
        if (first_hit(*parts_[k].program, asked, kInfinity, scratch, meeting.room[k].value)) meeting.add(k);
    }
}

bool World::next_of_all(const Ray& ray, const Leaving* leaving, double t_max, Scratch& scratch, Border& border) const {
    Meeting meeting;
    ask_all(ray, leaving ? *leaving : Leaving{}, scratch, meeting);
    return next_of_meeting(ray, meeting, t_max, scratch, border);
}

// Goes on from the nearest answer, past borders that a stronger part hides.
bool World::next_of_meeting(const Ray& ray, Meeting& meeting, double t_max, Scratch& scratch, Border& border) const {
    Ray asked = ray;
    double passed = 0;
    for (int hidden = 0; hidden < kMostHidden; ++hidden) {
        if (meeting.nearest == kMostParts || passed + meeting.hit(meeting.nearest).end.t > t_max) return false;
        const End& first = meeting.hit(meeting.nearest).end;
        Leaving& left = border.leaving;
        left.parts = 0;
        for (std::size_t k = 0; k < parts_.size(); ++k)
            if (((meeting.met >> k) & 1U) && meeting.hit(k).end.t - first.t <= meeting.hit(k).end.t_error + first.t_error + tie_) left.add(k, meeting.hit(k).departure);
        const std::uint32_t tied = left.parts;
        const int before = owner(meeting.inside), after = owner(meeting.inside ^ tied);
        passed += first.t;
        asked.origin = meeting.hit(meeting.nearest).point;
        if (before == after) {
            ask_all(asked, left, scratch, meeting);
            continue;
        }
        // The face is shown by the part that begins, else by the one that ends. What is opaque and was there before shows its own matter.
        const int shown = after >= 0 && ((tied >> after) & 1U) ? after : before;
        const int looks = after >= 0 ? after : before;
        const End& face = meeting.hit(static_cast<std::size_t>(shown)).end;
        border.t = border.travelled = passed;
        border.point = asked.origin;
        border.normal = glm::dot(face.normal, ray.direction) > 0 ? -face.normal : face.normal;
        border.surface = &parts_[static_cast<std::size_t>(looks)].look(meeting.hit(static_cast<std::size_t>(looks)).end);
        border.before = before >= 0 ? &parts_[static_cast<std::size_t>(before)].matter : nullptr;
        border.after = after >= 0 ? &parts_[static_cast<std::size_t>(after)].matter : nullptr;
        border.certified = face.certified;
        return true;
    }
    return false;
}

bool World::blocked(const Ray& ray, const Leaving* leaving, double t_max, Scratch& scratch) const {
    if (divided()) {
        Border border;
        return next_of_all(ray, leaving, t_max, scratch, border);
    }
    Ray asked = ray;
    asked.departure = leaving ? leaving->event(0) : nullptr;
    return any_hit(*parts_[0].program, asked, t_max, scratch);
}

}  // namespace whittle
