// file_text.h — bytes of a mesh file in the making, and the colours of its triangles. Internal to the writers.
#pragma once

#include <array>
#include <bit>
#include <charconv>
#include <string>
#include <string_view>
#include <vector>

#include "modeler/mesh/mesh_files.h"
#include "modeler/mesh/own_points.h"

namespace whittle {

static_assert(std::endian::native == std::endian::little, "binary formats are written in the machine's order");

// Numbers are the shortest text that reads back to the same bits, in every locale.
class FileText {
public:
    void add(std::string_view s) { bytes_ += s; }
    void add(double x) { put(x + 0.0); }  // no -0
    void add(float x) { put(x + 0.0F); }
    void add(std::uint32_t x) { put(x); }
    template <class... Rest>
    void adds(const Rest&... rest) {
        (add(rest), ...);
    }
    template <class... Rest>
    void line(const Rest&... rest) {
        (add(rest), ...);
        bytes_ += '\n';
    }
    template <class T>
    void raw(const T& x) { bytes_.append(reinterpret_cast<const char*>(&x), sizeof x); }
    std::size_t size() const { return bytes_.size(); }
    std::string take() { return std::move(bytes_); }

private:
    template <class T>
    void put(T x) {
        std::array<char, 32> buffer;
        const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x);
        bytes_.append(buffer.data(), end);
    }
    std::string bytes_;
};

// The colours of a mesh's triangles; nothing where the author named none at all. Each distinct one has a number, in order of first appearance.
class FileColors {
public:
    using Bytes = std::array<std::uint8_t, 4>;
    explicit FileColors(const MeshResult& result);
    bool any() const { return !palette_.empty(); }
    const std::vector<Bytes>& palette() const { return palette_; }
    std::uint32_t number_of(std::size_t triangle) const { return numbers_[triangle]; }
    const Bytes& of(std::size_t triangle) const { return palette_[numbers_[triangle]]; }

private:
    std::vector<Bytes> palette_;
    std::vector<std::uint32_t> numbers_;
};

// `text` as XML's character data or attribute value.
std::string xml_escaped(std::string_view text);

// The mesh in float32, equal points joined again but where parts only touch; triangles keep their leaves.
Mesh in_single_precision(const Mesh& mesh);

std::string write_3mf(const std::vector<MeshPart>& parts);
std::string write_amf(const std::vector<MeshPart>& parts);
std::string write_glb(const std::vector<MeshPart>& parts);
std::string write_om(const MeshResult& result);

}  // namespace whittle
