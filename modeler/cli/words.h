// words.h — option values with a form of their own: sizes, rays, tiles, names of planes.
//
// Each reader returns false, and may leave its target half written, where the text has not that form.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "modeler/cli/request.h"

namespace whittle {

// The words between commas.
std::vector<std::string> words_in(const std::string& text);

bool read_curves(const std::string& text, CanonicaliseOptions& reading);              // auto, exact, exact:N, faceted
bool read_size(const std::string& text, int& width, int& height);                     // W,H in pixels
bool read_camera(const std::string& text, std::vector<double>& numbers);              // six or seven numbers
bool read_ray(const std::string& text, std::vector<Ray>& rays);                      // six numbers that make an askable ray
bool read_planes(const std::string& text, AovSet& planes);                            // depth,normal,...
bool read_clip(const std::string& text, std::vector<std::array<double, 4>>& clips);   // nx,ny,nz,d
bool read_tile(const std::string& text, std::optional<TileRegion>& region);           // x,y,w,h
bool read_shard(const std::string& text, Shard& shard);                               // k/n, k from 1

// Words of --view, separated by commas: `edges` is set where it is among them.
bool read_view(const std::string& text, bool& edges);

}  // namespace whittle
