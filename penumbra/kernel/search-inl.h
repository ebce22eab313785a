// SPDX-License-Identifier: MIT
// One closest-hit search over records, for both kernels.
//
// Highway "inl" header: included once for each instruction set.

#if defined(PENUMBRA_KERNEL_SEARCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PENUMBRA_KERNEL_SEARCH_INL_H_
#undef PENUMBRA_KERNEL_SEARCH_INL_H_
#else
#define PENUMBRA_KERNEL_SEARCH_INL_H_
#endif

#include <hwy/highway.h>

#include "penumbra/kernel/intersect-inl.h"
#include "penumbra/kernel/traverse.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

/// What one closest-hit search knows so far.
struct Search {
  NearestRecord nearest;
  float t_min, t_max;
};

/// The record has this index.
template <class D>
HWY_INLINE void search_record(D d, const Record& record, std::uint32_t index, Vec3f origin,
                              const RayLanes<D>& ray, Search& search) {
  intersect(d, record, origin, ray, [&](auto t, auto hit) {
    const float at = hn::GetLane(t);
    NearestRecord& best = search.nearest;
    if (!hn::AllTrue(d, hit) || !(at > search.t_min && at < search.t_max)) return;
    if (best.record != no_record && !(at < best.t || (at == best.t && record.id < best.id))) return;
    if (hn::AllFalse(d, confirm(d, record, origin, ray, t, hit))) return;
    best.t = at, best.record = index, best.id = record.id;
  });
}

}  // namespace penumbra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include once for each instruction set
