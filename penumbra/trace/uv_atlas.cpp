// SPDX-License-Identifier: MIT
#include "penumbra/trace/uv_atlas.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "penumbra/scene/error.h"
#include "penumbra/trace/render.h"

namespace penumbra {
namespace {

/// Texels that triangles may cover on the whole, for each texel of the texture.
constexpr double most_layers = 64;
constexpr double slack = 1e-4;
/// What double rounds of a texel's corners, that far out in the largest texture, is less of its
/// area than what counts as cover (texel_points.cpp).
constexpr double largest_uv = 1e3;

enum class Place { inside, outside, flat, not_finite };

/// Blocks that a triangle may reach: [x_begin, x_end) x [y_begin, y_end).
struct BlockRange {
  std::uint32_t x_begin = 0, x_end = 0, y_begin = 0, y_end = 0;
};

BlockRange blocks_of(const TexelTriangle& t, std::uint32_t across, std::uint32_t down) {
  const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
  const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
  const auto block = [](double texel, std::uint32_t most) {
    return static_cast<std::uint32_t>(std::clamp(texel / block_edge, 0.0, double(most)));
  };
  return {block(left, across), std::min(block(right, across) + 1, across), block(top, down),
          std::min(block(bottom, down) + 1, down)};
}

class AtlasMaker {
 public:
  AtlasMaker(const Scene& scene, UvSet set, std::uint32_t width, std::uint32_t height)
      : scene_(scene),
        across_((width + block_edge - 1) / block_edge),
        down_((height + block_edge - 1) / block_edge) {
    atlas_.width = width, atlas_.height = height, atlas_.set = set;
    atlas_.begin.assign(std::size_t(across_) * down_ + 1, 0);
  }

  UvAtlas make(std::span<const std::uint32_t> meshes) && {
    count(meshes);
    for (std::size_t i = 1; i < atlas_.begin.size(); ++i) atlas_.begin[i] += atlas_.begin[i - 1];
    atlas_.triangles.resize(atlas_.begin.back());
    // Each begin is now its block's end; filling from behind brings it back.
    for (auto mesh = meshes.rbegin(); mesh != meshes.rend(); ++mesh)
      for (std::size_t t = triangles_of(*mesh); t-- > 0;) {
        const AtlasTriangle triangle{*mesh, static_cast<std::uint32_t>(t)};
        const TexelTriangle place = texel_triangle(scene_, atlas_, triangle);
        if (!is_drawn(place)) continue;
        for_each_block(
            place, [&](std::size_t block) { atlas_.triangles[--atlas_.begin[block]] = triangle; });
      }
    return std::move(atlas_);
  }

 private:
  std::size_t triangles_of(std::uint32_t mesh) const {
    const Mesh& m = scene_.shapes.meshes[mesh];
    return uvs_of(m, atlas_.set).empty() ? 0 : m.triangles.size();
  }

  Place place_of(const TexelTriangle& t) const {
    const double w = atlas_.width, h = atlas_.height;
    bool is_outside = false;
    for (const TexelPoint& p : t) {
      if (!(std::abs(p.x) <= largest_uv * w && std::abs(p.y) <= largest_uv * h))
        return Place::not_finite;
      is_outside |=
          p.x < -slack * w || p.x > (1 + slack) * w || p.y < -slack * h || p.y > (1 + slack) * h;
    }
    if (!(texel_area(t[0], t[1], t[2]) > 1e-9)) return Place::flat;
    return is_outside ? Place::outside : Place::inside;
  }
  bool is_drawn(const TexelTriangle& t) const {
    const Place place = place_of(t);
    return place == Place::inside || place == Place::outside;
  }

  template <typename Visit>
  void for_each_block(const TexelTriangle& t, const Visit& visit) const {
    const BlockRange range = blocks_of(t, across_, down_);
    for (std::uint32_t y = range.y_begin; y < range.y_end; ++y)
      for (std::uint32_t x = range.x_begin; x < range.x_end; ++x)
        if (may_meet(t, double(x) * block_edge, double(x + 1) * block_edge, double(y) * block_edge,
                     double(y + 1) * block_edge))
          visit(std::size_t(y) * across_ + x);
  }

  /// Texels that it covers or touches, about.
  double cost_of(const TexelTriangle& t) const {
    const double w = atlas_.width, h = atlas_.height;
    const auto extent = [](double a, double b, double c, double size) {
      const auto [lo, hi] = std::minmax({a, b, c});
      return std::max(0.0, std::min(hi, size) - std::max(lo, 0.0));
    };
    const double dx = extent(t[0].x, t[1].x, t[2].x, w), dy = extent(t[0].y, t[1].y, t[2].y, h);
    return std::min(texel_area(t[0], t[1], t[2]), dx * dy) + dx + dy;
  }

  void count(std::span<const std::uint32_t> meshes) {
    const double texels = double(atlas_.width) * atlas_.height;
    double cost = 0;
    for (const std::uint32_t mesh : meshes)
      for (std::size_t i = 0; i < triangles_of(mesh); ++i) {
        const TexelTriangle t =
            texel_triangle(scene_, atlas_, {mesh, static_cast<std::uint32_t>(i)});
        ++atlas_.triangle_count;
        switch (place_of(t)) {
          case Place::not_finite: ++atlas_.faults.not_finite; continue;
          case Place::flat: ++atlas_.faults.flat; continue;
          case Place::outside: ++atlas_.faults.outside; break;
          case Place::inside: break;
        }
        cost += cost_of(t);
        if (cost > most_layers * texels + 16.0 * double(atlas_.triangle_count)) refuse_layers();
        for_each_block(t, [&](std::size_t block) { ++atlas_.begin[block]; });
      }
    if (std::all_of(atlas_.begin.begin(), atlas_.begin.end(), [](auto n) { return n == 0; }))
      refuse_empty();
  }

  [[noreturn]] void refuse_layers() const {
    throw Error({scene_.name, {}, {}},
                fmt::format("its triangles cover the texture {} times over: these are no "
                            "coordinates for a lightmap",
                            most_layers),
                "unwrap it so that each triangle has a place of its own (Blender: Lightmap Pack, "
                "Smart UV Project; xatlas), or bake one mesh at a time");
  }
  [[noreturn]] void refuse_empty() const {
    throw Error({scene_.name, {}, {}},
                fmt::format("none of its {} triangles has a place in the texture ({} have no area "
                            "there, {} coordinates that are not numbers, the others lie outside of "
                            "[0, 1])",
                            atlas_.triangle_count, atlas_.faults.flat, atlas_.faults.not_finite),
                "unwrap it again (Blender: Lightmap Pack, Smart UV Project; xatlas)");
  }

  const Scene& scene_;
  std::uint32_t across_, down_;
  UvAtlas atlas_;
};

}  // namespace

UvAtlas make_atlas(const Scene& scene, std::span<const std::uint32_t> meshes, UvSet set,
                   std::uint32_t width, std::uint32_t height) {
  return AtlasMaker(scene, set, width, height).make(meshes);
}

TexelTriangle texel_triangle(const Scene& scene, const UvAtlas& atlas, AtlasTriangle triangle) {
  const Mesh& mesh = scene.shapes.meshes[triangle.mesh];
  const std::vector<Vec2f>& uvs = uvs_of(mesh, atlas.set);
  TexelTriangle t;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t corner = mesh.triangles[triangle.triangle][i];
    t[i] = {double(uvs[corner].u) * atlas.width, (1 - double(uvs[corner].v)) * atlas.height,
            Vec3d(mesh.positions[corner])};
  }
  return t;
}

}  // namespace penumbra
