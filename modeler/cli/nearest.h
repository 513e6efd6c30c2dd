// nearest.h — "did you mean": the known word that a mistyped one most likely meant.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace whittle {

// The word of `known` with the fewest insertions, deletions, replacements from `word`; none where more than a third of it would change.
// Ties go to the first.
std::optional<std::string> nearest(const std::string& word, const std::vector<std::string>& known);

}  // namespace whittle
