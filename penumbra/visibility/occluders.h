// SPDX-License-Identifier: MIT
// The library as other programs link it: their own arrays go in, what lights see of points comes
// out. Answers are those of the renderer: the class is proven, and fractions are, bit for bit,
// those of tracing every sample.
//
//   penumbra::Occluders occluders;
//   occluders.add_triangles(positions, triangles);
//   occluders.commit();
//   std::vector<float> seen = occluders.visible_fraction({.positions = points, .normals = normals},
//                                                        penumbra::BallLight{{0, 9, 0}, 1});
//
// Errors: everything here throws `Error` (scene/error.h) for arguments that cannot be meant, and
// leaves the object as it was. Threads: any member may be called from any thread at any time, but
// for moving and destroying. Questions are answered of what was committed last when they began;
// they run side by side, also beside a commit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "penumbra/geometry/box.h"
#include "penumbra/geometry/light_shape.h"
#include "penumbra/geometry/shape.h"
#include "penumbra/geometry/transform.h"
#include "penumbra/shadow/method.h"
#include "penumbra/shadow/shadow_query.h"
#include "penumbra/visibility/rows.h"

namespace penumbra {

struct GeometryRows;

/// What was added: numbers from 0, in the order of adding, of each kind by itself.
struct GeometryId {
  std::uint32_t index = 0;
};
/// As GeometryId.
struct GroupId {
  std::uint32_t index = 0;
};
/// As GeometryId.
struct InstanceId {
  std::uint32_t index = 0;
};

/// One triangle, sphere, cone or disk: number `primitive` of its geometry. What an instance places
/// is named by that and by the geometry's number in its group.
struct PrimitiveId {
  static constexpr std::uint32_t no_instance = 0xffffffffu;
  std::uint32_t geometry = 0, primitive = 0, instance = no_instance;

  constexpr bool operator==(const PrimitiveId&) const = default;
};

/// Surface points that ask. `positions` and `normals` in scene units and the occluders' frame.
/// Where they are no numbers the class is penumbra, and the fraction means nothing.
struct Points {
  VectorRows positions;
  /// Geometric normals, on the side that looks at the light; of samples below the plane nothing is
  /// seen. As many as positions, or none at all: then points float, and look around. Those that
  /// are not unit become so; (0, 0, 0) is that of a point that floats.
  VectorRows normals{};
  /// How far points are moved along their normals before they ask, so that the surface that they
  /// lie on does not block them. None: 64 ulp of the largest coordinate of point and occluders,
  /// more than float has lost of a point on any of them. 0: they lie where shadow rays begin.
  std::optional<float> offset{};
  /// What the random numbers of each point are drawn by; as many as positions, or none: then that
  /// of point i is `first_key` + i. See `light_key`.
  Rows<std::uint64_t> keys{};
  std::uint64_t first_key = 0;
};

/// How questions are answered.
struct AskOptions {
  std::uint32_t shadow_samples = 32;  ///< d, 1 to 65536
  Method method = Method::shaft;      ///< or stochastic, the judge; the others are the renderer's
  /// Which light of several this is: another, other samples. None: the points' keys are final, as
  /// `light_key` gives them.
  std::optional<std::uint32_t> light_index = 0;
  std::uint32_t threads = 0;  ///< 0: all cores. Answers are the same for any number
  /// Called with the finished share in [0, 1], from any thread, one call at a time. False ends the
  /// question with `Cancelled`, and what it throws comes out of the question; answers are filled in
  /// part then. It may run tasks of its own, and ask other questions.
  std::function<bool(double)> progress{};
};

/// A question whose `progress` said no. What was to be filled is filled in part.
struct Cancelled : std::runtime_error {
  Cancelled() : std::runtime_error("cancelled") {}
};

/// What stands between points and a light.
struct Blockers {
  /// lit: nothing can block a sample that is above the horizon. umbra: all are blocked for sure.
  ShadowClass shadow_class = ShadowClass::penumbra;
  /// Every primitive that may block a sample, in rising order: geometry, primitive, instance; those
  /// of instances last. For umbra, all that may.
  std::vector<PrimitiveId> primitives;
};

/// How what was added becomes what is asked of.
struct CommitOptions {
  /// Where only what the arrays hold has changed, or placements, the hierarchy is fitted to it and
  /// keeps its shape, which is quick and, where things have moved far, makes questions slower.
  /// Fractions and samples are the same; more, or less, may be proven. False builds it anew.
  bool may_refit = true;
};

/// What was committed.
struct CommitReport {
  std::size_t primitives = 0;            ///< with all that instances place
  std::size_t degenerate_triangles = 0;  ///< of no area; they block nothing
  bool is_refitted = false;
};

/// What blocks light. Arrays that are handed over are not copied: they are read, in place, by every
/// `commit`, and must be there, and not change, while one runs; between commits they may change as
/// they like. Lights and points may lie anywhere, inside of solids too.
class Occluders {
 public:
  Occluders();
  ~Occluders();
  Occluders(Occluders&&) noexcept;
  Occluders& operator=(Occluders&&) noexcept;

  // --- What there is. Nothing of it is asked before `commit`. ---

  /// Triangles block from both sides. The mesh may be open or dirty.
  GeometryId add_triangles(VectorRows positions, TriangleRows triangles);
  /// Radii > 0, one a centre.
  GeometryId add_spheres(VectorRows centers, NumberRows radii);
  /// Truncated cones from base to apex, open or solid; one radius >= 0 a base and apex, not both 0.
  /// Equal radii make cylinders.
  GeometryId add_cones(VectorRows bases, VectorRows apexes, NumberRows base_radii,
                       NumberRows apex_radii, Caps caps = Caps::capped);
  /// Flat disks, or rings where inner radii >= 0 are given. Normals need not be unit.
  GeometryId add_disks(VectorRows centers, VectorRows normals, NumberRows radii,
                       NumberRows inner_radii = {});

  /// The geometry of another, for instances to place: stored once however often it stands in the
  /// scene. It is taken as it is now (its arrays are read by commits of this); it must have no
  /// instances of its own.
  GroupId add_group(const Occluders& shapes);
  /// Triangles under any affine map that does not flatten them; groups with spheres, cones or disks
  /// under similarities alone.
  InstanceId add_instance(GroupId group, const Transform& placement);

  // What the arrays hold may change between commits: the next one reads them again. These give
  // other arrays, of as many rows, or other placements.

  /// Positions of triangles' vertices, centres of spheres and disks, bases of cones.
  void update(GeometryId geometry, VectorRows positions);
  void update(GroupId group, GeometryId geometry, VectorRows positions);
  void update(InstanceId instance, const Transform& placement);

  /// Something that the arrays lie in, to live as long as this.
  void keep(std::shared_ptr<const void> owner);

  /// Takes out what was added. Its number is not given again, and naming it is an error from then
  /// on; a group must not be placed any more.
  void remove(GeometryId geometry);
  void remove(InstanceId instance);
  void remove(GroupId group);

  /// Makes what was added and updated until now what questions are asked of. All coordinates must
  /// be finite and within 1e15, vertex numbers within range: else Error, and what was committed
  /// before stays. Cost: O(n log n) over all cores; of refitting, O(n). Memory beside what stays
  /// (`memory_bytes`): some 140 bytes a triangle while it runs, 50 when refitting; and what was
  /// committed before, until its last question has been answered.
  CommitReport commit(const CommitOptions& options = {});

  // --- Questions. Before the first `commit` they throw. `light` as penumbra::LightShape says. ---

  /// Class of each point, for the light as a whole: lit (nothing blocks what of it is above the
  /// point's horizon) and umbra (all of it is blocked, or below) are proofs, penumbra means that
  /// neither was found. Which are, depends on what is asked together, as neighbours share their
  /// proofs. No sample is taken, but by `stochastic`, whose classes are those of its samples. Cost:
  /// 5 to 500 ns a point, less where neighbours follow one another.
  ShadowCounters classify(const Points& points, const LightShape& light, std::span<ShadowClass> out,
                          const AskOptions& options = {}) const;
  std::vector<ShadowClass> classify(const Points& points, const LightShape& light,
                                    const AskOptions& options = {}) const;

  /// Share of the light's d samples that each point sees, in [0, 1].
  ShadowCounters visible_fraction(const Points& points, const LightShape& light,
                                  std::span<float> out, const AskOptions& options = {}) const;
  std::vector<float> visible_fraction(const Points& points, const LightShape& light,
                                      const AskOptions& options = {}) const;

  /// Which samples each point sees: bit i % 32 of word i / 32 for sample i; ceil(d / 32) words a
  /// point. `light_samples` says where they lie.
  ShadowCounters visible_samples(const Points& points, const LightShape& light,
                                 std::span<std::uint32_t> out,
                                 const AskOptions& options = {}) const;

  /// All of it: fraction, cosine-weighted fraction, class, rays.
  ShadowCounters visibility(const Points& points, const LightShape& light,
                            std::span<Visibility> out, const AskOptions& options = {}) const;

  /// Everything that may block the light as seen from a point. `normal` as of Points. Cost: that of
  /// a query, and of looking at all of it.
  Blockers blockers(Vec3f position, Vec3f normal, const LightShape& light) const;

  /// The same for every point of a box: what is in the hull of box and light, and may block.
  Blockers shaft(const Box& box, const LightShape& light) const;

  // --- Facts of what was committed last ---
  /// Holds all of it; empty where there is nothing.
  Box bounds() const;
  /// Of what stays between questions, beside the arrays.
  std::size_t memory_bytes() const;

 private:
  struct Data;
  Data& data() const;
  GeometryId add(const GeometryRows& rows);
  std::unique_ptr<Data> data_;
};

/// Ways from a point to the light's d samples (for suns: unit directions), in the order of
/// `visible_samples`: what a caller needs to weigh samples by himself. `position` is where rays
/// begin; `key` is the point's, and `light_index` as in AskOptions. Throws Error for a light that
/// is none.
std::vector<Vec3f> light_samples(const LightShape& light, Vec3f position, std::uint64_t key,
                                 std::uint32_t shadow_samples,
                                 std::optional<std::uint32_t> light_index = 0);

}  // namespace penumbra
