// ordered_blocks.h — memory whose addresses rise in the order of allocation, for CGAL's containers during corefinement.
//
// CGAL's triangulations report an edge from the one of its two faces that has the lower address, so the order of the triangles that corefinement
// makes would depend on the heap: on what was done before, on which thread. With rising addresses it depends on the operation alone.
// Include before any CGAL header.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <new>

namespace whittle {

// One thread's stretch of address space, handed out from the bottom and taken back as a whole when all of it has been returned.
class OrderedBlocks {
public:
    OrderedBlocks() = default;
    OrderedBlocks(const OrderedBlocks&) = delete;
    OrderedBlocks& operator=(const OrderedBlocks&) = delete;
    ~OrderedBlocks() {
        if (base_) munmap(base_, kSize);
    }
    static OrderedBlocks& mine() {
        thread_local OrderedBlocks blocks;
        return blocks;
    }

    // While one lives, the thread's CGAL containers allocate here.
    class Scope {
    public:
        Scope() { mine().on_ = true; }
        ~Scope() { mine().on_ = false; }
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;
    };

    void* allocate(std::size_t bytes) {
        bytes = (bytes + kAlign - 1) / kAlign * kAlign;
        if (!on_ || !reserved() || used_ + bytes > kSize) return ::operator new(bytes);
        void* at = base_ + used_;
        used_ += bytes;
        ++live_;
        return at;
    }
    void deallocate(void* at) {
        const auto* place = static_cast<char*>(at);
        if (!base_ || place < base_ || place >= base_ + kSize) return ::operator delete(at);
        if (--live_ == 0) used_ = 0;
    }

private:
    static constexpr std::size_t kSize = std::size_t{1} << 28, kAlign = 64;

    bool reserved() {
        if (base_ || failed_) return base_ != nullptr;
        void* at = mmap(nullptr, kSize, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
        failed_ = at == MAP_FAILED;
        base_ = failed_ ? nullptr : static_cast<char*>(at);
        return !failed_;
    }

    char* base_ = nullptr;
    std::size_t used_ = 0, live_ = 0;
    bool on_ = false, failed_ = false;
};

template <class T>
struct OrderedAllocator {
    using value_type = T;
    OrderedAllocator() = default;
    template <class U>
    OrderedAllocator(const OrderedAllocator<U>&) {}
    T* allocate(std::size_t n) { return static_cast<T*>(OrderedBlocks::mine().allocate(n * sizeof(T))); }
    void deallocate(T* at, std::size_t) { OrderedBlocks::mine().deallocate(at); }
    bool operator==(const OrderedAllocator&) const { return true; }
};

}  // namespace whittle

#define CGAL_ALLOCATOR(T) whittle::OrderedAllocator<T>
