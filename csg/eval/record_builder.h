// record_builder.h — puts an object of the language together, member by member. Internal to csg/eval.
#pragma once

#include <string_view>
#include <unordered_map>
#include <vector>

#include "csg/eval/value.h"

namespace whittle {

class RecordBuilder {
public:
    explicit RecordBuilder(Heap& heap) : heap_(heap) {}

    // A name set before keeps its place.
    // Requires: `name` is a string.
    void set(const Value& name, Value value) {
        const auto [at, added] = places_.emplace(name.string(), names_.size());
        if (!added) {
            values_[at->second] = std::move(value);
            return;
        }
        names_.push_back(name);
        values_.push_back(std::move(value));
    }
    void set(std::string_view name, Value value) { set(heap_.string(name), std::move(value)); }
    void erase(std::string_view name) {
        const auto at = places_.find(name);
        if (at == places_.end()) return;
        const auto index = static_cast<std::ptrdiff_t>(at->second);
        places_.erase(at);
        for (auto& [other, place] : places_)
            if (place > static_cast<std::size_t>(index)) --place;
        names_.erase(names_.begin() + index);
        values_.erase(values_.begin() + index);
    }
    Value finish() { return heap_.record(std::move(names_), std::move(values_)); }

private:
    Heap& heap_;
    std::vector<Value> names_, values_;
    std::unordered_map<std::string_view, std::size_t> places_;  // looks into the names
};

}  // namespace whittle
