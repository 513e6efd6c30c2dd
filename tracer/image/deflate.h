// deflate.h — zlib streams (RFC 1950, 1951) written without a library.
//
// A PNG is the picture most often asked for, and a compressor is what it takes to write one without waiting for the image library (0.2 s and 261
// shared objects). Matches by hash chains, one dynamic Huffman code a block; about as dense as zlib's level 3 on filtered rows.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace whittle {

// Law: inflating the result gives `bytes`.
std::string zlib_compressed(std::string_view bytes);

}  // namespace whittle
