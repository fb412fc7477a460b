// Material libraries of OBJ files, as they say it.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "math/vec2.h"
#include "math/vec3.h"
#include "util/error.h"

namespace dapple::obj {

struct MtlMap {
  std::string file;  // empty: no map
  Vec2f scale{1, 1};
  Vec2f offset;
  bool clamp = false;
  float strength = 1;    // "-bm"
  std::size_t line = 0;  // where it stands
};

enum class MtlMapUse { kd, ks, ke, d, bump, normal, roughness, metallic, sheen };
inline constexpr std::size_t kMtlMapUseCount = 9;

// The defaults are those of a file that does not say.
struct MtlMaterial {
  std::string name;
  Vec3f kd{0.8f, 0.8f, 0.8f};
  Vec3f ks;
  Vec3f ke;
  std::optional<float> ns;  // Phong's exponent
  float ni = 1;             // index of refraction
  float d = 1;              // opacity
  int illum = 2;
  // The PBR extension.
  std::optional<float> roughness, metallic;
  float sheen = 0, clearcoat = 0, clearcoat_roughness = 0;
  float anisotropy = 0, anisotropy_rotation = 0;
  std::array<MtlMap, kMtlMapUseCount> maps;

  const MtlMap& map(MtlMapUse use) const { return maps[static_cast<std::size_t>(use)]; }
  MtlMap& map(MtlMapUse use) { return maps[static_cast<std::size_t>(use)]; }
};

struct MtlLibrary {
  std::map<std::string, MtlMaterial, std::less<>> materials;  // the last of each name
  std::vector<std::string> warnings;
};

// Appends the file's materials to `library`; `name` is the file's, for errors.
[[nodiscard]] Status read_mtl(std::string_view text, std::string_view name, MtlLibrary& library);

}  // namespace dapple::obj
