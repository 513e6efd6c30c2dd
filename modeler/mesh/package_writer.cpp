// package_writer.cpp — 3MF and AMF: an object a part, colours a triangle, millimetres, doubles with all their digits.
// Source: 3MF Core Specification 1.3 and Materials Extension 1.2; ISO/ASTM 52915 (AMF).
#include <fmt/format.h>

#include "modeler/mesh/file_text.h"
#include "modeler/mesh/zip.h"

namespace whittle {

std::string xml_escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&': out += "&amp;"; break;
            case '<': out += "&lt;"; break;
            case '>': out += "&gt;"; break;
            case '"': out += "&quot;"; break;
            default: out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
        }
    }
    return out;
}

namespace {

constexpr std::string_view kXml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

void add_3mf_object(FileText& out, std::uint32_t id, std::uint32_t palette, const MeshPart& part) {
    const Mesh mesh = with_own_points(part.result->mesh);
    const FileColors colors(*part.result);
    if (colors.any()) {
        out.line("  <m:colorgroup id=\"", palette, "\">");
        for (const auto& c : colors.palette()) out.line("   <m:color color=\"", fmt::format("#{:02X}{:02X}{:02X}{:02X}", c[0], c[1], c[2], c[3]), "\"/>");
        out.line("  </m:colorgroup>");
    }
    out.adds("  <object id=\"", id, "\" type=\"model\"");
    if (!part.name.empty()) out.adds(" name=\"", xml_escaped(part.name), "\"");
    if (colors.any()) out.adds(" pid=\"", palette, "\" pindex=\"0\"");
    out.line(">\n   <mesh>\n    <vertices>");
    for (const Vec3& p : mesh.points) out.line("     <vertex x=\"", p.x, "\" y=\"", p.y, "\" z=\"", p.z, "\"/>");
    out.line("    </vertices>\n    <triangles>");
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        out.adds("     <triangle v1=\"", t[0], "\" v2=\"", t[1], "\" v3=\"", t[2], "\"");
        if (colors.any() && colors.number_of(i) != 0) out.adds(" pid=\"", palette, "\" p1=\"", colors.number_of(i), "\"");
        out.line("/>");
    }
    out.line("    </triangles>\n   </mesh>\n  </object>");
}

std::string model_of(const std::vector<MeshPart>& parts) {
    FileText out;
    out.adds(kXml, "<model unit=\"millimeter\" xml:lang=\"en-US\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" ");
    out.line("xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\">");
    out.line(" <metadata name=\"Application\">Whittle</metadata>\n <resources>");
    std::uint32_t id = 0;
    for (const MeshPart& part : parts) {
        add_3mf_object(out, id + 2, id + 1, part);
        id += 2;
    }
    out.line(" </resources>\n <build>");
    for (std::uint32_t i = 0; i < parts.size(); ++i) out.line("  <item objectid=\"", 2 * i + 2, "\"/>");
    out.line(" </build>\n</model>");
    return out.take();
}

void add_amf_color(FileText& out, const FileColors::Bytes& c) {
    out.adds("<color>");
    const char* names[] = {"r", "g", "b", "a"};
    for (std::size_t i = 0; i < 4; ++i) out.adds("<", names[i], ">", c[i] / 255.0, "</", names[i], ">");
    out.line("</color>");
}

// One volume an object, so that it is closed; where there are several colours the triangles have theirs.
void add_amf_object(FileText& out, std::uint32_t id, const MeshPart& part) {
    const Mesh mesh = with_own_points(part.result->mesh);
    const FileColors colors(*part.result);
    out.line(" <object id=\"", id, "\">");
    if (!part.name.empty()) out.line("  <metadata type=\"name\">", xml_escaped(part.name), "</metadata>");
    out.line("  <mesh>\n   <vertices>");
    for (const Vec3& p : mesh.points) out.line("    <vertex><coordinates><x>", p.x, "</x><y>", p.y, "</y><z>", p.z, "</z></coordinates></vertex>");
    out.line("   </vertices>\n   <volume>");
    if (colors.any() && colors.palette().size() == 1) add_amf_color(out, colors.palette()[0]);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        out.add("    <triangle>");
        if (colors.palette().size() > 1) add_amf_color(out, colors.of(i));
        out.line("<v1>", t[0], "</v1><v2>", t[1], "</v2><v3>", t[2], "</v3></triangle>");
    }
    out.line("   </volume>\n  </mesh>\n </object>");
}

}  // namespace

std::string write_3mf(const std::vector<MeshPart>& parts) {
    const std::string types = std::string(kXml) +
                              "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\"><Default Extension=\"rels\" "
                              "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/><Default Extension=\"model\" "
                              "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>\n";
    const std::string relations = std::string(kXml) +
                                  "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
                                  "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>\n";
    return zip_archive({{"[Content_Types].xml", types}, {"_rels/.rels", relations}, {"3D/3dmodel.model", model_of(parts)}});
}

std::string write_amf(const std::vector<MeshPart>& parts) {
    FileText out;
    out.line(kXml, "<amf unit=\"millimeter\" version=\"1.1\">\n <metadata type=\"producer\">Whittle</metadata>");
    for (std::uint32_t i = 0; i < parts.size(); ++i) add_amf_object(out, i, parts[i]);
    out.line("</amf>");
    return out.take();
}

}  // namespace whittle
