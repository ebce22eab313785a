// SPDX-License-Identifier: MIT
#include "penumbra/scene/emitter_join.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "penumbra/geometry/box.h"
#include "penumbra/geometry/reduced_hull.h"

namespace penumbra {
namespace {

/// So many sets are compared pair by pair.
constexpr std::size_t most_compared = 256;
/// Of the extent of all: how far apart are red and blue, and front and back.
constexpr double color_distance = 0.5, axis_distance = 0.15;
/// Cosine of how far fronts may be turned from their mean and still be one.
constexpr double same_front = 0.94;

/// Place, colour and direction.
using Feature = std::array<double, 9>;

struct Set {
  std::vector<std::size_t> pieces;
  Feature mean{}, square{};  ///< weighted by power
  double weight = 0;
  double cost() const {
    double sum = 0;
    for (std::size_t i = 0; i < mean.size(); ++i) sum += spread(i);
    return sum;
  }
  /// Sum of weighted squares about the mean.
  double spread(std::size_t i) const {
    return std::max(0.0, square[i] - weight * mean[i] * mean[i]);
  }
};

double weight_of(const EmitterPiece& piece) {
  return piece.power.x + piece.power.y + piece.power.z;
}

std::vector<Feature> features_of(std::span<const EmitterPiece> pieces) {
  Box box;
  for (const EmitterPiece& piece : pieces) box.add(Vec3f(piece.center));
  const Vec3d middle = (Vec3d(box.lo) + Vec3d(box.hi)) * 0.5;
  const double size = length(Vec3d(box.hi) - Vec3d(box.lo));
  std::vector<Feature> features;
  for (const EmitterPiece& piece : pieces) {
    const Vec3d place = piece.center - middle;
    const Vec3d color = piece.power * (color_distance * size / weight_of(piece));
    const Vec3d axis =
        piece.shines == Shines::front ? piece.axis * (axis_distance * size) : Vec3d{};
    features.push_back(
        {place.x, place.y, place.z, color.x, color.y, color.z, axis.x, axis.y, axis.z});
  }
  return features;
}

Set set_of(std::vector<std::size_t> pieces, std::span<const EmitterPiece> all,
           std::span<const Feature> features) {
  Set set;
  for (const std::size_t piece : pieces) {
    const double weight = weight_of(all[piece]);
    set.weight += weight;
    for (std::size_t i = 0; i < set.mean.size(); ++i) {
      const double x = features[piece][i];
      set.mean[i] += weight * x, set.square[i] += weight * x * x;
    }
  }
  for (double& x : set.mean) x /= set.weight;
  set.pieces = std::move(pieces);
  return set;
}

/// What the cost of both grows by when they become one.
double growth(const Set& a, const Set& b) {
  double distance = 0;
  for (std::size_t i = 0; i < a.mean.size(); ++i)
    distance += (a.mean[i] - b.mean[i]) * (a.mean[i] - b.mean[i]);
  return a.weight * b.weight / (a.weight + b.weight) * distance;
}

/// Cuts the set of the highest cost in two, across its longest extent, as long as there are too
/// few.
std::vector<Set> coarse_sets(std::span<const EmitterPiece> pieces,
                             std::span<const Feature> features) {
  std::vector<std::size_t> all(pieces.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::vector<Set> sets;
  sets.push_back(set_of(std::move(all), pieces, features));
  while (sets.size() < most_compared) {
    const auto worst = std::max_element(
        sets.begin(), sets.end(), [](const Set& a, const Set& b) { return a.cost() < b.cost(); });
    std::size_t axis = 0;
    for (std::size_t i = 1; i < worst->mean.size(); ++i)
      if (worst->spread(i) > worst->spread(axis)) axis = i;
    std::array<std::vector<std::size_t>, 2> halves;
    for (const std::size_t piece : worst->pieces)
      halves[features[piece][axis] > worst->mean[axis] ? 1 : 0].push_back(piece);
    if (halves[0].empty() || halves[1].empty()) break;
    *worst = set_of(std::move(halves[0]), pieces, features);
    sets.push_back(set_of(std::move(halves[1]), pieces, features));
  }
  return sets;
}

}  // namespace

std::vector<std::vector<std::size_t>> groups_of(std::span<const EmitterPiece> pieces,
                                                std::size_t most) {
  const std::vector<Feature> features = features_of(pieces);
  std::vector<Set> sets;
  if (pieces.size() <= most_compared)
    for (std::size_t i = 0; i < pieces.size(); ++i) sets.push_back(set_of({i}, pieces, features));
  else
    sets = coarse_sets(pieces, features);
  while (sets.size() > most) {
    std::size_t best_a = 0, best_b = 1;
    double least = growth(sets[0], sets[1]);
    for (std::size_t b = 1; b < sets.size(); ++b)
      for (std::size_t a = 0; a < b; ++a)
        if (const double cost = growth(sets[a], sets[b]); cost < least)
          best_a = a, best_b = b, least = cost;
    std::vector<std::size_t> both = std::move(sets[best_a].pieces);
    both.insert(both.end(), sets[best_b].pieces.begin(), sets[best_b].pieces.end());
    sets[best_a] = set_of(std::move(both), pieces, features);
    sets.erase(sets.begin() + static_cast<std::ptrdiff_t>(best_b));
  }
  std::vector<std::vector<std::size_t>> groups;
  for (Set& set : sets) {
    std::sort(set.pieces.begin(), set.pieces.end());
    groups.push_back(std::move(set.pieces));
  }
  std::sort(groups.begin(), groups.end());
  return groups;
}

EmitterPiece joined(std::span<const EmitterPiece> pieces, std::span<const std::size_t> group) {
  EmitterPiece all = pieces[group[0]];
  if (group.size() == 1) return all;
  all.is_joined = true;
  all.ball.reset();
  all.points.clear();
  all.field = {};
  Vec3d power, center, axis;
  bool is_front = true, is_both = true;
  for (const std::size_t i : group) {
    const EmitterPiece& piece = pieces[i];
    all.points.insert(all.points.end(), piece.points.begin(), piece.points.end());
    add(all.field, piece.field);
    power += piece.power;
    center += piece.center * weight_of(piece);
    // Of what shines to both sides either normal will do.
    const bool is_turned = piece.shines == Shines::both && dot(axis, piece.axis) < 0;
    axis += piece.axis * (is_turned ? -weight_of(piece) : weight_of(piece));
    is_front = is_front && piece.shines == Shines::front;
    is_both = is_both && piece.shines == Shines::both;
  }
  constexpr std::size_t most_points = 256;
  all.points = extreme_points(all.points, most_points);
  all.power = power;
  all.center = center / weight_of(all);
  all.axis = normalize(axis);
  for (const std::size_t i : group) {
    const double cosine = dot(pieces[i].axis, all.axis);
    is_front = is_front && cosine > same_front;
    is_both = is_both && std::abs(cosine) > same_front;
  }
  all.shines = is_front ? Shines::front : is_both ? Shines::both : Shines::around;
  if (all.shines == Shines::around) all.axis = {};
  return all;
}

}  // namespace penumbra
