// light_plot.h — time against error as a drawing: a panel a scene, a line an integrator and a sampler, both axes logarithmic.
#pragma once

#include <string>
#include <vector>

namespace whittle::bench {

struct LightPoint {
    int samples = 0;
    double seconds = 0, error = 0;
};

struct LightLine {
    std::string name;     // lines of one name have one ink
    std::string sampler;  // and are dashed by this; may be empty
    std::vector<LightPoint> points;
    double bias = 0;  // distance of its converged picture from the path tracer's
};

struct LightPanel {
    std::string scene;
    std::vector<LightLine> lines;
};

// An SVG; `axes` is what the axes are.
std::string light_plot(const std::vector<LightPanel>& panels, const std::string& axes = "CPU seconds; up: RMSE");

}  // namespace whittle::bench
