// SPDX-License-Identifier: MIT
#include "penumbra/shadow/sift.h"

// Highway compiles the rest once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "penumbra/shadow/sift.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "penumbra/shadow/sift_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

/// Sixteen columns of a list.
struct ColumnLanes {
  template <class Rows>
  static HWY_INLINE Lane load(const Rows& rows, std::size_t row, std::size_t first) {
    return hn::LoadU(lane_tag, rows.row[row] + first);
  }
};

/// One column in all lanes.
struct ColumnBroadcast {
  template <class Rows>
  static HWY_INLINE Lane load(const Rows& rows, std::size_t row, std::size_t column) {
    return all(rows.row[row][column]);
  }
};

template <class Columns, class Rows>
HWY_INLINE LaneVec load3(const Rows& rows, std::size_t row, std::size_t at) {
  return {Columns::load(rows, row, at), Columns::load(rows, row + 1, at),
          Columns::load(rows, row + 2, at)};
}

// One test a kind: which lanes are missed, and which are covered.
template <class Columns>
HWY_INLINE Verdict test(const SightLanes& sight, const SphereCandidates& spheres, std::size_t at) {
  return test_spheres(sight, load3<Columns>(spheres, 0, at), Columns::load(spheres, 3, at));
}
template <class Columns>
HWY_INLINE Verdict test(const SightLanes& sight, const RingCandidates& rings, std::size_t at) {
  return {rings_missed(sight, load3<Columns>(rings, 0, at), load3<Columns>(rings, 3, at),
                       Columns::load(rings, 6, at)),
          none()};
}
template <class Columns>
HWY_INLINE Verdict test(const SightLanes& sight, const ConeCandidates& r, std::size_t at) {
  return {cones_missed(sight,
                       {load3<Columns>(r, 0, at), load3<Columns>(r, 3, at), Columns::load(r, 6, at),
                        Columns::load(r, 7, at), Columns::load(r, 8, at)}),
          none()};
}
template <class Columns>
HWY_INLINE Verdict test(const SightLanes& sight, const TriangleCandidates& r, std::size_t at) {
  return {triangles_missed(sight, {{load3<Columns>(r, 0, at), load3<Columns>(r, 3, at),
                                    load3<Columns>(r, 6, at)}}),
          none()};
}

/// Lanes that hold candidates.
HWY_INLINE std::uint32_t used_lanes(std::size_t count, std::size_t first) {
  const std::size_t left = count - first;
  return left >= lane_count ? (1u << lane_count) - 1 : (1u << left) - 1;
}

HWY_INLINE std::uint32_t first_bit(std::uint32_t bits) {
  return static_cast<std::uint32_t>(__builtin_ctz(bits));
}

/// Calls f(rows) for each kind, spheres first, until f returns false.
template <class F>
HWY_INLINE void each_kind(const CandidateList& list, F&& f) {
  if (f(list.spheres) && f(list.rings) && f(list.cones)) f(list.triangles);
}

void Sift(const CandidateList& list, const SeenLight& light, Sifted& out) {
  const SightLanes sight(light);
  out.record.clear();
  out.cover = no_record;
  each_kind(list, [&](const auto& rows) {
    for (std::size_t first = 0; first < rows.count; first += lane_count) {
      const Verdict verdict = test<ColumnLanes>(sight, rows, first);
      const std::uint32_t used = used_lanes(rows.count, first);
      if (const std::uint32_t covers = bits_of(verdict.covers) & used) {
        out.cover = rows.index[first + first_bit(covers)];
        return false;
      }
      for (std::uint32_t kept = ~bits_of(verdict.missed) & used; kept != 0; kept &= kept - 1)
        out.record.push_back(rows.index[first + first_bit(kept)]);
    }
    return true;
  });
}

/// Appends the columns of a group of lanes that are kept.
template <class Rows>
HWY_INLINE void copy(const Rows& from, std::size_t first, std::uint32_t kept, Rows& to) {
  if (kept == 0) return;
  const hn::Rebind<std::uint32_t, LaneTag> index_tag;
  const LaneMask mask = mask_of(kept);
  for (std::size_t row = 0; row < std::size(from.row); ++row)
    hn::StoreU(hn::Compress(ColumnLanes::load(from, row, first), mask), lane_tag,
               to.row[row] + to.count);
  hn::StoreU(
      hn::Compress(hn::LoadU(index_tag, from.index + first), hn::RebindMask(index_tag, mask)),
      index_tag, to.index + to.count);
  to.count += static_cast<std::uint32_t>(__builtin_popcount(kept));
}

std::uint32_t SiftForAll(const CandidateList& list, const SeenLight& light, CandidateList& out) {
  const SightLanes sight(light);
  out.clear();
  std::uint32_t cover = no_record;
  const auto sift_kind = [&](const auto& rows, auto& kept_rows) {
    for (std::size_t first = 0; first < rows.count; first += lane_count) {
      const Verdict verdict = test<ColumnLanes>(sight, rows, first);
      const std::uint32_t used = used_lanes(rows.count, first);
      if (const std::uint32_t covers = bits_of(verdict.covers) & used) {
        cover = rows.index[first + first_bit(covers)];
        return;
      }
      copy(rows, first, ~bits_of(verdict.missed) & used, kept_rows);
    }
  };
  sift_kind(list.spheres, out.spheres);
  if (cover != no_record) return cover;
  sift_kind(list.rings, out.rings);
  sift_kind(list.cones, out.cones);
  sift_kind(list.triangles, out.triangles);
  return no_record;
}

void SiftRows(const CandidateList& list, const LightForm& light, const ReceiverGroup& group,
              SiftedRows& out) {
  out.candidate.clear();
  out.covered = out.kept = 0;
  each_kind(list, [&](const auto& rows) {
    for (std::size_t column = 0; column < rows.count; ++column) {
      std::uint64_t kept = 0;
      for (std::size_t first = 0; first < group.count; first += lane_count) {
        const SightLanes sight(light, group.rows, group.first + first);
        const Verdict verdict = test<ColumnBroadcast>(sight, rows, column);
        const std::uint32_t used = used_lanes(group.count, first);
        kept |= std::uint64_t(~bits_of(verdict.missed) & used) << first;
        out.covered |= std::uint64_t(bits_of(verdict.covers) & used) << first;
      }
      if (kept == 0) continue;
      out.kept |= kept;
      out.candidate.push_back({rows.index[column], kept});
    }
    return true;
  });
}

}  // namespace penumbra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace penumbra {

HWY_EXPORT(Sift);
HWY_EXPORT(SiftForAll);
HWY_EXPORT(SiftRows);

void sift(const CandidateList& list, const SeenLight& light, Sifted& out) {
  HWY_DYNAMIC_DISPATCH(Sift)(list, light, out);
}

std::uint32_t sift_for_all(const CandidateList& list, const SeenLight& light, CandidateList& out) {
  return HWY_DYNAMIC_DISPATCH(SiftForAll)(list, light, out);
}

void sift_rows(const CandidateList& list, const LightForm& light, const ReceiverGroup& group,
               SiftedRows& out) {
  HWY_DYNAMIC_DISPATCH(SiftRows)(list, light, group, out);
}

}  // namespace penumbra
#endif
