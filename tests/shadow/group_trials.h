// SPDX-License-Identifier: MIT
// Groups of receivers before a light that grows or moves, and what the judge says of its rays: for
// the tests of what the shaft method asks.
#pragma once

#include <vector>

#include "penumbra/geometry/sample_loops.h"
#include "penumbra/shadow/light_form.h"
#include "penumbra/shadow/seen_light.h"
#include "tests/shadow/light_rays.h"
#include "tests/shadow/offset_trials.h"

namespace penumbra::trials {

/// Lights that differ by t in [0, 1], and who looks at them.
class GroupTrial {
 public:
  /// Around the receiver and the light of `first`; `place_one()` gives other receivers to choose
  /// from.
  template <class PlaceOne>
  GroupTrial(const char* light_kind, const OffsetTrial& first, double scale, PlaceOne place_one,
             Random& random)
      : kind_(light_kind), figure_(first.figure), center_(first.center), p_(first.p) {
    const bool grows = random.one_in(2);
    smallest_ = grows ? first.size * double(random.power(-3, 0)) : first.size;
    largest_ = grows ? first.size * double(random.power(0, 1)) : first.size;
    if (!grows) shift_ = random.direction() * (scale * double(random.power(-3, 1)));
    add_receivers(first, scale, place_one, random);
  }

  LightShape light(double t) const {
    return make_light(kind_, figure_, center_ + shift_ * t, smallest_ + (largest_ - smallest_) * t,
                      p_);
  }
  const std::vector<ShadowQuery>& queries() const { return queries_; }

 private:
  template <class PlaceOne>
  void add_receivers(const OffsetTrial& first, double scale, PlaceOne place_one, Random& random) {
    const std::uint32_t count = random.one_in(3)   ? 1
                                : random.one_in(8) ? 1 + random.below(64)
                                                   : 1 + random.below(8);
    const std::uint32_t spread = random.below(4), normals = random.below(3);
    const float step = float(scale) * random.power(-7, 0.5f);
    for (std::uint32_t i = 0; i < count; ++i) {
      Receiver receiver{first.p, first.normal};
      if (i > 0 && spread == 1) receiver.position = first.p + random.in_cube() * step;
      if (i > 0 && spread > 1) receiver = place_one();
      if (spread == 2)  // drawn near to the first
        receiver.position =
            first.p + (receiver.position - first.p) * std::min(1.0f, step / float(scale));
      if (normals == 1) receiver.normal = normalize(Vec3f(center_) - receiver.position);
      if (normals == 2)
        receiver.normal = normalize(receiver.normal + random.in_cube() * random.power(-4, 0));
      queries_.push_back({receiver, i});
    }
  }

  const char* kind_;
  LightFigure figure_;
  Vec3d center_, shift_;
  Vec3f p_;
  double smallest_ = 0, largest_ = 0;
  std::vector<ShadowQuery> queries_;
};

/// A light and those of its receivers that surely lie outside it and don't have it below them.
struct Watchers {
  Watchers(const LightShape& light_, const std::vector<ShadowQuery>& queries, const Box& shapes)
      : light(light_), form(LightHull(light_, scene_of(shapes, queries))) {
    bits = see_light(form, queries, scene_of(shapes, queries), rows);
    std::uint64_t kept = bits.certain & ~bits.below;
    for (std::size_t i = 0; i < queries.size(); ++i)
      if (!contains(light, queries[i].receiver.position))
        kept |= bits.near & ~bits.below & 1ull << i;
    for (std::size_t i = 0; i < queries.size(); ++i)
      if (kept >> i & 1) {
        above |= (bits.above >> i & 1) << receivers.size();
        receivers.push_back(queries[i].receiver);
      }
    keep_rows(kept, rows);
  }
  /// Of `count` receivers from `first` on.
  ReceiverGroup group(std::size_t first, std::size_t count) const {
    const std::uint64_t wanted = (count < 64 ? (1ull << count) - 1 : ~0ull) << first;
    return {rows, first, count, (above & wanted) == wanted};
  }
  std::size_t count() const { return receivers.size(); }

  LightShape light;
  LightForm form;
  ReceiverRows rows;
  ReceiverBits bits;        ///< of all queries
  std::uint64_t above = 0;  ///< of those that are kept
  std::vector<Receiver> receivers;

 private:
  static Box scene_of(Box shapes, const std::vector<ShadowQuery>& queries) {
    for (const ShadowQuery& query : queries) shapes.add(query.receiver.position);
    return shapes;
  }
};

/// What one receiver's samples, and rays to the light's edge, come to.
struct Judgement {
  LightSamples rays;
  std::vector<std::uint32_t> active;  ///< as bits
  std::uint32_t active_count = 0;
};

inline Judgement judge_rays(const LightShape& light, const Receiver& receiver,
                            const SamplePattern& pattern, std::uint32_t extremes, Random& random) {
  Judgement judge{judging_rays(light, receiver.position, pattern, extremes, random), {}, 0};
  const LightSamples& rays = judge.rays;
  std::vector<float> weight(rays.x.size());
  weigh_directions(receiver.normal, rays.x.data(), rays.y.data(), rays.z.data(), rays.x.size(),
                   weight.data());
  judge.active.resize((rays.count + 31) / 32);
  for (std::uint32_t i = 0; i < rays.count; ++i) {
    const std::uint32_t is_active = !(weight[i] < 0);
    judge.active[i / 32] |= is_active << i % 32, judge.active_count += is_active;
  }
  return judge;
}

/// A t in [0, 1] at which a claim holds, to 2^-20 next to one at which it doesn't; or any, where
/// both are not found.
struct Critical {
  double t = 0;
  bool is_found = false;
};

template <class Claim>
Critical critical(Claim holds) {
  const bool at_start = holds(0.0), at_end = holds(1.0);
  double yes = at_end ? 1 : 0, no = 1 - yes;
  if (at_start == at_end) {
    if (holds(0.5) == at_start) return {0.5, false};
    (at_start ? no : yes) = 0.5;
  }
  for (int i = 0; i < 20; ++i) {
    const double middle = (yes + no) / 2;
    (holds(middle) ? yes : no) = middle;
  }
  return {yes, true};
}

}  // namespace penumbra::trials
