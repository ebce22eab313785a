// SPDX-License-Identifier: MIT
// The rays of a receiver in lanes, against boxes and against records.
//
// Highway "inl" header: included once for each instruction set.

#if defined(PENUMBRA_KERNEL_PACKET_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PENUMBRA_KERNEL_PACKET_INL_H_
#undef PENUMBRA_KERNEL_PACKET_INL_H_
#else
#define PENUMBRA_KERNEL_PACKET_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstdint>

#include "penumbra/geometry/light_sampling.h"
#include "penumbra/kernel/edge_planes-inl.h"
#include "penumbra/kernel/four_triangles-inl.h"
#include "penumbra/kernel/intersect-inl.h"
#include "penumbra/kernel/lanes-inl.h"
#include "penumbra/kernel/shaft-inl.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

/// Up to 32 rays of a receiver, and what is derived from their directions: one array a number, so
/// that it can be had for a group of rays and for a single one. Sets of them are bit masks.
struct Packet {
  static constexpr std::uint32_t most = 32;

  HWY_INLINE Packet(const LightSamples& rays_, std::uint32_t first_)
      : rays(rays_),
        first(first_),
        groups((std::min(rays_.count - first_, most) + lane_count - 1) / lane_count) {
    for (std::uint32_t i = 0; i < groups * lane_count; i += lane_count) {
      const Lane x = hn::LoadU(lane_tag, &rays.x[first + i]),
                 y = hn::LoadU(lane_tag, &rays.y[first + i]),
                 z = hn::LoadU(lane_tag, &rays.z[first + i]);
      const RayLanes<LaneTag> ray = make_ray_lanes(lane_tag, x, y, z);
      const Lane numbers[] = {ray.inverse_square, ray.shear_x, ray.shear_y, ray.scale, ray.axis};
      for (int k = 0; k < 5; ++k) hn::Store(numbers[k], lane_tag, &derived[k][i]);
      hn::Store(safe_reciprocal(lane_tag, x), lane_tag, &inverse[0][i]);
      hn::Store(safe_reciprocal(lane_tag, y), lane_tag, &inverse[1][i]);
      hn::Store(safe_reciprocal(lane_tag, z), lane_tag, &inverse[2][i]);
    }
  }

  /// Rays i, i + 1, ... in the lanes of d.
  template <class D>
  HWY_INLINE RayLanes<D> lanes(D d, std::uint32_t i) const {
    return {hn::LoadU(d, &rays.x[first + i]), hn::LoadU(d, &rays.y[first + i]),
            hn::LoadU(d, &rays.z[first + i]), hn::Load(d, &derived[0][i]),
            hn::Load(d, &derived[1][i]),      hn::Load(d, &derived[2][i]),
            hn::Load(d, &derived[3][i]),      hn::Load(d, &derived[4][i])};
  }

  HWY_INLINE Shear shear(std::uint32_t i) const {
    return {derived[1][i], derived[2][i], static_cast<int>(derived[4][i])};
  }

  const LightSamples& rays;
  std::uint32_t first, groups;
  alignas(64) float derived[5][most];  // the members of RayLanes after the direction
  alignas(64) float inverse[3][most];  // 1 / direction
};

/// Calls f(ray) for each of the rays.
template <class F>
HWY_INLINE void each_ray(std::uint32_t rays, F&& f) {
  for (; rays != 0; rays &= rays - 1) f(static_cast<std::uint32_t>(__builtin_ctz(rays)));
}

/// Calls f(group, bits) for each group of lanes with wanted rays; gathers the bits it returns.
template <class F>
HWY_INLINE std::uint32_t each_group(const Packet& packet, std::uint32_t wanted, F&& f) {
  constexpr std::uint32_t all = (1u << lane_count) - 1;
  std::uint32_t met = 0;
  for (std::uint32_t g = 0; g < packet.groups; ++g)
    if (const std::uint32_t bits = wanted >> (g * lane_count) & all)
      met |= (f(g, bits) & bits) << (g * lane_count);
  return met;
}

/// The wanted rays that may meet a triangle.
HWY_INLINE std::uint32_t near_triangle(const Record& triangle, const Packet& packet,
                                       std::uint32_t wanted) {
  const EdgePlanes planes = edge_planes(triangle, packet.rays.origin);
  return each_group(packet, wanted, [&](std::uint32_t g, std::uint32_t) {
    const std::uint32_t i = packet.first + g * lane_count;
    const auto passes =
        passes_by(lane_tag, planes, hn::LoadU(lane_tag, &packet.rays.x[i]),
                  hn::LoadU(lane_tag, &packet.rays.y[i]), hn::LoadU(lane_tag, &packet.rays.z[i]));
    return ~bits_of(passes);
  });
}

/// The wanted rays that are blocked by the record.
HWY_INLINE std::uint32_t blocked_by(const Record& record, const Packet& packet,
                                    std::uint32_t wanted) {
  if (record.kind == ShapeKind::triangle && (wanted & (wanted - 1)) != 0)
    wanted = near_triangle(record, packet, wanted);
  if (wanted == 0) return 0;
  if ((wanted & (wanted - 1)) == 0) {  // a vector of sixteen costs more than one lane
    const hn::CappedTag<float, 1> d;
    const auto ray = packet.lanes(d, static_cast<std::uint32_t>(__builtin_ctz(wanted)));
    const auto met =
        meets(d, record, packet.rays.origin, ray, hn::Set(d, packet.rays.t_max), hn::FirstN(d, 1));
    return hn::AllFalse(d, met) ? 0 : wanted;
  }
  return each_group(packet, wanted, [&](std::uint32_t g, std::uint32_t bits) {
    return bits_of(meets(lane_tag, record, packet.rays.origin,
                         packet.lanes(lane_tag, g * lane_count),
                         hn::Set(lane_tag, packet.rays.t_max), mask_of(bits)));
  });
}

/// The wanted rays that meet the box of one child: the shaft's test, ray by ray, and conservative
/// for the same reason.
HWY_INLINE std::uint32_t through_box(const WideNode& node, int child, const Packet& packet,
                                     std::uint32_t wanted) {
  float lo[3], hi[3], reach = 0;
  for (int axis = 0; axis < 3; ++axis) {
    lo[axis] = node.lo[axis][child] - packet.rays.origin[axis];
    hi[axis] = node.hi[axis][child] - packet.rays.origin[axis];
    reach = std::max({reach, std::abs(lo[axis]), std::abs(hi[axis])});
  }
  const float pad = box_pad * reach;
  return each_group(packet, wanted, [&](std::uint32_t g, std::uint32_t) {
    Lane near = hn::Zero(lane_tag), far = hn::Set(lane_tag, packet.rays.t_max);
    for (int axis = 0; axis < 3; ++axis) {
      const Lane inverse = hn::Load(lane_tag, &packet.inverse[axis][g * lane_count]);
      const Lane a = hn::Mul(hn::Set(lane_tag, lo[axis] - pad), inverse);
      const Lane b = hn::Mul(hn::Set(lane_tag, hi[axis] + pad), inverse);
      near = hn::Max(near, hn::Min(a, b)), far = hn::Min(far, hn::Max(a, b));
    }
    return bits_of(hn::Le(near, far));
  });
}

/// The same for all children of a node, boxes in lanes and ray by ray: through[i] are the wanted
/// rays that meet child i. Returns the children that any of them meets.
HWY_INLINE std::uint32_t through_boxes(const WideNode& node, const Packet& packet,
                                       std::uint32_t wanted, std::uint32_t* through) {
  const hn::CappedTag<float, WideNode::width> d;
  const hn::RebindToUnsigned<decltype(d)> words;
  using V = hn::Vec<decltype(d)>;
  std::uint32_t met = 0;
  for (std::size_t first = 0; first < WideNode::width; first += hn::Lanes(d)) {
    const auto boxes =
        padded_boxes(d, node, first, packet.rays.origin, packet.rays.origin, box_pad);
    auto rays = hn::Zero(words);
    each_ray(wanted, [&](std::uint32_t i) {
      V near = hn::Zero(d), far = hn::Set(d, packet.rays.t_max);
      for (int axis = 0; axis < 3; ++axis) {
        const V inverse = hn::Set(d, packet.inverse[axis][i]);
        const V a = hn::Mul(boxes.lo[axis], inverse), b = hn::Mul(boxes.hi[axis], inverse);
        near = hn::Max(near, hn::Min(a, b)), far = hn::Min(far, hn::Max(a, b));
      }
      const auto passes = hn::RebindMask(words, hn::Le(near, far));
      rays = hn::Or(rays, hn::IfThenElseZero(passes, hn::Set(words, 1u << i)));
    });
    hn::Store(rays, words, through + first);
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(words, hn::Ne(rays, hn::Zero(words)), bytes);
    met |= std::uint32_t(bytes[0]) << first;
  }
  return met & node.used;
}

/// For each of four records, the wanted rays that are known to pass by it.
HWY_INLINE void passed_by(const Record* const* records, const Packet& packet, std::uint32_t wanted,
                          std::uint32_t* passed) {
  const hn::RebindToUnsigned<FourTriangles::D> words;
  const FourTriangles triangles(records, packet.rays.origin);
  auto rays = hn::Zero(words);
  each_ray(wanted, [&](std::uint32_t i) {
    const auto passes = hn::RebindMask(words, triangles.passed_by(packet.shear(i)));
    rays = hn::Or(rays, hn::IfThenElseZero(passes, hn::Set(words, 1u << i)));
  });
  hn::Store(rays, words, passed);
}

}  // namespace penumbra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include once for each instruction set
