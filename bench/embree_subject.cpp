// embree_subject.cpp — Embree 3: single rays, packets of 16 with the coherent flag, high build quality, static.
#include "bench/subject.h"

#include <cmath>

#include <embree3/rtcore.h>

#include "bench/ray_sets.h"
#include "bench/scene_mesh.h"

namespace whittle::bench {

namespace {

struct Peer {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    RTCIntersectContext context{};
    ~Peer() {
        if (scene) rtcReleaseScene(scene);
        if (device) rtcReleaseDevice(device);
    }
};

void add_mesh(RTCDevice device, RTCScene scene, const PeerMesh& mesh) {
    RTCGeometry g = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, mesh.points.size()));
    for (const Vec3& p : mesh.points)
        for (int i = 0; i < 3; ++i) *points++ = static_cast<float>(p[i]);
    auto* corners = static_cast<unsigned*>(rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, mesh.triangles.size()));
    for (const auto& t : mesh.triangles)
        for (const std::uint32_t i : t) *corners++ = i;
    rtcCommitGeometry(g);
    rtcAttachGeometry(scene, g);
    rtcReleaseGeometry(g);
}

void add_balls(Peer& peer, const std::vector<Ball>& balls) {
    RTCGeometry g = rtcNewGeometry(peer.device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    auto* at = static_cast<float*>(rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 16, balls.size()));
    for (const Ball& b : balls) {
        for (int i = 0; i < 3; ++i) *at++ = static_cast<float>(b.centre[i]);
        *at++ = static_cast<float>(b.radius);
    }
    rtcCommitGeometry(g);
    rtcAttachGeometry(peer.scene, g);
    rtcReleaseGeometry(g);
}

// Instances of one scene of the mesh, which they keep alive.
void add_instances(Peer& peer, const PeerMesh& mesh, const std::vector<Placement>& placements) {
    RTCScene part = rtcNewScene(peer.device);
    rtcSetSceneBuildQuality(part, RTC_BUILD_QUALITY_HIGH);
    add_mesh(peer.device, part, mesh);
    rtcCommitScene(part);
    for (const Placement& p : placements) {
        RTCGeometry g = rtcNewGeometry(peer.device, RTC_GEOMETRY_TYPE_INSTANCE);
        rtcSetGeometryInstancedScene(g, part);
        float rows[12];
        for (std::size_t i = 0; i < 12; ++i) rows[i] = static_cast<float>(p.m[i]);
        rtcSetGeometryTransform(g, 0, RTC_FORMAT_FLOAT3X4_ROW_MAJOR, rows);
        rtcCommitGeometry(g);
        rtcAttachGeometry(peer.scene, g);
        rtcReleaseGeometry(g);
    }
    rtcReleaseScene(part);
}

// The normal is stored as Embree leaves it, not made a unit vector.
bool first_from(Peer& peer, const Ray& ray, float from, RTCRayHit& r) {
    r = {};
    r.ray.org_x = static_cast<float>(ray.origin.x), r.ray.org_y = static_cast<float>(ray.origin.y), r.ray.org_z = static_cast<float>(ray.origin.z);
    r.ray.dir_x = static_cast<float>(ray.direction.x), r.ray.dir_y = static_cast<float>(ray.direction.y), r.ray.dir_z = static_cast<float>(ray.direction.z);
    r.ray.tnear = from;
    r.ray.tfar = HUGE_VALF;
    r.ray.mask = ~0u;
    r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(peer.scene, &peer.context, &r);
    return r.hit.geomID != RTC_INVALID_GEOMETRY_ID;
}

void first_1(Peer& peer, const Batch& batch, Answers& answers) {
    RTCRayHit r;
    for (int i = 0; i < kBatch; ++i)
        if (first_from(peer, batch.rays[i], 0, r)) {
            answers.store(i, r.ray.tfar, {r.hit.Ng_x, r.hit.Ng_y, r.hit.Ng_z}, r.hit.primID);
        } else {
            answers.miss(i);
        }
}

void any_1(Peer& peer, const Batch& batch, Answers& answers) {
    for (int i = 0; i < kBatch; ++i) {
        const Ray& ray = batch.rays[i];
        RTCRay r{};
        r.org_x = static_cast<float>(ray.origin.x), r.org_y = static_cast<float>(ray.origin.y), r.org_z = static_cast<float>(ray.origin.z);
        r.dir_x = static_cast<float>(ray.direction.x), r.dir_y = static_cast<float>(ray.direction.y), r.dir_z = static_cast<float>(ray.direction.z);
        r.tfar = HUGE_VALF;
        r.mask = ~0u;
        rtcOccluded1(peer.scene, &peer.context, &r);
        answers.miss(i);
        if (r.tfar < 0) answers.t[static_cast<std::size_t>(i)] = 0;
    }
}

void fill_16(RTCRay16& r, const RayRows& rows, int first) {
    const auto floats = [first](const double* from, float* to) {
        for (int k = 0; k < 16; ++k) to[k] = static_cast<float>(from[first + k]);
    };
    floats(rows.origin[0], r.org_x), floats(rows.origin[1], r.org_y), floats(rows.origin[2], r.org_z);
    floats(rows.direction[0], r.dir_x), floats(rows.direction[1], r.dir_y), floats(rows.direction[2], r.dir_z);
    for (int k = 0; k < 16; ++k) r.tnear[k] = 0, r.tfar[k] = HUGE_VALF;
}

// What no query changes is filled once a batch.
void begin_16(RTCRay16& r) {
    for (int k = 0; k < 16; ++k) r.time[k] = 0, r.mask[k] = ~0u, r.id[k] = 0, r.flags[k] = 0;
}

void first_16(Peer& peer, const Batch& batch, Answers& answers) {
    alignas(64) int valid[16];
    for (int& v : valid) v = -1;
    RTCRayHit16 r;
    begin_16(r.ray);
    for (std::size_t i = 0; i < kBatch; i += 16) {
        fill_16(r.ray, batch.rows, static_cast<int>(i));
        for (unsigned& id : r.hit.geomID) id = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect16(valid, peer.scene, &peer.context, &r);
        for (std::size_t k = 0; k < 16; ++k) {
            answers.t[i + k] = r.ray.tfar[k];  // +inf where nothing was met
            answers.normal[0][i + k] = r.hit.Ng_x[k], answers.normal[1][i + k] = r.hit.Ng_y[k], answers.normal[2][i + k] = r.hit.Ng_z[k];
            answers.surface[i + k] = r.hit.primID[k];
        }
    }
}

void any_16(Peer& peer, const Batch& batch, Answers& answers) {
    alignas(64) int valid[16];
    for (int& v : valid) v = -1;
    RTCRay16 r;
    begin_16(r);
    for (std::size_t i = 0; i < kBatch; i += 16) {
        fill_16(r, batch.rows, static_cast<int>(i));
        rtcOccluded16(valid, peer.scene, &peer.context, &r);
        for (std::size_t k = 0; k < 16; ++k) answers.t[i + k] = r.tfar[k] < 0 ? 0 : -1;
    }
    for (auto& row : answers.normal) row.fill(0);
    answers.surface.fill(0);
}

}  // namespace

std::vector<Subject> embree_subjects(const BenchScene& scene, const PeerMesh& mesh, Query query, bool coherent) {
    if (query == Query::kSpans) return {};
    const std::vector<Ball>& balls = scene.balls;
    if (balls.empty() && mesh.triangles.empty()) return {};
    const auto peer = std::make_shared<Peer>();
    peer->device = rtcNewDevice("threads=1");
    peer->scene = rtcNewScene(peer->device);
    rtcSetSceneBuildQuality(peer->scene, RTC_BUILD_QUALITY_HIGH);
    if (!balls.empty()) add_balls(*peer, balls);
    else if (!scene.placements.empty()) add_instances(*peer, mesh, scene.placements);
    else add_mesh(peer->device, peer->scene, mesh);
    rtcCommitScene(peer->scene);
    rtcInitIntersectContext(&peer->context);
    peer->context.flags = coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    const auto of = [&](auto f) { return [peer, f](const Batch& batch, Answers& answers) { f(*peer, batch, answers); }; };
    const std::string triangles = std::to_string(mesh.triangles.size()) + " triangles";
    const std::string what = !balls.empty() ? " (balls)" : scene.placements.empty() ? " (" + triangles + ")" : " (instances of " + triangles + ")";
    if (query == Query::kAny) return {{"embree 1" + what, of(any_1), {}}, {"embree 16" + what, of(any_16), {}}};
    return {{"embree 1" + what, of(first_1), {}}, {"embree 16" + what, of(first_16), {}}};
}

std::vector<std::vector<double>> embree_all_hits(const PeerMesh& mesh, const std::vector<Ray>& rays) {
    Peer peer;
    peer.device = rtcNewDevice("threads=1");
    peer.scene = rtcNewScene(peer.device);
    rtcSetSceneFlags(peer.scene, RTC_SCENE_FLAG_ROBUST);
    add_mesh(peer.device, peer.scene, mesh);
    rtcCommitScene(peer.scene);
    rtcInitIntersectContext(&peer.context);
    std::vector<std::vector<double>> all(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        Ray ray = rays[i];
        float from = 0;
        RTCRayHit hit;
        while (all[i].size() < 1000 && first_from(peer, ray, from, hit)) {
            all[i].push_back(hit.ray.tfar);
            from = std::nextafter(hit.ray.tfar, HUGE_VALF);
        }
    }
    return all;
}

}  // namespace whittle::bench
