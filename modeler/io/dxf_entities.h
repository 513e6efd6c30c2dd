// dxf_entities.h — a DXF as pairs of code and value, gathered to entities. Internal to the reader.
// Source: Autodesk, DXF Reference (2018): group codes, ENTITIES and BLOCKS sections.
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "csg/base/vec.h"

namespace whittle {

// A vertex of a polyline with the bulge of the side that begins there.
struct DxfVertex { Vec2 at{0}; double bulge = 0; };

struct DxfEntity {
    std::string type, layer, name;       // code 0, 8; 2: of an INSERT's block
    std::string text;                    // code 1: of a dimension
    std::array<Vec2, 7> at{};            // codes 10..16 and 20..26
    std::map<int, double> numbers;       // all other codes that are numbers, last of each
    std::vector<DxfVertex> vertices;     // of a polyline; the control points of a SPLINE
    std::vector<double> knots;           // of a SPLINE
    double number(int code, double otherwise) const {
        const auto found = numbers.find(code);
        return found == numbers.end() ? otherwise : found->second;
    }
};

struct DxfFile {
    std::vector<DxfEntity> entities;
    std::map<std::string, std::vector<DxfEntity>> blocks;
    bool whole = false;  // there was an end
};

DxfFile read_dxf_entities(std::string_view text);

}  // namespace whittle
