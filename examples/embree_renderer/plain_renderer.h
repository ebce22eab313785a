// SPDX-License-Identifier: MIT
// What any renderer on Embree has already: a mesh, camera rays, shading, a picture.
#pragma once

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

struct Vec {
  float x, y, z;
};
inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec operator*(Vec a, float s) { return {a.x * s, a.y * s, a.z * s}; }
inline Vec operator-(Vec a, Vec b) { return a + b * -1; }
inline float dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec cross(Vec a, Vec b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Vec unit(Vec a) { return a * (1 / std::sqrt(dot(a, a))); }

struct Triangle {
  unsigned corners[3];
};
struct Mesh {
  std::vector<Vec> positions;
  std::vector<Triangle> triangles;
};

/// As `penumbra generate` writes it: after the header 6 floats a vertex, a byte and 3 numbers a
/// face.
inline Mesh read_ply(const char* path) {
  std::ifstream file(path, std::ios::binary);
  std::size_t vertices = 0, faces = 0;
  for (std::string line; std::getline(file, line) && line != "end_header";) {
    std::sscanf(line.c_str(), "element vertex %zu", &vertices);
    std::sscanf(line.c_str(), "element face %zu", &faces);
  }
  Mesh mesh{std::vector<Vec>(vertices), std::vector<Triangle>(faces)};
  for (Vec& p : mesh.positions)
    file.read(reinterpret_cast<char*>(&p), sizeof p).ignore(sizeof p);  // its normal
  for (Triangle& t : mesh.triangles) file.ignore(1).read(reinterpret_cast<char*>(&t), sizeof t);
  if (!file || faces == 0) throw std::runtime_error(std::string(path) + ": not such a PLY file");
  // A ground under it.
  const unsigned n = static_cast<unsigned>(mesh.positions.size());
  for (Vec corner : {Vec{-400, -99, -3.05f}, Vec{400, -99, -3.05f}, Vec{0, 400, -3.05f}})
    mesh.positions.push_back(corner);
  mesh.triangles.push_back({{n, n + 1, n + 2}});
  return mesh;
}

inline RTCScene build_scene(RTCDevice device, const Mesh& mesh) {
  const RTCScene scene = rtcNewScene(device);
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                             mesh.positions.data(), 0, sizeof(Vec), mesh.positions.size());
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                             mesh.triangles.data(), 0, sizeof(Triangle), mesh.triangles.size());
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene);
  return scene;
}

struct Hit {
  Vec position, normal;  // that looks at the camera
  std::size_t pixel;
};
inline constexpr unsigned shadow_rays = 32;
inline constexpr Vec light_center{5, -6, 7}, eye{3.5f, -9.5f, 0.8f}, looks_at{0, 0, -0.5f};
inline constexpr float light_radius = 0.5f;

/// Pixel by pixel; those that see nothing have no hit.
inline std::vector<Hit> trace_camera(RTCScene scene, std::size_t size) {
  const Vec ahead = unit(looks_at - eye), right = unit(cross(ahead, {0, 0, 1})),
            up = cross(right, ahead);
  std::vector<Hit> hits;
  for (std::size_t pixel = 0; pixel < size * size; ++pixel) {
    const Vec way = ahead +
                    right * ((static_cast<float>(pixel % size) + 0.5f) / size - 0.5f) * 0.75f +
                    up * (0.5f - (static_cast<float>(pixel / size) + 0.5f) / size) * 0.75f;
    RTCRayHit ray{{eye.x, eye.y, eye.z, 0, way.x, way.y, way.z, 0, 1e9f, ~0u, 0, 0}, {}};
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) continue;
    const Vec normal = unit({ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z});
    hits.push_back({eye + way * ray.ray.tfar, dot(normal, way) < 0 ? normal : normal * -1, pixel});
  }
  return hits;
}

/// Lambert's law, times the seen part of the light.
inline std::vector<float> shade(const std::vector<Hit>& hits, const std::vector<float>& seen,
                                std::size_t size) {
  std::vector<float> picture(size * size, 0.4f);
  for (std::size_t i = 0; i < hits.size(); ++i)
    picture[hits[i].pixel] =
        0.05f + 0.85f * seen[i] *
                    std::max(0.0f, dot(hits[i].normal, unit(light_center - hits[i].position)));
  return picture;
}

/// Grey, of values from 0 to 1.
inline void write_pgm(const std::string& path, const std::vector<float>& values,
                      std::size_t width) {
  std::ofstream file(path, std::ios::binary);
  file << "P5 " << width << " " << values.size() / width << " 255\n";
  for (float value : values)
    file.put(static_cast<char>(255 * std::pow(std::clamp(value, 0.0f, 1.0f), 1 / 2.2f) + 0.5f));
  if (!file.flush()) throw std::runtime_error(path + " cannot be written");
}
