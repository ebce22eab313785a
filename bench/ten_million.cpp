// SPDX-License-Identifier: MIT
// Surface points of the bust, one ball light: how long does the library take through C++? Its twin
// ten_million.py makes the input by this, asks the same through Python, and compares.
//
//   ten_million make FOLDER COUNT     writes mesh and points, as raw little-endian numbers
//   ten_million ask FOLDER ORDER      ORDER coherent or shuffled: prints seconds, writes fractions
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "penumbra/penumbra.h"
#include "penumbra/scene/gallery.h"

namespace penumbra {
namespace {

using Path = std::filesystem::path;
using Triangle = std::array<std::uint32_t, 3>;

template <class T>
void save(const Path& path, const std::vector<T>& values) {
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(values.data()),
             static_cast<std::streamsize>(values.size() * sizeof(T)));
  if (!file) throw Error({path.string(), {}, {}}, "cannot be written", "choose another folder");
}

template <class T>
std::vector<T> load(const Path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Error({path.string(), {}, {}}, "cannot be read", "make it first");
  std::vector<T> values(std::filesystem::file_size(path) / sizeof(T));
  file.read(reinterpret_cast<char*>(values.data()),
            static_cast<std::streamsize>(values.size() * sizeof(T)));
  return values;
}

struct SurfacePoints {
  std::vector<Vec3f> positions, normals;
};

/// The same number on each triangle, triangle by triangle in the mesh's order: neighbours follow
/// one another.
SurfacePoints points_on(const Mesh& mesh, std::size_t count, std::mt19937_64& random) {
  std::uniform_real_distribution<float> unit(0, 1);
  SurfacePoints points;
  for (std::size_t i = 0; i < count; ++i) {
    const Triangle& t = mesh.triangles[i * mesh.triangles.size() / count];
    const Vec3f a = mesh.positions[t[0]];
    const Vec3f u = mesh.positions[t[1]] - a, v = mesh.positions[t[2]] - a;
    float s = unit(random), r = unit(random);
    if (s + r > 1) s = 1 - s, r = 1 - r;
    points.positions.push_back(a + u * s + v * r);
    points.normals.push_back(normalize(cross(u, v)));
  }
  return points;
}

void make(const Path& folder, std::size_t count) {
  const Mesh mesh = gallery_scene("bust")->shapes.meshes.front();
  std::filesystem::create_directories(folder);
  save(folder / "vertices", mesh.positions);
  save(folder / "triangles", mesh.triangles);
  std::mt19937_64 random(1);
  SurfacePoints points = points_on(mesh, count, random);
  save(folder / "coherent.positions", points.positions);
  save(folder / "coherent.normals", points.normals);
  for (std::size_t i = count; i > 1; --i) {
    const std::size_t k = random() % i;
    std::swap(points.positions[i - 1], points.positions[k]);
    std::swap(points.normals[i - 1], points.normals[k]);
  }
  save(folder / "shuffled.positions", points.positions);
  save(folder / "shuffled.normals", points.normals);
}

void ask(const Path& folder, const std::string& order) {
  const auto vertices = load<Vec3f>(folder / "vertices");
  const auto triangles = load<Triangle>(folder / "triangles");
  const auto positions = load<Vec3f>(folder / (order + ".positions"));
  const auto normals = load<Vec3f>(folder / (order + ".normals"));
  Occluders occluders;
  occluders.add_triangles(std::span<const Vec3f>(vertices), std::span<const Triangle>(triangles));
  occluders.commit();
  const Box box = occluders.bounds();
  const float extent = box.largest_extent();
  const BallLight light{box.center() + Vec3f(1, 1, 1) * extent, 0.1f * extent};
  std::vector<float> fractions(positions.size());
  const auto start = std::chrono::steady_clock::now();
  occluders.visible_fraction(
      {.positions = std::span<const Vec3f>(positions), .normals = std::span<const Vec3f>(normals)},
      light, fractions);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  std::printf("%.4f\n", seconds.count());
  save(folder / (order + ".fractions"), fractions);
}

}  // namespace
}  // namespace penumbra

int main(int count, char** words) {
  try {
    if (count == 4 && std::string(words[1]) == "make")
      penumbra::make(words[2], std::stoul(words[3]));
    else if (count == 4 && std::string(words[1]) == "ask")
      penumbra::ask(words[2], words[3]);
    else
      return std::fputs("ten_million make FOLDER COUNT | ask FOLDER ORDER\n", stderr), 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
