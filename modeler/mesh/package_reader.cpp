// package_reader.cpp — the XML within 3MF and AMF.
// Source: 3MF Core Specification 1.3 and Materials Extension 1.2; ISO/ASTM 52915 (AMF).
#include "modeler/mesh/package_reader.h"

#include <charconv>
#include <cmath>
#include <cstring>
#include <map>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "modeler/mesh/zip.h"

namespace whittle {
namespace {

using pugi::xml_node;

// Components within components, and objects made in all: a chain of doublings ends here.
constexpr int kDeepestComponent = 32;
constexpr std::size_t kMostObjects = 100000;

struct Unit { const char* name; double mm; };
constexpr Unit kUnits[] = {{"millimeter", 1}, {"micron", 1e-3}, {"micrometer", 1e-3}, {"centimeter", 10}, {"inch", 25.4}, {"foot", 304.8}, {"feet", 304.8}, {"meter", 1000}};

double unit_mm(const char* name) {
    for (const Unit& unit : kUnits)
        if (std::strcmp(unit.name, name) == 0) return unit.mm;
    return 1;
}

bool number_of(std::string_view text, double& out) {
    const std::size_t start = text.find_first_not_of(" \t\r\n");
    if (start == std::string_view::npos) return false;
    text.remove_prefix(start + (text[start] == '+' ? 1 : 0));
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
    return error == std::errc() && std::isfinite(out);
}

// Names may carry a prefix: "m:colorgroup".
const char* local(const char* name) {
    const char* colon = std::strchr(name, ':');
    return colon ? colon + 1 : name;
}
bool is(const xml_node& node, const char* name) { return std::strcmp(local(node.name()), name) == 0; }
xml_node child(const xml_node& node, const char* name) {
    for (const xml_node& c : node.children())
        if (is(c, name)) return c;
    return {};
}

Result<void> parse(pugi::xml_document& document, const std::string& text) {
    const auto read = document.load_buffer(text.data(), text.size());
    if (read) return {};
    return fail(Fault::kWorld, fmt::format("XML at byte {}: {}", read.offset, read.description()));
}

tl::unexpected<Error> broken(const char* what, std::size_t number) { return fail(Fault::kWorld, fmt::format("{} {} is not whole", what, number)); }

// ------------------------------------------------------------------------------------------------------------------- 3MF

std::optional<Vec4> color_of(std::string_view text) {
    if (text.empty() || text[0] != '#' || (text.size() != 7 && text.size() != 9)) return std::nullopt;
    Vec4 color{0, 0, 0, 1};
    for (std::size_t i = 1; i + 1 < text.size(); i += 2) {
        int byte = 0;
        const auto [end, error] = std::from_chars(text.data() + i, text.data() + i + 2, byte, 16);
        if (error != std::errc() || end != text.data() + i + 2) return std::nullopt;
        color[static_cast<int>(i / 2)] = byte / 255.0;
    }
    return color;
}

// Row vectors times a 4x3 matrix, row by row, as the specification writes it.
std::optional<Placement> placement_of(const char* text) {
    Placement p;
    if (*text == '\0') return p;
    const char* at = text;
    const char* end = text + std::strlen(text);
    for (int i = 0; i < 12; ++i) {
        while (at < end && (*at == ' ' || *at == '\t' || *at == '\n' || *at == '\r')) ++at;
        double x = 0;
        const auto [next, error] = std::from_chars(at, end, x);
        if (error != std::errc() || !std::isfinite(x)) return std::nullopt;
        p.m[static_cast<std::size_t>(4 * (i % 3) + i / 3)] = x;
        at = next;
    }
    return p;
}

class Model3mf {
public:
    Result<Package> read(const xml_node& model) {
        mm_ = unit_mm(model.attribute("unit").as_string("millimeter"));
        const xml_node resources = child(model, "resources");
        for (const xml_node& node : resources.children()) read_resource(node);
        for (const xml_node& item : child(model, "build").children()) {
            if (!is(item, "item")) continue;
            const auto placement = placement_of(item.attribute("transform").as_string());
            if (!placement) return fail(Fault::kWorld, "an item's transform is not twelve numbers");
            if (auto made = make(item.attribute("objectid").as_string(), *placement, 0, {}); !made) return tl::unexpected(made.error());
        }
        return std::move(package_);
    }

private:
    void read_resource(const xml_node& node) {
        const std::string id = node.attribute("id").as_string();
        if (is(node, "object")) {
            objects_[id] = node;
        } else if (is(node, "basematerials")) {
            for (const xml_node& base : node.children()) colors_[id].push_back(color_of(base.attribute("displaycolor").as_string()));
        } else if (is(node, "colorgroup")) {
            for (const xml_node& color : node.children()) colors_[id].push_back(color_of(color.attribute("color").as_string()));
        }
    }

    std::optional<Vec4> color_at(const char* group, unsigned index) const {
        const auto found = colors_.find(group);
        return found != colors_.end() && index < found->second.size() ? found->second[index] : std::nullopt;
    }

    Result<void> make(const std::string& id, const Placement& placement, int depth, const std::string& outer_name) {
        const auto found = objects_.find(id);
        if (found == objects_.end()) return fail(Fault::kWorld, fmt::format("there is no object '{}'", id));
        const xml_node& object = found->second;
        if (depth > kDeepestComponent || package_.objects.size() >= kMostObjects) return fail(Fault::kWorld, "components are nested too deep or too many");
        const std::string name = outer_name.empty() ? object.attribute("name").as_string() : outer_name;
        if (const xml_node mesh = child(object, "mesh")) return add_mesh(object, mesh, placement, name);
        for (const xml_node& component : child(object, "components").children()) {
            const auto inner = placement_of(component.attribute("transform").as_string());
            if (!inner) return fail(Fault::kWorld, "a component's transform is not twelve numbers");
            if (auto made = make(component.attribute("objectid").as_string(), placement * *inner, depth + 1, name); !made) return made;
        }
        return {};
    }

    Result<void> add_mesh(const xml_node& object, const xml_node& mesh, const Placement& placement, const std::string& name) {
        PackageObject out;
        out.name = name;
        for (const xml_node& v : child(mesh, "vertices").children()) {
            Vec3 p;
            if (!number_of(v.attribute("x").as_string(), p.x) || !number_of(v.attribute("y").as_string(), p.y) || !number_of(v.attribute("z").as_string(), p.z))
                return broken("vertex", out.mesh.points.size() + 1);
            out.mesh.points.push_back(apply_to_point(placement, p) * mm_);
        }
        const bool mirrored = determinant(placement) < 0;
        out.color = color_at(object.attribute("pid").as_string(), object.attribute("pindex").as_uint());
        bool first = true, mixed = false;
        const char* group = object.attribute("pid").as_string();
        for (const xml_node& t : child(mesh, "triangles").children()) {
            constexpr unsigned kNone = 0xFFFFFFFF;
            Triangle corners{t.attribute("v1").as_uint(kNone), t.attribute("v2").as_uint(kNone), t.attribute("v3").as_uint(kNone)};
            for (const std::uint32_t v : corners)
                if (v >= out.mesh.points.size()) return broken("triangle", out.mesh.triangles.size() + 1);
            if (mirrored) std::swap(corners[1], corners[2]);
            out.mesh.triangles.push_back(corners);
            if (t.attribute("p1") || t.attribute("pid")) {
                const auto color = color_at(t.attribute("pid").as_string(group), t.attribute("p1").as_uint());
                if (first) out.color = color;
                mixed = mixed || color != out.color;
            }
            first = false;
        }
        if (mixed) package_.remarks.push_back(fmt::format("object '{}' has facets of several colours, the first is taken", name));
        package_.objects.push_back(std::move(out));
        return {};
    }

    double mm_ = 1;
    std::map<std::string, xml_node> objects_;
    std::map<std::string, std::vector<std::optional<Vec4>>> colors_;
    Package package_;
};

// The part that the archive's relations call the model.
std::string model_name(const ZipReader& zip) {
    const std::string usual = "3D/3dmodel.model";
    const auto relations = zip.read("_rels/.rels");
    pugi::xml_document document;
    if (!relations || !parse(document, *relations)) return usual;
    for (const xml_node& relation : document.first_child().children()) {
        const std::string_view type = relation.attribute("Type").as_string();
        std::string target = relation.attribute("Target").as_string();
        constexpr std::string_view kModel = "/3dmodel";
        if (type.size() < kModel.size() || type.substr(type.size() - kModel.size()) != kModel) continue;
        return !target.empty() && target[0] == '/' ? target.substr(1) : target;
    }
    return usual;
}

// ------------------------------------------------------------------------------------------------------------------- AMF

std::optional<Vec4> amf_color(const xml_node& node) {
    const xml_node color = child(node, "color");
    if (!color) return std::nullopt;
    Vec4 out{0, 0, 0, 1};
    constexpr const char* kNames[] = {"r", "g", "b", "a"};
    for (int i = 0; i < 4; ++i)
        if (const xml_node c = child(color, kNames[i])) number_of(c.text().as_string(), out[i]);
    return glm::clamp(out, 0.0, 1.0);
}

std::string amf_name(const xml_node& node) {
    for (const xml_node& c : node.children())
        if (is(c, "metadata") && std::strcmp(c.attribute("type").as_string(), "name") == 0) return c.text().as_string();
    return {};
}

Result<void> read_amf_object(const xml_node& object, double mm, const std::map<std::string, std::optional<Vec4>>& materials, Package& package) {
    const xml_node mesh = child(object, "mesh");
    std::vector<Vec3> points;
    for (const xml_node& vertex : child(mesh, "vertices").children()) {
        if (!is(vertex, "vertex")) continue;
        const xml_node at = child(vertex, "coordinates");
        Vec3 p;
        if (!number_of(child(at, "x").text().as_string(), p.x) || !number_of(child(at, "y").text().as_string(), p.y) || !number_of(child(at, "z").text().as_string(), p.z))
            return broken("vertex", points.size() + 1);
        points.push_back(p * mm);
    }
    for (const xml_node& volume : mesh.children()) {
        if (!is(volume, "volume")) continue;
        PackageObject out;
        out.name = amf_name(volume).empty() ? amf_name(object) : amf_name(volume);
        out.color = amf_color(volume);
        if (!out.color) out.color = amf_color(object);
        if (const auto found = materials.find(volume.attribute("materialid").as_string()); !out.color && found != materials.end()) out.color = found->second;
        out.mesh.points = points;
        for (const xml_node& triangle : volume.children()) {
            if (!is(triangle, "triangle")) continue;
            constexpr unsigned kNone = 0xFFFFFFFF;
            const Triangle corners{child(triangle, "v1").text().as_uint(kNone), child(triangle, "v2").text().as_uint(kNone), child(triangle, "v3").text().as_uint(kNone)};
            for (const std::uint32_t v : corners)
                if (v >= points.size()) return broken("triangle", out.mesh.triangles.size() + 1);
            out.mesh.triangles.push_back(corners);
        }
        package.objects.push_back(std::move(out));
    }
    return {};
}

}  // namespace

Result<Package> read_3mf(std::string_view bytes) {
    const auto zip = ZipReader::open(bytes);
    if (!zip) return tl::unexpected(zip.error());
    const auto text = zip->read(model_name(*zip));
    if (!text) return tl::unexpected(text.error());
    pugi::xml_document document;
    if (auto parsed = parse(document, *text); !parsed) return tl::unexpected(parsed.error());
    return Model3mf().read(child(document, "model"));
}

Result<Package> read_amf(std::string_view bytes) {
    std::string text(bytes);
    if (is_zip(bytes)) {
        const auto zip = ZipReader::open(bytes);
        if (!zip || zip->names().empty()) return fail(Fault::kWorld, "not a whole zip archive");
        auto inner = zip->read(zip->names().front());
        if (!inner) return tl::unexpected(inner.error());
        text = std::move(*inner);
    }
    pugi::xml_document document;
    if (auto parsed = parse(document, text); !parsed) return tl::unexpected(parsed.error());
    const xml_node amf = child(document, "amf");
    if (!amf) return fail(Fault::kWorld, "no <amf> in it");
    std::map<std::string, std::optional<Vec4>> materials;
    for (const xml_node& node : amf.children())
        if (is(node, "material")) materials[node.attribute("id").as_string()] = amf_color(node);
    Package package;
    const double mm = unit_mm(amf.attribute("unit").as_string("millimeter"));
    for (const xml_node& node : amf.children()) {
        if (is(node, "constellation")) package.remarks.push_back("a constellation is not read: its objects stand where they were made");
        if (!is(node, "object")) continue;
        if (auto read = read_amf_object(node, mm, materials, package); !read) return tl::unexpected(read.error());
    }
    return package;
}

}  // namespace whittle
