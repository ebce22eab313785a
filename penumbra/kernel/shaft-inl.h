// SPDX-License-Identifier: MIT
// Shaft against the eight boxes of a node. A shaft is bounded, along each axis and at each
// parameter t, by two lines: [P0 + t D0, P1 + t D1]. Two kinds are asked for:
// (1) All rays from one origin (P0 = P1) whose directions lie in a box [D0, D1]; a single ray is
// the one whose box is a point. For every ray of it that meets a record under a box in the sense of
// intersect-inl.h the test passes, exactly: reciprocal, product and padding are monotone under
// rounding.
// (2) The hull of a box of receivers [P0, P1] and a box of targets [L0, L1], with D = L - P (Haines
// & Wallace 1991). A box's reach below is at least a third of what it is from any receiver, since
// it is at least half of the receivers' extent; so boxes are padded four times as much, which
// leaves room for what float loses here.
//
// The extent overlaps a box's [lo, hi] where P1 + t D1 >= lo and P0 + t D0 <= hi: two half-lines,
// each bounding t from the side that the sign of its own slope says.
//
// Highway "inl" header: included once for each instruction set.

#if defined(PENUMBRA_KERNEL_SHAFT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PENUMBRA_KERNEL_SHAFT_INL_H_
#undef PENUMBRA_KERNEL_SHAFT_INL_H_
#else
#define PENUMBRA_KERNEL_SHAFT_INL_H_
#endif

#include <hwy/highway.h>

#include <cstdint>

#include "penumbra/geometry/light_sampling.h"
#include "penumbra/kernel/intersect-inl.h"
#include "penumbra/kernel/wide_tree.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

/// How the slopes D0 and D1 of an axis lie to 0: decides which end of t each half-line bounds.
enum class Slopes : std::uint8_t { rising, falling, widening, narrowing };

struct Shaft {
  Vec3f least_origin, most_origin;  // P0, P1
  float t_max;
  Slopes slopes[3];
  float inverse_least[3], inverse_most[3];  // 1 / D0, 1 / D1
  float spread;                             // the largest D1 - D0
  float pad = box_pad;                      // of boxes, as a share of their reach
};

HWY_INLINE Shaft make_shaft(const Box& origins, Vec3f least, Vec3f most, float t_max) {
  const hn::CappedTag<float, 1> d;
  Shaft shaft{origins.lo, origins.hi, t_max, {}, {}, {}, max_abs(most - least), box_pad};
  for (int axis = 0; axis < 3; ++axis) {
    const bool falls = !(most[axis] >= 0);
    shaft.slopes[axis] = least[axis] >= 0 ? (falls ? Slopes::narrowing : Slopes::rising)
                                          : (falls ? Slopes::falling : Slopes::widening);
    shaft.inverse_least[axis] = hn::GetLane(safe_reciprocal(d, hn::Set(d, least[axis])));
    shaft.inverse_most[axis] = hn::GetLane(safe_reciprocal(d, hn::Set(d, most[axis])));
  }
  return shaft;
}

/// The shaft around the rays first + i for the bits i of `active`.
inline Shaft make_shaft(const LightSamples& rays, std::uint32_t first, std::uint32_t active) {
  Vec3f least{FLT_MAX, FLT_MAX, FLT_MAX}, most = -least;
  for (; active != 0; active &= active - 1) {
    const std::uint32_t i = first + static_cast<std::uint32_t>(__builtin_ctz(active));
    const Vec3f direction{rays.x[i], rays.y[i], rays.z[i]};
    least = min(least, direction), most = max(most, direction);
  }
  return make_shaft({rays.origin, rays.origin}, least, most, rays.t_max);
}

/// A single ray.
HWY_INLINE Shaft make_shaft(Vec3f origin, Vec3f direction, float t_max) {
  return make_shaft({origin, origin}, direction, direction, t_max);
}

/// Children of a node that a shaft meets, as bit masks.
struct Overlap {
  std::uint32_t met = 0;   // for some t in [0, t_max]
  std::uint32_t wide = 0;  // there the shaft is wider than half the child's box
};

/// Boxes of a node in lanes as seen from the origins in [least, most], padded by a share of their
/// reach.
template <class V>
struct BoxLanes {
  V lo[3], hi[3];
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE BoxLanes<V> padded_boxes(D d, const WideNode& node, std::size_t first, Vec3f least,
                                    Vec3f most, float share) {
  BoxLanes<V> boxes;
  V reach = hn::Zero(d);
  for (int axis = 0; axis < 3; ++axis) {
    boxes.lo[axis] = hn::Sub(hn::Load(d, node.lo[axis] + first), hn::Set(d, most[axis]));
    boxes.hi[axis] = hn::Sub(hn::Load(d, node.hi[axis] + first), hn::Set(d, least[axis]));
    reach = hn::Max(reach, hn::Max(hn::Abs(boxes.lo[axis]), hn::Abs(boxes.hi[axis])));
  }
  const V pad = hn::Mul(hn::Set(d, share), reach);
  for (int axis = 0; axis < 3; ++axis)
    boxes.lo[axis] = hn::Sub(boxes.lo[axis], pad), boxes.hi[axis] = hn::Add(boxes.hi[axis], pad);
  return boxes;
}

/// Also writes a lower bound of that t for each child.
HWY_INLINE Overlap overlap(const Shaft& shaft, const WideNode& node, float* near_out) {
  const hn::CappedTag<float, WideNode::width> d;
  Overlap result;
  for (std::size_t first = 0; first < WideNode::width; first += hn::Lanes(d)) {
    using V = hn::Vec<decltype(d)>;
    const auto [lo, hi] =
        padded_boxes(d, node, first, shaft.least_origin, shaft.most_origin, shaft.pad);
    V near = hn::Zero(d), far = hn::Set(d, shaft.t_max);
    for (int axis = 0; axis < 3; ++axis) {
      const V at_lo = hn::Mul(lo[axis], hn::Set(d, shaft.inverse_most[axis]));
      const V at_hi = hn::Mul(hi[axis], hn::Set(d, shaft.inverse_least[axis]));
      switch (shaft.slopes[axis]) {
        case Slopes::rising: near = hn::Max(near, at_lo), far = hn::Min(far, at_hi); break;
        case Slopes::falling: near = hn::Max(near, at_hi), far = hn::Min(far, at_lo); break;
        case Slopes::widening: near = hn::Max(near, hn::Max(at_lo, at_hi)); break;
        case Slopes::narrowing: far = hn::Min(far, hn::Min(at_lo, at_hi)); break;
      }
    }
    hn::Store(near, d, near_out + first);
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, hn::Le(near, far), bytes);
    result.met |= std::uint32_t(bytes[0]) << first;
    const V extent =
        hn::Max(hn::Sub(hi[0], lo[0]), hn::Max(hn::Sub(hi[1], lo[1]), hn::Sub(hi[2], lo[2])));
    const V width = hn::Mul(near, hn::Set(d, shaft.spread));
    hn::StoreMaskBits(d, hn::Gt(hn::Add(width, width), extent), bytes);
    result.wide |= std::uint32_t(bytes[0]) << first;
  }
  result.met &= node.used;
  return result;
}

}  // namespace penumbra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include once for each instruction set
