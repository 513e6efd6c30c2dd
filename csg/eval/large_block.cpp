#include "csg/eval/large_block.h"

#include <cstdlib>

#include <sys/mman.h>

namespace whittle {

void* allocate_large(std::size_t bytes) {
    if (bytes < kLargePage) {
        void* block = std::malloc(bytes);
        if (!block) throw std::bad_alloc();
        return block;
    }
    void* block = nullptr;
    if (posix_memalign(&block, kLargePage, bytes) != 0) throw std::bad_alloc();
    madvise(block, bytes / kLargePage * kLargePage, MADV_HUGEPAGE);  // a wish: nothing is lost where it is not granted
    return block;
}

void free_large(void* block) { std::free(block); }

}  // namespace whittle
