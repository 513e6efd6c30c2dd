// zip.h — archives as 3MF and AMF use them: entries stored or deflated, the same bytes on every run.
//
// A hundred lines on zlib instead of libzip: that one brings a cryptographic library into every start of the program and stamps the time into what it writes.
// Source: PKWARE, .ZIP File Format Specification 6.3 (local headers, central directory, no encryption, no 64-bit sizes).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "csg/base/result.h"

namespace whittle {

struct ZipEntry {
    std::string name;
    std::string bytes;
};

// Deflated where that is shorter. Requires: fewer than 2^16 entries, fewer than 2^32 bytes in all.
std::string zip_archive(const std::vector<ZipEntry>& entries);

bool is_zip(std::string_view bytes);

// The files of an archive by name, opened one at a time.
class ZipReader {
public:
    // kWorld fault where there is no whole directory.
    static Result<ZipReader> open(std::string_view bytes);
    std::vector<std::string> names() const;
    // Its checksum is looked at; no more is unpacked than the directory promises, and that is at most a thousand times what is there.
    Result<std::string> read(std::string_view name) const;

private:
    struct Place { std::string name; std::uint16_t method; std::uint32_t packed, size, checksum, header; };
    std::string_view bytes_;
    std::vector<Place> places_;
};

}  // namespace whittle
