// SPDX-License-Identifier: MIT
// as_rendered SCENE: draws the scene, hands its shapes over as arrays of the caller's own, asks
// what the picture asked, and compares the answers bit for bit.
#include <penumbra/penumbra.h>
#include <penumbra/render.h>

#include <bit>
#include <cstdint>
#include <cstdio>
#include <mutex>
#include <stdexcept>
#include <unordered_map>
#include <vector>

namespace {

using namespace penumbra;

/// One question of the picture's, and its answer.
struct Asked {
  Receiver receiver;
  std::uint64_t key;  ///< of its light's random numbers
  float fraction;
};

/// All questions, by path of the ray tree and light.
struct AskedTogether {
  std::uint64_t path;
  std::uint32_t light;
  std::vector<Asked> asked;
};

template <class Row, class Shape>
Rows<Row> rows(const std::vector<Shape>& shapes, const Row Shape::*member) {
  return {&(shapes.front().*member), shapes.size(), sizeof(Shape)};
}

Occluders hand_over(const ShapeSet& shapes) {
  if (!shapes.cones.empty() || !shapes.instances.empty())
    throw std::invalid_argument("a scene of meshes, balls and disks, please");
  Occluders occluders;
  if (!shapes.spheres.empty())
    occluders.add_spheres(rows(shapes.spheres, &Sphere::center),
                          rows(shapes.spheres, &Sphere::radius));
  if (!shapes.rings.empty())
    occluders.add_disks(rows(shapes.rings, &Ring::center), rows(shapes.rings, &Ring::normal),
                        rows(shapes.rings, &Ring::radius), rows(shapes.rings, &Ring::inner_radius));
  for (const Mesh& mesh : shapes.meshes) occluders.add_triangles(mesh.positions, mesh.triangles);
  occluders.commit();
  return occluders;
}

/// How many of the answers differ from those of the picture.
std::size_t count_differing(const Occluders& occluders, const Renderer& renderer,
                            const RenderOptions& options, const AskedTogether& together) {
  // Pictures ask with keys of lights, Occluders with keys of points.
  std::unordered_map<std::uint64_t, std::uint64_t> point_keys;
  for (std::uint32_t y = 0; y < options.height; ++y)
    for (std::uint32_t x = 0; x < options.width; ++x) {
      const std::uint64_t key = point_key(options.seed, {x, y, 0}, together.path);
      point_keys[light_key(key, together.light)] = key;
    }
  std::vector<std::uint64_t> keys;
  for (const Asked& asked : together.asked) keys.push_back(point_keys.at(asked.key));

  const Receiver& first = together.asked.front().receiver;
  const std::size_t count = together.asked.size();
  const std::vector<float> seen = occluders.visible_fraction(
      {.positions = VectorRows(&first.position, count, sizeof(Asked)),
       .normals = VectorRows(&first.normal, count, sizeof(Asked)),
       .offset = 0,
       .keys = keys},
      renderer.scene().lights[together.light].shape,
      {.shadow_samples = options.shadow_samples, .light_index = together.light});
  std::size_t differing = 0;
  for (std::size_t i = 0; i < count; ++i)
    differing += std::bit_cast<std::uint32_t>(seen[i]) !=
                 std::bit_cast<std::uint32_t>(together.asked[i].fraction);
  return differing;
}

int run(const char* name) {
  const Renderer renderer(complete_scene(find_scene(name).scene, {}));
  std::mutex mutex;
  std::vector<AskedTogether> all;
  RenderOptions options{.width = 96, .height = 96};
  options.observe = [&](const AnsweredBatch& batch) {
    AskedTogether together{batch.path, batch.light, {}};
    for (std::size_t i = 0; i < batch.queries.size(); ++i)
      together.asked.push_back(
          {batch.queries[i].receiver, batch.queries[i].key, batch.seen[i].fraction});
    const std::scoped_lock lock(mutex);
    all.push_back(std::move(together));
  };
  renderer.render(options);

  const Occluders occluders = hand_over(renderer.scene().shapes);
  std::size_t count = 0, soft = 0, differing = 0;
  for (const AskedTogether& together : all) {
    differing += count_differing(occluders, renderer, options, together);
    count += together.asked.size();
    for (const Asked& asked : together.asked) soft += asked.fraction > 0 && asked.fraction < 1;
  }
  std::printf("%s: %zu answers, %zu soft, %zu differ\n", name, count, soft, differing);
  return differing > 0 || soft == 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc > 1 ? argv[1] : "bust");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
