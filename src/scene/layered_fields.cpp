#include "scene/layered_fields.h"

namespace dapple {
namespace {

using M = LayeredMaterial;
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kMost = std::numeric_limits<float>::max();
constexpr float kLeast = std::numeric_limits<float>::min();
constexpr float kBelowOne = 0.99999994f;

constexpr LayeredNumber kNumbers[] = {
    {"alpha", &M::alpha, 0, 1},
    {"alpha_cutoff", &M::alpha_cutoff},
    {"metallic", &M::metallic, 0, 1},
    {"roughness", &M::roughness, 0, 1},
    {"normal_scale", &M::normal_scale, -kMost},
    {"ior", &M::ior},
    {"specular", &M::specular, 0, 1},
    {"glossiness", &M::glossiness, 0, 1},
    {"transmission", &M::transmission, 0, 1},
    {"dispersion", &M::dispersion},
    {"diffuse_transmission", &M::diffuse_transmission, 0, 1},
    {"clearcoat", &M::clearcoat, 0, 1},
    {"clearcoat_roughness", &M::clearcoat_roughness, 0, 1},
    {"clearcoat_normal_scale", &M::clearcoat_normal_scale, -kMost},
    {"sheen_roughness", &M::sheen_roughness, 0, 1},
    {"anisotropy", &M::anisotropy, 0, 1},
    {"anisotropy_rotation", &M::anisotropy_rotation, -kMost},
    {"iridescence", &M::iridescence, 0, 1},
    {"iridescence_ior", &M::iridescence_ior},
    {"iridescence_min_nm", &M::iridescence_min_nm},
    {"iridescence_max_nm", &M::iridescence_max_nm},
    {"thickness", &M::thickness},
    {"attenuation_distance", &M::attenuation_distance, kLeast, kInfinity},
    {"scattering_anisotropy", &M::scattering_anisotropy, -kBelowOne, kBelowOne},
};

constexpr LayeredColour kColours[] = {
    {"base_colour", &M::base_colour},
    {"emission", &M::emission},
    {"specular_colour", &M::specular_colour},
    {"diffuse_transmission_colour", &M::diffuse_transmission_colour},
    {"sheen_colour", &M::sheen_colour},
    {"attenuation_colour", &M::attenuation_colour, 1},
    {"scattering", &M::scattering},
};

// Nothing is left out: words of numbers, of colours and of the rest are all there are.
static_assert(sizeof(LayeredMaterial) == 4 * (std::size(kNumbers) + 3 * std::size(kColours) + 4) +
                                             kMapUseCount * sizeof(TextureSlot));

constexpr std::string_view kMapNames[kMapUseCount] = {
    "base_colour",
    "metallic_roughness",
    "specular_glossiness",
    "normal",
    "emissive",
    "transmission",
    "clearcoat",
    "clearcoat_roughness",
    "clearcoat_normal",
    "sheen_colour",
    "sheen_roughness",
    "specular",
    "specular_colour",
    "anisotropy",
    "iridescence",
    "iridescence_thickness",
    "diffuse_transmission",
    "diffuse_transmission_colour",
};

}  // namespace

std::span<const LayeredNumber> layered_numbers() { return kNumbers; }
std::span<const LayeredColour> layered_colours() { return kColours; }

std::string_view map_name(MapUse use) { return kMapNames[static_cast<std::size_t>(use)]; }

std::string_view name_of(BaseModel model) {
  return model == BaseModel::specular_glossiness ? "specular_glossiness" : "metallic_roughness";
}

std::string_view name_of(AlphaMode mode) {
  constexpr std::string_view kNames[] = {"opaque", "mask", "blend"};
  return kNames[static_cast<std::size_t>(mode)];
}

}  // namespace dapple
