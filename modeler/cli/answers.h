// answers.h — the JSON answers of verbs that are one object: members in order, values with their errors.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "modeler/check/measure.h"
#include "modeler/cli/json.h"

namespace whittle::json {

// An object in the making. Law: str() is valid JSON whatever was added.
class Object {
public:
    Object& number(std::string_view name, double value);
    Object& count(std::string_view name, std::uint64_t value);
    Object& boolean(std::string_view name, bool value);
    Object& string(std::string_view name, std::string_view value);
    Object& strings(std::string_view name, const std::vector<std::string>& values);
    Object& numbers(std::string_view name, const std::vector<double>& values);
    Object& triple(std::string_view name, Vec3 value);
    // {"value":..,"error":..,"kind":"bound"|"ci99"}
    Object& measured(std::string_view name, const Measured& value);
    // `text` is JSON itself.
    Object& raw(std::string_view name, std::string_view text);
    std::string str() const { return "{" + fmt::to_string(members_) + "}"; }

private:
    Buffer& member(std::string_view name);
    Buffer members_;
};

std::string of(const Measured& value);
// [a,b,c] of texts that are JSON themselves.
std::string array(const std::vector<std::string>& texts);

}  // namespace whittle::json
