// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/read_scene.h"

#include <fmt/format.h>

#include <assimp/cimport.h>
#include <algorithm>

#include <string_view>

#include "penumbra/scene/settle_instances.h"
#include "penumbra/scene_io/source.h"

namespace penumbra {
namespace {

/// What the first bytes prove; empty where they prove nothing.
std::string_view sniffed_extension(std::string_view bytes) {
  if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r")) return "ply";
  if (bytes.starts_with("glTF")) return "glb";
  return {};
}

/// The same for files whose name says nothing: less is enough.
std::string_view guessed_extension(std::string_view bytes) {
  if (bytes.starts_with("solid")) return "stl";
  if (bytes.starts_with("data_")) return "cif";
  for (const std::string_view record :
       {"HEADER ", "ATOM  ", "HETATM", "CRYST1", "REMARK ", "MODEL "})
    if (bytes.starts_with(record)) return "pdb";
  return {};
}

bool assimp_knows(const std::string& extension) {
  return !extension.empty() && aiIsExtensionSupported(("." + extension).c_str()) == AI_TRUE;
}

enum class Format { nff, obj, ply, stl, gltf, pbrt, radiance, molecule, other, unknown };

Format format_of(const std::string& extension) {
  if (extension == "nff") return Format::nff;
  if (extension == "obj") return Format::obj;
  if (extension == "ply") return Format::ply;
  if (extension == "stl") return Format::stl;
  if (extension == "gltf" || extension == "glb" || extension == "vrm") return Format::gltf;
  if (extension == "pbrt") return Format::pbrt;
  if (extension == "rad" || extension == "rif") return Format::radiance;
  if (extension == "pdb" || extension == "ent" || extension == "cif" || extension == "mmcif")
    return Format::molecule;
  return assimp_knows(extension) ? Format::other : Format::unknown;
}

/// The format by name, unless the content is surely another one.
Format choose_format(Source& source, Warnings& warnings) {
  const Format named = format_of(source.extension);
  std::string_view sniffed = sniffed_extension(source.bytes);
  if (sniffed.empty() && named == Format::unknown) sniffed = guessed_extension(source.bytes);
  if (sniffed.empty()) return named;
  const Format format = format_of(std::string(sniffed));
  if (format == named) return named;
  if (named != Format::unknown)
    warnings.add("the name says ." + source.extension + ", but it is read as what it is, ." +
                 std::string(sniffed));
  source.extension = sniffed;
  return format;
}

Scene read(const Source& source, Format format, const ReadOptions& options, Warnings& warnings) {
  switch (format) {
    case Format::nff: return read_nff(source, warnings);
    case Format::obj: return read_obj(source, warnings);
    case Format::ply: return read_ply(source, warnings);
    case Format::stl: return read_stl(source, warnings);
    case Format::gltf: return read_gltf(source, warnings);
    case Format::pbrt: return read_pbrt(source, warnings);
    case Format::radiance: return read_radiance(source, warnings);
    case Format::molecule: return read_molecule(source, options, warnings);
    case Format::other: return read_assimp(source, warnings);
    case Format::unknown: break;
  }
  throw Error({source.path.string(), {}, {}},
              source.extension.empty() ? "the file has no extension that names its format"
                                       : "the format ." + source.extension + " is not known",
              "use .nff, .obj, .ply, .stl, .gltf, .glb, .pbrt, .rad, .rif, .pdb, .cif, or one that "
              "assimp reads "
              "(.dae, .fbx, .3ds, .off, .x3d and others), each also as .gz");
}

/// Scenes are in single precision: far from the origin little of a small model is left.
void warn_of_lost_digits(const Scene& scene, Warnings& warnings) {
  const Box box = object_bounds(scene.shapes);
  if (box.is_empty()) return;
  const float step = 0x1p-23f * std::max(max_abs(box.lo), max_abs(box.hi));
  if (step > 1e-5f * box.largest_extent())
    warnings.add(
        fmt::format("so far from the origin coordinates are rounded to steps of {:.2g}, and "
                    "the objects measure {:.2g}; move them to the origin",
                    step, box.largest_extent()));
}

void settle(Scene& scene, Warnings& warnings) {
  if (const std::size_t count = settle_instances(scene.shapes).stretched; count > 0)
    warnings.add(fmt::format("{} round shape{} stretched by instances: drawn as meshes", count,
                             count == 1 ? " is" : "s are"));
}

}  // namespace

SceneFile read_source(Source source, const ReadOptions& options) {
  const std::string name = source.path.string();
  Warnings warnings(name);
  if (source.bytes.empty())
    throw Error({name, {}, {}}, "the file is empty", "check how it was made");
  const Format format = choose_format(source, warnings);
  SceneFile file;
  file.scene = read(source, format, options, warnings);
  file.scene.name = name;
  settle(file.scene, warnings);
  const ValidationReport report = validate(file.scene);
  if (const std::size_t count = report.degenerate_triangles; count > 0)
    warnings.add(
        fmt::format("{} degenerate triangle{} left out", count, count == 1 ? " is" : "s are"));
  warn_of_lost_digits(file.scene, warnings);
  file.warnings = warnings.lines();
  return file;
}

SceneFile read_scene(const std::filesystem::path& path, const ReadOptions& options) {
  return read_source(load(path), options);
}

}  // namespace penumbra
