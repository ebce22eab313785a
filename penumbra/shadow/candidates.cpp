// SPDX-License-Identifier: MIT
#include "penumbra/shadow/candidates.h"

#include <cmath>

#include "penumbra/shadow/sift.h"

namespace penumbra {
namespace {

struct Ball {
  Vec3f center;
  float radius;
};

/// A ball that holds the record's hull, rounded up.
Ball ball_around(const Record& record) {
  switch (record.kind) {
    case ShapeKind::sphere: return {record.vector(0), record.number[3]};
    case ShapeKind::ring: return {record.vector(0), record.number[6] * 1.00001f};
    case ShapeKind::cone:
    case ShapeKind::triangle: break;
  }
  const Box box = bounds(record);
  const Vec3d axis(record.vector(3)),
      middle = Vec3d(record.vector(0)) + axis * (0.5 * double(record.number[6]));
  const double radius = std::hypot(0.5 * double(record.number[6]),
                                   double(std::max(record.number[7], record.number[8])));
  const double rounding = 1e-6 * (max_abs(middle) + max_abs(Vec3d(box.size())));
  return {Vec3f(middle), round_up(radius * (1 + 1e-6) + rounding)};
}

}  // namespace

void CandidateList::clear() {
  balls_ = triangles_ = 0;
  for (std::vector<float>& numbers : ball_) numbers.clear();
  for (std::vector<float>& numbers : triangle_) numbers.clear();
  ball_record_.clear(), triangle_record_.clear();
}

void CandidateList::add(const Record& record, std::uint32_t index) {
  if (record.kind == ShapeKind::triangle) {
    if (triangles_ % lanes == 0)
      for (std::vector<float>& numbers : triangle_) numbers.resize(triangles_ + lanes);
    for (int i = 0; i < 9; ++i) triangle_[i][triangles_] = record.number[i];
    triangle_record_.push_back(index);
    ++triangles_;
    return;
  }
  const Ball ball = ball_around(record);
  if (balls_ % lanes == 0)
    for (std::vector<float>& numbers : ball_) numbers.resize(balls_ + lanes);
  for (int axis = 0; axis < 3; ++axis) ball_[axis][balls_] = ball.center[axis];
  ball_[3][balls_] = ball.radius;
  ball_record_.push_back(index);
  ++balls_;
}

void CandidateList::sift(const LightHull& light, Vec3f p, std::vector<std::uint32_t>& out) const {
  if (size() == 0) return;
  const SeenLight seen = seen_light(light, p);
  for (std::size_t first = 0; first < balls_; first += lanes) {
    const float* const group[4] = {&ball_[0][first], &ball_[1][first], &ball_[2][first],
                                   &ball_[3][first]};
    std::uint32_t kept = sift_balls(group, seen, p);
    if (balls_ - first < lanes) kept &= (1u << (balls_ - first)) - 1;
    for (; kept != 0; kept &= kept - 1)
      out.push_back(ball_record_[first + static_cast<std::size_t>(__builtin_ctz(kept))]);
  }
  for (std::size_t first = 0; first < triangles_; first += lanes) {
    const float* group[9];
    for (int i = 0; i < 9; ++i) group[i] = &triangle_[i][first];
    std::uint32_t kept = sift_triangles(group, seen, p);
    if (triangles_ - first < lanes) kept &= (1u << (triangles_ - first)) - 1;
    for (; kept != 0; kept &= kept - 1)
      out.push_back(triangle_record_[first + static_cast<std::size_t>(__builtin_ctz(kept))]);
  }
}

}  // namespace penumbra
