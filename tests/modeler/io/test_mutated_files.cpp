// test_mutated_files.cpp — files with bytes changed, dropped and doubled are read or refused, never worse. WHITTLE_ROUNDS asks for more of them.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "csg/eval/imports.h"
#include "csg/solid/polyhedron.h"
#include "modeler/io/dxf.h"
#include "modeler/io/heights.h"
#include "modeler/io/svg.h"
#include "modeler/mesh/mend.h"
#include "modeler/mesh/mesh_files.h"
#include "modeler/mesh/package_reader.h"
#include "modeler/mesh/zip.h"

using namespace whittle;

namespace {

class Dice {
public:
    explicit Dice(std::uint64_t seed) : state_(seed) {}
    std::uint64_t operator()(std::uint64_t below) {
        state_ = state_ * 6364136223846793005U + 1442695040888963407U;
        return (state_ >> 33) % below;
    }

private:
    std::uint64_t state_;
};

const std::string kOff = "OFF\n4 4 0\n0 0 0\n6 0 0\n0 6 0\n0 0 6\n3 0 2 1\n3 0 1 3 255 0 0\n3 1 2 3\n3 2 0 3\n";
const std::string kObj = "v 0 0 0\nv 6 0 0\nv 0 6 0\nv 0 0 6\nf 1 3 2\nf 1/1 2/2 4/3\nf -3 -2 -1\nf 3 1 4\n";
const std::string kPly = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
                         "0 0 0\n6 0 0\n0 6 0\n0 0 6\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
const std::string kStl = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nfacet normal 0 0 1\nouter loop\n"
                         "vertex 0 0 0\nvertex 0 1 0\nvertex 0 0 1e1\nendloop\nendfacet\nendsolid a\n";
const std::string kSvg = R"svg(<svg width="40mm" height="30mm" viewBox="0 0 40 30"><g transform="rotate(10) scale(2,1)"><path d="M1 1h4a2 2 0 01-4 3c1 2 3-4 5 5s1 1 2 2q1 1 2 0t3 3z m1 1L2 3"/>
<rect x="1" y="2" width="9" height="4" rx="1"/></g><circle cx="3" cy="4" r="2"/><ellipse cx="9" cy="9" rx="4" ry="2"/><polygon points="0,0 5,5 5,0"/></svg>)svg";
const std::string kDxf = "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nB\n0\nCIRCLE\n8\n0\n10\n1\n20\n0\n40\n0.5\n0\nENDBLK\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nLINE\n8\nA\n10\n0\n20\n0\n11\n9\n21\n0\n"
                         "0\nARC\n8\nA\n10\n0\n20\n0\n40\n10\n50\n0\n51\n90\n0\nLWPOLYLINE\n8\nP\n90\n2\n70\n1\n10\n20\n20\n0\n42\n1\n10\n22\n20\n0\n42\n1\n0\nELLIPSE\n8\n0\n10\n0\n20\n0\n11\n4\n"
                         "21\n1\n40\n0.5\n41\n0\n42\n3\n0\nINSERT\n8\n0\n2\nB\n10\n50\n20\n5\n41\n2\n42\n-2\n50\n30\n0\nENDSEC\n0\nEOF\n";
const std::string kModel = R"(<model unit="inch"><resources><basematerials id="5"><base name="a" displaycolor="#FF0000"/></basematerials><object id="1" pid="5" pindex="0"><mesh><vertices>
<vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/><vertex x="0" y="0" z="1"/></vertices><triangles><triangle v1="0" v2="2" v3="1"/>
<triangle v1="0" v2="1" v3="3"/><triangle v1="1" v2="2" v3="3" p1="0"/><triangle v1="2" v2="0" v3="3"/></triangles></mesh></object>
<object id="2"><components><component objectid="1" transform="2 0 0 0 1 0 0 0 1 10 0 0"/></components></object></resources><build><item objectid="2"/></build></model>)";

std::string mutated(const std::string& good, Dice& dice) {
    std::string bytes = good;
    for (std::uint64_t n = 1 + dice(4); n > 0 && !bytes.empty(); --n) {
        const std::size_t at = dice(bytes.size());
        constexpr char kLikely[] = "0123456789.-+eE \n<>\"/#nai";
        switch (dice(5)) {
            case 0: bytes[at] = static_cast<char>(dice(256)); break;
            case 1: bytes[at] = kLikely[dice(sizeof kLikely - 1)]; break;
            case 2: bytes.erase(at, 1 + dice(12)); break;
            case 3: bytes.insert(at, bytes.substr(dice(bytes.size()), dice(40))); break;
            default: bytes.resize(at);
        }
    }
    return bytes;
}

// What comes out keeps the promises of imported.h.
void check(const ImportedMesh& mesh) {
    for (const ImportedSolid& solid : mesh.solids) {
        CHECK(open_edges(*solid.mesh) == 0);
        CHECK(signed_volume(*solid.mesh) >= 0);
    }
}
void check(const Drawing& drawing) {
    SolidBuilder builder;
    drawn_set(builder, drawing, [](double) { return 0; });
    drawn_set(builder, drawing, [](double) { return 12; });
}

}  // namespace

TEST_CASE("files with changed bytes are read or refused") {
    const char* asked = std::getenv("WHITTLE_ROUNDS");
    const std::uint64_t rounds = asked ? std::strtoull(asked, nullptr, 10) : 400;
    const std::string archive = zip_archive({{"3D/3dmodel.model", kModel}});
    std::size_t refused = 0, read = 0;
    for (std::uint64_t seed = 0; seed < rounds; ++seed) {
        INFO("seed " << seed);
        Dice dice(seed);
        for (const auto& [good, name] : {std::pair(&kOff, "a.off"), {&kObj, "a.obj"}, {&kPly, "a.ply"}, {&kStl, "a.stl"}}) {
            auto mesh = read_mesh(mutated(*good, dice), name);
            mesh ? ++read : ++refused;
            if (mesh) check(mended(std::move(*mesh)));
        }
        for (const auto& package : {read_3mf(mutated(archive, dice)), read_3mf(zip_archive({{"3D/3dmodel.model", mutated(kModel, dice)}})), read_amf(mutated(kModel, dice))}) {
            package ? ++read : ++refused;
            for (std::size_t i = 0; package && i < package->objects.size(); ++i) check(mended(package->objects[i].mesh));
        }
        for (const auto& drawing : {read_svg(mutated(kSvg, dice), {}), read_dxf(mutated(kDxf, dice), {})}) {
            drawing ? ++read : ++refused;
            if (drawing) check(*drawing);
        }
        read_heights(mutated("1 2 3\n4 5 6\n7 8 9\n", dice)) ? ++read : ++refused;
    }
    CHECK(read > rounds);
    CHECK(refused > rounds);
}
