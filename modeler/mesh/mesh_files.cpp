// mesh_files.cpp — writers. Numbers are printed by std::to_chars: the shortest text that reads back to the same bits, in every locale.
#include "modeler/mesh/mesh_files.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "modeler/mesh/paint.h"
#include "modeler/mesh/weld.h"

namespace whittle {
namespace {

static_assert(std::endian::native == std::endian::little, "binary formats are written in the machine's order");

class Text {
public:
    void add(std::string_view s) { bytes_ += s; }
    void add(double x) { put(x + 0.0); }  // no -0
    void add(float x) { put(x + 0.0F); }
    void add(std::uint32_t x) { put(x); }
    template <class... Rest>
    void line(const Rest&... rest) {
        (add(rest), ...);
        bytes_ += '\n';
    }
    template <class T>
    void raw(const T& x) { bytes_.append(reinterpret_cast<const char*>(&x), sizeof x); }
    std::string take() { return std::move(bytes_); }

private:
    template <class T>
    void put(T x) {
        std::array<char, 32> buffer;
        const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x);
        bytes_.append(buffer.data(), end);
    }
    std::string bytes_;
};

// The mesh in float32, equal points joined again.
Mesh in_single_precision(const Mesh& mesh) {
    Mesh out = mesh;
    for (Vec3& p : out.points) p = Vec3(glm::vec3(p));
    weld(out);
    remove_flat_triangles(out);
    return out;
}

glm::vec3 facet_normal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const Vec3 n = glm::cross(Vec3(b) - Vec3(a), Vec3(c) - Vec3(a));
    const double length = glm::length(n);
    return length > 0 ? glm::vec3(n / length) : glm::vec3(0);
}

std::string stl_binary(const Mesh& mesh) {
    Text out;
    std::array<char, 80> header{};
    constexpr std::string_view kHeader = "Whittle binary STL, millimetres";  // must not begin with "solid"
    std::copy(kHeader.begin(), kHeader.end(), header.begin());
    out.raw(header);
    out.raw(static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const Triangle& t : mesh.triangles) {
        const std::array<glm::vec3, 3> p{glm::vec3(mesh.points[t[0]]), glm::vec3(mesh.points[t[1]]), glm::vec3(mesh.points[t[2]])};
        out.raw(facet_normal(p[0], p[1], p[2]));
        out.raw(p);
        out.raw(std::uint16_t{0});
    }
    return out.take();
}

std::string stl_ascii(const Mesh& mesh) {
    Text out;
    out.line("solid whittle");
    for (const Triangle& t : mesh.triangles) {
        const std::array<glm::vec3, 3> p{glm::vec3(mesh.points[t[0]]), glm::vec3(mesh.points[t[1]]), glm::vec3(mesh.points[t[2]])};
        const glm::vec3 n = facet_normal(p[0], p[1], p[2]);
        out.line("  facet normal ", n.x, " ", n.y, " ", n.z);
        out.line("    outer loop");
        for (const glm::vec3& q : p) out.line("      vertex ", q.x, " ", q.y, " ", q.z);
        out.line("    endloop");
        out.line("  endfacet");
    }
    out.line("endsolid whittle");
    return out.take();
}

// The colour of each triangle as bytes; nothing where the author named none at all.
class Colours {
public:
    explicit Colours(const MeshResult& result) : result_(result) {
        for (const MeshLeaf& leaf : result.leaves) any_ = any_ || leaf.material.color;
        any_ = any_ && !result.mesh.leaf.empty();
        if (any_) paint_ = painting_leaves(result);
    }
    bool any() const { return any_; }
    std::array<std::uint8_t, 4> of(std::size_t triangle) const {
        constexpr Vec4 kUnnamed{0.976, 0.843, 0.173, 1};  // OpenSCAD's yellow
        const auto& color = result_.leaves[paint_[triangle]].material.color;
        const Vec4 c = glm::clamp(color.value_or(kUnnamed), 0.0, 1.0);
        std::array<std::uint8_t, 4> bytes{};
        for (int i = 0; i < 4; ++i) bytes[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(std::lround(c[i] * 255));
        return bytes;
    }

private:
    const MeshResult& result_;
    std::vector<std::uint32_t> paint_;
    bool any_ = false;
};

std::string off(const MeshResult& result) {
    const Mesh& mesh = result.mesh;
    const Colours colours(result);
    Text out;
    out.line("OFF");
    out.line(static_cast<std::uint32_t>(mesh.points.size()), " ", static_cast<std::uint32_t>(mesh.triangles.size()), " 0");
    for (const Vec3& p : mesh.points) out.line(p.x, " ", p.y, " ", p.z);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        out.add("3 ");
        if (!colours.any()) {
            out.line(t[0], " ", t[1], " ", t[2]);
            continue;
        }
        const auto c = colours.of(i);
        out.add(t[0]), out.add(" "), out.add(t[1]), out.add(" "), out.add(t[2]);
        for (std::size_t k = 0; k < (c[3] == 255 ? 3U : 4U); ++k) out.add(" "), out.add(std::uint32_t{c[k]});
        out.line("");
    }
    return out.take();
}

std::string obj(const MeshResult& result) {
    Text out;
    out.line("# Whittle, millimetres");
    for (const Vec3& p : result.mesh.points) out.line("v ", p.x, " ", p.y, " ", p.z);
    for (const Triangle& t : result.mesh.triangles) out.line("f ", t[0] + 1, " ", t[1] + 1, " ", t[2] + 1);
    return out.take();
}

std::string ply(const MeshResult& result) {
    const Mesh& mesh = result.mesh;
    const Colours colours(result);
    Text out;
    out.line("ply");
    out.line("format binary_little_endian 1.0");
    out.line("comment Whittle, millimetres");
    out.line("element vertex ", static_cast<std::uint32_t>(mesh.points.size()));
    for (const char* axis : {"x", "y", "z"}) out.line("property double ", axis);
    out.line("element face ", static_cast<std::uint32_t>(mesh.triangles.size()));
    out.line("property list uchar int vertex_indices");
    if (colours.any())
        for (const char* channel : {"red", "green", "blue", "alpha"}) out.line("property uchar ", channel);
    out.line("end_header");
    for (const Vec3& p : mesh.points) out.raw(p + 0.0);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        out.raw(std::uint8_t{3});
        out.raw(mesh.triangles[i]);
        if (colours.any()) out.raw(colours.of(i));
    }
    return out.take();
}

void warn(MeshFile& file) {
    const MeshReport& r = file.report;
    const auto say = [&](std::uint64_t count, const char* what) {
        if (count > 0) file.warnings.push_back(fmt::format("{} {}", count, what));
    };
    say(r.open_edges, "edges are open");
    say(r.degenerate, "facets have no area");
    say(r.duplicate, "facets are there twice");
    say(r.shared_edges, "edges belong to more than two facets: parts of the solid touch there");
}

std::string lower_suffix(std::string_view path) {
    const std::size_t dot = path.rfind('.');
    std::string suffix(dot == std::string_view::npos ? std::string_view() : path.substr(dot + 1));
    for (char& c : suffix) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return suffix;
}

}  // namespace

Result<MeshFormat> mesh_format(std::string_view path, bool ascii) {
    const std::string suffix = lower_suffix(path);
    if (suffix == "stl") return ascii ? MeshFormat::kStlAscii : MeshFormat::kStlBinary;
    if (suffix == "off") return MeshFormat::kOff;
    if (suffix == "obj") return MeshFormat::kObj;
    if (suffix == "ply") return MeshFormat::kPly;
    return fail(Fault::kCommand, fmt::format("{}: unknown mesh format '{}' (stl, off, obj, ply)", path, suffix));
}

Result<MeshFile> write_mesh(const MeshResult& result, MeshFormat format) {
    if (result.mesh.triangles.empty()) return fail(Fault::kScene, "Current top level object is empty.");
    MeshFile file;
    if (format == MeshFormat::kStlBinary || format == MeshFormat::kStlAscii) {
        const Mesh mesh = in_single_precision(result.mesh);
        file.report = report_mesh(mesh);
        file.bytes = format == MeshFormat::kStlBinary ? stl_binary(mesh) : stl_ascii(mesh);
    } else {
        file.report = result.report;
        file.bytes = format == MeshFormat::kOff ? off(result) : format == MeshFormat::kObj ? obj(result) : ply(result);
    }
    warn(file);
    return file;
}

}  // namespace whittle
