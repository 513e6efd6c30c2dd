#include "csg/eval/large_block.h"

#include <algorithm>
#include <cstdlib>

#include <sys/mman.h>

namespace whittle {

void* allocate_large(std::size_t bytes) {
    if (bytes < kLargePage) {
        void* block = std::malloc(bytes);
        if (!block) throw std::bad_alloc();
        return block;
    }
    // The last page is a large one too, unless a quarter of it would do.
    const std::size_t pages = (bytes + kLargePage * 3 / 4) / kLargePage, room = std::max(bytes, pages * kLargePage);
    void* block = nullptr;
    if (posix_memalign(&block, kLargePage, room) != 0) throw std::bad_alloc();
    madvise(block, pages * kLargePage, MADV_HUGEPAGE);  // a wish: nothing is lost where it is not granted
    return block;
}

void free_large(void* block) { std::free(block); }

}  // namespace whittle
