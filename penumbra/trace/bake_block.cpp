// SPDX-License-Identifier: MIT
#include "penumbra/trace/bake_block.h"

#include "penumbra/shadow/hull_proof.h"
#include "penumbra/trace/render.h"
#include "penumbra/trace/texel_points.h"

namespace penumbra {
namespace {

/// One light over one block.
class LightBaker {
 public:
  LightBaker(const BakeContext& context, const TexelPoints& points, std::uint32_t light,
             VisibilityScratch& visibility, BakeCounters& counters)
      : context_(context),
        points_(points),
        light_(light),
        visibility_(visibility),
        counters_(counters),
        known_(points.pieces.size(), ShadowClass::penumbra) {}

  void bake(BakePlanes& planes) {
    if (context_.shadows.method == Method::shaft)
      for (const BakedTriangle& triangle : points_.triangles) prove(triangle);
    ask();
    store(planes);
  }

 private:
  /// A query pays when it saves so many samples.
  static constexpr std::uint32_t fewest_samples = 4;

  /// Of a triangle all that lies in the block.
  void prove(const BakedTriangle& triangle) {
    const Pixel first = points_.texels.front();
    prove(triangle, {double(first.x), double(first.y), double(block_edge)});
  }

  /// Halves the square until what is under it is proven, or few samples are left.
  void prove(const BakedTriangle& triangle, const TexelSquare& square) {
    std::uint32_t samples = 0;
    for_each_piece(triangle, square, [&](std::size_t i) { samples += points_.pieces[i].samples; });
    if (samples < fewest_samples) return;
    const HullProof proof = prove_all(triangle, square);
    const bool is_lit = proof.shadow_class == ShadowClass::lit && proof.is_above;
    if (is_lit || proof.shadow_class == ShadowClass::umbra) {
      for_each_piece(triangle, square, [&](std::size_t i) { known_[i] = proof.shadow_class; });
      counters_.proven_samples += samples;
    } else if (square.edge > 1) {
      const double half = square.edge / 2;
      for (const double y : {square.y, square.y + half})
        for (const double x : {square.x, square.x + half}) prove(triangle, {x, y, half});
    }
  }

  /// Samples are rounded to float, so that they may lie outside of the corners' hull, by `slack`
  /// along each axis. So each corner becomes a tetrahedron that holds the cube of twice that edge,
  /// its own corners' rounding considered: with corners at k (+-1, +-1, +-1) it holds a third of k.
  HullProof prove_all(const BakedTriangle& triangle, const TexelSquare& square) {
    static constexpr Vec3d ways[] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    const Footprint footprint(triangle.place, square);
    corners_.clear();
    for (const TexelPoint& corner : footprint.corners())
      for (const Vec3d way : ways)
        corners_.push_back(receiver_at(triangle, corner.position + way * (8 * triangle.slack)));
    if (corners_.empty()) return {};
    return prove_hull(context_.shadows, light_, corners_, queue_, visibility_, counters_.shadow);
  }

  template <typename Visit>
  void for_each_piece(const BakedTriangle& triangle, const TexelSquare& square,
                      const Visit& visit) const {
    for (std::size_t i = triangle.pieces_begin; i < triangle.pieces_end; ++i) {
      const Pixel at = points_.texels[points_.pieces[i].texel];
      if (at.x >= square.x && at.x < square.x + square.edge && at.y >= square.y &&
          at.y < square.y + square.edge)
        visit(i);
    }
  }

  /// The visible fraction of each sample that is not known.
  void ask() {
    std::vector<ShadowQuery> queries;
    for (const TexelSample& sample : points_.samples)
      if (known_[sample.piece] == ShadowClass::penumbra)
        queries.push_back({sample.query.receiver, light_key(sample.query.key, light_)});
    seen_.resize(queries.size());
    counters_.asked_samples += queries.size();
    visibilities(context_.shadows, light_, queries, queue_, visibility_, counters_.shadow, seen_);
  }

  void store(BakePlanes& planes) {
    const std::size_t each = context_.pattern.size();
    const bool is_weighted = context_.options.value == BakeValue::cosine_weighted;
    auto sample = points_.samples.begin();
    auto answer = seen_.begin();
    for (const std::uint32_t texel : points_.covered) {
      double sum = 0;
      std::size_t lit = 0, umbra = 0;
      for (std::size_t s = 0; s < each; ++s, ++sample) {
        ShadowClass shadow_class = known_[sample->piece];
        if (shadow_class == ShadowClass::penumbra) {
          sum += double(is_weighted ? answer->cosine_weighted : answer->fraction);
          shadow_class = (answer++)->shadow_class;
        } else {
          sum += shadow_class == ShadowClass::lit ? 1 : 0;
        }
        lit += shadow_class == ShadowClass::lit, umbra += shadow_class == ShadowClass::umbra;
      }
      const ShadowClass whole = lit == each     ? ShadowClass::lit
                                : umbra == each ? ShadowClass::umbra
                                                : ShadowClass::penumbra;
      count(whole);
      const Pixel at = points_.texels[texel];
      const std::size_t index = std::size_t(at.y) * context_.atlas.width + at.x;
      planes.visibility[light_]->values[index] = static_cast<float>(sum / double(each));
      if (!planes.light_class.empty())
        planes.light_class[light_]->values[index] = static_cast<float>(whole);
    }
  }

  void count(ShadowClass shadow_class) {
    switch (shadow_class) {
      case ShadowClass::lit: ++counters_.lit; break;
      case ShadowClass::penumbra: ++counters_.penumbra; break;
      case ShadowClass::umbra: ++counters_.umbra; break;
    }
  }

  const BakeContext& context_;
  const TexelPoints& points_;
  std::uint32_t light_;
  VisibilityScratch& visibility_;
  BakeCounters& counters_;
  OccluderQueue queue_;
  std::vector<ShadowClass> known_;  // of each piece; penumbra: nothing
  std::vector<Visibility> seen_;    // of each sample that is not known
  std::vector<Receiver> corners_;
};

}  // namespace

BakeCounters bake_block(const BakeContext& context, std::size_t block,
                        VisibilityScratch& visibility, BakePlanes& planes) {
  BakeCounters counters;
  const TexelPoints points =
      place_points(context.scene, context.atlas, block, context.pattern, context.options.seed);
  counters.covered = points.covered.size();
  counters.overlapping = points.overlapping;
  for (const std::uint32_t texel : points.covered) {
    const Pixel at = points.texels[texel];
    planes.covered[std::size_t(at.y) * context.atlas.width + at.x] = 1;
  }
  for (std::uint32_t light = 0; light < context.shadows.lights.size(); ++light)
    LightBaker(context, points, light, visibility, counters).bake(planes);
  return counters;
}

}  // namespace penumbra
