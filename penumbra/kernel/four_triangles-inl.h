// SPDX-License-Identifier: MIT
// One ray against four triangles in lanes: which of them it passes by, exactly as the intersector
// sees it, so that few are left to test for a hit.
//
// Highway "inl" header: included once for each instruction set.

#if defined(PENUMBRA_KERNEL_FOUR_TRIANGLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PENUMBRA_KERNEL_FOUR_TRIANGLES_INL_H_
#undef PENUMBRA_KERNEL_FOUR_TRIANGLES_INL_H_
#else
#define PENUMBRA_KERNEL_FOUR_TRIANGLES_INL_H_
#endif

#include <hwy/highway.h>

#include <cstdint>

#include "penumbra/kernel/lanes-inl.h"
#include "penumbra/kernel/record.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Of a ray's direction what the edge functions need (see RayLanes).
struct Shear {
  float x, y;
  int kz;
};

#if HWY_TARGET == HWY_SCALAR

/// In a single lane there is nothing to win: no triangle is said to be passed by.
struct FourTriangles {
  using D = hn::CappedTag<float, 1>;
  HWY_INLINE FourTriangles(const Record* const*, Vec3f) {}
  HWY_INLINE hn::Mask<D> passed_by(const Shear&) const { return hn::FirstN(D(), 0); }
};

#else

/// Four records as seen from an origin.
class FourTriangles {
 public:
  using D = hn::FixedTag<float, 4>;

  HWY_INLINE FourTriangles(const Record* const* records, Vec3f origin) {
    const float* numbers[4];
    std::uint8_t triangles[8] = {};
    for (int i = 0; i < 4; ++i) {
      numbers[i] = records[i]->number.data();
      triangles[0] |= static_cast<std::uint8_t>((records[i]->kind == ShapeKind::triangle) << i);
    }
    triangles_ = hn::LoadMaskBits(d, triangles);
    V row[12];
    for (int first = 0; first < 12; first += 4) transpose(numbers, first, row + first);
    for (int i = 0; i < 9; ++i) number_[i] = hn::Sub(row[i], hn::Set(d, origin[i % 3]));
  }

  /// The records that are triangles and that the ray's line passes by. The edge functions are those
  /// of intersect_triangle_along, by the same operations, so they have the same bits; where two of
  /// them have opposite signs there is no hit, whatever a third that is 0 is refined to. NaN has
  /// no sign.
  HWY_INLINE hn::Mask<D> passed_by(const Shear& ray) const {
    const int kx = ray.kz == 2 ? 0 : ray.kz + 1, ky = ray.kz == 0 ? 2 : ray.kz - 1;
    V px[3], py[3];
    for (int corner = 0; corner < 3; ++corner) {
      const V* number = number_ + 3 * corner;
      px[corner] = hn::Sub(number[kx], hn::Mul(hn::Set(d, ray.x), number[ray.kz]));
      py[corner] = hn::Sub(number[ky], hn::Mul(hn::Set(d, ray.y), number[ray.kz]));
    }
    const V zero = hn::Zero(d);
    auto negative = hn::FirstN(d, 0), positive = negative;
    for (int k = 0; k < 3; ++k) {
      const int from = (k + 2) % 3, to = (k + 1) % 3;
      const V edge = hn::Sub(hn::Mul(px[from], py[to]), hn::Mul(py[from], px[to]));
      negative = hn::Or(negative, hn::Lt(edge, zero));
      positive = hn::Or(positive, hn::Gt(edge, zero));
    }
    return hn::And(hn::And(negative, positive), triangles_);
  }

 private:
  using V = hn::Vec<D>;
  static constexpr D d{};

  /// Lane i of row[k] becomes number first + k of record i.
  static HWY_INLINE void transpose(const float* const* numbers, int first, V* row) {
    const V a = hn::LoadU(d, numbers[0] + first), b = hn::LoadU(d, numbers[1] + first),
            c = hn::LoadU(d, numbers[2] + first), e = hn::LoadU(d, numbers[3] + first);
    const V low_ab = hn::InterleaveLower(d, a, b), low_ce = hn::InterleaveLower(d, c, e),
            high_ab = hn::InterleaveUpper(d, a, b), high_ce = hn::InterleaveUpper(d, c, e);
    row[0] = hn::ConcatLowerLower(d, low_ce, low_ab);
    row[1] = hn::ConcatUpperUpper(d, low_ce, low_ab);
    row[2] = hn::ConcatLowerLower(d, high_ce, high_ab);
    row[3] = hn::ConcatUpperUpper(d, high_ce, high_ab);
  }

  V number_[9];
  hn::Mask<D> triangles_;
};

#endif

}  // namespace penumbra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include once for each instruction set
