// node_list.h — the two containers of a scene: its nodes, and the children of one.
//
// A scene of a million parts is mostly nodes, so they are kept in blocks that never move (growing copies nothing), and the ids of up to three children lie in
// the node itself.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <vector>

#include "csg/eval/large_block.h"

namespace whittle {

// Ids, in order; sixteen bytes as long as there are at most three.
class ChildIds {
public:
    using Id = std::uint32_t;

    ChildIds() = default;
    ChildIds(const ChildIds& o) { assign(o.begin(), o.end()); }
    ChildIds(ChildIds&& o) noexcept { swap(o); }
    ChildIds(const std::vector<Id>& ids) { assign(ids.data(), ids.data() + ids.size()); }
    ChildIds(std::initializer_list<Id> ids) { assign(ids.begin(), ids.end()); }
    ChildIds& operator=(ChildIds o) noexcept {
        swap(o);
        return *this;
    }
    ~ChildIds() {
        if (is_far()) delete[] far();
    }
    void assign(const Id* first, const Id* last) {
        ChildIds made(static_cast<std::size_t>(last - first));
        std::copy(first, last, made.data());
        swap(made);
    }
    void swap(ChildIds& o) noexcept {
        std::swap(count_, o.count_);
        std::swap_ranges(near_, near_ + kNear, o.near_);
    }

    std::size_t size() const { return count_; }
    bool empty() const { return count_ == 0; }
    const Id* begin() const { return is_far() ? far() : near_; }
    const Id* end() const { return begin() + count_; }
    auto rbegin() const { return std::make_reverse_iterator(end()); }
    auto rend() const { return std::make_reverse_iterator(begin()); }
    Id operator[](std::size_t i) const { return begin()[i]; }

private:
    static constexpr std::size_t kNear = 3;
    explicit ChildIds(std::size_t count) : count_(static_cast<std::uint32_t>(count)) {
        if (!is_far()) return;
        Id* block = new Id[count];
        std::memcpy(near_, &block, sizeof block);
    }
    bool is_far() const { return count_ > kNear; }
    Id* far() const {
        Id* block = nullptr;
        std::memcpy(&block, near_, sizeof block);
        return block;
    }
    Id* data() { return is_far() ? far() : near_; }

    std::uint32_t count_ = 0;
    Id near_[kNear] = {};
};
static_assert(sizeof(ChildIds) == 16);

// A growing array whose elements stay where they are.
template <class T>
class BlockList {
public:
    template <class List, class Element>
    class Iterator {
    public:
        Iterator(List* list, std::size_t at) : list_(list), at_(at) {}
        Element& operator*() const { return (*list_)[at_]; }
        Iterator& operator++() {
            ++at_;
            return *this;
        }
        bool operator==(const Iterator& o) const { return at_ == o.at_; }

    private:
        List* list_;
        std::size_t at_;
    };

    std::size_t size() const { return blocks_.empty() ? 0 : start_of(blocks_.size() - 1) + blocks_.back().size(); }
    bool empty() const { return blocks_.empty(); }
    T& operator[](std::size_t i) { return i < kFirst ? blocks_[0][i] : blocks_[1 + (i - kFirst) / kBlock][(i - kFirst) % kBlock]; }
    const T& operator[](std::size_t i) const { return const_cast<BlockList&>(*this)[i]; }
    T& back() { return blocks_.back().back(); }
    void push_back(T element) { emplace_back() = std::move(element); }
    T& emplace_back() {
        if (blocks_.empty()) blocks_.emplace_back().reserve(kFirst);
        else if (blocks_.back().size() == (blocks_.size() == 1 ? kFirst : kBlock)) blocks_.emplace_back().reserve(kBlock);
        return blocks_.back().emplace_back();
    }
    void clear() { blocks_.clear(); }
    Iterator<BlockList, T> begin() { return {this, 0}; }
    Iterator<BlockList, T> end() { return {this, size()}; }
    Iterator<const BlockList, const T> begin() const { return {this, 0}; }
    Iterator<const BlockList, const T> end() const { return {this, size()}; }

private:
    static constexpr std::size_t kFirst = 1024, kBlock = 2 * kLargePage / sizeof(T);
    static std::size_t start_of(std::size_t block) { return block == 0 ? 0 : kFirst + (block - 1) * kBlock; }
    std::vector<std::vector<T, LargeAllocator<T>>> blocks_;
};

// A large value that few nodes have, kept outside them. Reads like the value; copies copy it.
template <class T>
class Boxed {
public:
    Boxed(T value = {}) : value_(1, std::move(value)) {}
    operator const T&() const { return value_.front(); }
    const T& get() const { return value_.front(); }
    const T* operator->() const { return &value_.front(); }

private:
    std::vector<T> value_;
};

}  // namespace whittle
