// parameter_set.cpp — the one reader of JSON in the program.
#include "modeler/io/parameter_set.h"

#include <nlohmann/json.hpp>

#include "csg/base/file.h"

namespace whittle {

Result<std::vector<std::pair<std::string, std::string>>> read_parameter_set(const std::string& path, const std::string& set) {
    const auto text = read_whole_file(path);
    if (!text) return tl::unexpected<Error>(text.error());
    const auto whole = nlohmann::json::parse(*text, nullptr, false);
    if (!whole.is_object() || !whole.contains("parameterSets") || !whole["parameterSets"].is_object())
        return fail(Fault::kScene, "'" + path + "' holds no parameter sets");
    std::vector<std::pair<std::string, std::string>> values;
    const auto& sets = whole["parameterSets"];
    if (!sets.contains(set) || !sets[set].is_object()) return values;
    for (const auto& [name, value] : sets[set].items()) values.emplace_back(name, value.is_string() ? value.get<std::string>() : value.dump());
    return values;
}

}  // namespace whittle
