// SPDX-License-Identifier: MIT
#include "penumbra/kernel/placement.h"

#include <cfloat>
#include <cmath>

#include "penumbra/geometry/placed_shape.h"
#include "penumbra/kernel/wide_tree.h"

namespace penumbra {
namespace {

Vec3f point(const Placement& placement, Vec3f p) {
  return Vec3f(apply_point(placement.map, Vec3d(p)));
}

Vec3f direction(const Placement& placement, Vec3f v) {
  return Vec3f(normalize(apply_direction(placement.map, Vec3d(v))));
}

float length(const Placement& placement, float l) {
  return static_cast<float>(l * placement.scale);
}

void set(Record& record, int first, Vec3f v) {
  record.number[first] = v.x, record.number[first + 1] = v.y, record.number[first + 2] = v.z;
}

}  // namespace

Placement make_placement(const Transform& map, const WideNode& root, std::uint32_t group,
                         std::uint32_t first) {
  Placement placement{map, similarity_scale(map), group, first};
  const Vec3d axis[3] = {map.x_axis, map.y_axis, map.z_axis};
  const Box group_box = bounds(root);
  const Vec3f reach = max(max(group_box.hi, -group_box.lo), Vec3f{});
  for (int row = 0; row < 3; ++row) {
    // What is round may be turned, by what a similarity is off, from any row into any other.
    double sum = std::abs(map.offset[row]) + placement.scale * double(max_abs(reach));
    placement.offset[row] = static_cast<float>(map.offset[row]);
    for (int column = 0; column < 3; ++column) {
      placement.matrix[row][column] = static_cast<float>(axis[column][row]);
      sum += std::abs(axis[column][row]) * reach[column];
    }
    // Boxes lose eight roundings of 2^-24 here, records one or two of theirs; a map that is a
    // similarity to 2^-22 moves what is round by less than four times that.
    // FLT_MIN: entries and products may underflow.
    const double underflow = FLT_MIN * (1 + reach.x + reach.y + reach.z);
    placement.pad[row] = static_cast<float>(sum * 0x1p-19 + underflow);
  }
  for (int child = 0; child < WideNode::width; ++child)
    if (root.used >> child & 1) placement.box.add(placed(box_of(root, child), map));
  const Vec3f pad{placement.pad[0], placement.pad[1], placement.pad[2]};
  placement.box = {placement.box.lo - pad, placement.box.hi + pad};
  return placement;
}

Record placed(const Record& record, const Placement& placement) {
  Record out = record;
  out.id += placement.first;
  set(out, 0, point(placement, record.vector(0)));
  switch (record.kind) {
    case ShapeKind::sphere: out.number[3] = length(placement, record.number[3]); break;
    case ShapeKind::cone:
      set(out, 3, direction(placement, record.vector(3)));
      for (int i = 6; i < 9; ++i) out.number[i] = length(placement, record.number[i]);
      break;
    case ShapeKind::ring:
      set(out, 3, direction(placement, record.vector(3)));
      for (int i = 6; i < 8; ++i) out.number[i] = length(placement, record.number[i]);
      break;
    case ShapeKind::triangle:
      set(out, 3, point(placement, record.vector(3)));
      set(out, 6, point(placement, record.vector(6)));
      break;
  }
  return out;
}

}  // namespace penumbra
