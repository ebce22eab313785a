// SPDX-License-Identifier: MIT
// Values of options, from text. All parsers throw UsageError that says what is expected, with the
// choices where only some words are, which is where shells get them from (complete.cpp); the
// option's own name is added by `add_parsed`.
#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "bake_files.h"
#include "penumbra/kernel/embree_baseline.h"
#include "penumbra/scene/complete_scene.h"
#include "penumbra/scene_io/read_points.h"
#include "penumbra/scene_io/read_scene.h"
#include "penumbra/scene_io/write_answers.h"
#include "penumbra/trace/render.h"

namespace CLI {
class App;  // the library takes long to compile
class Option;
}  // namespace CLI

namespace penumbra {

struct PixelSize {
  std::uint32_t width = 0, height = 0;
};

struct PixelPosition {
  std::uint32_t x = 0, y = 0;
};

/// A finite number in [least, most].
double parse_number(std::string_view text, double least, double most);
/// A whole number in [least, most].
std::uint64_t parse_count(std::string_view text, std::uint64_t least, std::uint64_t most);
/// `640x480`; at most 65536 a side and 2^28 pixels.
PixelSize parse_size(std::string_view text);
/// `x,y`
PixelPosition parse_pixel(std::string_view text);
/// `x,y,z`
Vec3d parse_vector(std::string_view text);
/// `r,g,b`, none negative.
Color parse_color(std::string_view text);
/// `0.5` or `10%`
LightRadius parse_light_radius(std::string_view text);
/// `auto`, `none` or a height.
std::variant<GroundChoice, double> parse_ground(std::string_view text);
MoleculeStyle parse_style(std::string_view text);

enum class Shell { bash, zsh, fish };
Shell parse_shell(std::string_view text);

/// What stands between the commas.
std::vector<std::string> parse_list(std::string_view text);

Method parse_method(std::string_view text);
/// `shaft` or `stochastic`: what can be asked of single points.
Method parse_asking_method(std::string_view text);
/// In the order in which help and tables name them.
std::vector<Method> all_methods();
std::string_view name_of(Method method);

/// `native` or `user`.
EmbreeSpheres parse_embree_spheres(std::string_view text);

/// `class,visibility,depth,normal,samples`, any of them.
std::vector<Aov> parse_aovs(std::string_view text);

/// `auto`, `1` or `2`.
UvChoice parse_uv_set(std::string_view text);
/// `none` or `cosine`.
BakeValue parse_bake_value(std::string_view text);
/// `8` or `16`.
int parse_bits(std::string_view text);
/// `per-light` or `mean`.
BakeChannel parse_bake_channel(std::string_view text);
/// `class` and `coverage`, any of them: sets what is named.
void parse_bake_layers(std::string_view text, BakeOutput& output);

/// The words after all `--light` options, one after the other: a light starts at each word that is
/// not a number.
std::vector<Light> parse_lights(const std::vector<std::string>& words);

/// Whether a file's name ends in this, in capitals or not.
bool has_extension(std::string_view name, std::string_view extension);

/// A name that ends in one of these extensions.
std::string parse_output(std::string_view text, std::initializer_list<std::string_view> extensions);

/// csv, ply, npy, float or double.
PointFormat parse_point_format(std::string_view text);
/// csv, ascii, npy, ply, float or double.
AnswerFormat parse_answer_format(std::string_view text);

/// One file for two purposes would end as neither. Empty names and `-` are none.
void check_files_differ(const std::string& a, const std::string& b);

/// Adds an option whose text goes to `parse`, with the option's name put before what it throws.
CLI::Option* add_parsed(CLI::App& command, const std::string& names, const std::string& value,
                        const std::string& help,
                        const std::function<void(const std::string&)>& parse);

/// Adds `--style` and `--waters`.
void add_read_options(CLI::App& command, ReadOptions& options);

}  // namespace penumbra
