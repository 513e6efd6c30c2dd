// png.h — eight-bit pictures as PNG without the image library.
//
// Source: W3C, Portable Network Graphics (2003): chunks, filters and the minimum-sum-of-differences choice of a row's filter.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace whittle {

// `bytes`: width*height*channels, interleaved, rows from the top; sRGB. Requires: channels is 1 (grey), 3 or 4; the picture is not empty.
std::string png_encoded(int width, int height, int channels, const std::vector<std::uint8_t>& bytes);

}  // namespace whittle
