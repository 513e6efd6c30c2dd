#include "tracer/image/deflate.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <vector>

namespace whittle {

namespace {

constexpr std::size_t kWindow = 32768, kLongest = 258, kShortest = 4, kTokensABlock = 1U << 16;
constexpr int kLiterals = 286, kDistances = 30, kEndOfBlock = 256;
constexpr int kChainLength = 6;
// A match this long is taken without looking for a better one.
constexpr std::size_t kGoodMatch = 64;

// length 0: the literal `value`; else a copy of `length` bytes from `value` bytes back.
struct Token {
    std::uint16_t length;
    std::uint16_t value;
};

class BitWriter {
public:
    explicit BitWriter(std::string& out) : out_(out) {}
    void put(std::uint32_t bits, int count) {
        held_ |= static_cast<std::uint64_t>(bits) << used_;
        for (used_ += count; used_ >= 8; used_ -= 8, held_ >>= 8) out_.push_back(static_cast<char>(held_ & 0xff));
    }
    void flush() {
        if (used_ > 0) put(0, 8 - used_);
    }

private:
    std::string& out_;
    std::uint64_t held_ = 0;
    int used_ = 0;
};

// Extra bits of the length and distance codes, and the least value each begins with (RFC 1951, 3.2.5).
struct Ranges {
    std::array<std::uint16_t, 30> base{};
    std::array<std::uint8_t, 30> extra{};
};

Ranges length_ranges() {
    Ranges r;
    std::uint16_t next = 3;
    for (std::size_t i = 0; i < 28; ++i) {
        r.extra[i] = i < 8 ? 0 : static_cast<std::uint8_t>((i - 4) / 4);
        r.base[i] = next;
        next = static_cast<std::uint16_t>(next + (1U << r.extra[i]));
    }
    r.base[28] = 258;
    return r;
}

Ranges distance_ranges() {
    Ranges r;
    std::uint32_t next = 1;
    for (std::size_t i = 0; i < 30; ++i) {
        r.extra[i] = i < 4 ? 0 : static_cast<std::uint8_t>((i - 2) / 2);
        r.base[i] = static_cast<std::uint16_t>(next);
        next += 1U << r.extra[i];
    }
    return r;
}

struct Code {
    std::vector<std::uint8_t> lengths;
    std::vector<std::uint16_t> bits;  // reversed, ready to be written
};

// Depths of Huffman's tree; unused symbols have 0.
std::vector<std::uint8_t> huffman_depths(const std::vector<std::uint32_t>& counts) {
    struct Node { std::uint64_t count; int left, right; };
    std::vector<Node> nodes;
    std::vector<int> symbols;
    const auto later = [&](int a, int b) { return nodes[a].count != nodes[b].count ? nodes[a].count > nodes[b].count : a > b; };
    std::vector<int> heap;
    for (std::size_t s = 0; s < counts.size(); ++s)
        if (counts[s] > 0) {
            heap.push_back(static_cast<int>(nodes.size()));
            symbols.push_back(static_cast<int>(s));
            nodes.push_back({counts[s], -1, -1});
        }
    std::vector<std::uint8_t> depths(counts.size(), 0);
    if (heap.size() == 1) depths[symbols[0]] = 1;
    if (heap.size() < 2) return depths;
    std::make_heap(heap.begin(), heap.end(), later);
    const auto least = [&] {
        std::pop_heap(heap.begin(), heap.end(), later);
        const int n = heap.back();
        heap.pop_back();
        return n;
    };
    while (heap.size() > 1) {
        const int a = least(), b = least();
        nodes.push_back({nodes[a].count + nodes[b].count, a, b});
        heap.push_back(static_cast<int>(nodes.size()) - 1);
        std::push_heap(heap.begin(), heap.end(), later);
    }
    std::vector<std::uint8_t> depth(nodes.size(), 0);
    for (std::size_t n = nodes.size(); n-- > symbols.size();)
        depth[nodes[n].left] = depth[nodes[n].right] = static_cast<std::uint8_t>(depth[n] + 1);
    for (std::size_t i = 0; i < symbols.size(); ++i) depths[symbols[i]] = depth[i];
    return depths;
}

std::uint16_t reversed(std::uint32_t code, int length) {
    std::uint32_t r = 0;
    for (int i = 0; i < length; ++i) r |= ((code >> i) & 1U) << (length - 1 - i);
    return static_cast<std::uint16_t>(r);
}

// Canonical code of at most `limit` bits: where the tree is deeper, rare symbols are called less rare.
Code code_for(std::vector<std::uint32_t> counts, int limit) {
    Code code;
    for (code.lengths = huffman_depths(counts); *std::max_element(code.lengths.begin(), code.lengths.end()) > limit; code.lengths = huffman_depths(counts))
        for (std::uint32_t& c : counts) c = c > 0 ? c / 2 + 1 : 0;
    code.bits.resize(counts.size());
    std::uint32_t next = 0;
    for (int length = 1; length <= limit; ++length, next <<= 1)
        for (std::size_t s = 0; s < counts.size(); ++s)
            if (code.lengths[s] == length) code.bits[s] = reversed(next++, length);
    return code;
}

class Compressor {
public:
    explicit Compressor(std::string_view bytes) : in_(bytes), head_(kHashSize, kNowhere), previous_(kWindow, kNowhere), bits_(out_) {
        for (std::size_t i = 0; i < 29; ++i)
            for (std::size_t l = length_.base[i]; l < 259 && (i == 28 || l < length_.base[i] + (1U << length_.extra[i])); ++l) length_code_[l] = static_cast<std::uint8_t>(i);
        length_code_[258] = 28;
    }

    std::string run() {
        out_ = "\x78\x5e";
        std::size_t at = 0;
        do {
            tokens_.clear();
            while (at < in_.size() && tokens_.size() < kTokensABlock) at = next_token(at);
            write_block(at >= in_.size());
        } while (at < in_.size());
        bits_.flush();
        write_checksum();
        return std::move(out_);
    }

private:
    static constexpr std::size_t kHashSize = 1U << 15;
    static constexpr std::uint32_t kNowhere = 0xffffffffU;

    std::uint32_t hash(std::size_t at) const {
        std::uint32_t four;
        std::memcpy(&four, in_.data() + at, 4);
        return (four * 2654435761U) >> 17;
    }
    void remember(std::size_t at) {
        if (at + kShortest > in_.size()) return;
        std::uint32_t& head = head_[hash(at)];
        previous_[at % kWindow] = head;
        head = static_cast<std::uint32_t>(at);
    }
    std::size_t match(std::size_t a, std::size_t b) const {
        const std::size_t most = std::min(kLongest, in_.size() - b);
        std::size_t n = 0;
        while (n < most && in_[a + n] == in_[b + n]) ++n;
        return n;
    }

    // Appends one token; returns where the next one begins.
    std::size_t next_token(std::size_t at) {
        std::size_t best = 0, from = 0;
        if (at + kShortest <= in_.size()) {
            std::uint32_t candidate = head_[hash(at)];
            for (int i = 0; i < kChainLength && candidate != kNowhere && at - candidate < kWindow && best < kGoodMatch; ++i) {
                const std::size_t n = match(candidate, at);
                if (n > best) best = n, from = candidate;
                const std::uint32_t older = previous_[candidate % kWindow];
                if (older == kNowhere || older >= candidate) break;
                candidate = older;
            }
        }
        if (best < kShortest) {
            tokens_.push_back({0, static_cast<unsigned char>(in_[at])});
            remember(at);
            return at + 1;
        }
        tokens_.push_back({static_cast<std::uint16_t>(best), static_cast<std::uint16_t>(at - from)});
        // Of long runs only the border is remembered: their inside is found from there.
        const std::size_t remembered = std::min<std::size_t>(best, 16);
        for (std::size_t i = 0; i < remembered; ++i) remember(at + i);
        return at + best;
    }

    std::size_t distance_code(std::uint32_t distance) const {
        return static_cast<std::size_t>(std::upper_bound(distance_.base.begin(), distance_.base.end(), distance) - distance_.base.begin() - 1);
    }

    void write_block(bool last) {
        std::vector<std::uint32_t> literals(kLiterals, 0), distances(kDistances, 0);
        literals[kEndOfBlock] = 1;
        for (const Token& t : tokens_) {
            ++literals[t.length == 0 ? t.value : 257U + length_code_[t.length]];
            if (t.length > 0) ++distances[distance_code(t.value)];
        }
        // Some readers refuse a code without symbols.
        if (std::all_of(distances.begin(), distances.end(), [](std::uint32_t c) { return c == 0; })) distances[0] = 1;
        const Code literal = code_for(literals, 15), distance = code_for(distances, 15);
        bits_.put(last ? 1 : 0, 1);
        bits_.put(2, 2);
        write_codes(literal, distance);
        for (const Token& t : tokens_) write_token(t, literal, distance);
        bits_.put(literal.bits[kEndOfBlock], literal.lengths[kEndOfBlock]);
    }

    // Lengths of both codes, each written plainly by a third code.
    void write_codes(const Code& literal, const Code& distance) {
        std::vector<std::uint32_t> counts(19, 0);
        for (const Code* code : {&literal, &distance})
            for (std::uint8_t length : code->lengths) ++counts[length];
        const Code lengths = code_for(counts, 7);
        bits_.put(kLiterals - 257, 5);
        bits_.put(kDistances - 1, 5);
        bits_.put(19 - 4, 4);
        for (int s : {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15}) bits_.put(lengths.lengths[static_cast<std::size_t>(s)], 3);
        for (const Code* code : {&literal, &distance})
            for (std::uint8_t length : code->lengths) bits_.put(lengths.bits[length], lengths.lengths[length]);
    }

    void write_token(const Token& t, const Code& literal, const Code& distance) {
        if (t.length == 0) return bits_.put(literal.bits[t.value], literal.lengths[t.value]);
        const std::size_t l = length_code_[t.length], d = distance_code(t.value);
        bits_.put(literal.bits[257 + l], literal.lengths[257 + l]);
        bits_.put(static_cast<std::uint32_t>(t.length - length_.base[l]), length_.extra[l]);
        bits_.put(distance.bits[d], distance.lengths[d]);
        bits_.put(static_cast<std::uint32_t>(t.value - distance_.base[d]), distance_.extra[d]);
    }

    // Adler-32. 5552 bytes are the most whose sums fit 32 bits.
    void write_checksum() {
        std::uint32_t a = 1, b = 0;
        for (std::size_t at = 0; at < in_.size();) {
            for (const std::size_t end = std::min(in_.size(), at + 5552); at < end; ++at) b += a += static_cast<unsigned char>(in_[at]);
            a %= 65521;
            b %= 65521;
        }
        for (std::uint32_t byte : {b >> 8, b, a >> 8, a}) out_.push_back(static_cast<char>(byte & 0xff));
    }

    std::string_view in_;
    std::vector<std::uint32_t> head_, previous_;
    std::vector<Token> tokens_;
    std::string out_;
    BitWriter bits_;
    Ranges length_ = length_ranges(), distance_ = distance_ranges();
    std::array<std::uint8_t, 259> length_code_{};
};

}  // namespace

std::string zlib_compressed(std::string_view bytes) { return Compressor(bytes).run(); }

}  // namespace whittle
