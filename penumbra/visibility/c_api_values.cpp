// SPDX-License-Identifier: MIT
#include "penumbra/visibility/c_api_values.h"

#include <cstdlib>
#include <vector>

#include "penumbra/visibility/lights.h"

namespace penumbra {
namespace {

Vec3f vector(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

std::vector<Vec3f> corners_of(const penumbra_light& light) {
  const VectorRows rows = rows_of<Vec3f>(light.corners, "light.corners");
  std::vector<Vec3f> corners;
  corners.reserve(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) corners.push_back(rows[i]);
  return corners;
}

Method method_of(std::uint32_t method) {
  if (method == PENUMBRA_METHOD_SHAFT) return Method::shaft;
  if (method == PENUMBRA_METHOD_STOCHASTIC) return Method::stochastic;
  refuse_argument("there is no method " + std::to_string(method) +
                  "; use PENUMBRA_METHOD_SHAFT or PENUMBRA_METHOD_STOCHASTIC");
}

}  // namespace

std::ptrdiff_t checked_stride(const penumbra_rows& rows, std::size_t row_size, const char* name) {
  if (!rows.data)
    refuse_argument(std::string(name) + " has NULL for data and a count of " +
                    std::to_string(rows.count));
  if (rows.stride == PENUMBRA_STRIDE_REPEAT) return 0;
  const std::ptrdiff_t stride =
      rows.stride == 0 ? static_cast<std::ptrdiff_t>(row_size) : rows.stride;
  // Bytes between the first row and the last, and where both begin.
  const std::size_t step = static_cast<std::size_t>(std::abs(stride)), steps = rows.count - 1;
  const auto first = reinterpret_cast<std::uintptr_t>(rows.data);
  const std::size_t room = stride > 0 ? UINTPTR_MAX - first : first;
  const bool fits = steps <= (PTRDIFF_MAX - row_size) / step && steps * step <= room &&
                    first + (stride > 0 ? steps * step : 0) <= UINTPTR_MAX - row_size;
  if (!fits) refuse_argument(std::string(name) + " has a count and stride beyond all memory");
  return stride;
}

void check_struct_size(std::size_t given, std::size_t known, const char* name) {
  if (given == known) return;
  const std::string sizes = std::to_string(given) + " instead of " + std::to_string(known);
  refuse_argument(std::string(name) + " has a struct_size of " + sizes +
                  (given > known ? "; set it to sizeof, or use the library of your header or later"
                                 : "; set it to sizeof"));
}

Vec3f vector_of(const float* given, const char* name) {
  check_pointer(given, name);
  float v[3];
  std::memcpy(v, static_cast<const void*>(given), sizeof v);
  return vector(v);
}

void write_vector(float* out, Vec3f v, const char* name) {
  check_pointer(out, name);
  const float numbers[3] = {v.x, v.y, v.z};
  std::memcpy(static_cast<void*>(out), numbers, sizeof numbers);
}

Transform transform_of(const double* placement) {
  check_pointer(placement, "placement");
  double m[12];
  std::memcpy(m, static_cast<const void*>(placement), sizeof m);
  const auto column = [&m](int i) { return Vec3d{m[i], m[4 + i], m[8 + i]}; };
  return {column(0), column(1), column(2), column(3)};
}

LightShape light_of(const penumbra_light* light) {
  const auto given = read_struct(light, "light");
  const Vec3f center = vector(given.center), u = vector(given.u), v = vector(given.v);
  switch (given.kind) {
    case PENUMBRA_LIGHT_POINT: return PointLight{center};
    case PENUMBRA_LIGHT_BALL: return BallLight{center, given.radius};
    case PENUMBRA_LIGHT_PARALLELOGRAM: return ParallelogramLight{center, u, v};
    case PENUMBRA_LIGHT_DISK: return DiskLight{center, u, given.radius};
    case PENUMBRA_LIGHT_LINE: return LineLight{center, u};
    case PENUMBRA_LIGHT_SUN: return sun_light(u, given.diameter_deg);
    case PENUMBRA_LIGHT_POLYGON: return polygon_light(corners_of(given));
    case PENUMBRA_LIGHT_HULL: return hull_light(corners_of(given));
    default:
      refuse_argument("there is no kind of light " + std::to_string(given.kind) +
                      "; use one of PENUMBRA_LIGHT_POINT to PENUMBRA_LIGHT_HULL");
  }
}

Points points_of(const penumbra_points* points) {
  const auto given = read_struct(points, "points");
  if (given.has_offset > 1) refuse_argument("points.has_offset is neither 0 nor 1");
  Points read;
  read.positions = rows_of<Vec3f>(given.positions, "points.positions");
  read.normals = rows_of<Vec3f>(given.normals, "points.normals");
  read.keys = rows_of<std::uint64_t>(given.keys, "points.keys");
  read.first_key = given.first_key;
  if (given.has_offset) read.offset = given.offset;
  return read;
}

AskOptions ask_options_of(const penumbra_ask_options* options) {
  if (!options) return {};
  const auto given = read_struct(options, "options");
  AskOptions read;
  read.shadow_samples = given.shadow_samples;
  read.method = method_of(given.method);
  if (given.keys_are_final > 1) refuse_argument("options.keys_are_final is neither 0 nor 1");
  read.light_index.reset();
  if (!given.keys_are_final) read.light_index = given.light_index;
  read.threads = given.threads;
  if (given.progress)
    read.progress = [call = given.progress, user = given.progress_user](double share) {
      const InProgress within;
      return call(user, share) != 0;
    };
  return read;
}

}  // namespace penumbra
