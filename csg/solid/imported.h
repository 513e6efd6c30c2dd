// imported.h — what files outside the language give (meshes, drawings, heights, dimensions), and the interface that reads them.
//
// Formats are the readers' business (modeler/io); csg knows only what is in them: closed facets, contours of lines, arcs and Bezier curves, a grid of heights.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "csg/base/result.h"
#include "csg/solid/solid.h"

namespace whittle {

// A closed surface of a file, counter-clockwise seen from outside; where it crosses itself, inside is what an odd number of crossings leads to.
struct ImportedSolid {
    std::shared_ptr<const FacetList> mesh;
    std::optional<Vec4> color;  // as color() takes it
    std::string name;
};

// The union of the solids; none of them: the file holds no facets. `remarks` say what was mended, with numbers.
struct ImportedMesh {
    std::vector<ImportedSolid> solids;
    std::vector<std::string> remarks;
};

// One side of a contour, from the end of the side before it to the last of `degree` points: a Bezier curve, or for degree 1 a line or a circular arc.
// `bulge` is the tangent of a quarter of the arc's angle, positive counter-clockwise, as DXF writes it; 0: straight.
struct DrawnSide {
    int degree = 1;
    std::array<Vec2, 3> p{};
    double bulge = 0;
    Vec2 end() const { return p[static_cast<std::size_t>(degree - 1)]; }
    static DrawnSide line(Vec2 to) { return {1, {to, {}, {}}, 0}; }
    static DrawnSide arc(Vec2 to, double bulge) { return {1, {to, {}, {}}, bulge}; }
};
// Closed: the last side ends where the contour starts.
struct DrawnContour {
    Vec2 start{0};
    std::vector<DrawnSide> sides;
};
// Inside is what an odd number of contours surrounds; the figures of a drawing are united.
struct DrawnFigure { std::vector<DrawnContour> contours; };
struct Drawing {
    std::vector<DrawnFigure> figures;
    std::vector<std::string> remarks;
};

struct DrawingRequest {
    std::string layer;    // empty: all
    Vec2 origin{0};
    double scale = 1;
    bool center = false;  // the drawing's box, or the sheet of an SVG, is centred on the origin
    double dpi = 72;      // of an SVG
    int facets = 0;       // of a full circle where the author asked for facets; 0: true curves
};

// Heights on the unit grid: z[row * columns + column] stands at (column, row).
struct HeightMap {
    std::uint32_t columns = 0, rows = 0;
    std::vector<double> z;
};

// Faults: kWorld where a file cannot be read or is not what its name says.
class Imports {
public:
    virtual ~Imports() = default;
    virtual Result<ImportedMesh> mesh(const std::string& path) = 0;
    virtual Result<Drawing> drawing(const std::string& path, const DrawingRequest& request) = 0;
    // `invert`: of a picture only.
    virtual Result<HeightMap> heights(const std::string& path, bool invert) = 0;
    // The dimension of that name, and the point where the two lines of a layer cross; kScene fault where there is none.
    virtual Result<double> dxf_dimension(const std::string& path, const DrawingRequest& request, const std::string& name) = 0;
    virtual Result<Vec2> dxf_crossing(const std::string& path, const DrawingRequest& request) = 0;
};

}  // namespace whittle
