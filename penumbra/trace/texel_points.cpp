// SPDX-License-Identifier: MIT
#include "penumbra/trace/texel_points.h"

#include <algorithm>
#include <cmath>

#include "penumbra/geometry/box.h"
#include "penumbra/trace/render.h"

namespace penumbra {
namespace {

constexpr double ulp = 0x1p-24;
/// Less than this of a texel is no cover: its points would be the rounding's.
constexpr double least_area = 1e-7;

BakedTriangle baked_triangle(const Scene& scene, const UvAtlas& atlas, AtlasTriangle which) {
  BakedTriangle baked;
  baked.place = texel_triangle(scene, atlas, which);
  const Vec3d a = baked.place[0].position, b = baked.place[1].position, c = baked.place[2].position;
  baked.normal = normalize(cross(b - a, c - a));
  const Mesh& mesh = scene.shapes.meshes[which.mesh];
  if (!mesh.normals.empty()) {
    Vec3d sum;
    for (const std::uint32_t corner : mesh.triangles[which.triangle])
      sum += Vec3d(mesh.normals[corner]);
    if (dot(sum, baked.normal) < 0) baked.normal = -baked.normal;
  }
  // As `surface_point` has it, but twice as far, since a whole footprint takes one offset and gets
  // some slack below it.
  const double largest = std::max({max_abs(a), max_abs(b), max_abs(c)});
  const double extent = std::max({max_abs(b - a), max_abs(c - a), max_abs(c - b)});
  baked.offset = 64 * ulp * (largest + extent);
  baked.slack = ulp * (largest + baked.offset);
  return baked;
}

/// About the middle of a texel, where quads' diagonals, which belong to no triangle, rarely pass.
constexpr double middle_x = 0.5037, middle_y = 0.4883;

/// A triangle of a texel's cover.
struct Part {
  std::uint32_t piece;
  TexelPoint a, b, c;
  double end;  ///< area up to and with it
};

class PointPlacer {
 public:
  PointPlacer(const UvAtlas& atlas, std::size_t block, const SamplePattern& pattern,
              std::uint64_t seed, TexelPoints& out)
      : pattern_(pattern), seed_(seed), out_(out), u_(pattern.size()), v_(pattern.size()) {
    const std::uint32_t across = (atlas.width + block_edge - 1) / block_edge;
    const std::uint32_t x = static_cast<std::uint32_t>(block % across) * block_edge,
                        y = static_cast<std::uint32_t>(block / across) * block_edge;
    area_ = {x, std::min(x + block_edge, atlas.width), y, std::min(y + block_edge, atlas.height)};
    out_.texels = z_order(area_);
    order_.resize(block_edge * block_edge);
    for (std::uint32_t i = 0; i < out_.texels.size(); ++i) order_at(out_.texels[i]) = i;
    inside_.resize(out_.texels.size());
  }

  void cut(BakedTriangle& triangle, std::uint32_t index) {
    const TexelTriangle& t = triangle.place;
    triangle.pieces_begin = out_.pieces.size();
    const auto texel = [](double at, std::uint32_t lo, std::uint32_t hi) {
      return static_cast<std::uint32_t>(std::clamp(std::floor(at), double(lo), double(hi - 1)));
    };
    const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
    const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
    for (std::uint32_t y = texel(top, area_.y_begin, area_.y_end);
         y <= texel(bottom, area_.y_begin, area_.y_end); ++y)
      for (std::uint32_t x = texel(left, area_.x_begin, area_.x_end);
           x <= texel(right, area_.x_begin, area_.x_end); ++x) {
        const double area = texel_area(Footprint(t, {double(x), double(y), 1}));
        if (!(area > least_area)) continue;
        const std::uint32_t in_order = order_at({x, y});
        out_.pieces.push_back({index, in_order, static_cast<float>(area), 0});
        if (is_inside(t, x + middle_x, y + middle_y) && ++inside_[in_order] == 2)
          ++out_.overlapping;
      }
    triangle.pieces_end = out_.pieces.size();
  }

  void place() {
    std::vector<std::uint32_t> by_texel(out_.pieces.size());
    for (std::uint32_t i = 0; i < by_texel.size(); ++i) by_texel[i] = i;
    std::stable_sort(by_texel.begin(), by_texel.end(), [&](std::uint32_t a, std::uint32_t b) {
      return out_.pieces[a].texel < out_.pieces[b].texel;
    });
    for (std::size_t begin = 0, end = 0; begin < by_texel.size(); begin = end) {
      const std::uint32_t texel = out_.pieces[by_texel[begin]].texel;
      while (end < by_texel.size() && out_.pieces[by_texel[end]].texel == texel) ++end;
      place(texel, std::span(by_texel).subspan(begin, end - begin));
    }
  }

 private:
  std::uint32_t& order_at(Pixel p) {
    return order_[(p.y - area_.y_begin) * block_edge + p.x - area_.x_begin];
  }

  /// The points of one texel, on these pieces.
  void place(std::uint32_t texel, std::span<const std::uint32_t> pieces) {
    const Pixel at = out_.texels[texel];
    parts_.clear();
    double area = 0;
    for (const std::uint32_t piece : pieces) {
      const Footprint footprint(out_.triangles[out_.pieces[piece].triangle].place,
                                {double(at.x), double(at.y), 1});
      const std::span<const TexelPoint> corner = footprint.corners();
      for (std::size_t i = 2; i < corner.size(); ++i) {
        area += texel_area(corner[0], corner[i - 1], corner[i]);
        parts_.push_back({piece, corner[0], corner[i - 1], corner[i], area});
      }
    }
    const std::uint64_t key = hash(seed_, std::uint64_t(at.y) << 32 | at.x);
    pattern_.scramble(key, u_, v_);
    out_.covered.push_back(texel);
    for (std::uint32_t s = 0; s < pattern_.size(); ++s) {
      const double wanted = double(u_[s]) * area;
      const auto part = std::upper_bound(parts_.begin(), parts_.end() - 1, wanted,
                                         [](double w, const Part& p) { return w < p.end; });
      const double before = part == parts_.begin() ? 0 : std::prev(part)->end;
      const double share = std::clamp((wanted - before) / (part->end - before), 0.0, 1.0);
      const double r = std::sqrt(share), v = double(v_[s]);
      const Vec3d position = part->a.position * (1 - r) + part->b.position * (r * (1 - v)) +
                             part->c.position * (r * v);
      TexelPiece& piece = out_.pieces[part->piece];
      ++piece.samples;
      out_.samples.push_back(
          {part->piece, {receiver_at(out_.triangles[piece.triangle], position), hash(key, s)}});
    }
  }

  const SamplePattern& pattern_;
  std::uint64_t seed_;
  TexelPoints& out_;
  Area area_{};
  std::vector<float> u_, v_;
  std::vector<std::uint32_t> order_;   // of a texel in Z-order, row by row
  std::vector<std::uint32_t> inside_;  // triangles that hold the texel's middle
  std::vector<Part> parts_;
};

}  // namespace

TexelPoints place_points(const Scene& scene, const UvAtlas& atlas, std::size_t block,
                         const SamplePattern& pattern, std::uint64_t seed) {
  TexelPoints points;
  PointPlacer placer(atlas, block, pattern, seed, points);
  for (const AtlasTriangle which : atlas.block(block)) {
    points.triangles.push_back(baked_triangle(scene, atlas, which));
    placer.cut(points.triangles.back(), static_cast<std::uint32_t>(points.triangles.size() - 1));
  }
  placer.place();
  return points;
}

Receiver receiver_at(const BakedTriangle& triangle, Vec3d position) {
  return {Vec3f(position + triangle.normal * triangle.offset), Vec3f(triangle.normal)};
}

}  // namespace penumbra
