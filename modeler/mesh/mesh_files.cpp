// mesh_files.cpp — STL, OFF, OBJ and PLY, and the choice of a writer.
#include "modeler/mesh/mesh_files.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "modeler/mesh/file_text.h"
#include "modeler/mesh/paint.h"
#include "modeler/mesh/settle.h"
#include "modeler/mesh/weld.h"

namespace whittle {
namespace {

using Text = FileText;

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

std::string off(const MeshResult& result) {
    const Mesh mesh = with_own_points(result.mesh);
    const FileColors colours(result);
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

std::string material_of(const FileColors::Bytes& c, std::vector<FileColors::Bytes>& known, Text& library) {
    const std::string name = fmt::format("color_{:02x}{:02x}{:02x}{:02x}", c[0], c[1], c[2], c[3]);
    if (std::find(known.begin(), known.end(), c) != known.end()) return name;
    known.push_back(c);
    library.line("newmtl ", name, "\nKd ", c[0] / 255.0, " ", c[1] / 255.0, " ", c[2] / 255.0, "\nd ", c[3] / 255.0);
    return name;
}

// An object a part; a material a colour, in the file beside it.
std::string obj(const std::vector<MeshPart>& parts, const std::string& materials_name, std::string& materials) {
    Text out, library;
    out.line("# Whittle, millimetres");
    std::vector<FileColors::Bytes> known;
    std::uint32_t first = 1;
    for (const MeshPart& part : parts) {
        const FileColors colors(*part.result);
        if (colors.any() && !materials_name.empty() && known.empty()) out.line("mtllib ", materials_name);
        if (!part.name.empty()) out.line("o ", part.name);
        const Mesh mesh = with_own_points(part.result->mesh);
        for (const Vec3& p : mesh.points) out.line("v ", p.x, " ", p.y, " ", p.z);
        std::uint32_t current = 0xFFFFFFFF;
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            if (colors.any() && !materials_name.empty() && colors.number_of(i) != current) {
                current = colors.number_of(i);
                out.line("usemtl ", material_of(colors.of(i), known, library));
            }
            const Triangle& t = mesh.triangles[i];
            out.line("f ", t[0] + first, " ", t[1] + first, " ", t[2] + first);
        }
        first += static_cast<std::uint32_t>(mesh.points.size());
    }
    materials = library.take();
    return out.take();
}

std::string ply(const MeshResult& result) {
    const Mesh mesh = with_own_points(result.mesh);
    const FileColors colours(result);
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
    say(r.self_intersections.value_or(0), "pairs of facets cross in the precision of the file");
    say(r.shared_edges, "edges belong to more than two facets: parts of the solid touch there");
}

std::string lower_suffix(std::string_view path) {
    const std::size_t dot = path.rfind('.');
    std::string suffix(dot == std::string_view::npos ? std::string_view() : path.substr(dot + 1));
    for (char& c : suffix) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return suffix;
}

}  // namespace

FileColors::FileColors(const MeshResult& result) {
    bool any = false;
    for (const MeshLeaf& leaf : result.leaves) any = any || leaf.shown().color;
    if (!any || result.mesh.leaf.empty()) return;
    constexpr Vec4 kUnnamed{0.976, 0.843, 0.173, 1};  // OpenSCAD's yellow
    for (const std::uint32_t leaf : painting_leaves(result)) {
        const Vec4 color = glm::clamp(result.leaves[leaf].shown().color.value_or(kUnnamed), 0.0, 1.0);
        Bytes bytes{};
        for (int i = 0; i < 4; ++i) bytes[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(std::lround(color[i] * 255));
        const auto found = std::find(palette_.begin(), palette_.end(), bytes);
        numbers_.push_back(static_cast<std::uint32_t>(found - palette_.begin()));
        if (found == palette_.end()) palette_.push_back(bytes);
    }
}

Mesh in_single_precision(const Mesh& mesh) {
    MeshControl nobody;
    Mesh out = settled_in_single(mesh, nobody).mesh;
    divide_knots(out);
    for (Vec3& p : out.points) p = Vec3(glm::vec3(p));
    return with_own_points(out);
}

namespace {

struct Suffix { std::string_view name; MeshFormat format; };
constexpr Suffix kSuffixes[] = {{"stl", MeshFormat::kStlBinary}, {"off", MeshFormat::kOff}, {"obj", MeshFormat::kObj}, {"ply", MeshFormat::kPly},
                                {"3mf", MeshFormat::k3mf},       {"amf", MeshFormat::kAmf}, {"glb", MeshFormat::kGlb}, {"om", MeshFormat::kOm}};

// What is wrong with any of the parts.
MeshReport report_of(const std::vector<MeshPart>& parts) {
    MeshReport sum = parts.front().result->report;
    for (std::size_t i = 1; i < parts.size(); ++i) {
        const MeshReport& r = parts[i].result->report;
        sum.triangles += r.triangles, sum.vertices += r.vertices, sum.components += r.components, sum.genus += r.genus;
        sum.open_edges += r.open_edges, sum.shared_edges += r.shared_edges, sum.degenerate += r.degenerate, sum.duplicate += r.duplicate;
    }
    return sum;
}

std::string bytes_of(const std::vector<MeshPart>& parts, MeshFormat format, const std::string& materials_name, std::string& materials) {
    const MeshResult& first = *parts.front().result;
    switch (format) {
        case MeshFormat::kOff: return off(first);
        case MeshFormat::kObj: return obj(parts, materials_name, materials);
        case MeshFormat::kPly: return ply(first);
        case MeshFormat::k3mf: return write_3mf(parts);
        case MeshFormat::kAmf: return write_amf(parts);
        case MeshFormat::kGlb: return write_glb(parts);
        case MeshFormat::kOm: return write_om(first);
        case MeshFormat::kStlBinary:
        case MeshFormat::kStlAscii: break;
    }
    return {};
}

}  // namespace

bool holds_parts(MeshFormat format) {
    return format == MeshFormat::k3mf || format == MeshFormat::kAmf || format == MeshFormat::kGlb || format == MeshFormat::kObj;
}

Result<MeshFormat> mesh_format(std::string_view path, bool ascii) {
    const std::string suffix = lower_suffix(path);
    std::string known;
    for (const Suffix& s : kSuffixes) {
        if (suffix == s.name) return s.format == MeshFormat::kStlBinary && ascii ? MeshFormat::kStlAscii : s.format;
        known += (known.empty() ? "" : ", ") + std::string(s.name);
    }
    return fail(Fault::kCommand, fmt::format("{}: unknown mesh format '{}' ({})", path, suffix, known));
}

Result<MeshFile> write_mesh(const std::vector<MeshPart>& parts, MeshFormat format, const std::string& materials_name) {
    if (std::all_of(parts.begin(), parts.end(), [](const MeshPart& p) { return p.result->mesh.triangles.empty(); }))
        return fail(Fault::kScene, "Current top level object is empty.");
    MeshFile file;
    if (format == MeshFormat::kStlBinary || format == MeshFormat::kStlAscii) {
        MeshControl nobody;
        const auto [mesh, crossings, rearranged] = settled_in_single(parts.front().result->mesh, nobody);
        file.report = report_mesh(mesh);
        file.report.self_intersections = crossings;
        file.bytes = format == MeshFormat::kStlBinary ? stl_binary(mesh) : stl_ascii(mesh);
    } else {
        file.report = report_of(parts);
        file.bytes = bytes_of(parts, format, materials_name, file.materials);
    }
    warn(file);
    return file;
}

Result<MeshFile> write_mesh(const MeshResult& result, MeshFormat format) { return write_mesh({MeshPart{{}, &result}}, format); }

}  // namespace whittle
