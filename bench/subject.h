// subject.h — one thing that is timed: it answers batches of rays and stores every answer.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/scene_mesh.h"
#include "bench/scenes.h"
#include "csg/base/result.h"
#include "csg/span/ray.h"

namespace whittle::bench {

// What a timed query leaves behind for each ray. t < 0: nothing met. For any hit t is 0; for all spans it is the length inside and
// `surface` the number of spans.
struct Answer {
    double t = -1;
    Vec3 normal{0};
    std::uint32_t surface = 0;
};

struct Subject {
    std::string name;
    // Answers rays[0, count) into answers[0, count); count <= kBatch.
    std::function<void(const Ray* rays, int count, Answer* answers)> run;
    std::function<std::string()> note;  // about the work done since the last call; may be empty
};

enum class Query { kFirst, kAny, kSpans };

// The engine's single rays; and its packets where the query has them.
Result<std::vector<Subject>> whittle_subjects(const BenchScene& scene, Query query);

// Embree on the mesh of the scene (chord error 1e-3 of the radius), or on its own balls. Empty where there is no such mesh, or no Embree.
std::vector<Subject> embree_subjects(const BenchScene& scene, Query query, bool coherent);

// t of every triangle that Embree in robust mode reports along each ray, ascending, asked by going on just behind the last one. Empty where there is no Embree.
std::vector<std::vector<double>> embree_all_hits(const PeerMesh& mesh, const std::vector<Ray>& rays);

}  // namespace whittle::bench
