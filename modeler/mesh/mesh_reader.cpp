// mesh_reader.cpp — STL, OFF, OBJ and PLY back into a mesh. Polygons of more than three corners become fans; nothing is repaired.
//
// What a header promises is compared with the bytes that are there before anything is made of that size.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>

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

// Why a file is not what it says it is.
using Outcome = tl::expected<Mesh, std::string>;
tl::unexpected<std::string> wrong(std::string why) { return tl::unexpected<std::string>(std::move(why)); }
std::string number_of(const char* what, std::size_t index) { return fmt::format("{} {}", what, index); }

constexpr std::size_t kStlHeader = 84, kStlFacet = 50;

Outcome read_stl_binary(std::string_view bytes, std::uint32_t count) {
    if (const std::size_t whole = (bytes.size() - kStlHeader) / kStlFacet; whole < count)
        return wrong(fmt::format("the header promises {} facets, the file ends after {}", count, whole));
    Mesh mesh;
    mesh.points.reserve(std::size_t{3} * count);
    mesh.triangles.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        std::array<float, 12> f;
        std::memcpy(f.data(), bytes.data() + kStlHeader + i * kStlFacet, sizeof f);
        const auto first = static_cast<std::uint32_t>(mesh.points.size());
        if (!std::all_of(f.begin() + 3, f.end(), [](float x) { return std::isfinite(x); })) return wrong(number_of("a coordinate that is not finite in facet", i + 1));
        for (std::size_t k = 3; k < 12; k += 3) mesh.points.emplace_back(f[k], f[k + 1], f[k + 2]);
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
        if (!words.read(mesh.points.back())) return wrong(number_of("no three finite numbers in vertex", mesh.points.size()));
        const auto n = static_cast<std::uint32_t>(mesh.points.size());
        if (n % 3 == 0) mesh.triangles.push_back({n - 3, n - 2, n - 1});
    }
    if (mesh.triangles.empty()) return wrong("no facets");
    return mesh;
}

// A count larger than the text has bytes is a lie that must not become an allocation.
bool plausible(std::uint64_t count, std::string_view text) { return count <= text.size(); }

Outcome read_off(std::string_view text) {
    Words words(text, true);
    words.next();
    std::uint32_t points = 0, faces = 0, edges = 0;
    if (!words.read(points) || !words.read(faces) || !words.read(edges)) return wrong("no counts of points, faces and edges");
    if (!plausible(points, text) || !plausible(faces, text)) return wrong(fmt::format("the header promises {} points and {} faces, more than the file has bytes", points, faces));
    Mesh mesh;
    mesh.points.resize(points);
    for (std::size_t i = 0; i < points; ++i)
        if (!words.read(mesh.points[i])) return wrong(number_of("no three finite numbers in point", i + 1));
    for (std::uint32_t i = 0; i < faces; ++i) {
        std::uint32_t n = 0;
        if (!words.read(n) || !plausible(n, text)) return wrong(number_of("no number of corners in face", i + 1));
        std::vector<std::uint32_t> corners(n);
        for (std::uint32_t& v : corners)
            if (!words.read(v) || v >= points) return wrong(number_of("a corner that is no point in face", i + 1));
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
            if (!words.read(mesh.points.back())) return wrong(number_of("no three finite numbers in point", mesh.points.size()));
        } else if (w == "f") {
            std::vector<std::uint32_t> corners;
            Words line(words.rest_of_line(), true);
            while (!line.end()) {
                const std::string_view corner = line.next();
                std::int64_t v = 0;
                const auto [end, error] = std::from_chars(corner.data(), corner.data() + corner.size(), v);
                if (error != std::errc()) return wrong(number_of("a corner that is no number near facet", mesh.triangles.size() + 1));
                if (v < 0) v += static_cast<std::int64_t>(mesh.points.size()) + 1;
                if (v < 1 || v > static_cast<std::int64_t>(mesh.points.size())) return wrong(number_of("a corner that is no point near facet", mesh.triangles.size() + 1));
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

enum class PlyFormat { kAscii, kLittleEndian, kBigEndian };

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
    PlyBody(std::string_view bytes, PlyFormat format) : bytes_(bytes), words_(format == PlyFormat::kAscii ? bytes : std::string_view(), false), format_(format) {}

    bool read(const std::string& type, double& x) {
        if (format_ == PlyFormat::kAscii) return words_.read(x);
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
        std::array<char, sizeof value> raw;
        std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(at_), raw.size(), raw.begin());
        if (format_ == PlyFormat::kBigEndian) std::reverse(raw.begin(), raw.end());
        std::memcpy(&value, raw.data(), sizeof value);
        at_ += sizeof value;
        x = static_cast<double>(value);
        return true;
    }
    std::string_view bytes_;
    std::size_t at_ = 0;
    Words words_;
    PlyFormat format_;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::kAscii;
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
            known_format = format == "ascii" || format == "binary_little_endian" || format == "binary_big_endian";
            header.format = format == "ascii" ? PlyFormat::kAscii : format == "binary_big_endian" ? PlyFormat::kBigEndian : PlyFormat::kLittleEndian;
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
    if (!header) return wrong("no whole header, or one that promises more than the file has bytes");
    PlyBody body(bytes.substr(header->size), header->format);
    const auto short_of = [](const PlyElement& e, std::uint32_t i) { return wrong(fmt::format("the header promises {} of '{}', number {} is not whole", e.count, e.name, i + 1)); };
    Mesh mesh;
    for (const PlyElement& e : header->elements)
        for (std::uint32_t i = 0; i < e.count; ++i) {
            Vec3 p{0};
            for (const PlyProperty& property : e.properties) {
                double x = 0;
                if (property.count_type.empty()) {
                    if (!body.read(property.type, x)) return short_of(e, i);
                    if (property.name == "x" || property.name == "y" || property.name == "z") p[property.name[0] - 'x'] = x;
                    continue;
                }
                double n = 0;
                if (!body.read(property.count_type, n) || n < 0 || !plausible(static_cast<std::uint64_t>(n), bytes)) return short_of(e, i);
                std::vector<std::uint32_t> corners;
                for (int k = 0; k < static_cast<int>(n); ++k) {
                    if (!body.read(property.type, x)) return short_of(e, i);
                    if (e.name != "face") continue;
                    if (!(x >= 0 && x < static_cast<double>(mesh.points.size()))) return wrong(number_of("a corner that is no point in face", i + 1));
                    corners.push_back(static_cast<std::uint32_t>(x));
                }
                if (e.name == "face") add_fan(mesh, corners);
            }
            if (e.name != "vertex") continue;
            if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return wrong(number_of("no three finite numbers in point", i + 1));
            mesh.points.push_back(p);
        }
    return mesh;
}

bool ends_with(std::string_view path, std::string_view suffix) {
    return path.size() >= suffix.size() && std::equal(suffix.rbegin(), suffix.rend(), path.rbegin(), [](char a, char b) { return a == (b >= 'A' && b <= 'Z' ? b - 'A' + 'a' : b); });
}

// Binary unless it begins as text and its size is not the one its count asks for.
Outcome read_stl(std::string_view bytes) {
    std::uint32_t count = 0;
    const bool may_be_binary = bytes.size() >= kStlHeader;
    if (may_be_binary) std::memcpy(&count, bytes.data() + 80, sizeof count);
    if (may_be_binary && bytes.size() == kStlHeader + kStlFacet * count) return read_stl_binary(bytes, count);
    const std::size_t start = bytes.find_first_not_of(" \t\r\n");
    if (start != std::string_view::npos && bytes.substr(start, 5) == "solid") return read_stl_ascii(bytes);
    if (may_be_binary) return read_stl_binary(bytes, count);
    return wrong("neither text nor long enough to be binary");
}

Outcome read_any(std::string_view bytes, std::string_view path) {
    if (bytes.empty()) return wrong("the file is empty");
    if (ends_with(path, ".stl")) return read_stl(bytes);
    if (ends_with(path, ".obj")) return read_obj(bytes);
    if (bytes.substr(0, 3) == "ply") return read_ply(bytes);
    if (bytes.substr(0, 3) == "OFF") return read_off(bytes);
    if (ends_with(path, ".off") || ends_with(path, ".ply")) return wrong("no OFF or ply at its start");
    return read_stl(bytes);
}

}  // namespace

Result<Mesh> read_mesh(std::string_view bytes, std::string_view path) {
    Outcome mesh = read_any(bytes, path);
    if (!mesh) return fail(Fault::kWorld, fmt::format("{}: not a whole STL, OFF, OBJ or PLY file: {}", path, mesh.error()));
    weld(*mesh);
    return std::move(*mesh);
}

}  // namespace whittle
