// parallel_lines.h — shoots numbered lines on all cores and adds up what each found, in the order of the numbers: same bytes on any number of threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <vector>

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include "tracer/engine/engine.h"

namespace whittle {

// Lines of one block are added by one thread; a block is what cancellation waits for.
inline constexpr std::uint64_t kLinesPerBlock = 256;

// What one thread brings to its lines.
struct LineScratch {
    Scratch engine;
    Spans spans;
};

// Calls line(number, scratch, sum) for every number below `count` and folds block sums with +=, blocks in order.
// Stops early, with a sum that means nothing, when `cancel` becomes true. Counters of all threads go to `counters`.
template <class Sum, class Local = LineScratch, class Line>
Sum sum_over_lines(std::uint64_t count, const std::atomic<bool>* cancel, EngineCounters& counters, const Line& line) {
    const std::uint64_t blocks = (count + kLinesPerBlock - 1) / kLinesPerBlock;
    std::vector<Sum> sums(blocks);
    tbb::enumerable_thread_specific<Local> locals;
    tbb::parallel_for(tbb::blocked_range<std::uint64_t>(0, blocks), [&](const tbb::blocked_range<std::uint64_t>& range) {
        Local& local = locals.local();
        for (std::uint64_t b = range.begin(); b != range.end(); ++b) {
            if (cancel && cancel->load(std::memory_order_relaxed)) return;
            const std::uint64_t end = std::min(count, (b + 1) * kLinesPerBlock);
            for (std::uint64_t i = b * kLinesPerBlock; i < end; ++i) line(i, local, sums[b]);
        }
    });
    for (const Local& local : locals) counters += local.engine.counters;
    Sum total;
    for (const Sum& s : sums) total += s;
    return total;
}

}  // namespace whittle
