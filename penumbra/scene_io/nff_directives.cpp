// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstring>

#include "penumbra/scene_io/light_spec.h"
#include "penumbra/scene_io/nff_state.h"
#include "penumbra/scene_io/numbers.h"

namespace penumbra {
namespace {

Vec3f read_vector(Tokens& words, std::string_view what) {
  const float x = words.number(what), y = words.number(what), z = words.number(what);
  return {x, y, z};
}

Color read_color(Tokens& words, std::string_view what) {
  const Token first = words.peek();
  const Color color = read_vector(words, what);
  if (color.x < 0 || color.y < 0 || color.z < 0)
    throw Error(words.place(first), std::string(what) + " is below 0", "give numbers from 0 up");
  return color;
}

/// The words after the first, as `read` takes them; its errors get the directive's place.
template <typename Read>
auto read_words(const Token& directive, const std::string& file, Read read) {
  std::vector<std::string> words = split_words(directive.text);
  words.erase(words.begin());
  try {
    return read(words);
  } catch (const Error& error) {
    throw Error({file, directive.line, {}}, error.problem, error.hint);
  }
}

void add_light(NffState& state, const Token& directive, const std::string& file) {
  const LightSpec spec = read_words(
      directive, file, [](std::span<const std::string> words) { return parse_light_spec(words); });
  state.scene.lights.push_back(
      {spec.shape, spec.intensity.value_or(Color{}), Falloff::none, spec.beam});
  state.light_has_intensity.push_back(spec.intensity.has_value());
}

Light& last_light(NffState& state, const Tokens& words, const Token& directive) {
  if (state.scene.lights.empty())
    throw Error(words.place(directive), "there is no light before this comment",
                "put it after the light that it is about");
  return state.scene.lights.back();
}

void set_radius(NffState& state, Tokens& words, const Token& directive) {
  Light& light = last_light(state, words, directive);
  const Token value = words.peek();
  const float radius = words.number("a radius");
  const bool is_round = std::holds_alternative<PointLight>(light.shape) ||
                        std::holds_alternative<BallLight>(light.shape);
  if (!(radius > 0) || !is_round)
    throw Error(words.place(value), "makes no ball of the light before this comment",
                "give a radius above 0 after a point");
  light.shape = BallLight{*center(light.shape), radius};
}

void set_beam(NffState& state, Tokens& words, const Token& directive, const Token& line) {
  Light& light = last_light(state, words, directive);
  light.beam = read_words(line, words.file(), [&](std::span<const std::string> beam_words) {
    return parse_beam(beam_words, light.shape);
  });
  while (!words.next().text.empty()) {
  }
}

Camera& last_view(NffState& state, const Tokens& words, const Token& directive) {
  if (!state.scene.camera)
    throw Error(words.place(directive), "there is no view before this comment",
                "put it after the view that it is about");
  return *state.scene.camera;
}

void set_parallel(NffState& state, Tokens& words, const Token& directive) {
  const Token value = words.peek();
  const double height = words.number_double("a height");
  if (!(height > 0)) words.fail(value, "a height above 0");
  last_view(state, words, directive).parallel_height = height;
}

void set_window(NffState& state, Tokens& words, const Token& directive) {
  ImageWindow& window = last_view(state, words, directive).window;
  for (double* edge : {&window.left, &window.top, &window.right, &window.bottom})
    *edge = words.number_double("an edge of the window");
}

void set_material(NffState& state, Tokens& words) {
  Material& m = state.material;
  state.surface.reset();
  for (Token key = words.next(); !key.text.empty(); key = words.next()) {
    if (key.text == "diffuse")
      m.diffuse = read_color(words, "a colour");
    else if (key.text == "highlight")
      m.highlight = read_color(words, "a colour");
    else if (key.text == "mirror")
      m.mirror = read_color(words, "a colour");
    else if (key.text == "transmission")
      m.transmission = read_color(words, "a colour");
    else if (key.text == "emission")
      m.emission = read_color(words, "a colour");
    else if (key.text == "shininess")
      m.shininess = std::max(0.0f, words.number("a shininess"));
    else if (key.text == "refraction_index") {
      const Token value = words.peek();
      m.refraction_index = words.number("a refraction index");
      if (!(m.refraction_index > 0)) words.fail(value, "a refraction index above 0");
    } else if (key.text == "casts_shadow")
      m.casts_shadow = words.integer("0 or 1") != 0;
    else if (key.text == "emits_from_back")
      m.emits_from_back = words.integer("0 or 1") != 0;
    else if (key.text == "name")
      m.name = std::string(words.rest_of_line());
    else
      words.fail(key, "a member of a material");
  }
}

void set_background(NffState& state, Tokens& words) {
  if (words.peek().text == "none") {
    words.next();
    state.scene.background.reset();
    return;
  }
  state.scene.background = read_color(words, "a background colour");
}

void begin_mesh(NffState& state, Tokens& words) {
  state.flat_mesh = state.smooth_mesh = NffState::none;
  state.mesh_is_backdrop = words.peek().text == "backdrop";
  if (state.mesh_is_backdrop) words.next();
}

}  // namespace

std::uint32_t current_surface(NffState& state) {
  if (state.surface) return *state.surface;
  const Material& m = state.material;
  const Color colors[] = {m.diffuse, m.highlight, m.mirror, m.transmission, m.emission};
  const float numbers[] = {m.shininess, m.refraction_index, m.casts_shadow ? 1.0f : 0.0f,
                           m.emits_from_back ? 1.0f : 0.0f};
  std::string bits(sizeof colors + sizeof numbers, '\0');
  std::memcpy(bits.data(), colors, sizeof colors);
  std::memcpy(bits.data() + sizeof colors, numbers, sizeof numbers);
  const auto next = static_cast<std::uint32_t>(state.scene.materials.size());
  const auto [entry, is_new] = state.surfaces_by_bits.emplace(bits + m.name, next);
  if (is_new) state.scene.materials.push_back(m);
  state.surface = entry->second;
  return *state.surface;
}

void apply_directive(NffState& state, const Token& directive, const std::string& file,
                     Warnings& warnings) {
  Tokens words(file, directive.text, Comments::none, directive.line);
  const Token name = words.next();
  Scene& scene = state.scene;
  if (name.text == "light") return add_light(state, directive, file);
  if (name.text == "radius") {
    set_radius(state, words, name);
  } else if (name.text == "intensity") {
    last_light(state, words, name).intensity = read_color(words, "an intensity");
    state.light_has_intensity.back() = true;
  } else if (name.text == "falloff") {
    const Token value = words.next();
    if (value.text != "inverse_square") words.fail(value, "inverse_square");
    last_light(state, words, name).falloff = Falloff::inverse_square;
  } else if (name.text == "beam") {
    set_beam(state, words, name, directive);
  } else if (name.text == "parallel") {
    set_parallel(state, words, name);
  } else if (name.text == "window") {
    set_window(state, words, name);
  } else if (name.text == "background") {
    set_background(state, words);
  } else if (name.text == "ambient") {
    scene.ambient = read_color(words, "an ambient colour");
  } else if (name.text == "up") {
    for (int axis = 0; axis < 3; ++axis) scene.up[axis] = words.number_double("a direction");
    state.has_up = true;
  } else if (name.text == "ground") {
    scene.wants_ground = true;
  } else if (name.text == "material") {
    set_material(state, words);
  } else if (name.text == "backdrop") {
    state.next_is_backdrop = true;
  } else if (name.text == "mesh") {
    begin_mesh(state, words);
  } else if (name.text == "capped") {
    state.next_caps = Caps::capped;
  } else if (name.text == "ring") {
    state.next_ring_normal = read_vector(words, "a normal");
  } else {
    return warnings.add("a comment that begins with #! is not known and left out", name.line);
  }
  if (const Token more = words.next(); !more.text.empty())
    words.fail(more, "the end of the line after " + in_quotes(name.text));
}

}  // namespace penumbra
