// SPDX-License-Identifier: MIT
#include "penumbra/shadow/seen_light.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace penumbra {

void keep_rows(std::uint64_t bits, ReceiverRows& rows) {
  std::size_t to = 0;
  for (; bits != 0; bits &= bits - 1, ++to) {
    const auto from = static_cast<std::size_t>(std::countr_zero(bits));
    if (from == to) continue;
    for (int axis = 0; axis < 3; ++axis) {
      rows.p[axis][to] = rows.p[axis][from];
      rows.normal[axis][to] = rows.normal[axis][from];
      rows.way[axis][to] = rows.way[axis][from];
    }
    rows.distance[to] = rows.distance[from], rows.doubt[to] = rows.doubt[from];
  }
  rows.count = to;
}

namespace {

Vec3f column(const float (&row)[3][ReceiverRows::padded], std::size_t i) {
  return {row[0][i], row[1][i], row[2][i]};
}

}  // namespace

Box ReceiverGroup::bounds() const {
  Box box;
  for (std::size_t i = first; i < first + count; ++i) box.add(column(rows.p, i));
  return box;
}

SeenLight seen_by_one(const LightForm& light, const ReceiverRows& rows, std::size_t index) {
  return {.light = &light,
          .p = column(rows.p, index),
          .normal = column(rows.normal, index),
          .way = column(rows.way, index),
          .distance = rows.distance[index],
          .size = light.size,
          .doubt = rows.doubt[index]};
}

SeenLight seen_part(const SeenLight& sight, const LightSamples& samples, std::uint32_t word,
                    std::uint32_t bits) {
  Box box;
  for (; bits != 0; bits &= bits - 1) {
    const std::uint32_t i = 32 * word + static_cast<std::uint32_t>(std::countr_zero(bits));
    box.add({samples.x[i], samples.y[i], samples.z[i]});
  }
  // A sun's samples are unit directions, and the rays go on.
  const float scale = sight.light->is_sun ? sight.distance : 1;
  SeenLight part = sight;
  part.counts_as_ball = true;
  part.way = box.center() * scale, part.distance = length(part.way);
  part.size = length(box.size()) * (0.5f * (1 + 0x1p-20f) * scale);
  part.doubt = 0x1p-20f * (part.distance + part.size);
  return part;
}

bool is_apart(const SeenLight& seen) {
  return seen.distance > (seen.size + seen.receiver_radius) * (1 + 0x1p-20f) + 8 * seen.doubt;
}

SeenLight seen_by_all(const LightForm& light, const ReceiverGroup& group) {
  const ReceiverRows& rows = group.rows;
  const Box box = group.bounds();
  SeenLight seen;
  seen.light = &light, seen.counts_as_ball = true, seen.size = light.size;
  seen.p = box.center();
  Vec3f up;
  for (std::size_t i = group.first; i < group.first + group.count; ++i)
    up += column(rows.normal, i);
  seen.normal = up = normalize(up);
  float square = 0, floor = 0;
  for (std::size_t i = group.first; i < group.first + group.count; ++i) {
    const Vec3f off = column(rows.p, i) - seen.p;
    square = std::max(square, length_squared(off));
    floor = std::min(floor, dot(up, off));
    seen.doubt = std::max(seen.doubt, rows.doubt[i]);
  }
  constexpr float pad = 0x1p-20f;
  const float radius = std::sqrt(square) * (1 + pad);
  const Vec3f to = light.is_sun ? light.center : (light.center - seen.p) + light.center_rest;
  seen.way = to, seen.distance = length(to), seen.receiver_radius = radius;
  // A sun moves with the receivers; what float loses of p and way is doubt.
  seen.doubt += (light.is_sun ? radius : 0) + pad * (max_abs(seen.p) + seen.distance);
  floor -= pad * radius;
  const float lowest =
      dot(up, to) - (light.size + seen.doubt) * (1 + pad) - pad * (seen.distance + radius);
  seen.floor = group.are_above && lowest > floor ? floor : -std::numeric_limits<float>::infinity();
  return seen;
}

}  // namespace penumbra
