// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/gltf_extensions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

namespace penumbra {
namespace {

/// Read, of no matter for a still picture, or warned of where they are used.
constexpr std::array<std::string_view, 18> known{"EXT_mesh_gpu_instancing",
                                                 "KHR_animation_pointer",
                                                 "KHR_lights_punctual",
                                                 "KHR_materials_emissive_strength",
                                                 "KHR_materials_ior",
                                                 "KHR_materials_pbrSpecularGlossiness",
                                                 "KHR_materials_transmission",
                                                 "KHR_materials_unlit",
                                                 "KHR_materials_variants",
                                                 "KHR_materials_volume",
                                                 "KHR_mesh_quantization",
                                                 "KHR_node_hoverability",
                                                 "KHR_node_selectability",
                                                 "KHR_node_visibility",
                                                 "KHR_texture_transform",
                                                 "KHR_xmp",
                                                 "KHR_xmp_json_ld",
                                                 "VRM"};

constexpr std::array<std::string_view, 3> compressions{
    "KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"};

/// Surfaces and their images: without it they look plainer, but stand where they stood.
constexpr std::array<std::string_view, 10> looks{
    "KHR_materials_",  "EXT_materials_",        "MSFT_materials_", "ADOBE_materials_",
    "VRMC_",           "KHR_texture_",          "EXT_texture_",    "MSFT_texture_",
    "GOOGLE_texture_", "EXT_lights_image_based"};

bool is_among(const auto& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

void check_required_extensions(const GltfDocument& gltf, Warnings& warnings) {
  const Json* required = member(gltf.root, "extensionsRequired");
  if (!required || !required->is_array()) return;
  for (const Json& entry : *required) {
    if (!entry.is_string()) gltf.fail("'extensionsRequired' is not a list of names");
    const std::string name = entry.get<std::string>();
    if (is_among(known, name)) continue;
    if (is_among(compressions, name)) refuse_compression(gltf, name);
    const bool is_look = std::any_of(looks.begin(), looks.end(), [&](std::string_view begin) {
      return std::string_view(name).starts_with(begin);
    });
    if (!is_look)
      gltf.fail(fmt::format("it requires the extension '{:.60}', which is not read", name),
                "export it without");
    warnings.add(fmt::format("the extension {:.60} is not read; surfaces look plainer", name));
  }
}

void refuse_compression(const GltfDocument& gltf, std::string_view name) {
  gltf.fail(
      fmt::format("its meshes are compressed ({}), which is not read", name),
      "unpack it with `gltf-transform copy in.glb out.glb`, or export it without compression");
}

}  // namespace penumbra
