// SPDX-License-Identifier: MIT
// embree_renderer MESH.ply [SIZE]: a plain renderer on Embree 3, a mesh on a ground under a ball
// light. Its soft shadows are 32 shadow rays a point, in packets of 8; or, with the lines marked
// `new`, penumbra's. Draws both, into embree.pgm and penumbra.pgm, and says what the shadows took:
//   penumbra generate bust -o bust.ply && ./embree_renderer bust.ply
#include "plain_renderer.h"

#include <penumbra/penumbra.h>  // new
#include <tbb/parallel_for.h>

#include <array>
#include <chrono>
#include <cstdlib>

namespace {

/// Before: rays to 32 points of the disk that the ball is seen as, turned differently at each
/// point.
std::vector<float> shadows_by_embree(RTCScene scene, const std::vector<Hit>& hits) {
  std::array<float, shadow_rays> a, b;  // of a unit disk, by the golden angle
  for (unsigned k = 0; k < shadow_rays; ++k) {
    a[k] = std::sqrt((k + 0.5f) / shadow_rays) * std::cos(2.399963f * k);
    b[k] = std::sqrt((k + 0.5f) / shadow_rays) * std::sin(2.399963f * k);
  }
  std::vector<float> seen(hits.size());
  tbb::parallel_for(std::size_t{0}, hits.size(), [&](std::size_t i) {
    const Vec p = hits[i].position + hits[i].normal * 1e-4f, way = light_center - p;
    const float radius = light_radius / std::sqrt(1 - light_radius * light_radius / dot(way, way));
    const float turn = static_cast<float>(hits[i].pixel * 2654435761u % 65536) * 9.5874e-5f;
    const Vec x = unit(cross(way, {0.3f, 0.5f, -0.8f})), y = unit(cross(way, x));
    const Vec u = (x * std::cos(turn) + y * std::sin(turn)) * radius;
    const Vec v = (y * std::cos(turn) - x * std::sin(turn)) * radius;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    int free = 0;
    for (unsigned first = 0; first < shadow_rays; first += 8) {
      RTCRay8 rays;
      alignas(32) int valid[8];
      for (unsigned k = 0; k < 8; ++k) {
        const Vec to = way + u * a[first + k] + v * b[first + k];
        rays.org_x[k] = p.x, rays.org_y[k] = p.y, rays.org_z[k] = p.z;
        rays.dir_x[k] = to.x, rays.dir_y[k] = to.y, rays.dir_z[k] = to.z;
        rays.tnear[k] = 0, rays.tfar[k] = 1, rays.time[k] = 0, rays.mask[k] = ~0u;
        rays.flags[k] = 0;
        valid[k] = dot(to, hits[i].normal) > 0 ? -1 : 0;
      }
      rtcOccluded8(valid, scene, &context, &rays);
      for (unsigned k = 0; k < 8; ++k) free += valid[k] && rays.tfar[k] >= 0;
    }
    seen[i] = static_cast<float>(free) / shadow_rays;
  });
  return seen;
}

/// After: the mesh is handed over as it lies there, and the hits are asked about as they are.
std::vector<float> shadows_by_penumbra(const penumbra::Occluders& occluders,  // new, all of it
                                       const std::vector<Hit>& hits) {
  return occluders.visible_fraction(
      {.positions = {&hits[0].position, hits.size(), sizeof(Hit)},
       .normals = {&hits[0].normal, hits.size(), sizeof(Hit)}},
      penumbra::BallLight{{light_center.x, light_center.y, light_center.z}, light_radius},
      {.shadow_samples = shadow_rays});
}

/// Of what `work` does, in milliseconds.
template <class Work>
double took(const char* what, Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  std::printf("%-34s %8.1f ms\n", what, time.count());
  return time.count();
}

void run(const char* path, std::size_t size) {
  const Mesh mesh = read_ply(path);
  const RTCDevice device = rtcNewDevice(nullptr);
  RTCScene scene = nullptr;
  took("Embree builds", [&] { scene = build_scene(device, mesh); });

  penumbra::Occluders occluders;  // new, to `commit`
  occluders.add_triangles({mesh.positions.data(), mesh.positions.size(), sizeof(Vec)},
                          {mesh.triangles.data(), mesh.triangles.size(), sizeof(Triangle)});
  took("penumbra builds", [&] { occluders.commit(); });

  std::vector<Hit> hits;
  took("camera rays", [&] { hits = trace_camera(scene, size); });
  std::vector<float> before, after;
  const double embree =
      took("shadows before, by Embree", [&] { before = shadows_by_embree(scene, hits); });
  const double penumbra =
      took("shadows after, by penumbra", [&] { after = shadows_by_penumbra(occluders, hits); });
  double difference = 0;
  for (std::size_t i = 0; i < hits.size(); ++i) difference += std::abs(before[i] - after[i]);
  std::printf("%zu points: %.2f times as fast; fractions differ by %.4f in the mean\n", hits.size(),
              embree / penumbra, difference / static_cast<double>(hits.size()));
  write_pgm("embree.pgm", shade(hits, before, size), size);
  write_pgm("penumbra.pgm", shade(hits, after, size), size);
  rtcReleaseScene(scene);
  rtcReleaseDevice(device);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    run(argc > 1 ? argv[1] : "bust.ply", argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 640);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
