#include "import/obj/layered.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "import/channels.h"
#include "import/text.h"

namespace dapple::obj {
namespace {

float clamped(float value) { return std::clamp(value, 0.0f, 1.0f); }
Vec3f clamped(const Vec3f& c) { return {clamped(c.x), clamped(c.y), clamped(c.z)}; }

bool is_black(const Vec3f& c) { return max_abs_component(c) == 0; }

// The microfacet distribution whose highlight is as wide as that of Phong's exponent has the width
// sqrt(2 / (n + 2)) [WalterMLT07]; roughness is its square root.
float roughness_of(float exponent) {
  return std::sqrt(std::sqrt(2 / (std::max(exponent, 0.0f) + 2)));
}

bool is_mirror(const MtlMaterial& m) {
  return (m.illum == 3 || m.illum == 5) && is_black(m.kd) && !is_black(m.ks);
}
bool is_glass(const MtlMaterial& m) { return (m.illum == 6 || m.illum == 7) && m.ni != 1; }
bool has_pbr(const MtlMaterial& m) {
  return m.roughness || m.metallic || !m.map(MtlMapUse::roughness).file.empty() ||
         !m.map(MtlMapUse::metallic).file.empty();
}

void set_phong(const MtlMaterial& from, LayeredMaterial& to) {
  to.roughness = from.ns ? roughness_of(*from.ns) : 1;
  to.specular_colour = clamped(from.ks);
  to.specular = is_black(from.ks) ? 0 : 1;
  if (is_mirror(from)) {
    to.base_colour = clamped(from.ks);
    to.metallic = 1;
    if (!from.ns) to.roughness = 0;
  } else if (is_glass(from)) {
    to.base_colour = {1, 1, 1};
    to.transmission = 1;
    to.thickness = 1;
    to.specular = 1;
    to.specular_colour = {1, 1, 1};
    to.ior = std::clamp(from.ni, 1.0f, 4.0f);
    if (!from.ns) to.roughness = 0;
  }
}

void set_pbr(const MtlMaterial& from, LayeredMaterial& to) {
  const auto has_map = [&](MtlMapUse use) { return !from.map(use).file.empty(); };
  to.roughness = clamped(from.roughness.value_or(has_map(MtlMapUse::roughness) ? 1.0f : 0.5f));
  to.metallic = clamped(from.metallic.value_or(has_map(MtlMapUse::metallic) ? 1.0f : 0.0f));
  const float sheen = clamped(from.sheen);
  to.sheen_colour = {sheen, sheen, sheen};
  to.sheen_roughness = 0.5f;
  to.clearcoat = clamped(from.clearcoat);
  to.clearcoat_roughness = clamped(from.clearcoat_roughness);
  to.anisotropy = clamped(from.anisotropy);
  constexpr float kTurn = 6.28318530717958647692f;
  to.anisotropy_rotation = kTurn * from.anisotropy_rotation;
}

class Maps {
 public:
  Maps(const MtlMaterial& from, const std::string& file, ModelImport& import, LayeredMaterial& to)
      : from_(from), file_(file), import_(import), to_(to) {}

  Status set() {
    if (auto s = base_colour(); !s) return s;
    if (auto s = metallic_roughness(); !s) return s;
    if (auto s = simple(MtlMapUse::ke, MapUse::emissive); !s) return s;
    if (auto s = simple(MtlMapUse::ks, MapUse::specular_colour); !s) return s;
    return normal();
  }

 private:
  const MtlMap& map(MtlMapUse use) const { return from_.map(use); }
  bool has(MtlMapUse use) const { return !map(use).file.empty(); }
  std::string place(const MtlMap& map) const { return line_place(file_, map.line); }

  static Texture settings(const MtlMap& map) {
    const Wrap wrap = map.clamp ? Wrap::clamp_to_edge : Wrap::repeat;
    return {kNoImage, wrap, wrap, Filter::linear};
  }

  // The file's v grows upwards: v' = 1 - (scale (1 - v) + offset).
  void put(const Expected<TextureId>& id, const MtlMap& map, MapUse use) {
    TextureSlot& slot = to_.map(use);
    slot.texture = *id;
    slot.to_uv[0][0] = map.scale.x;
    slot.to_uv[0][2] = map.offset.x;
    slot.to_uv[1][1] = map.scale.y;
    slot.to_uv[1][2] = 1 - map.scale.y - map.offset.y;
  }

  Status simple(MtlMapUse from, MapUse to) {
    if (!has(from)) return {};
    const auto id = import_.texture(map(from).file, place(map(from)), settings(map(from)));
    if (!id) return tl::unexpected(id.error());
    put(id, map(from), to);
    if (to == MapUse::emissive && is_black(to_.emission)) to_.emission = {1, 1, 1};
    if (to == MapUse::specular_colour) to_.specular = 1;
    if (to == MapUse::specular_colour && is_black(from_.ks)) to_.specular_colour = {1, 1, 1};
    return {};
  }

  Status base_colour() {
    const MtlMap &kd = map(MtlMapUse::kd), &d = map(MtlMapUse::d);
    if (is_black(from_.kd) && has(MtlMapUse::kd)) to_.base_colour = {1, 1, 1};
    if (!has(MtlMapUse::d)) return simple(MtlMapUse::kd, MapUse::base_colour);
    to_.alpha_mode = AlphaMode::blend;
    if (kd.file == d.file) return simple(MtlMapUse::kd, MapUse::base_colour);
    const auto alpha = import_.picture(d.file);
    const auto colour =
        has(MtlMapUse::kd) ? import_.picture(kd.file) : Expected<RawImage>(white_picture());
    const auto joined = !alpha ? alpha : !colour ? colour : with_alpha(*colour, *alpha);
    const MtlMap& slot = has(MtlMapUse::kd) ? kd : d;
    const auto id = import_.texture(joined, place(d), settings(slot));
    if (!id) return tl::unexpected(id.error());
    put(id, slot, MapUse::base_colour);
    return {};
  }

  Status metallic_roughness() {
    const MtlMap &pr = map(MtlMapUse::roughness), &pm = map(MtlMapUse::metallic);
    if (!has(MtlMapUse::roughness) && !has(MtlMapUse::metallic)) return {};
    const auto read = [&](MtlMapUse use) {
      return has(use) ? import_.picture(map(use).file) : Expected<RawImage>(white_picture());
    };
    const auto roughness = read(MtlMapUse::roughness), metallic = read(MtlMapUse::metallic);
    const auto joined = !roughness  ? roughness
                        : !metallic ? metallic
                                    : roughness_and_metallic(*roughness, *metallic);
    const MtlMap& slot = has(MtlMapUse::roughness) ? pr : pm;
    const auto id = import_.texture(joined, place(slot), settings(slot));
    if (!id) return tl::unexpected(id.error());
    put(id, slot, MapUse::metallic_roughness);
    return {};
  }

  // Under "map_Bump" stand heights by the letter, and normals from many programs.
  Status normal() {
    const bool named = has(MtlMapUse::normal);
    const MtlMap& from = map(named ? MtlMapUse::normal : MtlMapUse::bump);
    if (from.file.empty()) return {};
    if (!named) {
      const auto heights = import_.picture(from.file);
      if (heights && !looks_like_normals(*heights)) {
        import_.log().warn(fmt::format("{}: the heights of '{}' are not used; normal maps are",
                                       place(from), from.file));
        return {};
      }
    }
    const auto id = import_.texture(from.file, place(from), settings(from));
    if (!id) return tl::unexpected(id.error());
    if (*id == import_.builder().magenta_texture()) return {};
    put(id, from, MapUse::normal);
    to_.normal_scale = from.strength;
    return {};
  }

  const MtlMaterial& from_;
  const std::string& file_;
  ModelImport& import_;
  LayeredMaterial& to_;
};

}  // namespace

Expected<LayeredMaterial> to_layered(const MtlMaterial& from, const std::string& file,
                                     ModelImport& import) {
  LayeredMaterial to;
  to.base_colour = clamped(from.kd);
  to.emission = {std::max(from.ke.x, 0.0f), std::max(from.ke.y, 0.0f), std::max(from.ke.z, 0.0f)};
  to.alpha = clamped(from.d);
  if (to.alpha < 1) to.alpha_mode = AlphaMode::blend;
  if (has_pbr(from)) {
    set_pbr(from, to);
  } else {
    set_phong(from, to);
  }
  if (auto set = Maps(from, file, import, to).set(); !set) return tl::unexpected(set.error());
  return to;
}

}  // namespace dapple::obj
