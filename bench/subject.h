// subject.h — one thing that is timed: it answers batches of rays and stores every answer.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/ray_sets.h"
#include "bench/scene_mesh.h"
#include "bench/scenes.h"
#include "csg/base/result.h"
#include "csg/span/ray.h"
#include "tracer/engine/engine.h"
#include "tracer/engine/rows.h"

namespace whittle::bench {

// What a timed query leaves behind for each ray of a batch. t is negative or +inf: nothing met. For any hit t is 0; for all spans it is the length inside
// and `surface` the number of spans.
struct Answers {
    alignas(64) std::array<double, kBatch> t;
    alignas(64) std::array<std::array<double, kBatch>, 3> normal;
    alignas(64) std::array<std::uint32_t, kBatch> surface;

    void store(int i, double at, const Vec3& n, std::uint32_t face) {
        const auto k = static_cast<std::size_t>(i);
        t[k] = at;
        for (std::size_t axis = 0; axis < 3; ++axis) normal[axis][k] = n[static_cast<int>(axis)];
        surface[k] = face;
    }
    void miss(int i) { store(i, -1, Vec3(0), 0); }
    bool met(std::size_t k) const { return t[k] >= 0 && t[k] < HUGE_VAL; }
};

// kBatch rays, one by one and in rows: every subject reads what suits it.
struct Batch {
    const Ray* rays = nullptr;
    RayRows rows;
};

class RaySet {
public:
    // Rays beyond the last whole batch are left out.
    explicit RaySet(std::vector<Ray> rays);
    std::size_t batches() const { return rays_.size() / kBatch; }
    Batch batch(std::size_t k) const;

private:
    std::vector<Ray> rays_;
    std::array<std::vector<double>, 6> rows_;
};

// A round of a subject that cannot be handed rays: a program that draws the picture of camera_rays().
struct OwnRound {
    double rays = 0, seconds = 0;
};

struct Subject {
    std::string name;
    std::function<void(const Batch& batch, Answers& answers)> run;
    std::function<std::string()> note{};  // about the work done since the last call; may be empty
    std::function<OwnRound()> own_round{}; // instead of run, where it is set
    double hit_share = 0;                  // of own rounds
};

enum class Query { kFirst, kAny, kSpans };

// The engine's single rays; and its packets where the query has them.
std::vector<Subject> whittle_subjects(std::shared_ptr<const Program> program, Query query);

// Embree on `mesh` (instances of it where the scene is that), or on its own balls. Empty where there is nothing of the kind, or no Embree.
std::vector<Subject> embree_subjects(const BenchScene& scene, const PeerMesh& mesh, Query query, bool coherent);

// POV-Ray 3.7 on the scene as `whittle -o x.pov` writes it, flat and in bounded groups, drawn without lights (+Q1) by one thread: user seconds of a picture
// less those of one of 4 x 3 pixels, which is all reading. S2 also as bench/povray/s2.pov, by hand. Empty where there is no `povray`, and for scenes that
// it cannot read in reasonable time. `folder` is for its files.
std::vector<Subject> povray_subjects(const BenchScene& scene, const std::string& folder);

// The distances to what POV-Ray's trace() meets from each ray's origin, -1 for nothing; empty where there is no `povray`.
std::vector<double> povray_distances(const BenchScene& scene, const std::vector<Ray>& rays, const std::string& folder);

// t of every triangle that Embree in robust mode reports along each ray, ascending, asked by going on just behind the last one. Empty where there is no Embree.
std::vector<std::vector<double>> embree_all_hits(const PeerMesh& mesh, const std::vector<Ray>& rays);

}  // namespace whittle::bench
