// lookup_memo.h — the table that lookup() was asked about last, in the order of its keys. Internal to csg/eval.
//
// Scripts ask one table thousands of times; going through all of it each time is what a single question costs.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "csg/eval/value.h"

namespace whittle {

struct LookupPair { double key, value; };

class LookupMemo {
public:
    // The table's pairs by key, the first of equal keys only; nothing the first time it is asked about, nor where a key is nan. `pair_of(row, pair)`: is the row
    // a pair of numbers?
    template <class PairOf>
    std::span<const LookupPair> pairs(const Value& table, PairOf pair_of) {
        if (!table_.is_vector() || table_.object() != table.object()) {
            table_ = table;
            known_ = false;
            return {};
        }
        if (!known_) sort(pair_of);
        return pairs_;
    }

private:
    template <class PairOf>
    void sort(PairOf pair_of) {
        known_ = true;
        pairs_.clear();
        LookupPair pair;
        for (std::uint32_t i = 0; i < table_.size(); ++i)
            if (pair_of(table_[i], pair)) pairs_.push_back(pair);
        if (std::any_of(pairs_.begin(), pairs_.end(), [](const LookupPair& p) { return std::isnan(p.key); })) return pairs_.clear();
        std::stable_sort(pairs_.begin(), pairs_.end(), [](const LookupPair& a, const LookupPair& b) { return a.key < b.key; });
        pairs_.erase(std::unique(pairs_.begin(), pairs_.end(), [](const LookupPair& a, const LookupPair& b) { return a.key == b.key; }), pairs_.end());
    }

    Value table_;  // kept, so that no other takes its place
    bool known_ = false;
    std::vector<LookupPair> pairs_;
};

}  // namespace whittle
