// binary_writers.cpp — glTF binary and OpenMesh's own format.
// Source: Khronos, glTF 2.0 Specification (2021), chapters 3 and 4; OpenMesh 9.0, OMFormat.hh (version 1.2 of the format: points and faces).
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "modeler/mesh/file_text.h"
#include "modeler/mesh/weld.h"

namespace whittle {
namespace {

// ------------------------------------------------------------------------------------------------------------------ glTF

// glTF's factors are linear.
double linear(std::uint8_t byte) {
    const double c = byte / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

std::string json_string(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        if (static_cast<unsigned char>(c) < 0x20) out += fmt::format("\\u{:04x}", static_cast<int>(c));
        else out += c;
    }
    return out + "\"";
}

class Glb {
public:
    void add(const MeshPart& part) {
        MeshResult rounded = *part.result;
        rounded.mesh = in_single_precision(part.result->mesh);
        if (rounded.mesh.triangles.empty()) return;
        const Mesh& mesh = rounded.mesh;
        const FileColors colors(rounded);
        const std::size_t points = add_points(mesh);
        std::string primitives;
        for (std::uint32_t c = 0; c < std::max<std::size_t>(1, colors.palette().size()); ++c) {
            std::vector<std::uint32_t> indices;
            for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
                if (!colors.any() || colors.number_of(i) == c) indices.insert(indices.end(), mesh.triangles[i].begin(), mesh.triangles[i].end());
            const FileColors::Bytes color = colors.any() ? colors.palette()[c] : FileColors::Bytes{249, 215, 44, 255};
            append(primitives, fmt::format("{{\"attributes\":{{\"POSITION\":{}}},\"indices\":{},\"material\":{}}}", points, add_indices(indices), material(color)));
        }
        const std::string name = part.name.empty() ? "" : ",\"name\":" + json_string(part.name);
        append(meshes_, fmt::format("{{\"primitives\":[{}]{}}}", primitives, name));
        // Metres with y up.
        append(nodes_, fmt::format("{{\"mesh\":{0},\"matrix\":[0.001,0,0,0,0,0,-0.001,0,0,0.001,0,0,0,0,0,1]{1}}}", count_, name));
        append(roots_, std::to_string(count_++));
    }

    std::string take() {
        std::string json = fmt::format("{{\"asset\":{{\"version\":\"2.0\",\"generator\":\"Whittle\"}},\"scene\":0,\"scenes\":[{{\"nodes\":[{}]}}],\"nodes\":[{}],\"meshes\":[{}],", roots_,
                                       nodes_, meshes_);
        json += fmt::format("\"materials\":[{}],\"accessors\":[{}],\"bufferViews\":[{}],\"buffers\":[{{\"byteLength\":{}}}]}}", materials_, accessors_, views_, data_.size());
        while (json.size() % 4 != 0) json += ' ';
        FileText out;
        const std::string data = data_.take();
        out.add("glTF");
        out.raw(std::uint32_t{2});
        out.raw(static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + data.size()));
        out.raw(static_cast<std::uint32_t>(json.size()));
        out.add("JSON");
        out.add(json);
        out.raw(static_cast<std::uint32_t>(data.size()));
        out.add(std::string_view("BIN\0", 4));
        out.add(data);
        return out.take();
    }

private:
    static void append(std::string& list, const std::string& item) { list += (list.empty() ? "" : ",") + item; }

    std::size_t accessor(std::size_t start, int target, const std::string& rest) {
        append(views_, fmt::format("{{\"buffer\":0,\"byteOffset\":{},\"byteLength\":{},\"target\":{}}}", start, data_.size() - start, target));
        append(accessors_, fmt::format("{{\"bufferView\":{},{}}}", accessors_count_, rest));
        return accessors_count_++;
    }
    std::size_t add_points(const Mesh& mesh) {
        constexpr int kVertices = 34962, kFloat = 5126;
        const std::size_t start = data_.size();
        for (const Vec3& p : mesh.points) data_.raw(glm::vec3(p) + 0.0F);
        const Bounds box = mesh_bounds(mesh);
        const auto triple = [](const Vec3& v) { return fmt::format("[{},{},{}]", static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)); };
        return accessor(start, kVertices, fmt::format("\"componentType\":{},\"count\":{},\"type\":\"VEC3\",\"min\":{},\"max\":{}", kFloat, mesh.points.size(), triple(box.lo), triple(box.hi)));
    }
    std::size_t add_indices(const std::vector<std::uint32_t>& indices) {
        constexpr int kElements = 34963, kUnsignedInt = 5125;
        const std::size_t start = data_.size();
        for (const std::uint32_t i : indices) data_.raw(i);
        return accessor(start, kElements, fmt::format("\"componentType\":{},\"count\":{},\"type\":\"SCALAR\"", kUnsignedInt, indices.size()));
    }
    std::size_t material(const FileColors::Bytes& c) {
        const auto found = std::find(colors_.begin(), colors_.end(), c);
        if (found != colors_.end()) return static_cast<std::size_t>(found - colors_.begin());
        append(materials_, fmt::format("{{\"pbrMetallicRoughness\":{{\"baseColorFactor\":[{},{},{},{}],\"metallicFactor\":0,\"roughnessFactor\":0.5}}{}}}", linear(c[0]), linear(c[1]),
                                       linear(c[2]), c[3] / 255.0, c[3] == 255 ? "" : ",\"alphaMode\":\"BLEND\""));
        colors_.push_back(c);
        return colors_.size() - 1;
    }

    FileText data_;
    std::string roots_, nodes_, meshes_, materials_, accessors_, views_;
    std::vector<FileColors::Bytes> colors_;
    std::size_t count_ = 0, accessors_count_ = 0;
};

// -------------------------------------------------------------------------------------------------------------- OpenMesh

// A chunk's head: size of a number, values an element, float, signed, kind of data, kind of element.
constexpr std::uint16_t om_chunk(int bits, int values, int is_float, int is_signed, int type, int entity) {
    return static_cast<std::uint16_t>(bits << 14 | (values - 1) << 11 | is_float << 10 | is_signed << 9 | type << 5 | entity << 2);
}
constexpr std::uint8_t kOmVersion = 1 << 5 | 2;
constexpr std::uint16_t kOmPoints = om_chunk(1, 3, 1, 1, 0, 0), kOmFaces = om_chunk(2, 3, 0, 0, 7, 2), kOmColors = om_chunk(0, 3, 0, 0, 4, 2), kOmEnd = om_chunk(0, 1, 0, 0, 0, 7);

}  // namespace

std::string write_glb(const std::vector<MeshPart>& parts) {
    Glb glb;
    for (const MeshPart& part : parts) glb.add(part);
    return glb.take();
}

std::string write_om(const MeshResult& result) {
    const Mesh mesh = with_own_points(result.mesh);
    const FileColors colors(result);
    FileText out;
    out.add("OMT");
    out.raw(kOmVersion);
    out.raw(static_cast<std::uint32_t>(mesh.points.size()));
    out.raw(static_cast<std::uint32_t>(mesh.triangles.size()));
    out.raw(static_cast<std::uint32_t>(mesh.triangles.size() / 2 * 3));
    out.raw(kOmPoints);
    for (const Vec3& p : mesh.points) out.raw(p + 0.0);
    out.raw(kOmFaces);
    for (const Triangle& t : mesh.triangles) out.raw(t);
    if (colors.any()) {
        out.raw(kOmColors);
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) out.raw(std::array<std::uint8_t, 3>{colors.of(i)[0], colors.of(i)[1], colors.of(i)[2]});
    }
    out.raw(kOmEnd);
    return out.take();
}

}  // namespace whittle
