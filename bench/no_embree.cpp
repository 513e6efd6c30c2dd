// no_embree.cpp — what embree_subjects() is where Embree is not installed.
#include "bench/subject.h"

namespace whittle::bench {

std::vector<Subject> embree_subjects(const BenchScene&, Query, bool) { return {}; }

}  // namespace whittle::bench
