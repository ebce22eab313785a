// SPDX-License-Identifier: MIT
// Occluders that change: positions and placements that move, parts that come and go.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <thread>

#include "penumbra/scene/error.h"
#include "penumbra/scene/gallery.h"
#include "penumbra/visibility/occluders.h"
#include "tests/kernel/nasty_shapes.h"

namespace penumbra {
namespace {

using nasty::Random;

const BallLight lamp{{0.3f, 0.2f, 4}, 0.4f};

/// Points all around, that look at no side.
std::vector<Vec3f> points_around(std::size_t count) {
  Random random(3);
  std::vector<Vec3f> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back(random.in_cube() * 3.0f);
  return points;
}

std::vector<float> seen_from(const Occluders& occluders, const std::vector<Vec3f>& points) {
  return occluders.visible_fraction({.positions = points}, lamp);
}

const Mesh& bust() {
  static const Mesh mesh = gallery_scene("bust")->shapes.meshes.front();
  return mesh;
}

/// The bust within the cube of edge 2, to be bent.
struct BendingBust {
  Mesh mesh = bust();
  std::vector<Vec3f> straight;
  Occluders occluders;
  GeometryId id;

  BendingBust() {
    const Box box = bounds(mesh);
    for (Vec3f& p : mesh.positions) p = (p - box.center()) * (2 / box.largest_extent());
    straight = mesh.positions;
    id = occluders.add_triangles(mesh.positions, mesh.triangles);
  }
  void bend(float amount) {
    for (std::size_t i = 0; i < straight.size(); ++i) {
      const Vec3f p = straight[i];
      mesh.positions[i] = {p.x + amount * std::sin(3 * p.z), p.y, p.z + amount * p.x};
    }
  }
  Occluders built_anew() const {
    Occluders anew;
    anew.add_triangles(mesh.positions, mesh.triangles);
    anew.commit();
    return anew;
  }
};

TEST(MovedOccluders, are_refitted_and_answer_as_if_built_anew) {
  BendingBust bust;
  EXPECT_FALSE(bust.occluders.commit().is_refitted);
  const auto points = points_around(4000);
  for (const float amount : {0.01f, 0.3f, -2.0f}) {
    bust.bend(amount);
    EXPECT_TRUE(bust.occluders.commit().is_refitted);
    EXPECT_EQ(seen_from(bust.occluders, points), seen_from(bust.built_anew(), points));
  }
  EXPECT_FALSE(bust.occluders.commit({.may_refit = false}).is_refitted);
  EXPECT_EQ(seen_from(bust.occluders, points), seen_from(bust.built_anew(), points));
}

TEST(MovedOccluders, whose_triangles_come_apart_hide_nothing_by_their_old_neighbours) {
  // Every triangle with vertices of its own, welded by position alone; then each shrinks.
  const Mesh mesh = BendingBust().mesh;
  std::vector<Vec3f> positions;
  std::vector<Triangle> triangles;
  for (const Triangle& t : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (const std::uint32_t corner : t) positions.push_back(mesh.positions[corner]);
    triangles.push_back({first, first + 1, first + 2});
  }
  Occluders occluders;
  occluders.add_triangles(positions, triangles);
  occluders.commit();
  for (std::size_t i = 0; i < positions.size(); i += 3) {
    const Vec3f middle = (positions[i] + positions[i + 1] + positions[i + 2]) * (1.0f / 3);
    for (std::size_t k = i; k < i + 3; ++k) positions[k] = middle + (positions[k] - middle) * 0.5f;
  }
  EXPECT_TRUE(occluders.commit().is_refitted);
  const auto points = points_around(4000);
  const Points asked{.positions = points};
  EXPECT_EQ(occluders.visible_fraction(asked, lamp),
            occluders.visible_fraction(asked, lamp, {.method = Method::stochastic}));
}

TEST(MovedOccluders, that_become_degenerate_are_built_anew) {
  BendingBust bust;
  bust.occluders.commit();
  bust.mesh.positions[bust.mesh.triangles[0][0]] = bust.mesh.positions[bust.mesh.triangles[0][1]];
  const CommitReport report = bust.occluders.commit();
  EXPECT_FALSE(report.is_refitted);
  EXPECT_GE(report.degenerate_triangles, 1u);
  const auto points = points_around(1000);
  EXPECT_EQ(seen_from(bust.occluders, points), seen_from(bust.built_anew(), points));
}

TEST(MovedOccluders, take_other_arrays_of_the_same_length) {
  BendingBust bust;
  bust.occluders.commit();
  std::vector<Vec3f> elsewhere = bust.straight;
  for (Vec3f& p : elsewhere) p.x += 1;
  bust.occluders.update(bust.id, elsewhere);
  EXPECT_TRUE(bust.occluders.commit().is_refitted);
  Occluders anew;
  anew.add_triangles(elsewhere, bust.mesh.triangles);
  anew.commit();
  const auto points = points_around(1000);
  EXPECT_EQ(seen_from(bust.occluders, points), seen_from(anew, points));
  elsewhere.pop_back();
  EXPECT_THROW(bust.occluders.update(bust.id, elsewhere), Error);
}

TEST(MovedOccluders, that_could_not_be_committed_leave_what_there_was) {
  BendingBust bust;
  bust.occluders.commit();
  const auto points = points_around(500);
  const auto before = seen_from(bust.occluders, points);
  bust.mesh.positions[7].y = NAN;
  EXPECT_THROW(bust.occluders.commit(), Error);
  EXPECT_EQ(seen_from(bust.occluders, points), before);
  bust.mesh.positions[7] = bust.straight[7];
  EXPECT_TRUE(bust.occluders.commit().is_refitted);
  EXPECT_EQ(seen_from(bust.occluders, points), before);
}

/// A tetrahedron and a ball, placed by instances.
struct Placed {
  std::vector<Vec3f> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::vector<Triangle> faces{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  std::vector<Vec3f> centers{{0.8f, 0.8f, 0.8f}};
  std::vector<float> radii{0.3f};
  Occluders shapes, occluders;
  GroupId group;
  Placed() {
    shapes.add_triangles(corners, faces);
    shapes.add_spheres(centers, radii);
    group = occluders.add_group(shapes);
  }
};

constexpr Transform turned{{0, 1.5, 0}, {-1.5, 0, 0}, {0, 0, 1.5}, {0.4, -0.2, 0.1}};

TEST(PlacedOccluders, are_the_shapes_where_they_are_placed) {
  Placed placed;
  placed.occluders.add_instance(placed.group, {});
  placed.occluders.add_instance(placed.group, turned);
  EXPECT_EQ(placed.occluders.commit().primitives, 10u);
  std::vector<Vec3f> corners = placed.corners, centers = placed.centers;
  std::vector<Triangle> faces = placed.faces;
  for (std::size_t i = 0; i < 4; ++i)
    corners.push_back(Vec3f(apply_point(turned, Vec3d(placed.corners[i]))));
  for (const Triangle& face : placed.faces)
    faces.push_back({face[0] + 4, face[1] + 4, face[2] + 4});
  centers.push_back(Vec3f(apply_point(turned, Vec3d(centers[0]))));
  const std::vector<float> radii{0.3f, static_cast<float>(0.3f * 1.5)};
  Occluders flat;
  flat.add_triangles(corners, faces);
  flat.add_spheres(centers, radii);
  flat.commit();
  const auto points = points_around(4000);
  EXPECT_EQ(seen_from(placed.occluders, points), seen_from(flat, points));
}

TEST(PlacedOccluders, are_refitted_when_they_or_their_group_move) {
  Placed placed;
  const InstanceId one = placed.occluders.add_instance(placed.group, {});
  placed.occluders.add_instance(placed.group, turned);
  placed.occluders.commit();
  const auto points = points_around(2000);
  const auto agrees_with_anew = [&](const Transform& first) {
    Occluders anew;
    const GroupId group = anew.add_group(placed.shapes);
    anew.add_instance(group, first);
    anew.add_instance(group, turned);
    anew.commit();
    return seen_from(placed.occluders, points) == seen_from(anew, points);
  };
  const Transform shifted{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0.5}};
  placed.occluders.update(one, shifted);
  EXPECT_TRUE(placed.occluders.commit().is_refitted);
  EXPECT_TRUE(agrees_with_anew(shifted));
  for (Vec3f& corner : placed.corners) corner = corner * 1.25f;
  EXPECT_TRUE(placed.occluders.commit().is_refitted);
  EXPECT_TRUE(agrees_with_anew(shifted));
}

TEST(PlacedOccluders, come_and_go) {
  Placed placed;
  const InstanceId one = placed.occluders.add_instance(placed.group, {});
  placed.occluders.commit();
  EXPECT_THROW(placed.occluders.remove(placed.group), Error);
  placed.occluders.remove(one);
  EXPECT_EQ(placed.occluders.commit().primitives, 0u);
  placed.occluders.remove(placed.group);
  EXPECT_THROW(placed.occluders.add_instance(placed.group, {}), Error);
  EXPECT_THROW(placed.occluders.remove(one), Error);
  EXPECT_THROW(placed.occluders.update(one, turned), Error);
}

TEST(MovedOccluders, are_asked_from_other_threads_while_they_change) {
  BendingBust bust;
  bust.occluders.commit();
  const auto points = points_around(300);
  const auto straight = seen_from(bust.occluders, points);
  bust.bend(0.4f);
  const auto bent = seen_from(bust.built_anew(), points);
  ASSERT_NE(straight, bent);
  std::atomic<bool> is_over = false;
  std::atomic<int> wrong = 0;
  std::vector<std::thread> askers;
  for (int i = 0; i < 3; ++i)
    askers.emplace_back([&] {
      while (!is_over) {
        const auto seen = seen_from(bust.occluders, points);
        wrong += seen != straight && seen != bent;
      }
    });
  for (int i = 0; i < 20; ++i) {
    bust.bend(i % 2 ? 0.4f : 0);
    bust.occluders.commit();
  }
  is_over = true;
  for (std::thread& asker : askers) asker.join();
  EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace penumbra
