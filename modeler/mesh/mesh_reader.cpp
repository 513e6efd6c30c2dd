// mesh_reader.cpp — STL, OFF, OBJ and PLY back into a mesh. Polygons of more than three corners become fans; nothing is repaired.
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "modeler/mesh/mesh_files.h"
#include "modeler/mesh/weld.h"

namespace whittle {
namespace {

// Words of a text, separated by white space; '#' starts a comment where the format has them.
class Words {
public:
    explicit Words(std::string_view text, bool comments) : text_(text), comments_(comments) {}

    std::string_view next() {
        skip();
        const std::size_t start = at_;
        while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
        return text_.substr(start, at_ - start);
    }
    bool end() { return skip(), at_ >= text_.size(); }
    std::string_view rest_of_line() {
        const std::size_t start = at_;
        while (at_ < text_.size() && text_[at_] != '\n') ++at_;
        return text_.substr(start, at_ - start);
    }
    template <class T>
    bool read(T& x) {
        std::string_view w = next();
        if (!w.empty() && w.front() == '+') w.remove_prefix(1);
        const auto [end, error] = std::from_chars(w.data(), w.data() + w.size(), x);
        return error == std::errc() && end == w.data() + w.size();
    }
    bool read(Vec3& p) { return read(p.x) && read(p.y) && read(p.z) && std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

private:
    static bool is_space(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }
    void skip() {
        while (at_ < text_.size()) {
            if (is_space(text_[at_])) {
                ++at_;
            } else if (comments_ && text_[at_] == '#') {
                rest_of_line();
            } else {
                return;
            }
        }
    }
    std::string_view text_;
    std::size_t at_ = 0;
    bool comments_;
};

void add_fan(Mesh& mesh, const std::vector<std::uint32_t>& corners) {
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) mesh.triangles.push_back({corners[0], corners[i], corners[i + 1]});
}

using Outcome = std::optional<Mesh>;  // nothing: the file is not what it says it is

Outcome read_stl_binary(std::string_view bytes) {
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + 80, sizeof count);
    Mesh mesh;
    for (std::size_t i = 0; i < count; ++i) {
        std::array<float, 12> f;
        std::memcpy(f.data(), bytes.data() + 84 + i * 50, sizeof f);
        const auto first = static_cast<std::uint32_t>(mesh.points.size());
        for (std::size_t k = 3; k < 12; k += 3) {
            mesh.points.emplace_back(f[k], f[k + 1], f[k + 2]);
            for (std::size_t j = k; j < k + 3; ++j)
                if (!std::isfinite(f[j])) return std::nullopt;
        }
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

Outcome read_stl_ascii(std::string_view text) {
    Words words(text, false);
    words.next();
    words.rest_of_line();
    Mesh mesh;
    while (!words.end()) {
        const std::string_view w = words.next();
        if (w == "endsolid") return mesh;
        if (w != "vertex") continue;
        mesh.points.emplace_back();
        if (!words.read(mesh.points.back())) return std::nullopt;
        const auto n = static_cast<std::uint32_t>(mesh.points.size());
        if (n % 3 == 0) mesh.triangles.push_back({n - 3, n - 2, n - 1});
    }
    return mesh.triangles.empty() ? Outcome{} : mesh;
}

// A count larger than the text has bytes is a lie that must not become an allocation.
bool plausible(std::uint64_t count, std::string_view text) { return count <= text.size(); }

Outcome read_off(std::string_view text) {
    Words words(text, true);
    words.next();
    std::uint32_t points = 0, faces = 0, edges = 0;
    if (!words.read(points) || !words.read(faces) || !words.read(edges) || !plausible(points, text) || !plausible(faces, text)) return std::nullopt;
    Mesh mesh;
    mesh.points.resize(points);
    for (Vec3& p : mesh.points)
        if (!words.read(p)) return std::nullopt;
    for (std::uint32_t i = 0; i < faces; ++i) {
        std::uint32_t n = 0;
        if (!words.read(n) || !plausible(n, text)) return std::nullopt;
        std::vector<std::uint32_t> corners(n);
        for (std::uint32_t& v : corners)
            if (!words.read(v) || v >= points) return std::nullopt;
        add_fan(mesh, corners);
        words.rest_of_line();  // colours
    }
    return mesh;
}

Outcome read_obj(std::string_view text) {
    Words words(text, true);
    Mesh mesh;
    while (!words.end()) {
        const std::string_view w = words.next();
        if (w == "v") {
            mesh.points.emplace_back();
            if (!words.read(mesh.points.back())) return std::nullopt;
        } else if (w == "f") {
            std::vector<std::uint32_t> corners;
            Words line(words.rest_of_line(), true);
            while (!line.end()) {
                const std::string_view corner = line.next();
                std::int64_t v = 0;
                const auto [end, error] = std::from_chars(corner.data(), corner.data() + corner.size(), v);
                if (error != std::errc()) return std::nullopt;
                if (v < 0) v += static_cast<std::int64_t>(mesh.points.size()) + 1;
                if (v < 1 || v > static_cast<std::int64_t>(mesh.points.size())) return std::nullopt;
                corners.push_back(static_cast<std::uint32_t>(v - 1));
            }
            add_fan(mesh, corners);
            continue;
        }
        words.rest_of_line();
    }
    return mesh;
}

// ------------------------------------------------------------------------------------------------------------------- PLY

struct PlyProperty {
    std::string type, count_type, name;  // count_type: of a list
};
struct PlyElement {
    std::string name;
    std::uint32_t count = 0;
    std::vector<PlyProperty> properties;
};

// Numbers of a body, ascii or binary.
class PlyBody {
public:
    PlyBody(std::string_view bytes, bool ascii) : bytes_(bytes), words_(ascii ? bytes : std::string_view(), false), ascii_(ascii) {}

    bool read(const std::string& type, double& x) {
        if (ascii_) return words_.read(x);
        if (type == "double" || type == "float64") return take<double>(x);
        if (type == "float" || type == "float32") return take<float>(x);
        if (type == "int" || type == "int32") return take<std::int32_t>(x);
        if (type == "uint" || type == "uint32") return take<std::uint32_t>(x);
        if (type == "short" || type == "int16") return take<std::int16_t>(x);
        if (type == "ushort" || type == "uint16") return take<std::uint16_t>(x);
        if (type == "char" || type == "int8") return take<std::int8_t>(x);
        if (type == "uchar" || type == "uint8") return take<std::uint8_t>(x);
        return false;
    }

private:
    template <class T>
    bool take(double& x) {
        T value;
        if (bytes_.size() - at_ < sizeof value) return false;
        std::memcpy(&value, bytes_.data() + at_, sizeof value);
        at_ += sizeof value;
        x = static_cast<double>(value);
        return true;
    }
    std::string_view bytes_;
    std::size_t at_ = 0;
    Words words_;
    bool ascii_;
};

struct PlyHeader {
    bool ascii = false;
    std::vector<PlyElement> elements;
    std::size_t size = 0;
};

std::optional<PlyHeader> read_ply_header(std::string_view bytes) {
    PlyHeader header;
    bool known_format = false;
    while (header.size < bytes.size()) {
        const std::size_t end = bytes.find('\n', header.size);
        if (end == std::string_view::npos) return std::nullopt;
        Words line(bytes.substr(header.size, end - header.size), false);
        header.size = end + 1;
        const std::string_view w = line.next();
        if (w == "end_header") return known_format ? std::optional(header) : std::nullopt;
        if (w == "format") {
            const std::string_view format = line.next();
            header.ascii = format == "ascii";
            known_format = header.ascii || format == "binary_little_endian";
        } else if (w == "element") {
            PlyElement e;
            e.name = line.next();
            if (!line.read(e.count) || !plausible(e.count, bytes)) return std::nullopt;
            header.elements.push_back(std::move(e));
        } else if (w == "property") {
            if (header.elements.empty()) return std::nullopt;
            PlyProperty p;
            p.type = line.next();
            if (p.type == "list") {
                p.count_type = line.next();
                p.type = line.next();
            }
            p.name = line.next();
            header.elements.back().properties.push_back(std::move(p));
        }
    }
    return std::nullopt;
}

Outcome read_ply(std::string_view bytes) {
    const auto header = read_ply_header(bytes);
    if (!header) return std::nullopt;
    PlyBody body(bytes.substr(header->size), header->ascii);
    Mesh mesh;
    for (const PlyElement& e : header->elements)
        for (std::uint32_t i = 0; i < e.count; ++i) {
            Vec3 p{0};
            for (const PlyProperty& property : e.properties) {
                double x = 0;
                if (property.count_type.empty()) {
                    if (!body.read(property.type, x)) return std::nullopt;
                    if (property.name == "x" || property.name == "y" || property.name == "z") p[property.name[0] - 'x'] = x;
                    continue;
                }
                double n = 0;
                if (!body.read(property.count_type, n) || n < 0 || !plausible(static_cast<std::uint64_t>(n), bytes)) return std::nullopt;
                std::vector<std::uint32_t> corners;
                for (int k = 0; k < static_cast<int>(n); ++k) {
                    if (!body.read(property.type, x) || x < 0 || x >= static_cast<double>(mesh.points.size())) return std::nullopt;
                    corners.push_back(static_cast<std::uint32_t>(x));
                }
                if (e.name == "face") add_fan(mesh, corners);
            }
            if (e.name == "vertex") mesh.points.push_back(p);
        }
    return mesh;
}

Outcome read_any(std::string_view bytes, std::string_view path) {
    std::uint32_t count = 0;
    if (bytes.size() >= 84) std::memcpy(&count, bytes.data() + 80, sizeof count);
    const auto ends = [&](std::string_view suffix) { return path.size() >= suffix.size() && path.substr(path.size() - suffix.size()) == suffix; };
    if (bytes.substr(0, 3) == "ply") return read_ply(bytes);
    if (bytes.substr(0, 3) == "OFF") return read_off(bytes);
    if (ends(".obj") || ends(".OBJ")) return read_obj(bytes);
    if (bytes.size() >= 84 && bytes.size() == 84 + std::size_t{50} * count) return read_stl_binary(bytes);
    if (bytes.substr(0, 5) == "solid") return read_stl_ascii(bytes);
    return std::nullopt;
}

}  // namespace

Result<Mesh> read_mesh(std::string_view bytes, std::string_view path) {
    Outcome mesh = read_any(bytes, path);
    if (!mesh) return fail(Fault::kWorld, fmt::format("{}: not a whole STL, OFF, OBJ or PLY file", path));
    weld(*mesh);
    return std::move(*mesh);
}

}  // namespace whittle
