// answers.cpp — see answers.h.
#include "modeler/cli/answers.h"

namespace whittle::json {

Buffer& Object::member(std::string_view name) {
    if (members_.size() > 0) members_.push_back(',');
    json::string(members_, name);
    members_.push_back(':');
    return members_;
}

Object& Object::number(std::string_view name, double value) { return json::number(member(name), value), *this; }
Object& Object::count(std::string_view name, std::uint64_t value) { return json::raw(member(name), fmt::format("{}", value)), *this; }
Object& Object::boolean(std::string_view name, bool value) { return json::boolean(member(name), value), *this; }
Object& Object::string(std::string_view name, std::string_view value) { return json::string(member(name), value), *this; }
Object& Object::triple(std::string_view name, Vec3 value) { return json::triple(member(name), value), *this; }
Object& Object::raw(std::string_view name, std::string_view text) { return json::raw(member(name), text), *this; }
Object& Object::measured(std::string_view name, const Measured& value) { return raw(name, of(value)); }

Object& Object::strings(std::string_view name, const std::vector<std::string>& values) {
    std::vector<std::string> quoted;
    for (const auto& value : values) {
        Buffer text;
        json::string(text, value);
        quoted.push_back(fmt::to_string(text));
    }
    return raw(name, array(quoted));
}

Object& Object::numbers(std::string_view name, const std::vector<double>& values) {
    std::vector<std::string> texts;
    for (const double value : values) {
        Buffer text;
        json::number(text, value);
        texts.push_back(fmt::to_string(text));
    }
    return raw(name, array(texts));
}

std::string of(const Measured& value) {
    return Object().number("value", value.value).number("error", value.error).string("kind", name_of(value.kind)).str();
}

std::string array(const std::vector<std::string>& texts) { return fmt::format("[{}]", fmt::join(texts, ",")); }

}  // namespace whittle::json
