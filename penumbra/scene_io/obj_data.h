// SPDX-License-Identifier: MIT
// An OBJ file's statements, and the meshes made of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "penumbra/scene/scene.h"
#include "penumbra/scene_io/source.h"

namespace penumbra {

/// Indices from 0 into the file's lists of positions, texture coordinates and normals; -1: none.
struct ObjCorner {
  std::int64_t position = -1, uv = -1, normal = -1;
};

struct ObjFace {
  std::size_t first_corner = 0, line = 0;
  std::uint32_t corner_count = 0;
  std::uint32_t material = 0;  ///< index into ObjData::material_names
  bool is_smooth = false;      ///< in a smoothing group
};

/// A file name that the text mentions, and where.
struct ObjMention {
  std::string text;
  std::size_t line = 0;
};

/// Indices of corners are not yet checked against the lists' ends, since faces may come first.
struct ObjData {
  std::vector<Vec3f> positions, normals;
  std::vector<Color> colors;  ///< empty, or one a position (linear)
  std::vector<Vec2f> uvs;
  std::vector<ObjCorner> corners;
  std::vector<ObjFace> faces;
  std::vector<std::string> material_names{""};   ///< the first is for faces without any
  std::map<std::string, std::size_t> first_use;  ///< line of a material's first usemtl
  std::vector<ObjMention> libraries;             ///< mtllib
};

/// Reads all statements. Throws Error with the line of numbers that are none or not finite, and of
/// keywords that the format does not have.
ObjData parse_obj(const Source& source, Warnings& warnings);

/// Meshes of all faces, surfaces being ObjFace::material: one for faces that have normals, one for
/// smoothing groups without (which get them), one for flat faces. Throws Error with the line of a
/// face whose index is out of range.
std::vector<Mesh> obj_meshes(const ObjData& data, const std::string& file);

}  // namespace penumbra
