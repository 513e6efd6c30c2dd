#include "modeler/io/dxf_entities.h"

#include <charconv>
#include <cmath>

namespace whittle {
namespace {

std::string_view trimmed(std::string_view s) {
    const auto first = s.find_first_not_of(" \t\r"), last = s.find_last_not_of(" \t\r");
    return first == std::string_view::npos ? std::string_view() : s.substr(first, last - first + 1);
}

std::string_view next_line(std::string_view text, std::size_t& at) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = text.substr(at, end - at);
    at = std::min(end + 1, text.size());
    return trimmed(line);
}

double number_of(std::string_view text) {
    if (!text.empty() && text[0] == '+') text.remove_prefix(1);
    double x = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
    return error == std::errc() && std::isfinite(x) ? x : 0;
}

class Gatherer {
public:
    void pair(int code, std::string_view value) {
        if (code == 0) return begin(value);
        if (current_.type == "SECTION" && code == 2) section_ = value;
        if (current_.type == "BLOCK" && code == 2) block_ = value;
        if (code == 8) current_.layer = value;
        else if (code == 2) current_.name = value;
        else if (code == 1) current_.text = value;
        else coordinate(code, number_of(value));
    }
    void begin(std::string_view type) {
        finish();
        current_ = {};
        current_.type = type;
        if (type == "EOF" || type == "ENDSEC") file_.whole = true;
        if (type == "ENDBLK") block_.clear();
    }
    DxfFile take() {
        finish();
        return std::move(file_);
    }

private:
    void coordinate(int code, double x) {
        const bool spline = current_.type == "SPLINE", polyline = current_.type == "LWPOLYLINE" || spline;
        if (spline && code == 40) current_.knots.push_back(x);
        if (polyline && code == 10) current_.vertices.push_back({{x, 0}, 0});
        else if (polyline && code == 20 && !current_.vertices.empty()) current_.vertices.back().at.y = x;
        else if (polyline && code == 42 && !current_.vertices.empty()) current_.vertices.back().bulge = x;
        else if (code >= 10 && code <= 16) current_.at[static_cast<std::size_t>(code - 10)].x = x;
        else if (code >= 20 && code <= 26) current_.at[static_cast<std::size_t>(code - 20)].y = x;
        else current_.numbers[code] = x;
    }

    void finish() {
        const bool in_block = section_ == "BLOCKS" && !block_.empty();
        if (section_ != "ENTITIES" && !in_block) return;
        if (current_.type.empty() || current_.type == "SECTION" || current_.type == "ENDSEC" || current_.type == "BLOCK" || current_.type == "EOF") {
            if (current_.type == "ENDSEC") section_.clear();
            return;
        }
        auto& list = in_block ? file_.blocks[block_] : file_.entities;
        if (current_.type == "SEQEND") return;
        if (current_.type == "VERTEX") {
            if (!list.empty() && list.back().type == "POLYLINE") list.back().vertices.push_back({current_.at[0], current_.number(42, 0)});
            return;
        }
        list.push_back(std::move(current_));
    }

    DxfFile file_;
    DxfEntity current_;
    std::string section_, block_;
};

}  // namespace

DxfFile read_dxf_entities(std::string_view text) {
    Gatherer gatherer;
    for (std::size_t at = 0; at < text.size();) {
        const std::string_view code_text = next_line(text, at);
        int code = 0;
        const auto [end, error] = std::from_chars(code_text.data(), code_text.data() + code_text.size(), code);
        if (error != std::errc()) {
            if (code_text.empty() && at >= text.size()) break;
            DxfFile broken;
            return broken;
        }
        gatherer.pair(code, next_line(text, at));
    }
    return gatherer.take();
}

}  // namespace whittle
