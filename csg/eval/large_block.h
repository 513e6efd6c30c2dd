// large_block.h — memory for much: megabytes at once, in large pages where the system has them.
//
// A fresh page of 4 kB costs a fault of a microsecond or two, more than filling it. Evaluation of a script that makes 20 MB of lists spent a third of its time so.
#pragma once

#include <cstddef>
#include <new>

namespace whittle {

inline constexpr std::size_t kLargePage = std::size_t{2} << 20;

// Any number of bytes, aligned as large pages are from that size on. Throws std::bad_alloc.
void* allocate_large(std::size_t bytes);
void free_large(void* block);

// For containers.
template <class T>
struct LargeAllocator {
    using value_type = T;
    LargeAllocator() = default;
    template <class U>
    LargeAllocator(const LargeAllocator<U>&) {}
    T* allocate(std::size_t count) { return static_cast<T*>(allocate_large(count * sizeof(T))); }
    void deallocate(T* block, std::size_t) { free_large(block); }
    bool operator==(const LargeAllocator&) const { return true; }
};

}  // namespace whittle
