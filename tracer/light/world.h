// world.h — the borders a ray of light meets: what it leaves, what it enters, and the surface between.
//
// Where the solid is divided by matter (matter_parts.h) every part is asked and borders that coincide are one: a wall that belongs to two
// parts at once, because they touch, leads from the one matter straight into the other, with no gap and no film.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "csg/base/result.h"
#include "tracer/engine/engine.h"
#include "tracer/light/color_scheme.h"
#include "tracer/light/matter_parts.h"
#include "tracer/light/surface.h"

namespace whittle {

// More clear matters than this are not told apart.
inline constexpr std::size_t kMostParts = 8;

// Room for a plain value that is not cleared beforehand: clearing what rays seldom fill took a tenth of the time of glass.
template <class T>
union Room {
    T value;
    Room() {}
};

// The events that a continuation ray leaves, one a part. Bit k of `parts`: part k has one; the others hold nothing.
struct Leaving {
    std::array<Room<Departure>, kMostParts> room;
    std::uint32_t parts = 0;
    // Of part k; null: it leaves none.
    const Departure* event(std::size_t k) const { return (parts >> k) & 1U ? &room[k].value : nullptr; }
    void add(std::size_t k, const Departure& event) {
        room[k].value = event;
        parts |= 1U << k;
    }
};

// `before` and `after` are null in air.
struct Border {
    double t = 0;
    double travelled = 0;  // inside `before`, in units of t
    Vec3 point{0};
    Vec3 normal{0};        // unit, against the ray
    const Surface* surface = nullptr;
    const Surface* before = nullptr;
    const Surface* after = nullptr;
    bool certified = true;
    Leaving leaving;

    // Index before over index behind.
    double eta() const { return (before ? before->ior : 1.0) / (after ? after->ior : 1.0); }
};

// What a camera ray meets first; `met` false: nothing.
struct FirstBorder {
    bool met = false;
    Border border;
};

// First hits of rays asked together, part by part. Made by World::meet(), read by World::first().
struct MetTogether {
    static constexpr int kMost = 256;
    struct OfPart {
        std::array<Hit, kMost> hits;
        std::array<bool, kMost> found;
    };
    std::vector<OfPart> parts;
};

class World {
public:
    // kScene: an unknown material.
    static Result<World> make(std::shared_ptr<const Program> whole, const Solid* solid);

    // The first border with t <= t_max at which the matter changes. Requires a unit direction; `leaving` may be null.
    bool next(const Ray& ray, const Leaving* leaving, double t_max, Scratch& scratch, Border& border) const;
    // The first borders of `count` <= MetTogether::kMost rays without departures: first() gives next() of ray `k`, to the bit. Fast where the rays lie
    // close together (first_hits(), engine.h).
    void meet(const Ray* rays, int count, Scratch& scratch, MetTogether& met) const;
    bool first(const Ray& ray, const MetTogether& met, int k, Scratch& scratch, Border& border) const;
    // Gives the scheme's colours to surfaces that name neither colour nor preset, and to faces left by cutters that name none.
    void recolor(const ColorScheme& scheme);
    // Is anything before t_max? Asks the whole solid.
    bool blocked(const Ray& ray, const Leaving* leaving, double t_max, Scratch& scratch) const;

    const Program& program(std::size_t part) const { return *parts_[part].program; }
    const Program& whole() const { return *parts_[0].program; }
    bool divided() const { return parts_.size() > 1; }
    // What the ray leaves of `whole`, the solid that this world was made of. Requires, where it is divided: know_whole() was called before.
    Departure departure_from_whole(const Leaving& leaving) const;
    void know_whole(const Program& whole);
    // Around each thing that is a mirror or clear.
    std::vector<Bounds> focusing_bounds() const;
    // Of all parts; those of the whole solid by its leaf uses where it is not divided.
    const std::vector<Surface>& surfaces(std::size_t part) const { return parts_[part].surfaces; }
    std::size_t part_count() const { return parts_.size(); }

private:
    struct Part {
        std::shared_ptr<const Program> program;
        std::vector<Surface> surfaces;  // by leaf use
        Surface matter;                 // inside
        double priority = 0;
        bool clear = false;
        std::vector<Surface> cut_faces{};  // by leaf use, where cuts are shown: what of its matter a cutter lays bare
        std::vector<bool> cut{};           // then by class: is it only cutters'?
        std::vector<ClassId> in_whole{};   // by class, once know_whole() was called

        const Surface& look(const End& face) const { return !cut.empty() && cut[face.surface] ? cut_faces[face.use] : surfaces[face.use]; }
    };
    // What the parts answered to one ray.
    struct Meeting {
        std::array<Room<Hit>, kMostParts> room;
        std::uint32_t met = 0, inside = 0;  // bits of the parts; those not met have no hit
        std::size_t nearest = kMostParts;
        const Hit& hit(std::size_t part) const { return room[part].value; }
        void add(std::size_t part);
    };
    void border_of(const Ray& ray, const Hit& hit, Border& border) const;
    void ask_all(const Ray& ray, const Leaving& left, Scratch& scratch, Meeting& meeting) const;
    bool next_of_all(const Ray& ray, const Leaving* leaving, double t_max, Scratch& scratch, Border& border) const;
    bool next_of_meeting(const Ray& ray, Meeting& meeting, double t_max, Scratch& scratch, Border& border) const;
    int owner(std::uint32_t inside) const;

    std::vector<Part> parts_;
    std::vector<int> ranked_;   // parts, the winner of overlaps first
    double tie_ = 0;            // mm: the snap's share of a tie between parts
};

}  // namespace whittle
