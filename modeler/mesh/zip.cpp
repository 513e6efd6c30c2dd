#include "modeler/mesh/zip.h"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>
#include <zlib.h>

namespace whittle {
namespace {

constexpr std::uint32_t kLocal = 0x04034b50, kCentral = 0x02014b50, kEnd = 0x06054b50;
constexpr std::size_t kLocalSize = 30, kCentralSize = 46, kEndSize = 22;
constexpr std::uint16_t kStored = 0, kDeflated = 8, kVersion = 20;
constexpr std::uint16_t kFirstDay = 0x21;  // 1980-01-01, as early as the format can say
constexpr std::size_t kLongestComment = 0xFFFF;
// No deflated byte stands for more.
constexpr std::uint64_t kMostExpansion = 1032;

template <class T>
T number_at(std::string_view bytes, std::size_t at) {
    T value{};
    if (at + sizeof value <= bytes.size()) std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

template <class... T>
void put(std::string& out, const T&... values) {
    (out.append(reinterpret_cast<const char*>(&values), sizeof values), ...);
}

std::uint32_t checksum_of(std::string_view bytes) {
    return static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

// Raw deflate, without zlib's header.
std::string deflated(std::string_view bytes) {
    z_stream stream{};
    if (deflateInit2(&stream, 6, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY) != Z_OK) return std::string(bytes) + "\n";  // longer: will be stored
    std::string out(deflateBound(&stream, static_cast<uLong>(bytes.size())), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
    deflate(&stream, Z_FINISH);
    out.resize(stream.total_out);
    deflateEnd(&stream);
    return out;
}

bool inflated(std::string_view packed, std::string& out) {
    z_stream stream{};
    if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) return false;
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
    stream.avail_in = static_cast<uInt>(packed.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
    const int end = inflate(&stream, Z_FINISH);
    const bool whole = end == Z_STREAM_END && stream.total_out == out.size();
    inflateEnd(&stream);
    return whole;
}

}  // namespace

std::string zip_archive(const std::vector<ZipEntry>& entries) {
    std::string out, directory;
    for (const ZipEntry& entry : entries) {
        const std::string packed = deflated(entry.bytes);
        const bool pack = packed.size() < entry.bytes.size();
        const std::string& body = pack ? packed : entry.bytes;
        const auto offset = static_cast<std::uint32_t>(out.size());
        std::string common;
        put(common, kVersion, std::uint16_t{0}, pack ? kDeflated : kStored, std::uint16_t{0}, kFirstDay, checksum_of(entry.bytes),
            static_cast<std::uint32_t>(body.size()), static_cast<std::uint32_t>(entry.bytes.size()), static_cast<std::uint16_t>(entry.name.size()), std::uint16_t{0});
        put(out, kLocal);
        out += common + entry.name + body;
        put(directory, kCentral, kVersion);
        directory += common;
        put(directory, std::uint16_t{0}, std::uint16_t{0}, std::uint16_t{0}, std::uint32_t{0}, offset);
        directory += entry.name;
    }
    const auto start = static_cast<std::uint32_t>(out.size());
    const auto count = static_cast<std::uint16_t>(entries.size());
    out += directory;
    put(out, kEnd, std::uint16_t{0}, std::uint16_t{0}, count, count, static_cast<std::uint32_t>(directory.size()), start, std::uint16_t{0});
    return out;
}

bool is_zip(std::string_view bytes) { return number_at<std::uint32_t>(bytes, 0) == kLocal; }

Result<ZipReader> ZipReader::open(std::string_view bytes) {
    const auto broken = [] { return fail(Fault::kWorld, "not a whole zip archive"); };
    if (bytes.size() < kEndSize) return broken();
    std::size_t end = bytes.size() - kEndSize;
    const std::size_t last = end > kLongestComment ? end - kLongestComment : 0;
    while (number_at<std::uint32_t>(bytes, end) != kEnd) {
        if (end == last) return broken();
        --end;
    }
    ZipReader reader;
    reader.bytes_ = bytes;
    std::size_t at = number_at<std::uint32_t>(bytes, end + 16);
    for (std::uint16_t i = number_at<std::uint16_t>(bytes, end + 10); i > 0; --i) {
        if (at + kCentralSize > bytes.size() || number_at<std::uint32_t>(bytes, at) != kCentral) return broken();
        const std::size_t name = number_at<std::uint16_t>(bytes, at + 28), extra = number_at<std::uint16_t>(bytes, at + 30), comment = number_at<std::uint16_t>(bytes, at + 32);
        if (at + kCentralSize + name > bytes.size()) return broken();
        reader.places_.push_back({std::string(bytes.substr(at + kCentralSize, name)), number_at<std::uint16_t>(bytes, at + 10), number_at<std::uint32_t>(bytes, at + 20),
                                  number_at<std::uint32_t>(bytes, at + 24), number_at<std::uint32_t>(bytes, at + 16), number_at<std::uint32_t>(bytes, at + 42)});
        at += kCentralSize + name + extra + comment;
    }
    return reader;
}

std::vector<std::string> ZipReader::names() const {
    std::vector<std::string> names;
    for (const Place& p : places_) names.push_back(p.name);
    return names;
}

Result<std::string> ZipReader::read(std::string_view name) const {
    const auto place = std::find_if(places_.begin(), places_.end(), [&](const Place& p) { return p.name == name; });
    if (place == places_.end()) return fail(Fault::kWorld, fmt::format("the archive holds no '{}'", name));
    const auto broken = [&] { return fail(Fault::kWorld, fmt::format("'{}' in the archive is damaged", name)); };
    const std::size_t header = place->header;
    if (header + kLocalSize > bytes_.size() || number_at<std::uint32_t>(bytes_, header) != kLocal) return broken();
    const std::size_t start = header + kLocalSize + number_at<std::uint16_t>(bytes_, header + 26) + number_at<std::uint16_t>(bytes_, header + 28);
    if (start > bytes_.size() || place->packed > bytes_.size() - start) return broken();
    const std::string_view packed = bytes_.substr(start, place->packed);
    std::string out;
    if (place->method == kStored) {
        out = packed;
    } else if (place->method == kDeflated) {
        if (place->size > kMostExpansion * (packed.size() + 1)) return broken();
        out.resize(place->size);
        if (!inflated(packed, out)) return broken();
    } else {
        return fail(Fault::kWorld, fmt::format("'{}' in the archive is packed by a method that is not known ({})", name, place->method));
    }
    if (checksum_of(out) != place->checksum) return broken();
    return out;
}

}  // namespace whittle
