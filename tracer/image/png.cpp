#include "tracer/image/png.h"

#include <array>
#include <cassert>
#include <cstdlib>
#include <string_view>

#include "tracer/image/deflate.h"

namespace whittle {

namespace {

std::array<std::uint32_t, 256> crc_table() {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t n = 0; n < 256; ++n) {
        std::uint32_t c = n;
        for (int k = 0; k < 8; ++k) c = (c & 1U) ? 0xedb88320U ^ (c >> 1) : c >> 1;
        table[n] = c;
    }
    return table;
}

void put_number(std::uint32_t n, std::string& out) {
    for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<char>((n >> shift) & 0xff));
}

void put_chunk(std::string_view type, std::string_view data, std::string& out) {
    static const std::array<std::uint32_t, 256> table = crc_table();
    put_number(static_cast<std::uint32_t>(data.size()), out);
    std::uint32_t crc = 0xffffffffU;
    for (std::string_view part : {type, data}) {
        out += part;
        for (char c : part) crc = table[(crc ^ static_cast<unsigned char>(c)) & 0xff] ^ (crc >> 8);
    }
    put_number(~crc, out);
}

int paeth(int left, int up, int corner) {
    const int p = left + up - corner, dl = std::abs(p - left), du = std::abs(p - up), dc = std::abs(p - corner);
    return dl <= du && dl <= dc ? left : du <= dc ? up : corner;
}

// Filters of PNG that pay on rendered pictures, by their numbers.
constexpr std::array<int, 4> kFilters{0, 1, 2, 4};

// Row `now` through filter `kind` into `out`; returns the sum of the differences taken as signed bytes.
long filtered(int kind, const std::uint8_t* now, const std::uint8_t* above, std::size_t length, std::size_t channels, std::uint8_t* out) {
    long sum = 0;
    for (std::size_t i = 0; i < length; ++i) {
        const int left = i >= channels ? now[i - channels] : 0, up = above ? above[i] : 0, corner = above && i >= channels ? above[i - channels] : 0;
        const int guess = kind == 0 ? 0 : kind == 1 ? left : kind == 2 ? up : paeth(left, up, corner);
        out[i] = static_cast<std::uint8_t>(now[i] - guess);
        sum += std::abs(static_cast<int>(static_cast<std::int8_t>(out[i])));
    }
    return sum;
}

std::string filtered_rows(std::size_t row_length, std::size_t rows, std::size_t channels, const std::vector<std::uint8_t>& bytes) {
    std::string all;
    all.reserve((row_length + 1) * rows);
    std::array<std::vector<std::uint8_t>, kFilters.size()> tried;
    tried.fill(std::vector<std::uint8_t>(row_length));
    for (std::size_t y = 0; y < rows; ++y) {
        const std::uint8_t* now = bytes.data() + y * row_length;
        const std::uint8_t* above = y > 0 ? now - row_length : nullptr;
        std::size_t best = 0;
        long least = -1;
        for (std::size_t f = 0; f < kFilters.size(); ++f) {
            const long sum = filtered(kFilters[f], now, above, row_length, channels, tried[f].data());
            if (least < 0 || sum < least) least = sum, best = f;
        }
        all.push_back(static_cast<char>(kFilters[best]));
        all.append(tried[best].begin(), tried[best].end());
    }
    return all;
}

}  // namespace

std::string png_encoded(int width, int height, int channels, const std::vector<std::uint8_t>& bytes) {
    assert(width > 0 && height > 0 && (channels == 1 || channels == 3 || channels == 4));
    std::string out("\x89PNG\r\n\x1a\n", 8);
    std::string header;
    put_number(static_cast<std::uint32_t>(width), header);
    put_number(static_cast<std::uint32_t>(height), header);
    header.push_back(8);
    header.push_back(channels == 1 ? 0 : channels == 3 ? 2 : 6);
    header.append(3, '\0');
    put_chunk("IHDR", header, out);
    put_chunk("sRGB", std::string_view("\0", 1), out);
    const std::size_t row_length = static_cast<std::size_t>(width) * static_cast<std::size_t>(channels);
    put_chunk("IDAT", zlib_compressed(filtered_rows(row_length, static_cast<std::size_t>(height), static_cast<std::size_t>(channels), bytes)), out);
    put_chunk("IEND", {}, out);
    return out;
}

}  // namespace whittle
