// engine.h — answers what a ray meets in a solid: first hit, any hit, all spans.
//
// A Program is built once from a solid, immutable, and shared by all threads; each thread brings its own Scratch.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "csg/base/result.h"
#include "csg/base/vec.h"
#include "csg/solid/solid.h"
#include "csg/span/ray.h"

namespace whittle {

struct EngineOptions {
    bool snap = true;  // numerics: the one documented snap
    std::vector<std::string> disabled_passes;
};

// The passes of this folder that only save work, in the order of csg/base/passes.h, which says what each saves.
enum class EnginePass : std::uint8_t { kBoxes, kHierarchy, kOcclusion, kFirst, kAny, kFilter, kFrustum, kWindows, kMasks, kCells, kCoarse };
inline constexpr std::size_t kEnginePasses = 11;
const char* name_of(EnginePass pass);

// Work done by one thread; add up with +=. Names follow docs/command-line (--stats).
struct EngineCounters {
    std::uint64_t primitive_tests = 0;
    std::uint64_t spans_evaluated = 0;
    std::uint64_t escalated_double_double = 0;
    std::uint64_t escalated_exact = 0;
    std::uint64_t uncertified = 0;
    std::uint64_t packet_rays = 0;      // answered in packets
    std::uint64_t packet_deferred = 0;  // taken into packets, but answered alone
    std::uint64_t folded = 0;           // leaves folded to tiles
    // By pass: subtrees left out (boxes, frustum, windows), parts of wide groups not asked (hierarchy), parts and subtrees behind a hit (occlusion), rays
    // (first, any), comparisons that double decided (filter), packets that did not meet a part (masks), leaves of which a cell knows (cells), rays whose crossing float
    // found (coarse).
    std::array<std::uint64_t, kEnginePasses> skipped{};
    std::uint64_t& skipped_by(EnginePass pass) { return skipped[static_cast<std::size_t>(pass)]; }
    EngineCounters& operator+=(const EngineCounters& o);
};

// What reading the solid did (once): fusions by the snap and displacements.
struct BuildReport {
    std::uint64_t leaves = 0, kept = 0, classes = 0;
    std::uint64_t snap_fused = 0;
    double snap_largest = 0;
    double largest_displacement = 0;
    std::vector<std::string> warnings;
};

// A material that many uses have, kept once.
class SharedMaterial {
public:
    SharedMaterial() : SharedMaterial(Material()) {}
    explicit SharedMaterial(Material material) : material_(std::make_shared<const Material>(std::move(material))) {}
    const Material& operator*() const { return *material_; }
    const Material* operator->() const { return material_.get(); }
    operator const Material&() const { return *material_; }
    friend bool operator==(const SharedMaterial& a, const SharedMaterial& b) { return a.material_ == b.material_ || *a == *b; }

private:
    std::shared_ptr<const Material> material_;
};

// A leaf use: one shape of the solid as the author placed it. `material` is the whole path's, outermost winning.
struct LeafUse {
    SharedMaterial material;
    SourcePlace place;
    bool subtracts = false;          // a cutter, or within one at any depth: its matter fills nothing
    std::uint32_t subtractions = 0;  // above it: 1 for a cutter, 2 for c in a - (b - c)
    std::uint32_t cut_depth = 0;     // of two cutters on one face the lesser shows: at each difference what it subtracts comes before what it is subtracted from
};

// First border met from outside to inside; or the exit if the ray starts inside (`from_inside`).
struct Hit {
    End end;
    Vec3 point{0};
    bool from_inside = false;
    Departure departure;  // the event's tied classes: hand it to the continuation ray
};

class Program;

// Per-thread memory of the queries. Not shared between threads; reusable with any program.
class Scratch {
public:
    Scratch();
    ~Scratch();
    Scratch(Scratch&&) noexcept;
    Scratch& operator=(Scratch&&) noexcept;
    EngineCounters counters;

    struct Impl;
    std::unique_ptr<Impl> impl;
};

// Fails (kScene) where the root is unbounded in a way no query can answer, or holds a shape the engine cannot meet yet.
Result<std::shared_ptr<const Program>> compile(const Solid& solid, const EngineOptions& options = {});

const BuildReport& build_report(const Program& program);
const std::vector<LeafUse>& leaf_uses(const Program& program);
Bounds program_bounds(const Program& program);

// First border with 0 <= t <= t_max.
bool first_hit(const Program& program, const Ray& ray, double t_max, Scratch& scratch, Hit& hit);
// first_hit() of `count` rays, to the bit: fast where they lie close together and start near each other, as a camera's in a tile of 16 x 16 pixels do
// (in the order of 4 x 4 blocks), 256 at a time; rays that have nothing in common gain too where the solid has few parts. hits[i] is set where found[i] is.
void first_hits(const Program& program, const Ray* rays, int count, double t_max, Scratch& scratch, Hit* hits, bool* found);
// Is any point with 0 < t < t_max inside the solid?
bool any_hit(const Program& program, const Ray& ray, double t_max, Scratch& scratch);
// any_hit() of `count` rays, each up to its own t_max: fast where they lie close together, as a tile's shadow rays to one light do.
void any_hits(const Program& program, const Ray* rays, const double* t_max, int count, Scratch& scratch, bool* blocked);
// All maximal spans of t >= 0, in order.
void all_spans(const Program& program, const Ray& ray, Scratch& scratch, Spans& spans);

}  // namespace whittle
