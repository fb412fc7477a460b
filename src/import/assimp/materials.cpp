#include "import/assimp/materials.h"

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "import/obj/layered.h"

namespace dapple::assimp {
namespace {

using obj::MtlMap;
using obj::MtlMapUse;
using obj::MtlMaterial;

Vec3f colour_or(const aiMaterial& from, const char* key, unsigned type, unsigned index,
                const Vec3f& otherwise) {
  aiColor3D colour;
  if (from.Get(key, type, index, colour) != aiReturn_SUCCESS) return otherwise;
  const Vec3f result(colour.r, colour.g, colour.b);
  return is_finite(result) ? result : otherwise;
}

std::optional<float> number(const aiMaterial& from, const char* key, unsigned type,
                            unsigned index) {
  float value = 0;
  if (from.Get(key, type, index, value) != aiReturn_SUCCESS || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

struct MapKind {
  aiTextureType type;
  MtlMapUse use;
};
constexpr MapKind kMaps[] = {
    {aiTextureType_DIFFUSE, MtlMapUse::kd},
    {aiTextureType_BASE_COLOR, MtlMapUse::kd},
    {aiTextureType_EMISSIVE, MtlMapUse::ke},
    {aiTextureType_EMISSION_COLOR, MtlMapUse::ke},
    {aiTextureType_OPACITY, MtlMapUse::d},
    {aiTextureType_HEIGHT, MtlMapUse::bump},
    {aiTextureType_NORMALS, MtlMapUse::normal},
    {aiTextureType_NORMAL_CAMERA, MtlMapUse::normal},
    {aiTextureType_DIFFUSE_ROUGHNESS, MtlMapUse::roughness},
    {aiTextureType_METALNESS, MtlMapUse::metallic},
};

void set_maps(const aiMaterial& from, MtlMaterial& to) {
  for (const MapKind& kind : kMaps) {
    aiString file;
    if (from.GetTexture(kind.type, 0, &file) != aiReturn_SUCCESS || file.length == 0) continue;
    MtlMap& map = to.map(kind.use);
    map.file = file.C_Str();
    std::ranges::replace(map.file, '\\', '/');
    aiTextureMapMode wrap = aiTextureMapMode_Wrap;
    if (from.Get(AI_MATKEY_MAPPINGMODE_U(kind.type, 0), wrap) == aiReturn_SUCCESS) {
      map.clamp = wrap == aiTextureMapMode_Clamp || wrap == aiTextureMapMode_Decal;
    }
    aiUVTransform moved;
    if (from.Get(AI_MATKEY_UVTRANSFORM(kind.type, 0), moved) == aiReturn_SUCCESS &&
        std::isfinite(moved.mScaling.x + moved.mScaling.y + moved.mTranslation.x +
                      moved.mTranslation.y)) {
      map.scale = {moved.mScaling.x, moved.mScaling.y};
      map.offset = {moved.mTranslation.x, moved.mTranslation.y};
    }
  }
}

// The same parameters as a material library of OBJ has, so that they mean the same.
MtlMaterial description(const aiMaterial& from) {
  MtlMaterial m;
  m.kd = colour_or(from, AI_MATKEY_COLOR_DIFFUSE, m.kd);
  m.kd = colour_or(from, AI_MATKEY_BASE_COLOR, m.kd);
  m.ks = colour_or(from, AI_MATKEY_COLOR_SPECULAR, m.ks);
  m.ke = number(from, AI_MATKEY_EMISSIVE_INTENSITY).value_or(1.0f) *
         colour_or(from, AI_MATKEY_COLOR_EMISSIVE, m.ke);
  m.ns = number(from, AI_MATKEY_SHININESS);
  m.d = number(from, AI_MATKEY_OPACITY).value_or(1.0f);
  m.roughness = number(from, AI_MATKEY_ROUGHNESS_FACTOR);
  m.metallic = number(from, AI_MATKEY_METALLIC_FACTOR);
  set_maps(from, m);
  return m;
}

// A picture inside the file: still encoded, or pixels of blue, green, red and alpha.
Expected<RawImage> picture_of(const aiTexture& texture) {
  const auto* data = reinterpret_cast<const std::byte*>(texture.pcData);
  if (texture.mHeight == 0) return decode_raw_image({data, texture.mWidth}, kMaxImagePixels);
  if (std::uint64_t{texture.mWidth} * texture.mHeight > kMaxImagePixels) {
    return fail(Errc::bad_data, "", "a picture inside the file is too large");
  }
  RawImage image{texture.mWidth, texture.mHeight, RawFormat::rgba8, {}};
  image.texels.reserve(std::size_t{4} * texture.mWidth * texture.mHeight);
  for (std::size_t i = 0; i < std::size_t{texture.mWidth} * texture.mHeight; ++i) {
    const aiTexel& texel = texture.pcData[i];
    image.texels.insert(image.texels.end(), {texel.r, texel.g, texel.b, texel.a});
  }
  return image;
}

// Materials name them by "*INDEX" or by the name of the file they were.
void embed_pictures(const aiScene& scene, ModelImport& import) {
  for (unsigned i = 0; i < scene.mNumTextures; ++i) {
    const aiTexture& texture = *scene.mTextures[i];
    auto picture = picture_of(texture);
    if (!picture) {
      import.log().warn(
          fmt::format("{}, picture {}: {}", import.path(), i, to_string(picture.error())));
      continue;
    }
    std::string name = texture.mFilename.C_Str();
    std::ranges::replace(name, '\\', '/');
    if (!name.empty()) import.embed(name, *picture);
    import.embed(fmt::format("*{}", i), std::move(*picture));
  }
}

}  // namespace

Expected<std::vector<MaterialId>> add_materials(const aiScene& scene, ModelImport& import) {
  embed_pictures(scene, import);
  std::vector<MaterialId> ids;
  for (unsigned i = 0; i < scene.mNumMaterials; ++i) {
    const auto layered = obj::to_layered(description(*scene.mMaterials[i]), import.path(), import);
    if (!layered) return tl::unexpected(layered.error());
    ids.push_back(import.builder().add_material(*layered));
  }
  return ids;
}

}  // namespace dapple::assimp
