// memory.h — what this process holds, from the allocator and from the kernel.
#pragma once

#include <cstddef>

namespace whittle::bench {

// Bytes given out by malloc and not given back.
std::size_t bytes_held();

// Forgets the high-water mark of resident memory; false where the kernel does not let it.
bool reset_peak();
// Most resident bytes since then.
std::size_t peak_bytes();

}  // namespace whittle::bench
