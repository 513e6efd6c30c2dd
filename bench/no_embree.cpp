// no_embree.cpp — what Embree answers where it is not installed.
#include "bench/subject.h"

namespace whittle::bench {

std::vector<Subject> embree_subjects(const BenchScene&, const PeerMesh&, Query, bool) { return {}; }
std::vector<std::vector<double>> embree_all_hits(const PeerMesh&, const std::vector<Ray>&) { return {}; }

}  // namespace whittle::bench
