#include "csg/eval/value.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <numeric>

namespace whittle {

const char* type_name(Type type) {
    switch (type) {
        case Type::kUnset:
        case Type::kUndef: return "undefined";
        case Type::kBool: return "bool";
        case Type::kNumber: return "number";
        case Type::kString: return "string";
        case Type::kVector: return "vector";
        case Type::kRecord: return "object";
        case Type::kRange: return "range";
        case Type::kFunction: return "function";
    }
    return "";
}

bool Value::truth_of_object() const {
    switch (type_) {
        case Type::kUnset:
        case Type::kUndef: return false;
        case Type::kBool:
        case Type::kNumber: return number_ != 0;
        case Type::kString: return string_object().bytes > 0;
        case Type::kVector: return vector().size > 0;
        case Type::kRecord:
        case Type::kRange:
        case Type::kFunction: return true;
    }
    return false;
}

void* Heap::allocate_new(std::size_t bytes, std::size_t index) {
    if (index >= kClasses) {
        if (bytes > kMaxBlock || (limit_ > 0 && bytes_ + bytes > limit_)) throw std::bad_alloc();
        LargeBlock* block = new (allocate_large(sizeof(LargeBlock) + bytes)) LargeBlock;
        block->previous = &large_;
        block->next = large_.next;
        large_.next = block->next->previous = block;
        bytes_ += bytes;
        return block + 1;
    }
    const std::size_t rounded = bytes_of_class(index);
    if (slab_left_ < rounded) {
        constexpr std::size_t kFirst = 128 * 1024;  // then large pages: a fault fills one in the time of sixty small ones
        const std::size_t slab = slabs_.empty() ? kFirst : slabs_.size() == 1 ? kLargePage : 2 * kLargePage;
        slabs_.reserve(slabs_.size() + 1);
        slabs_.push_back(allocate_large(slab));
        slab_ = static_cast<char*>(slabs_.back());
        slab_left_ = slab;
    }
    char* block = slab_;
    slab_ += rounded;
    slab_left_ -= rounded;
    bytes_ += bytes;
    return block;
}

void Heap::free_large_block(void* block) {
    LargeBlock* large = static_cast<LargeBlock*>(block) - 1;
    large->previous->next = large->next;
    large->next->previous = large->previous;
    free_large(large);
}

Heap::~Heap() {
    for (void* slab : slabs_) free_large(slab);
    for (LargeBlock* block = large_.next; block != &large_;) free_large(std::exchange(block, block->next));
}

namespace {

constexpr std::size_t bytes_of_record(std::size_t size) { return sizeof(RecordObject) + size * (2 * sizeof(Value) + sizeof(std::uint32_t)); }

std::size_t bytes_of(const Object& object) {
    switch (object.type) {
        case Type::kString: {
            const StringObject& text = static_cast<const StringObject&>(object);
            return sizeof(StringObject) + (text.buffer ? 0 : text.bytes);
        }
        case Type::kVector: return sizeof(VectorObject) + sizeof(Value) * static_cast<const VectorObject&>(object).size;
        case Type::kRecord: return bytes_of_record(static_cast<const RecordObject&>(object).size);
        case Type::kRange: return sizeof(RangeObject);
        default: return sizeof(FunctionObject);
    }
}

// Bytes that do not continue a character, eight at a time.
std::uint32_t count_points(std::string_view text) {
    std::size_t continuing = 0, i = 0;
    for (; i + 8 <= text.size(); i += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, text.data() + i, 8);
        constexpr std::uint64_t kOnes = 0x0101010101010101u;
        continuing += (((word >> 7) & ~(word >> 6) & kOnes) * kOnes) >> 56;
    }
    for (; i < text.size(); ++i) continuing += (static_cast<unsigned char>(text[i]) & 0xC0) == 0x80;
    return static_cast<std::uint32_t>(text.size() - continuing);
}

template <class T>
T* make(Heap& heap, Type type, std::size_t extra = 0) {
    T* object = new (heap.allocate(sizeof(T) + extra)) T;
    object->type = type;
    object->heap = &heap;
    return object;
}

}  // namespace

Value Heap::string(std::string_view text) {
    StringObject* s = make<StringObject>(*this, Type::kString, text.size());
    s->bytes = static_cast<std::uint32_t>(text.size());
    std::memcpy(s->own_data(), text.data(), text.size());
    s->points = count_points(text);
    return Value(s);
}

Value Heap::appended(const StringObject& head, std::string_view tail) {
    const std::size_t total = head.bytes + tail.size();
    if (total > kMaxBlock / 2) throw std::bad_alloc();
    StringBuffer* buffer = head.buffer;
    if (buffer && buffer->used == head.bytes && buffer->capacity >= total) {
        ++buffer->refs;
    } else {
        const std::size_t capacity = 2 * total;
        buffer = new (allocate(sizeof(StringBuffer) + capacity)) StringBuffer;
        buffer->capacity = static_cast<std::uint32_t>(capacity);
        std::memcpy(buffer->data(), head.data(), head.bytes);
    }
    std::memcpy(buffer->data() + head.bytes, tail.data(), tail.size());
    buffer->used = static_cast<std::uint32_t>(total);
    StringObject* s = make<StringObject>(*this, Type::kString);
    s->buffer = buffer;
    s->bytes = static_cast<std::uint32_t>(total);
    s->points = head.points + count_points(tail);
    return Value(s);
}

Value Heap::range(double begin, double step, double end) {
    RangeObject* r = make<RangeObject>(*this, Type::kRange);
    r->begin = begin;
    r->step = step;
    r->end = end;
    return Value(r);
}

Value Heap::vector(Value* first, std::size_t count) {
    VectorObject* v = make<VectorObject>(*this, Type::kVector, count * sizeof(Value));
    v->size = static_cast<std::uint32_t>(count);
    for (std::size_t i = 0; i < count; ++i) new (v->data() + i) Value(std::move(first[i]));
    note_nesting(*v);
    return Value(v);
}

Value Heap::blank_vector(std::size_t count) {
    VectorObject* v = make<VectorObject>(*this, Type::kVector, count * sizeof(Value));
    v->size = static_cast<std::uint32_t>(count);
    for (std::size_t i = 0; i < count; ++i) new (v->data() + i) Value();
    return Value(v);
}

Value Heap::numbers(const double* first, std::size_t count) {
    VectorObject* v = make<VectorObject>(*this, Type::kVector, count * sizeof(Value));
    v->size = static_cast<std::uint32_t>(count);
    v->holds_objects = false;
    for (std::size_t i = 0; i < count; ++i) new (v->data() + i) Value(first[i]);
    return Value(v);
}

Value Heap::record(std::vector<Value> names, std::vector<Value> values) {
    const std::size_t count = names.size();
    RecordObject* r = make<RecordObject>(*this, Type::kRecord, bytes_of_record(count) - sizeof(RecordObject));
    r->size = static_cast<std::uint32_t>(count);
    for (std::size_t i = 0; i < count; ++i) {
        new (r->data() + i) Value(std::move(names[i]));
        if (values[i].is_nested()) r->nesting = std::max(r->nesting, values[i].nesting() + 1);
        new (r->data() + count + i) Value(std::move(values[i]));
    }
    std::iota(r->order(), r->order() + count, 0u);
    std::sort(r->order(), r->order() + count, [r](std::uint32_t a, std::uint32_t b) { return r->names()[a].string() < r->names()[b].string(); });
    return Value(r);
}

const Value* RecordObject::find(std::string_view name) const {
    const std::uint32_t* end = order() + size;
    const std::uint32_t* at = std::lower_bound(order(), end, name, [this](std::uint32_t i, std::string_view text) { return names()[i].string() < text; });
    return at != end && names()[*at].string() == name ? values() + *at : nullptr;
}

Value Heap::function(std::uint32_t code, Activation* frame) {
    FunctionObject* f = make<FunctionObject>(*this, Type::kFunction);
    f->code = code;
    f->frame = frame;
    retain(frame);
    return Value(f);
}

Value Heap::method(const FunctionObject& f, const RecordObject& self) {
    Value made = function(f.code, f.frame);
    FunctionObject& method = *static_cast<FunctionObject*>(made.object());
    method.self = const_cast<RecordObject*>(&self);
    ++method.self->refs;
    return made;
}

namespace {

void free_object(Object* object) {
    Heap& heap = *object->heap;
    const std::size_t bytes = bytes_of(*object);
    if (object->type == Type::kString)
        if (StringBuffer* buffer = static_cast<StringObject*>(object)->buffer; buffer && --buffer->refs == 0)
            heap.free(buffer, sizeof(StringBuffer) + buffer->capacity);
    heap.free(object, bytes);
}

// Frees everything that only the given object or frame kept alive. Iterative: parts whose last reference goes join the list.
class Releaser {
public:
    void run(Object* start) {
        objects_.push_back(start);
        while (!objects_.empty() || !frames_.empty()) {
            if (!objects_.empty()) {
                Object* object = objects_.back();
                objects_.pop_back();
                open(*object);
                free_object(object);
            } else {
                Activation* frame = frames_.back();
                frames_.pop_back();
                for (std::uint32_t i = 0; i < frame->size; ++i) drop(frame->slots()[i]);
                drop(frame->parent);
                frame->heap->free(frame, sizeof(Activation) + frame->size * sizeof(Value));
            }
        }
    }

private:
    void open(Object& object) {
        if (object.type == Type::kVector) {
            VectorObject& v = static_cast<VectorObject&>(object);
            for (std::uint32_t i = 0; i < v.size; ++i) drop(v.data()[i]);
        } else if (object.type == Type::kRecord) {
            RecordObject& r = static_cast<RecordObject&>(object);
            for (std::uint32_t i = 0; i < 2 * r.size; ++i) drop(r.data()[i]);
        } else if (object.type == Type::kFunction) {
            FunctionObject& f = static_cast<FunctionObject&>(object);
            drop(f.frame);
            if (f.self && --f.self->refs == 0) objects_.push_back(f.self);
        }
    }
    void drop(const Value& value) {
        if (value.is_object() && --value.object()->refs == 0) objects_.push_back(value.object());
    }
    void drop(Activation* frame) {
        if (frame && --frame->refs == 0) frames_.push_back(frame);
    }
    std::vector<Object*> objects_;
    std::vector<Activation*> frames_;
};

// Has it parts that could die with it?
bool is_flat(Object& object) {
    if (object.type == Type::kVector) return !static_cast<VectorObject&>(object).holds_objects;
    return object.type != Type::kFunction && object.type != Type::kRecord;
}

}  // namespace

void release_object(Object* object) {
    if (is_flat(*object)) return free_object(object);
    Releaser().run(object);
}

void release_frame(Activation* frame) {
    while (frame) {
        for (std::uint32_t i = 0; i < frame->size; ++i) {
            const Value& value = frame->slots()[i];
            if (value.is_object() && --value.object()->refs == 0) release_object(value.object());
        }
        Activation* parent = frame->parent;
        frame->heap->free(frame, sizeof(Activation) + frame->size * sizeof(Value));
        frame = parent && --parent->refs == 0 ? parent : nullptr;
    }
}

std::uint32_t range_count(const RangeObject& range) {
    constexpr std::uint32_t kEndless = std::numeric_limits<std::uint32_t>::max();
    if (std::isnan(range.begin) || std::isnan(range.end) || std::isnan(range.step)) return 0;
    if (range.step < 0 ? range.begin < range.end : range.begin > range.end) return 0;
    if (range.begin == range.end && range.step == 0) return 0;  // OpenSCAD counts one but visits none
    if (range.begin == range.end || std::isinf(range.step)) return 1;
    if (std::isinf(range.begin) || std::isinf(range.end) || range.step == 0) return kEndless;
    const double steps = std::nextafter((range.end - range.begin) / range.step, std::numeric_limits<double>::infinity());
    return steps >= kEndless ? kEndless : static_cast<std::uint32_t>(std::floor(steps)) + 1;
}

}  // namespace whittle
