// SPDX-License-Identifier: MIT
#include "penumbra/shadow/sheet.h"

#include <algorithm>

// Highway compiles the rest once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "penumbra/shadow/sheet_covers.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "penumbra/shadow/sight_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

/// Triangles as the search sees them; from the receivers' centre.
struct SheetLanes {
  LaneVec v[3], e[3];  // corners, edges from corner k
  Lane far[3];         // of the corners
  Lane side;           // of the plane that the receivers lie on, by the corners' turn: 1 or -1
  Lane margin;         // twice what hits may lie off
};

/// Which triangles have the receivers and the light surely on opposite sides of their plane.
/// Slivers have no side to speak of, nor has what is too near beside the light.
HWY_INLINE LaneMask stands_between(const SightLanes& sight, SheetLanes& t) {
  const Lane reach = max_of(largest(t.v[0]), largest(t.v[1]), largest(t.v[2]));
  t.margin = hn::Add(hn::Mul(all(0x1p-17f), hn::Add(reach, all(sight.radius))), all(2 * tiny));
  for (int k = 0; k < 3; ++k) t.far[k] = norm(t.v[k]);
  const LaneVec normal = cross(t.e[0], t.e[1]);
  const Lane size = norm(normal), edges = hn::Mul(norm(t.e[0]), norm(t.e[1]));
  const Lane height = hn::Neg(dot(normal, t.v[0])), rounding = hn::Mul(all(sum_pad), edges);
  t.side = hn::CopySign(all(1.0f), height);
  const LaneVec up = scaled(normal, t.side);
  const Lane above = hn::Abs(height), kept_off = hn::Mul(t.margin, size);
  const Lane clear =
      hn::Add(hn::Add(kept_off, hn::Mul(size, all(sight.radius))), hn::Mul(rounding, t.far[0]));
  const Lane light = hn::Add(hn::Add(above, dot(up, sight.way)), sight.extent(up, size));
  const Lane light_pad = hn::Add(kept_off, hn::Mul(rounding, hn::Add(t.far[0], sight.reach)));
  const LaneMask in_range =
      hn::And(hn::Gt(reach, sight.least_reach),
              hn::Gt(size, hn::Max(hn::Mul(all(0x1p-14f), edges), all(1e-30f))));
  return hn::And(in_range, hn::And(hn::Gt(above, hn::Max(clear, all(1e-30f))),
                                   hn::Lt(hn::Add(light, light_pad), hn::Zero(lane_tag))));
}

/// Where all segments from receivers to samples cross the plane of the triangle on the inner side
/// of its edge k: there is a plane through the edge that has the triangle, the receivers and the
/// light on one side, each by a margin. That plane is the one through the centre and the edge,
/// turned about the edge away from the receivers.
HWY_INLINE LaneMask stays_inside(const SightLanes& sight, const SheetLanes& t, int k) {
  const LaneVec &a = t.v[k], &e = t.e[k];
  const LaneVec level = scaled(cross(a, e), t.side);
  const Lane level_square = dot(level, level), square = dot(e, e);
  const Lane length = hn::Sqrt(square), apart_square = hn::Div(level_square, square);
  const Lane apart = hn::Sqrt(apart_square);  // of the centre from the edge's line
  // What float loses of the plane is worse the more slanted the edge is seen.
  const Lane margin =
      hn::Add(t.margin, hn::Div(hn::Mul(all(0x1p-18f), hn::Mul(t.far[k], t.far[k])), apart));
  const Lane kept_off = hn::Add(all(sight.radius * (1 + sum_pad)), margin);
  const Lane turn = hn::Div(hn::Mul(kept_off, length),
                            hn::Sqrt(hn::Sub(apart_square, hn::Mul(kept_off, kept_off))));
  const LaneVec to = along(a, hn::Neg(hn::Div(dot(a, e), square)), e);
  const LaneVec out = along(level, turn, to);
  const Lane size = hn::Sqrt(hn::Add(level_square, hn::Mul(hn::Mul(turn, turn), apart_square)));
  const Lane rounding = hn::Mul(all(sum_pad), hn::Mul(t.far[k], hn::Add(length, turn)));
  const Lane light = hn::Add(hn::Sub(dot(out, sight.way), dot(out, a)), sight.extent(out, size));
  const Lane light_pad =
      hn::Add(hn::Mul(rounding, hn::Add(t.far[k], sight.reach)), hn::Mul(margin, size));
  const LaneVec third = sub(t.v[(k + 2) % 3], a);
  const LaneMask is_before =
      hn::Lt(hn::Add(dot(out, third), hn::Mul(rounding, norm(third))), hn::Zero(lane_tag));
  return hn::And(hn::And(hn::Gt(apart, kept_off), is_before),
                 hn::Lt(hn::Add(light, light_pad), hn::Zero(lane_tag)));
}

struct SheetBits {
  std::uint32_t between, on_left;  // left: side is 1
  std::uint32_t inside[3];
};

HWY_INLINE SheetBits test_sheet(const SightLanes& sight, const RecordRun& records,
                                std::span<const TriangleSheet::Member> members) {
  alignas(64) float corner[9][lane_count] = {};
  Record room;
  for (std::size_t lane = 0; lane < members.size(); ++lane) {
    const Record& record = records.get(members[lane].record, room);
    for (int i = 0; i < 9; ++i) corner[i][lane] = record.number[i];
  }
  SheetLanes t;
  for (int k = 0; k < 3; ++k)
    t.v[k] = sub({hn::Load(lane_tag, corner[3 * k]), hn::Load(lane_tag, corner[3 * k + 1]),
                  hn::Load(lane_tag, corner[3 * k + 2])},
                 sight.p);
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    t.e[k] = sub({hn::Load(lane_tag, corner[3 * next]), hn::Load(lane_tag, corner[3 * next + 1]),
                  hn::Load(lane_tag, corner[3 * next + 2])},
                 {hn::Load(lane_tag, corner[3 * k]), hn::Load(lane_tag, corner[3 * k + 1]),
                  hn::Load(lane_tag, corner[3 * k + 2])});
  }
  SheetBits bits;
  bits.between = bits_of(stands_between(sight, t));
  bits.on_left = bits_of(hn::Gt(t.side, hn::Zero(lane_tag)));
  for (int k = 0; k < 3; ++k) bits.inside[k] = bits_of(stays_inside(sight, t, k));
  return bits;
}

bool SheetCovers(const TriangleSheet::Part& sheet, const RecordRun& records, const SeenLight& light,
                 std::uint32_t start, std::uint32_t most_triangles, SheetScratch& scratch,
                 std::uint64_t& tests) {
  const SightLanes sight(light);
  scratch.clear();
  scratch.insert({start, false});
  const std::uint32_t most = std::min(most_triangles, SheetScratch::most);
  bool is_left = false;
  for (std::size_t first = 0; first < scratch.found().size(); first += lane_count) {
    std::array<TriangleSheet::Member, lane_count> members;
    const std::size_t count = std::min(lane_count, scratch.found().size() - first);
    std::copy_n(scratch.found().begin() + static_cast<std::ptrdiff_t>(first), count,
                members.begin());
    tests += count;
    const SheetBits bits = test_sheet(sight, records, {members.data(), count});
    for (std::size_t lane = 0; lane < count; ++lane) {
      const bool lane_is_left = (bits.on_left >> lane & 1) != members[lane].is_turned;
      if (first + lane == 0) is_left = lane_is_left;
      if (!(bits.between >> lane & 1) || lane_is_left != is_left) return false;
      for (int k = 0; k < 3; ++k) {
        if (bits.inside[k] >> lane & 1) continue;
        const TriangleSheet::Member next = sheet.across(members[lane], k);
        if (next.record == no_record) return false;
        if (scratch.insert(next) == SheetScratch::Insert::contradicts ||
            scratch.found().size() > most)
          return false;
      }
    }
    // A group may end before its lanes are full: the next begins where this one ended.
    first -= lane_count - count;
  }
  return true;
}

}  // namespace penumbra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace penumbra {

HWY_EXPORT(SheetCovers);

bool sheet_covers(const TriangleSheet& sheet, const RecordTable& records, const SeenLight& light,
                  std::uint32_t start, std::uint32_t most_triangles, SheetScratch& scratch,
                  std::uint64_t& tests) {
  const RecordRun run = records.run_of(start);
  const TriangleSheet::Part part = sheet.part_of(run);
  Record room;
  const Record& first = run.get(start, room);
  if (!part.neighbors || first.kind != ShapeKind::triangle || !first.casts_shadow) return false;
  return HWY_DYNAMIC_DISPATCH(SheetCovers)(part, run, light, start, most_triangles, scratch, tests);
}

}  // namespace penumbra
#endif
