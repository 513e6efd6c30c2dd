// value.h — what an expression of the language evaluates to: 16 bytes, numbers in place, the rest counted references.
//
// One thread owns a Heap and every value made on it; counts are plain integers. Releasing a value walks its parts with a work list, not by
// recursion, so that a list nested a million deep goes away quietly.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <new>
#include <string_view>
#include <utility>
#include <vector>

#include "csg/eval/large_block.h"

namespace whittle {

class Heap;
struct Activation;
class Value;

enum class Type : std::uint8_t { kUnset, kUndef, kBool, kNumber, kString, kVector, kRecord, kRange, kFunction };

// Name of a type as messages call it.
const char* type_name(Type type);

struct Object {
    std::uint32_t refs = 1;
    Type type;
    bool holds_objects = true;  // of a vector; false: numbers and the like only, which nobody need visit to free it
    Heap* heap;
};

// Bytes that several strings begin with: the longest of them may grow in place, so that putting a text together piece by piece costs what the pieces cost.
struct StringBuffer {
    std::uint32_t refs = 1, used = 0, capacity = 0;
    char* data() { return reinterpret_cast<char*>(this + 1); }
};

// UTF-8 bytes follow the header or lie in a buffer. `points` counts code points; bytes == points means ASCII, where indexing needs no walk.
struct StringObject : Object {
    std::uint32_t bytes = 0, points = 0;
    StringBuffer* buffer = nullptr;
    const char* data() const { return buffer ? buffer->data() : reinterpret_cast<const char*>(this + 1); }
    char* own_data() { return reinterpret_cast<char*>(this + 1); }
    std::string_view view() const { return {data(), bytes}; }
};

// What holds values: `nesting` is one more than the deepest one's.
struct NestedObject : Object {
    std::uint32_t size = 0, nesting = 1;
};

// `size` values follow the header.
struct VectorObject : NestedObject {
    inline const Value* data() const;
    inline Value* data();
};

// What the language calls an object: named values. `size` names in the order of their making follow the header, then as many values, then the
// positions of the names in the order of their bytes.
struct RecordObject : NestedObject {
    inline const Value* names() const;
    inline const Value* values() const;
    inline Value* data();  // names and values
    inline std::uint32_t* order();
    inline const std::uint32_t* order() const;
    // The value of that name; null where there is none.
    const Value* find(std::string_view name) const;
};

struct RangeObject : Object {
    double begin = 0, step = 1, end = 0;
};

// A function literal with the frame it was made in, and the record it was read from where it is a method.
struct FunctionObject : Object {
    std::uint32_t code = 0;  // index of the function in the program's code
    Activation* frame = nullptr;
    RecordObject* self = nullptr;
};

void release_object(Object* object);

class Value {
public:
    Value() : type_(Type::kUndef) { number_ = 0; }
    explicit Value(double number) : type_(Type::kNumber) { number_ = number; }
    explicit Value(bool truth) : type_(Type::kBool) { number_ = truth ? 1 : 0; }
    // Takes over the reference.
    explicit Value(Object* object) : type_(object->type) { object_ = object; }
    Value(const Value& o) : type_(o.type_), bits_(o.bits_) { retain(); }
    Value(Value&& o) noexcept : type_(o.type_), bits_(o.bits_) { o.type_ = Type::kUndef; }
    Value& operator=(const Value& o) {
        if (this != &o) {
            Value copy(o);
            swap(copy);
        }
        return *this;
    }
    Value& operator=(Value&& o) noexcept {
        swap(o);
        return *this;
    }
    Value& operator=(double number) {
        if (is_object()) *this = Value(number);
        else type_ = Type::kNumber, number_ = number;
        return *this;
    }
    ~Value() {
        if (is_object() && --object_->refs == 0) release_object(object_);
    }
    void swap(Value& o) noexcept {
        std::swap(type_, o.type_);
        std::swap(bits_, o.bits_);
    }
    static Value unset() {
        Value v;
        v.type_ = Type::kUnset;
        return v;
    }

    Type type() const { return type_; }
    bool is_unset() const { return type_ == Type::kUnset; }
    bool is_undef() const { return type_ <= Type::kUndef; }
    bool is_number() const { return type_ == Type::kNumber; }
    bool is_bool() const { return type_ == Type::kBool; }
    bool is_string() const { return type_ == Type::kString; }
    bool is_vector() const { return type_ == Type::kVector; }
    bool is_record() const { return type_ == Type::kRecord; }
    bool is_nested() const { return type_ == Type::kVector || type_ == Type::kRecord; }
    bool is_range() const { return type_ == Type::kRange; }
    bool is_function() const { return type_ == Type::kFunction; }
    bool is_object() const { return type_ >= Type::kString; }

    double number() const { return number_; }
    bool boolean() const { return number_ != 0; }
    std::string_view string() const { return static_cast<const StringObject*>(object_)->view(); }
    const StringObject& string_object() const { return *static_cast<const StringObject*>(object_); }
    const VectorObject& vector() const { return *static_cast<const VectorObject*>(object_); }
    const RecordObject& record() const { return *static_cast<const RecordObject*>(object_); }
    std::uint32_t nesting() const { return static_cast<const NestedObject*>(object_)->nesting; }
    const RangeObject& range() const { return *static_cast<const RangeObject*>(object_); }
    const FunctionObject& function() const { return *static_cast<const FunctionObject*>(object_); }
    Object* object() const { return object_; }
    inline std::uint32_t size() const;                  // of a vector
    inline const Value& operator[](std::size_t) const;  // of a vector

    bool truth() const { return type_ == Type::kNumber || type_ == Type::kBool ? number_ != 0 : truth_of_object(); }

private:
    bool truth_of_object() const;
    friend void release_object(Object* object);
    void retain() {
        if (is_object()) ++object_->refs;
    }
    Type type_;
    union {
        double number_;
        Object* object_;
        std::uint64_t bits_;
    };
};
static_assert(sizeof(Value) == 16);

const Value* VectorObject::data() const { return reinterpret_cast<const Value*>(this + 1); }
Value* VectorObject::data() { return reinterpret_cast<Value*>(this + 1); }
const Value* RecordObject::names() const { return reinterpret_cast<const Value*>(this + 1); }
const Value* RecordObject::values() const { return names() + size; }
Value* RecordObject::data() { return reinterpret_cast<Value*>(this + 1); }
std::uint32_t* RecordObject::order() { return reinterpret_cast<std::uint32_t*>(data() + 2 * std::size_t{size}); }
const std::uint32_t* RecordObject::order() const { return reinterpret_cast<const std::uint32_t*>(names() + 2 * std::size_t{size}); }

// The elements of a vector that nobody else holds yet.
inline Value* elements_of_new(Value& vector) { return static_cast<VectorObject*>(vector.object())->data(); }
// To be called when they are filled: notes how deep they nest and whether there are objects among them.
inline void note_nesting(VectorObject& v) {
    v.holds_objects = false;
    for (std::uint32_t i = 0; i < v.size; ++i) {
        const Value& element = v.data()[i];
        if (!element.is_object()) continue;
        v.holds_objects = true;
        if (element.is_nested() && element.nesting() >= v.nesting) v.nesting = element.nesting() + 1;
    }
}
inline void note_nesting(Value& vector) { note_nesting(*static_cast<VectorObject*>(vector.object())); }
std::uint32_t Value::size() const { return vector().size; }
const Value& Value::operator[](std::size_t i) const { return vector().data()[i]; }

// Makes objects and counts their bytes. Small blocks are kept for reuse. What is still in it when it goes, goes with it unvisited: functions that a variable of
// their own frame names would never go otherwise, and the values of a whole run need not be taken apart at its end. No Value may outlive it.
class Heap {
public:
    Heap() = default;
    Heap(const Heap&) = delete;
    Heap& operator=(const Heap&) = delete;
    ~Heap();

    Value string(std::string_view text);
    // `head` followed by `tail`; shares the bytes of a long head.
    Value appended(const StringObject& head, std::string_view tail);
    Value range(double begin, double step, double end);
    // A vector of the given values, moved from.
    Value vector(Value* first, std::size_t count);
    Value vector(std::vector<Value> values) { return vector(values.data(), values.size()); }
    // `count` numbers.
    Value numbers(const double* first, std::size_t count);
    // `count` undefs, to be filled through elements_of_new() before anybody else sees them.
    Value blank_vector(std::size_t count);
    // Named values, moved from. Requires: the names are strings, no two equal, as many as the values.
    Value record(std::vector<Value> names, std::vector<Value> values);
    Value function(std::uint32_t code, Activation* frame);
    // `function` as a method of `self`.
    Value method(const FunctionObject& function, const RecordObject& self);
    inline Activation* frame(std::uint32_t slots, Activation* parent);

    std::uint64_t bytes() const { return bytes_; }
    // Large blocks beyond it are refused with std::bad_alloc; 0: none.
    void set_limit(std::uint64_t bytes) { limit_ = bytes; }
    void* allocate(std::size_t bytes) {
        const std::size_t index = class_of(bytes);
        if (index < kClasses)
            if (FreeBlock* block = free_[index]) {
                bytes_ += bytes;
                free_[index] = block->next;
                return block;
            }
        return allocate_new(bytes, index);
    }
    void free(void* block, std::size_t bytes) {
        bytes_ -= bytes;
        const std::size_t index = class_of(bytes);
        if (index >= kClasses) return free_large_block(block);
        free_[index] = new (block) FreeBlock{free_[index]};
    }

private:
    // Blocks up to kSmall bytes are pooled by steps of kStep, larger ones up to kMiddle by powers of two; beyond, they are the system's.
    static constexpr std::size_t kStep = 16, kSmall = 512, kMiddle = 65536;
    static constexpr std::size_t kSmallClasses = kSmall / kStep + 1, kClasses = kSmallClasses + 7;
    static constexpr std::size_t class_of(std::size_t bytes) {
        if (bytes <= kSmall) return (bytes + kStep - 1) / kStep;
        return bytes > kMiddle ? kClasses : kSmallClasses + static_cast<std::size_t>(std::bit_width((bytes - 1) / kSmall)) - 1;
    }
    static constexpr std::size_t bytes_of_class(std::size_t index) { return index < kSmallClasses ? index * kStep : kSmall << (index - kSmallClasses + 1); }
    void* allocate_new(std::size_t bytes, std::size_t index);
    void free_large_block(void* block);
    // Stands before a block of the system's; all of them are a ring.
    struct alignas(16) LargeBlock {
        LargeBlock* previous = this;
        LargeBlock* next = this;
    };
    struct FreeBlock { FreeBlock* next; };
    static constexpr std::size_t kMaxBlock = std::size_t{3} << 30;  // sizes are 32 bits
    std::uint64_t bytes_ = 0, limit_ = 0;
    FreeBlock* free_[kClasses] = {};
    std::vector<void*> slabs_;
    LargeBlock large_;
    char* slab_ = nullptr;
    std::size_t slab_left_ = 0;
};

struct ModuleCall;

// One activation of a file, module, function or capturing scope: its variables. Counted, since function values keep frames alive.
struct Activation {
    std::uint32_t refs = 1;
    std::uint32_t size = 0;
    Activation* parent = nullptr;
    Heap* heap = nullptr;
    ModuleCall* call = nullptr;  // of a module's frame
    Value* slots() { return reinterpret_cast<Value*>(this + 1); }
};

inline void retain(Activation* frame) {
    if (frame) ++frame->refs;
}
Activation* Heap::frame(std::uint32_t slots, Activation* parent) {
    Activation* f = new (allocate(sizeof(Activation) + slots * sizeof(Value))) Activation;
    f->size = slots;
    f->parent = parent;
    f->heap = this;
    if (parent) ++parent->refs;
    for (std::uint32_t i = 0; i < slots; ++i) new (f->slots() + i) Value(Value::unset());
    return f;
}

void release_frame(Activation* frame);
inline void release(Activation* frame) {
    if (frame && --frame->refs == 0) release_frame(frame);
}

// Holds one reference to a frame.
class FrameRef {
public:
    explicit FrameRef(Activation* frame) : frame_(frame) {}
    FrameRef(const FrameRef&) = delete;
    FrameRef& operator=(const FrameRef&) = delete;
    ~FrameRef() { release(frame_); }
    Activation* get() const { return frame_; }
    // Gives the reference away.
    Activation* take() { return std::exchange(frame_, nullptr); }
    void reset(Activation* frame) {
        release(frame_);
        frame_ = frame;
    }

private:
    Activation* frame_;
};

// Number of elements of a range: 0 in the wrong direction or for nan, 2^32-1 when endless.
std::uint32_t range_count(const RangeObject& range);
inline double range_at(const RangeObject& range, std::uint32_t index) { return index == 0 ? range.begin : range.begin + range.step * index; }

// Lists are compared and printed by recursion; deeper ones are refused when made.
inline constexpr std::uint32_t kMaxValueNesting = 20000;

}  // namespace whittle
