// SPDX-License-Identifier: MIT
// NFF that reads back to the same scene: what the format cannot say goes into the comments listed
// in nff_state.h. Lost are textures, texture coordinates, vertex colours, and vertices that no
// triangle uses.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "penumbra/geometry/polygon.h"
#include "penumbra/scene/nff_material.h"
#include "penumbra/scene_io/light_spec.h"
#include "penumbra/scene_io/nff_state.h"
#include "penumbra/scene_io/numbers.h"
#include "penumbra/scene_io/write_scene.h"

namespace penumbra {
namespace {

template <typename Number>
std::string words_of(Vec3<Number> v) {
  return fmt::format("{} {} {}", to_text(v.x), to_text(v.y), to_text(v.z));
}

template <typename... Values>
void append(std::string& out, fmt::format_string<Values...> format, Values&&... values) {
  fmt::format_to(std::back_inserter(out), format, std::forward<Values>(values)...);
}

float linear(float code) { return nff_color({code, 0, 0}).x; }

/// The inverse of `linear`, to double precision.
double display_code(double value) {
  return value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055;
}

/// The display code of a linear value: the shortest that gives the same bits when there is one.
std::string code_text(float value) {
  const double code = display_code(value);
  const std::string nearest = fmt::format("{:.6g}", code);
  for (int digits = 1; digits <= 6; ++digits) {
    std::string text = fmt::format("{:.{}g}", code, digits);
    if (linear(parse_float(text).value_or(-1)) == value) return text;
  }
  auto candidate = static_cast<float>(code);
  for (int i = 0; i < 4; ++i) candidate = std::nextafter(candidate, 0.0f);
  for (int i = 0; i < 9; ++i, candidate = std::nextafter(candidate, 1e30f))
    if (linear(candidate) == value) return to_text(candidate);
  return nearest;
}

/// Appends a colour, and on a line of its own what it must be in linear values where the display
/// codes are not exact.
void append_display_color(std::string& out, Color c, std::string_view directive) {
  const std::array codes = {code_text(c.x), code_text(c.y), code_text(c.z)};
  append(out, "{} {} {}\n", codes[0], codes[1], codes[2]);
  for (int channel = 0; channel < 3; ++channel)
    if (linear(parse_float(codes[channel]).value_or(-1)) != c[channel])
      return append(out, "#! {} {}\n", directive, words_of(c));
}

/// "r g b Kd" for a diffuse colour.
struct DiffuseText {
  std::array<std::string, 3> rgb;
  std::string kd = "1";
};

/// With the Kd of two digits for which three digits a colour give the same bits, when there is one:
/// so scenes that came from NFF keep their numbers.
DiffuseText diffuse_text(Color diffuse) {
  DiffuseText text;
  for (int percent = 100; percent > 0; --percent) {
    text.kd = fmt::format("{:g}", percent / 100.0);
    const float kd = *parse_float(text.kd);
    bool fits = true;
    for (int channel = 0; fits && channel < 3; ++channel) {
      const double share = static_cast<double>(diffuse[channel]) / static_cast<double>(kd);
      text.rgb[channel] = fmt::format("{:.3g}", display_code(share));
      fits = linear(*parse_float(text.rgb[channel])) * kd == diffuse[channel];
    }
    if (fits) return text;
  }
  return {{code_text(diffuse.x), code_text(diffuse.y), code_text(diffuse.z)}, "1"};
}

void append_color(std::string& out, const char* key, Color wanted, Color have) {
  if (wanted != have) append(out, " {} {}", key, words_of(wanted));
}

/// What `#! material` must add to a fill line that gives `have`.
std::string material_words(const Material& wanted, const Material& have) {
  std::string out;
  append_color(out, "diffuse", wanted.diffuse, have.diffuse);
  append_color(out, "highlight", wanted.highlight, have.highlight);
  append_color(out, "mirror", wanted.mirror, have.mirror);
  append_color(out, "transmission", wanted.transmission, have.transmission);
  append_color(out, "emission", wanted.emission, have.emission);
  if (wanted.shininess != have.shininess) append(out, " shininess {}", to_text(wanted.shininess));
  if (wanted.refraction_index != have.refraction_index)
    append(out, " refraction_index {}", to_text(wanted.refraction_index));
  if (!wanted.casts_shadow) out += " casts_shadow 0";
  if (!wanted.emits_from_back) out += " emits_from_back 0";
  if (wanted.name.empty()) return out;
  out += " name ";
  for (const char c : wanted.name) out += c == '\n' || c == '\r' ? ' ' : c;
  return out;
}

/// The fill line, and our comment after it where that is not enough.
std::string fill_text(const Material& m) {
  const DiffuseText diffuse = diffuse_text(m.diffuse);
  const float ks = m.mirror.x != 0 ? m.mirror.x : m.highlight.x;
  const bool is_dull = m.highlight == Color{} && (ks != 0 || m.shininess == 0);
  const float shine = is_dull ? 100000 : m.shininess;
  const float t = m.transmission.x, ior = m.refraction_index;
  Color rgb;
  for (int channel = 0; channel < 3; ++channel) rgb[channel] = *parse_float(diffuse.rgb[channel]);
  const Material read = nff_material(rgb, *parse_float(diffuse.kd), ks, shine, t, ior);
  std::string out =
      fmt::format("f {} {} {} {} {} {} {} {}\n", diffuse.rgb[0], diffuse.rgb[1], diffuse.rgb[2],
                  diffuse.kd, to_text(ks), to_text(shine), to_text(t), to_text(ior));
  const std::string more = material_words(m, read);
  if (!more.empty()) append(out, "#! material{}\n", more);
  return out;
}

void append_surroundings(std::string& out, const Scene& scene) {
  if (scene.background) {
    out += "b ";
    append_display_color(out, *scene.background, "background");
  } else {
    out += "#! background none\n";
  }
  append(out, "#! ambient {}\n#! up {}\n", words_of(scene.ambient), words_of(scene.up));
  if (scene.wants_ground) out += "#! ground\n";
  if (!scene.camera) return;
  const Camera& camera = *scene.camera;
  append(out, "v\nfrom {}\nat {}\nup {}\nangle {}\nhither {}\nresolution {} {}\n",
         words_of(camera.from), words_of(camera.at), words_of(camera.up), to_text(camera.fov_deg),
         to_text(camera.near), camera.width, camera.height);
  if (camera.parallel_height > 0) append(out, "#! parallel {}\n", to_text(camera.parallel_height));
  const ImageWindow& w = camera.window;
  if (w.left != 0 || w.top != 0 || w.right != 1 || w.bottom != 1)
    append(out, "#! window {} {} {} {}\n", to_text(w.left), to_text(w.top), to_text(w.right),
           to_text(w.bottom));
}

void append_light(std::string& out, const Light& light, Color shared) {
  const auto* ball = std::get_if<BallLight>(&light.shape);
  if (ball == nullptr && !std::holds_alternative<PointLight>(light.shape)) {
    append(out, "#! light {}\n", light_words(light));
  } else {
    append(out, "l {}", words_of(*center(light.shape)));
    out += light.intensity == shared ? "\n" : " ";
    if (light.intensity != shared) append_display_color(out, light.intensity, "intensity");
    if (light.beam) append(out, "#! beam {}\n", beam_words(*light.beam));
  }
  // Other programs see a ball as a point, which is better than not at all.
  if (ball != nullptr) append(out, "#! radius {}\n", to_text(ball->radius));
  if (light.falloff == Falloff::inverse_square) out += "#! falloff inverse_square\n";
}

/// Writes shapes, with a fill line wherever the surface changes.
class ShapeWriter {
 public:
  ShapeWriter(std::string& out, const Scene& scene) : out_(out) {
    for (const Material& material : scene.materials) fills_.push_back(fill_text(material));
    // All of them first, in order: then they have the same indices when read.
    for (const std::string& fill : fills_) out_ += fill;
    if (!fills_.empty()) current_ = static_cast<std::uint32_t>(fills_.size() - 1);
  }

  void add(const Sphere& s) {
    use(s.surface);
    append(out_, "s {} {}\n", words_of(s.center), to_text(s.radius));
  }

  void add(const Cone& c) {
    use(c.surface);
    if (c.caps == Caps::capped) out_ += "#! capped\n";
    add_cone(c.base, c.base_radius, c.apex, c.apex_radius);
  }

  void add(const Ring& r) {
    use(r.surface);
    append(out_, "#! ring {}\n", words_of(r.normal));
    add_cone(r.center, r.radius, r.center, r.inner_radius);
  }

  void add(const Mesh& mesh) {
    if (mesh.triangles.empty()) return;
    if (mesh.is_backdrop && is_one_polygon(mesh)) return add_backdrop(mesh);
    if (mesh.is_backdrop)
      out_ += "#! mesh backdrop\n";
    else if (has_mesh_)
      out_ += "#! mesh\n";
    has_mesh_ = true;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) add_triangle(mesh, t);
  }

 private:
  void use(std::uint32_t surface) {
    if (surface == current_ || surface >= fills_.size()) return;
    out_ += fills_[surface];
    current_ = surface;
  }

  void add_cone(Vec3f base, float base_radius, Vec3f apex, float apex_radius) {
    append(out_, "c {} {}  {} {}\n", words_of(base), to_text(base_radius), words_of(apex),
           to_text(apex_radius));
  }

  static bool is_one_polygon(const Mesh& mesh) {
    return mesh.normals.empty() && mesh.surfaces.empty() && mesh.positions.size() > 3 &&
           mesh.positions.size() <= 64 && triangulate(mesh.positions) == mesh.triangles;
  }

  void add_backdrop(const Mesh& mesh) {
    use(mesh.surface);
    append(out_, "#! backdrop\np {}\n", mesh.positions.size());
    for (const Vec3f p : mesh.positions) append(out_, "{}\n", words_of(p));
  }

  void add_triangle(const Mesh& mesh, std::size_t t) {
    use(surface_of(mesh, t));
    out_ += mesh.normals.empty() ? "p 3\n" : "pp 3\n";
    for (const std::uint32_t corner : mesh.triangles[t]) {
      out_ += words_of(mesh.positions[corner]);
      if (!mesh.normals.empty()) append(out_, "  {}", words_of(mesh.normals[corner]));
      out_ += "\n";
    }
  }

  std::string& out_;
  std::vector<std::string> fills_;  ///< a material
  std::uint32_t current_ = std::numeric_limits<std::uint32_t>::max();
  bool has_mesh_ = false;
};

}  // namespace

std::string to_nff(const Scene& scene) {
  std::string out = "# written by penumbra; comments with #! are its own\n";
  append_surroundings(out, scene);
  const float shared = nff_light_intensity(scene.lights.size());
  for (const Light& light : scene.lights) append_light(out, light, {shared, shared, shared});
  ShapeWriter writer(out, scene);
  for (const Sphere& sphere : scene.shapes.spheres) writer.add(sphere);
  for (const Cone& cone : scene.shapes.cones) writer.add(cone);
  for (const Ring& ring : scene.shapes.rings) writer.add(ring);
  for (const Mesh& mesh : scene.shapes.meshes) writer.add(mesh);
  return out;
}

}  // namespace penumbra
