// mend.h — a mesh as files hold it → closed solids, with what was mended said in numbers.
//
// A closed surface is asked of nobody who made a file, but of everything that counts crossings. What can be mended in one way only is mended: copies of facets
// go, borders a rounding apart are joined, facets that disagree with their neighbours turn, holes are closed by patches on their own border. A surface
// that crosses itself stays as it is: inside is what an odd number of crossings leads to.
// Source: Guéziec, Taubin, Lazarus, Horn, Cutting and Stitching (2001), for the order of the steps.
#pragma once

#include <string>
#include <vector>

#include "csg/solid/imported.h"
#include "modeler/mesh/mesh.h"

namespace whittle {

// Closed and oriented on return: count_open_edges is 0. One remark a kind of repair.
// Requires: welded (weld.h).
void close_mesh(Mesh& mesh, std::vector<std::string>& remarks);

// The solids of a closed mesh: shells apart where their boxes overlap, so that parts stuck into each other are united; a shell that faces inward is a
// cavity of the smallest shell around it, or is turned where there is none.
std::vector<std::shared_ptr<const FacetList>> shells_of(const Mesh& mesh, std::vector<std::string>& remarks);

// Both, of a mesh that need not be welded; nothing where no facet is left.
ImportedMesh mended(Mesh mesh);

}  // namespace whittle
