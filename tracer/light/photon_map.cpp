#include "tracer/light/photon_map.h"

#include <bit>
#include <cmath>

namespace whittle {

namespace {

// Photons of a face that bends away by more (25 degrees) belong to another.
constexpr double kSameFace = 0.9;

// Photons may lie this share of the radius above or below the face's plane.
constexpr double kThickness = 0.25;

}  // namespace

PhotonMap::PhotonMap(std::vector<Photon> photons, double radius) : radius_(radius) {
    begin_.assign(std::bit_ceil(photons.size() + 1) + 1, 0);
    std::vector<std::uint32_t> slots(photons.size());
    for (std::size_t i = 0; i < photons.size(); ++i) {
        slots[i] = static_cast<std::uint32_t>(slot_of(cell_of(photons[i].point)));
        ++begin_[slots[i] + 1];
    }
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    photons_.resize(photons.size());
    for (std::size_t i = 0; i < photons.size(); ++i) photons_[next[slots[i]]++] = photons[i];
}

// Twice as wide as the radius: a search meets eight cells.
PhotonMap::Cell PhotonMap::cell_of(Vec3 p) const {
    const Vec3 scaled = p / (2 * radius_);
    return {static_cast<std::int64_t>(std::floor(scaled.x)), static_cast<std::int64_t>(std::floor(scaled.y)), static_cast<std::int64_t>(std::floor(scaled.z))};
}

std::size_t PhotonMap::slot_of(const Cell& c) const {
    const std::uint64_t mixed = static_cast<std::uint64_t>(c[0]) * 0x9e3779b97f4a7c15U ^ static_cast<std::uint64_t>(c[1]) * 0xc2b2ae3d27d4eb4fU ^
                                static_cast<std::uint64_t>(c[2]) * 0x165667b19e3779f9U;
    return (mixed ^ (mixed >> 31)) & (begin_.size() - 2);
}

Vec3 PhotonMap::radiance(Vec3 point, Vec3 normal, const Bsdf& bsdf) const {
    Vec3 sum(0);
    if (photons_.empty()) return sum;
    const Cell lowest = cell_of(point - Vec3(radius_));
    std::array<std::size_t, 8> seen{};
    std::size_t count = 0;
    for (std::int64_t corner = 0; corner < 8; ++corner) {
        const std::size_t slot = slot_of({lowest[0] + (corner & 1), lowest[1] + ((corner >> 1) & 1), lowest[2] + (corner >> 2)});
        // Two cells may share a slot: it is read once.
        if (std::find(seen.begin(), seen.begin() + count, slot) != seen.begin() + count) continue;
        seen[count++] = slot;
        for (std::uint32_t i = begin_[slot]; i < begin_[slot + 1]; ++i) {
            const Photon& photon = photons_[i];
            const Vec3 off = photon.point - point;
            if (glm::dot(off, off) > radius_ * radius_ || glm::dot(photon.normal, normal) < kSameFace) continue;
            if (std::abs(glm::dot(off, normal)) > kThickness * radius_) continue;
            const double cosine = glm::dot(photon.towards, normal);
            if (cosine > 0) sum += photon.power * bsdf.value(photon.towards, cosine);
        }
    }
    return sum / (kPi * radius_ * radius_);
}

}  // namespace whittle
