// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/assimp_import.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include <assimp/DefaultIOSystem.h>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include "penumbra/scene_io/byte_stream.h"

namespace penumbra {

namespace {

/// Gives assimp our bytes under the file's name, and the files beside it as they are.
class SourceFiles : public Assimp::DefaultIOSystem {
 public:
  SourceFiles(std::string name, const std::string& bytes) : name_(std::move(name)), bytes_(bytes) {}

  bool Exists(const char* file) const override {
    return file == name_ || DefaultIOSystem::Exists(file);
  }
  Assimp::IOStream* Open(const char* file, const char* mode) override {
    if (file != name_) return DefaultIOSystem::Open(file, mode);
    return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(bytes_.data()),
                                      bytes_.size());
  }
  void Close(Assimp::IOStream* stream) override { delete stream; }

 private:
  std::string name_;
  const std::string& bytes_;
};

Vec3f to_vec(const aiVector3D& v) { return {v.x, v.y, v.z}; }
Color to_color(const aiColor3D& c) { return max(Color{c.r, c.g, c.b}, Color{}); }

Color color_of(const aiMaterial& material, const char* key, unsigned type, unsigned index) {
  aiColor3D color(0, 0, 0);
  material.Get(key, type, index, color);
  return to_color(color);
}

float number_of(const aiMaterial& material, const char* key, unsigned type, unsigned index,
                float otherwise) {
  material.Get(key, type, index, otherwise);
  return otherwise;
}

void pack_material(const aiMaterial& source, ByteWriter& out) {
  aiColor3D diffuse(0.8f, 0.8f, 0.8f);
  if (source.Get(AI_MATKEY_BASE_COLOR, diffuse) != AI_SUCCESS)
    source.Get(AI_MATKEY_COLOR_DIFFUSE, diffuse);
  // Files disagree whether 0 or 1 is opaque, and nobody writes what cannot be seen.
  float opacity = std::clamp(number_of(source, AI_MATKEY_OPACITY, 1), 0.0f, 1.0f);
  if (opacity == 0) opacity = 1;
  const float shininess = number_of(source, AI_MATKEY_SHININESS, 0);
  const float strength = number_of(source, AI_MATKEY_SHININESS_STRENGTH, 1);

  out.text(source.GetName().C_Str());
  out.value(to_color(diffuse) * opacity);
  out.value(shininess > 0 ? min(color_of(source, AI_MATKEY_COLOR_SPECULAR) * strength, {1, 1, 1})
                          : Color{});
  out.value(std::clamp(shininess, 0.0f, 1e6f));
  out.value(Color{1, 1, 1} * (1 - opacity));
  out.value(color_of(source, AI_MATKEY_COLOR_EMISSIVE));
  aiString texture;
  if (source.GetTexture(aiTextureType_BASE_COLOR, 0, &texture) != AI_SUCCESS)
    source.GetTexture(aiTextureType_DIFFUSE, 0, &texture);
  out.text(texture.C_Str());
}

void pack_mesh(const aiMesh& mesh, ByteWriter& out) {
  std::vector<Vec3f> positions, normals, colors;
  std::vector<Vec2f> uvs, lightmap_uvs;
  std::vector<Triangle> triangles;
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    positions.push_back(to_vec(mesh.mVertices[i]));
    if (mesh.HasNormals()) normals.push_back(to_vec(mesh.mNormals[i]));
    if (mesh.HasTextureCoords(0))
      uvs.push_back({mesh.mTextureCoords[0][i].x, mesh.mTextureCoords[0][i].y});
    if (mesh.HasTextureCoords(1))
      lightmap_uvs.push_back({mesh.mTextureCoords[1][i].x, mesh.mTextureCoords[1][i].y});
    if (mesh.HasVertexColors(0)) {
      const aiColor4D c = mesh.mColors[0][i];
      colors.push_back(to_color({c.r, c.g, c.b}));
    }
  }
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const aiFace& face = mesh.mFaces[i];
    if (face.mNumIndices == 3)
      triangles.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
  }
  out.value(static_cast<std::uint32_t>(mesh.mMaterialIndex));
  out.text(mesh.mName.C_Str());
  out.list(positions);
  out.list(normals);
  out.list(uvs);
  out.list(colors);
  out.list(lightmap_uvs);
  out.list(triangles);
}

void pack_camera(const aiScene& scene, ByteWriter& out) {
  Camera camera;
  bool is_usable = false;
  if (scene.mNumCameras > 0) {
    const aiCamera& source = *scene.mCameras[0];
    camera.from = Vec3d(to_vec(source.mPosition));
    camera.at = camera.from + Vec3d(to_vec(source.mLookAt));
    camera.up = Vec3d(to_vec(source.mUp));
    const double aspect = source.mAspect > 0 ? static_cast<double>(source.mAspect) : 1;
    const double half_width = std::tan(static_cast<double>(source.mHorizontalFOV) / 2);
    camera.fov_deg = 2 * std::atan(half_width / aspect) * 180 / std::numbers::pi;
    is_usable = source.mOrthographicWidth == 0 && camera.fov_deg > 1 && camera.fov_deg < 179 &&
                length(cross(camera.at - camera.from, camera.up)) > 0;
  }
  out.value(static_cast<std::uint32_t>(is_usable));
  if (is_usable) out.value(camera);
}

/// A light as plain numbers: a variant's index must not come out of a stream.
struct PackedLight {
  Vec3f place;  ///< position, or where the sun is
  std::uint32_t is_sun = 0;
  Color intensity;
};

void pack_lights(const aiScene& scene, ByteWriter& out) {
  std::vector<PackedLight> lights;
  for (unsigned i = 0; i < scene.mNumLights; ++i) {
    const aiLight& source = *scene.mLights[i];
    PackedLight light{to_vec(source.mPosition), 0, to_color(source.mColorDiffuse)};
    if (source.mType == aiLightSource_DIRECTIONAL) {
      light = {normalize(-to_vec(source.mDirection)), 1, light.intensity};
      if (light.place == Vec3f{}) continue;
    } else if (source.mType != aiLightSource_POINT && source.mType != aiLightSource_SPOT) {
      continue;
    }
    if (max_abs(light.intensity) > 0) lights.push_back(light);
  }
  out.list(lights);
}

Light unpacked(const PackedLight& light) {
  if (light.is_sun) return {SunLight{light.place}, light.intensity, Falloff::none};
  return {PointLight{light.place}, light.intensity, Falloff::inverse_square};
}

void configure(Assimp::Importer& importer) {
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
}

}  // namespace

std::string import_with_assimp(const Source& source) {
  const std::filesystem::path folder = source.path.parent_path();
  const std::string name = (folder / ("scene." + source.extension)).string();
  Assimp::Importer importer;
  importer.SetIOHandler(new SourceFiles(name, source.bytes));  // which the importer then owns
  configure(importer);
  const aiScene* scene = importer.ReadFile(
      name, aiProcess_Triangulate | aiProcess_JoinIdenticalVertices | aiProcess_SortByPType |
                aiProcess_ValidateDataStructure | aiProcess_PreTransformVertices);
  ByteWriter out;
  std::string error = scene ? "" : importer.GetErrorString();
  if (!scene && error.empty()) error = "it does not say why";
  if (const std::size_t at = error.find(name); at != std::string::npos)
    error.replace(at, name.size(), source.path.string());
  out.text(error);
  if (!scene) return out.take();
  out.value(static_cast<std::uint64_t>(scene->mNumMaterials));
  for (unsigned i = 0; i < scene->mNumMaterials; ++i) pack_material(*scene->mMaterials[i], out);
  out.value(static_cast<std::uint64_t>(scene->mNumTextures));
  for (unsigned i = 0; i < scene->mNumTextures; ++i) {
    const aiTexture& image = *scene->mTextures[i];
    const bool is_file = image.mHeight == 0;  // else raw pixels, which no common format has
    out.text(is_file ? std::string_view(reinterpret_cast<const char*>(image.pcData), image.mWidth)
                     : std::string_view());
  }
  out.value(static_cast<std::uint64_t>(scene->mNumMeshes));
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) pack_mesh(*scene->mMeshes[i], out);
  pack_camera(*scene, out);
  pack_lights(*scene, out);
  return out.take();
}

AssimpScene unpack_assimp_scene(const std::string& bytes, const std::string& file) {
  ByteReader in(bytes);
  AssimpScene result;
  result.error = in.text();
  if (!result.error.empty()) return result;
  Scene& scene = result.scene;
  for (std::size_t i = in.count(8); i > 0; --i) {
    Material m;
    m.name = in.text();
    m.diffuse = in.value<Color>();
    m.highlight = in.value<Color>();
    m.shininess = in.value<float>();
    m.transmission = in.value<Color>();
    m.emission = in.value<Color>();
    scene.materials.push_back(std::move(m));
    result.texture_names.push_back(in.text());
  }
  for (std::size_t i = in.count(8); i > 0; --i) result.images.push_back(in.text());
  for (std::size_t i = in.count(8); i > 0; --i) {
    Mesh mesh;
    mesh.surface = in.value<std::uint32_t>();
    mesh.name = in.text();
    mesh.positions = in.list<Vec3f>();
    mesh.normals = in.list<Vec3f>();
    mesh.uvs = in.list<Vec2f>();
    mesh.colors = in.list<Color>();
    mesh.lightmap_uvs = in.list<Vec2f>();
    mesh.triangles = in.list<Triangle>();
    if (!mesh.triangles.empty()) scene.shapes.meshes.push_back(std::move(mesh));
  }
  if (in.value<std::uint32_t>()) scene.camera = in.value<Camera>();
  for (const PackedLight& light : in.list<PackedLight>()) scene.lights.push_back(unpacked(light));
  if (!in.is_good())
    throw Error({file, {}, {}}, "assimp could not read it: its answer is damaged",
                "convert it to OBJ or glTF");
  return result;
}

}  // namespace penumbra
