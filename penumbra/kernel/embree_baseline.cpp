// SPDX-License-Identifier: MIT
#include "penumbra/kernel/embree_baseline.h"

#include <embree3/rtcore.h>

#include <atomic>
#include <limits>
#include <stdexcept>
#include <vector>

#include "penumbra/kernel/embree_user_geometry.h"
#include "penumbra/kernel/record.h"

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

RTCIntersectContext context_for(Coherence coherence) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = coherence == Coherence::coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT
                                                   : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  return context;
}

// Where rays come from: `fill` writes neighbours to a packet, `ray` one to a stream.

struct FromOne {
  const LightSamples& rays;
  template <class Packet>
  void fill(std::uint32_t first, int width, Packet& packet) const {
    for (int i = 0; i < width; ++i) packet.org_x[i] = rays.origin.x;
    for (int i = 0; i < width; ++i) packet.org_y[i] = rays.origin.y;
    for (int i = 0; i < width; ++i) packet.org_z[i] = rays.origin.z;
    std::copy_n(&rays.x[first], width, packet.dir_x);
    std::copy_n(&rays.y[first], width, packet.dir_y);
    std::copy_n(&rays.z[first], width, packet.dir_z);
  }
  RTCRay ray(std::uint32_t i) const {
    return {rays.origin.x,
            rays.origin.y,
            rays.origin.z,
            0,
            rays.x[i],
            rays.y[i],
            rays.z[i],
            0,
            rays.t_max,
            ~0u,
            i,
            0};
  }
};

struct FromMany {
  const MixedRays& rays;
  template <class Packet>
  void fill(std::uint32_t first, int width, Packet& packet) const {
    std::copy_n(&rays.origin[0][first], width, packet.org_x);
    std::copy_n(&rays.origin[1][first], width, packet.org_y);
    std::copy_n(&rays.origin[2][first], width, packet.org_z);
    std::copy_n(&rays.direction[0][first], width, packet.dir_x);
    std::copy_n(&rays.direction[1][first], width, packet.dir_y);
    std::copy_n(&rays.direction[2][first], width, packet.dir_z);
  }
  RTCRay ray(std::uint32_t i) const {
    return {rays.origin[0][i],
            rays.origin[1][i],
            rays.origin[2][i],
            0,
            rays.direction[0][i],
            rays.direction[1][i],
            rays.direction[2][i],
            0,
            rays.t_max,
            ~0u,
            i,
            0};
  }
};

/// Packets of `width` neighbouring rays through one of Embree's packet functions; those without an
/// active ray are left out.
template <int width, typename Packet, typename Rays, typename Occluded>
void occluded_packets(const Rays& from, std::span<const std::uint32_t> active,
                      std::span<std::uint32_t> blocked, Occluded&& occluded) {
  alignas(64) int valid[width];
  alignas(64) Packet packet;
  for (int i = 0; i < width; ++i) {
    packet.tnear[i] = 0, packet.time[i] = 0;
    packet.mask[i] = ~0u, packet.id[i] = 0, packet.flags[i] = 0;
  }
  constexpr std::uint32_t all = (1u << width) - 1;
  for (std::uint32_t first = 0; first < from.rays.count; first += width) {
    const std::uint32_t bits = active[first / 32] >> first % 32 & all;
    if (bits == 0) continue;
    for (int i = 0; i < width; ++i) valid[i] = -static_cast<int>(bits >> i & 1);
    for (int i = 0; i < width; ++i) packet.tfar[i] = from.rays.t_max;
    from.fill(first, width, packet);
    occluded(valid, &packet);
    std::uint32_t hit = 0;
    for (int i = 0; i < width; ++i) hit |= std::uint32_t{packet.tfar[i] < 0} << i;
    blocked[first / 32] |= (hit & bits) << first % 32;
  }
}

template <typename Rays>
void occluded_stream(const Rays& from, std::span<const std::uint32_t> active,
                     std::span<std::uint32_t> blocked, RTCScene scene,
                     RTCIntersectContext& context) {
  thread_local std::vector<RTCRay> stream;
  stream.clear();
  for (std::uint32_t i = 0; i < from.rays.count; ++i)
    if (active[i / 32] >> i % 32 & 1) stream.push_back(from.ray(i));
  rtcOccluded1M(scene, &context, stream.data(), static_cast<unsigned>(stream.size()),
                sizeof(RTCRay));
  for (const RTCRay& ray : stream)
    if (ray.tfar < 0) blocked[ray.id / 32] |= 1u << ray.id % 32;
}

template <typename Rays>
void occluded_by_embree(EmbreeVariant variant, const Rays& from,
                        std::span<const std::uint32_t> active, std::span<std::uint32_t> blocked,
                        RTCScene scene) {
  RTCIntersectContext context = context_for(variant.coherence);
  std::fill(blocked.begin(), blocked.end(), 0u);
  switch (variant.call) {
    case EmbreeCall::packets_of_8:
      return occluded_packets<8, RTCRay8>(from, active, blocked, [&](const int* valid, RTCRay8* p) {
        rtcOccluded8(valid, scene, &context, p);
      });
    case EmbreeCall::packets_of_16:
      return occluded_packets<16, RTCRay16>(
          from, active, blocked,
          [&](const int* valid, RTCRay16* p) { rtcOccluded16(valid, scene, &context, p); });
    case EmbreeCall::stream: return occluded_stream(from, active, blocked, scene, context);
  }
}

}  // namespace

std::string name_of(EmbreeVariant variant) {
  std::string name;
  switch (variant.call) {
    case EmbreeCall::packets_of_8: name = "rtcOccluded8"; break;
    case EmbreeCall::packets_of_16: name = "rtcOccluded16"; break;
    case EmbreeCall::stream: name = "rtcOccluded1M"; break;
  }
  return variant.coherence == Coherence::coherent ? name + ", coherent" : name;
}

std::string embree_version() { return RTC_VERSION_STRING; }

void MixedRays::resize(std::uint32_t rays) {
  count = rays;
  const std::size_t padded = (std::size_t{rays} + 15) / 16 * 16;
  for (int axis = 0; axis < 3; ++axis) origin[axis].resize(padded), direction[axis].resize(padded);
}

void MixedRays::set(std::uint32_t i, Vec3f from, Vec3f along) {
  for (int axis = 0; axis < 3; ++axis)
    origin[axis][i] = from[axis], direction[axis][i] = along[axis];
}

EmbreeBaseline::EmbreeBaseline(const ShapeSet& shapes, EmbreeSpheres spheres)
    : data_(std::make_unique<Data>()) {
  data_->device = rtcNewDevice(nullptr);
  if (!data_->device) throw std::runtime_error("Embree gives no device");
  rtcSetDeviceMemoryMonitorFunction(data_->device, count_memory, &data_->bytes);
  data_->scene = rtcNewScene(data_->device);
  rtcSetSceneBuildQuality(data_->scene, RTC_BUILD_QUALITY_HIGH);
  const auto note = [&](ShapeKind kind, std::uint32_t object) {
    data_->kind.push_back(kind);
    data_->object.push_back(object);
  };
  if (spheres == EmbreeSpheres::native && !shapes.spheres.empty()) {
    add_spheres(data_->device, data_->scene, shapes.spheres);
    note(ShapeKind::sphere, 0);
  }
  for (std::uint32_t m = 0; m < shapes.meshes.size(); ++m) {
    add_mesh(data_->device, data_->scene, shapes.meshes[m]);
    note(ShapeKind::triangle, m);
  }
  const auto add_records = [&](ShapeKind kind, std::size_t count) {
    for (std::uint32_t i = 0; i < count; ++i)
      data_->user_records.push_back(make_record(shapes, {kind, i}, i));
  };
  if (spheres == EmbreeSpheres::user) add_records(ShapeKind::sphere, shapes.spheres.size());
  add_records(ShapeKind::cone, shapes.cones.size());
  add_records(ShapeKind::ring, shapes.rings.size());
  if (!data_->user_records.empty()) {
    attach_records(data_->device, data_->scene, data_->user_records);
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

std::vector<EmbreeVariant> EmbreeBaseline::variants() const {
  std::vector<EmbreeCall> calls = {EmbreeCall::packets_of_8, EmbreeCall::stream};
  if (rtcGetDeviceProperty(data_->device, RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED))
    calls.push_back(EmbreeCall::packets_of_16);
  std::vector<EmbreeVariant> variants;
  for (const EmbreeCall call : calls)
    for (const Coherence coherence : {Coherence::coherent, Coherence::none})
      variants.push_back({call, coherence});
  return variants;
}

void EmbreeBaseline::occluded(EmbreeVariant variant, const LightSamples& rays,
                              std::span<const std::uint32_t> active,
                              std::span<std::uint32_t> blocked) const {
  occluded_by_embree(variant, FromOne{rays}, active, blocked, data_->scene);
}

void EmbreeBaseline::occluded(EmbreeVariant variant, const MixedRays& rays,
                              std::span<const std::uint32_t> active,
                              std::span<std::uint32_t> blocked) const {
  occluded_by_embree(variant, FromMany{rays}, active, blocked, data_->scene);
}

std::size_t EmbreeBaseline::memory_bytes() const {
  return static_cast<std::size_t>(data_->bytes.load()) +
         data_->user_records.capacity() * sizeof(Record);
}

}  // namespace penumbra
