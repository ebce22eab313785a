// SPDX-License-Identifier: MIT
#include "penumbra/kernel/embree_baseline.h"

#include <embree3/rtcore.h>

#include <atomic>
#include <limits>
#include <stdexcept>
#include <vector>

#include "penumbra/kernel/record.h"
#include "penumbra/kernel/traverse.h"

namespace penumbra {

struct EmbreeBaseline::Data {
  std::atomic<std::ptrdiff_t> bytes = 0;  // first: the device reports until it is gone
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<Record> user_records;
  std::vector<ShapeKind> kind;        // of each geometry
  std::vector<std::uint32_t> object;  // mesh index of a triangle geometry

  ~Data() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }
};

namespace {

bool count_memory(void* bytes, ssize_t change, bool) {
  *static_cast<std::atomic<std::ptrdiff_t>*>(bytes) += change;
  return true;
}

void set_buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, const void* from,
                std::size_t stride, std::size_t count) {
  rtcSetSharedGeometryBuffer(geometry, type, 0, format, from, 0, stride, count);
}

/// Copies, padded: Embree reads 16 bytes at each vertex.
void add_mesh(RTCDevice device, RTCScene scene, const Mesh& mesh) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
  auto* vertex = static_cast<Vec3f*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                             RTC_FORMAT_FLOAT3, sizeof(Vec3f),
                                                             mesh.positions.size()));
  std::copy(mesh.positions.begin(), mesh.positions.end(), vertex);
  set_buffer(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, mesh.triangles.data(),
             sizeof(Triangle), mesh.triangles.size());
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

void add_spheres(RTCDevice device, RTCScene scene, const std::vector<Sphere>& spheres) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
  auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 4 * sizeof(float), spheres.size()));
  for (const Sphere& s : spheres)
    for (float number : {s.center.x, s.center.y, s.center.z, s.radius}) *vertex++ = number;
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

void user_bounds(const RTCBoundsFunctionArguments* arguments) {
  const Box b = bounds(
      (*static_cast<const std::vector<Record>*>(arguments->geometryUserPtr))[arguments->primID]);
  *arguments->bounds_o = {b.lo.x, b.lo.y, b.lo.z, 0, b.hi.x, b.hi.y, b.hi.z, 0};
}

/// The record against ray `i` of a packet, by our own intersector.
NearestRecord test_user(const std::vector<Record>& records, unsigned primitive, RTCRayN* ray,
                        unsigned n, unsigned i) {
  const Ray one{{RTCRayN_org_x(ray, n, i), RTCRayN_org_y(ray, n, i), RTCRayN_org_z(ray, n, i)},
                {RTCRayN_dir_x(ray, n, i), RTCRayN_dir_y(ray, n, i), RTCRayN_dir_z(ray, n, i)},
                RTCRayN_tnear(ray, n, i),
                RTCRayN_tfar(ray, n, i)};
  return nearest_brute({&records[primitive], 1}, one);
}

void user_intersect(const RTCIntersectFunctionNArguments* arguments) {
  const auto& records = *static_cast<const std::vector<Record>*>(arguments->geometryUserPtr);
  RTCRayN* rays = RTCRayHitN_RayN(arguments->rayhit, arguments->N);
  RTCHitN* hits = RTCRayHitN_HitN(arguments->rayhit, arguments->N);
  for (unsigned i = 0; i < arguments->N; ++i) {
    if (!arguments->valid[i]) continue;
    const NearestRecord found = test_user(records, arguments->primID, rays, arguments->N, i);
    if (!found.found) continue;
    RTCRayN_tfar(rays, arguments->N, i) = found.t;
    RTCHitN_geomID(hits, arguments->N, i) = arguments->geomID;
    RTCHitN_primID(hits, arguments->N, i) = arguments->primID;
  }
}

void user_occluded(const RTCOccludedFunctionNArguments* arguments) {
  const auto& records = *static_cast<const std::vector<Record>*>(arguments->geometryUserPtr);
  for (unsigned i = 0; i < arguments->N; ++i)
    if (arguments->valid[i] &&
        test_user(records, arguments->primID, arguments->ray, arguments->N, i).found)
      RTCRayN_tfar(arguments->ray, arguments->N, i) = -std::numeric_limits<float>::infinity();
}

void add_user(RTCDevice device, RTCScene scene, std::vector<Record>& records) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(records.size()));
  rtcSetGeometryUserData(geometry, &records);
  rtcSetGeometryBoundsFunction(
      geometry, [](const RTCBoundsFunctionArguments* arguments) { user_bounds(arguments); },
      nullptr);
  rtcSetGeometryIntersectFunction(geometry, user_intersect);
  rtcSetGeometryOccludedFunction(geometry, user_occluded);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

RTCIntersectContext context_for(Coherence coherence) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = coherence == Coherence::coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT
                                                   : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  return context;
}

/// Packets of `width` neighbouring rays through one of Embree's packet functions.
template <int width, typename Packet, typename Occluded>
void occluded_packets(const LightSamples& rays, std::span<const std::uint32_t> active,
                      std::span<std::uint32_t> blocked, Occluded&& occluded) {
  std::fill(blocked.begin(), blocked.end(), 0u);
  for (std::uint32_t first = 0; first < rays.count; first += width) {
    alignas(64) int valid[width];
    alignas(64) Packet packet;
    const std::uint32_t bits = active[first / 32] >> first % 32;
    for (int i = 0; i < width; ++i) {
      valid[i] = first + i < rays.count && (bits >> i & 1) ? -1 : 0;
      packet.org_x[i] = rays.origin.x, packet.org_y[i] = rays.origin.y,
      packet.org_z[i] = rays.origin.z;
      packet.dir_x[i] = rays.x[first + i], packet.dir_y[i] = rays.y[first + i],
      packet.dir_z[i] = rays.z[first + i];
      packet.tnear[i] = 0, packet.tfar[i] = rays.t_max;
      packet.time[i] = 0, packet.mask[i] = ~0u, packet.id[i] = 0, packet.flags[i] = 0;
    }
    occluded(valid, &packet);
    for (int i = 0; i < width; ++i)
      if (valid[i] && packet.tfar[i] < 0) blocked[first / 32] |= 1u << (first % 32 + i);
  }
}

}  // namespace

EmbreeBaseline::EmbreeBaseline(const ShapeSet& shapes) : data_(std::make_unique<Data>()) {
  data_->device = rtcNewDevice(nullptr);
  if (!data_->device) throw std::runtime_error("Embree gives no device");
  rtcSetDeviceMemoryMonitorFunction(data_->device, count_memory, &data_->bytes);
  data_->scene = rtcNewScene(data_->device);
  rtcSetSceneBuildQuality(data_->scene, RTC_BUILD_QUALITY_HIGH);
  const auto note = [&](ShapeKind kind, std::uint32_t object) {
    data_->kind.push_back(kind);
    data_->object.push_back(object);
  };
  if (!shapes.spheres.empty()) {
    add_spheres(data_->device, data_->scene, shapes.spheres);
    note(ShapeKind::sphere, 0);
  }
  for (std::uint32_t m = 0; m < shapes.meshes.size(); ++m) {
    add_mesh(data_->device, data_->scene, shapes.meshes[m]);
    note(ShapeKind::triangle, m);
  }
  for (std::uint32_t i = 0; i < shapes.cones.size(); ++i)
    data_->user_records.push_back(make_record(shapes, {ShapeKind::cone, i}, i));
  for (std::uint32_t i = 0; i < shapes.rings.size(); ++i)
    data_->user_records.push_back(make_record(shapes, {ShapeKind::ring, i}, i));
  if (!data_->user_records.empty()) {
    add_user(data_->device, data_->scene, data_->user_records);
    note(ShapeKind::cone, 0);
  }
  rtcCommitScene(data_->scene);
}

EmbreeBaseline::~EmbreeBaseline() = default;
EmbreeBaseline::EmbreeBaseline(EmbreeBaseline&&) noexcept = default;
EmbreeBaseline& EmbreeBaseline::operator=(EmbreeBaseline&&) noexcept = default;

std::optional<Hit> EmbreeBaseline::closest(const Ray& ray) const {
  RTCIntersectContext context = context_for(Coherence::coherent);
  RTCRayHit one{};
  one.ray = {ray.origin.x,
             ray.origin.y,
             ray.origin.z,
             ray.t_min,
             ray.direction.x,
             ray.direction.y,
             ray.direction.z,
             0,
             ray.t_max,
             ~0u,
             0,
             0};
  one.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(data_->scene, &context, &one);
  if (one.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  const ShapeKind kind = data_->kind[one.hit.geomID];
  if (kind == ShapeKind::triangle)
    return Hit{one.ray.tfar, {kind, data_->object[one.hit.geomID], one.hit.primID, 0}};
  if (kind == ShapeKind::sphere) return Hit{one.ray.tfar, {kind, one.hit.primID, 0, 0}};
  const Record& record = data_->user_records[one.hit.primID];
  return Hit{one.ray.tfar, {record.kind, record.id, 0, 0}};
}

void EmbreeBaseline::occluded8(const LightSamples& rays, std::span<const std::uint32_t> active,
                               std::span<std::uint32_t> blocked, Coherence coherence) const {
  RTCIntersectContext context = context_for(coherence);
  occluded_packets<8, RTCRay8>(rays, active, blocked, [&](const int* valid, RTCRay8* packet) {
    rtcOccluded8(valid, data_->scene, &context, packet);
  });
}

void EmbreeBaseline::occluded16(const LightSamples& rays, std::span<const std::uint32_t> active,
                                std::span<std::uint32_t> blocked, Coherence coherence) const {
  RTCIntersectContext context = context_for(coherence);
  occluded_packets<16, RTCRay16>(rays, active, blocked, [&](const int* valid, RTCRay16* packet) {
    rtcOccluded16(valid, data_->scene, &context, packet);
  });
}

void EmbreeBaseline::occluded_stream(const LightSamples& rays,
                                     std::span<const std::uint32_t> active,
                                     std::span<std::uint32_t> blocked, Coherence coherence) const {
  RTCIntersectContext context = context_for(coherence);
  thread_local std::vector<RTCRay> stream;
  stream.clear();
  for (std::uint32_t i = 0; i < rays.count; ++i)
    if (active[i / 32] >> i % 32 & 1)
      stream.push_back({rays.origin.x, rays.origin.y, rays.origin.z, 0, rays.x[i], rays.y[i],
                        rays.z[i], 0, rays.t_max, ~0u, i, 0});
  rtcOccluded1M(data_->scene, &context, stream.data(), static_cast<unsigned>(stream.size()),
                sizeof(RTCRay));
  std::fill(blocked.begin(), blocked.end(), 0u);
  for (const RTCRay& ray : stream)
    if (ray.tfar < 0) blocked[ray.id / 32] |= 1u << ray.id % 32;
}

std::size_t EmbreeBaseline::memory_bytes() const {
  return static_cast<std::size_t>(data_->bytes.load());
}

}  // namespace penumbra
