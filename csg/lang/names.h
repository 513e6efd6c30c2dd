// names.h — every identifier of a run as a small number, so that nothing compares strings after reading.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>

namespace whittle {

using NameId = std::uint32_t;
inline constexpr NameId kNoName = 0;  // the empty name

class Names {
public:
    Names() { intern(""); }
    Names(const Names&) = delete;
    Names& operator=(const Names&) = delete;

    // Law: text(intern(s)) == s; equal texts have equal ids.
    NameId intern(std::string_view text) {
        if (auto it = ids_.find(text); it != ids_.end()) return it->second;
        texts_.emplace_back(text);
        const NameId id = static_cast<NameId>(texts_.size() - 1);
        ids_.emplace(texts_.back(), id);
        return id;
    }
    const std::string& text(NameId id) const { return texts_[id]; }
    std::size_t size() const { return texts_.size(); }
    // $-variables are dynamic; $children alone is an ordinary variable of the module.
    bool is_dynamic(NameId id) const { return texts_[id].size() > 0 && texts_[id][0] == '$' && texts_[id] != "$children"; }

private:
    std::deque<std::string> texts_;  // stable addresses: the map's keys look into it
    std::unordered_map<std::string_view, NameId> ids_;
};

}  // namespace whittle
