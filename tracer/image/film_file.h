// film_file.h — a film as bytes, to the bit: the checkpoint that a rendering is resumed from.
//
// Numbers stand as this machine holds them (little-endian doubles and floats); the head names the format's version, the tail is a checksum. A film is
// read back only under the fingerprint it was written with, so that nothing is resumed that was drawn from another scene or by other options.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "csg/base/result.h"
#include "tracer/image/film.h"

namespace whittle {

// 64 bits of FNV-1a, going on from `before`.
std::uint64_t fingerprint_of(std::string_view bytes, std::uint64_t before = 0xcbf29ce484222325ULL);

std::string film_bytes(const Film& film, std::uint64_t fingerprint);

// Does `bytes` begin as film_bytes() does?
bool is_film(std::string_view bytes);

// kWorld: no film, cut short, or damaged. kCommand: of another fingerprint.
Result<Film> film_of_bytes(std::string_view bytes, std::uint64_t fingerprint);

}  // namespace whittle
