#include <string>

#include "import/gltf/schema.h"

namespace dapple::gltf {

namespace {

using enum JsonKind;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr Property unit(std::string_view name) { return {.name = name, .low = 0, .high = 1}; }
constexpr Property positive(std::string_view name) { return {.name = name, .low = 0}; }
constexpr Property map(std::string_view name) {
  return {.name = name, .kind = object, .object = &kTextureInfoSchema};
}
constexpr Property colour(std::string_view name, double high, std::size_t count = 3) {
  return {.name = name,
          .is_array = true,
          .low = 0,
          .high = high,
          .least_items = count,
          .most_items = count};
}
constexpr Property count(std::string_view name, double low) {
  return {.name = name, .kind = integer, .required = true, .low = low};
}
constexpr Property refer(std::string_view name, std::string_view array, bool required = true) {
  return {.name = name, .kind = integer, .required = required, .refers = array};
}

// ---- Materials ----

constexpr Property kAnisotropy[] = {
    unit("anisotropyStrength"), {.name = "anisotropyRotation"}, map("anisotropyTexture")};
constexpr Property kClearcoat[] = {unit("clearcoatFactor"), map("clearcoatTexture"),
                                   unit("clearcoatRoughnessFactor"),
                                   map("clearcoatRoughnessTexture"), map("clearcoatNormalTexture")};
constexpr Property kDispersion[] = {positive("dispersion")};
constexpr Property kStrength[] = {positive("emissiveStrength")};
constexpr Property kIor[] = {positive("ior")};
constexpr Property kIridescence[] = {unit("iridescenceFactor"),
                                     map("iridescenceTexture"),
                                     {.name = "iridescenceIor", .low = 1},
                                     positive("iridescenceThicknessMinimum"),
                                     positive("iridescenceThicknessMaximum"),
                                     map("iridescenceThicknessTexture")};
constexpr Property kSheen[] = {colour("sheenColorFactor", 1), map("sheenColorTexture"),
                               unit("sheenRoughnessFactor"), map("sheenRoughnessTexture")};
constexpr Property kSpecular[] = {unit("specularFactor"), map("specularTexture"),
                                  colour("specularColorFactor", kInfinity),
                                  map("specularColorTexture")};
constexpr Property kTransmission[] = {unit("transmissionFactor"), map("transmissionTexture")};
constexpr Property kVolume[] = {positive("thicknessFactor"),
                                map("thicknessTexture"),
                                {.name = "attenuationDistance", .low = 0, .above_low = true},
                                colour("attenuationColor", 1)};
constexpr Property kDiffuse[] = {
    unit("diffuseTransmissionFactor"), map("diffuseTransmissionTexture"),
    colour("diffuseTransmissionColorFactor", 1), map("diffuseTransmissionColorTexture")};
constexpr Property kGlossiness[] = {colour("diffuseFactor", 1, 4), map("diffuseTexture"),
                                    colour("specularFactor", 1), unit("glossinessFactor"),
                                    map("specularGlossinessTexture")};

// ---- Textures ----

constexpr Property kTransform[] = {
    {.name = "offset", .is_array = true, .least_items = 2, .most_items = 2},
    {.name = "rotation"},
    {.name = "scale", .is_array = true, .least_items = 2, .most_items = 2},
    {.name = "texCoord", .kind = integer, .low = 0}};
constexpr Property kSource[] = {refer("source", "images", false)};

// ---- Geometry ----

constexpr Property kMeshopt[] = {
    refer("buffer", "buffers"),
    {.name = "byteOffset", .kind = integer, .low = 0},
    count("byteLength", 1),
    count("byteStride", 1),
    count("count", 1),
    {.name = "mode", .kind = text, .required = true, .choices = "|ATTRIBUTES|TRIANGLES|INDICES|"},
    {.name = "filter", .kind = text, .choices = "|NONE|OCTAHEDRAL|QUATERNION|EXPONENTIAL|"}};
constexpr Property kFallback[] = {{.name = "fallback", .kind = boolean}};
constexpr Property kDraco[] = {refer("bufferView", "bufferViews"),
                               {.name = "attributes", .kind = object, .required = true}};
constexpr Property kInstancing[] = {{.name = "attributes", .kind = object, .required = true}};
constexpr Property kVisibility[] = {{.name = "visible", .kind = boolean}};

constexpr Property kVariant[] = {{.name = "name", .kind = text, .required = true}};
constexpr Schema kVariantSchema{kVariant, ""};
constexpr Property kVariants[] = {{.name = "variants",
                                   .kind = object,
                                   .required = true,
                                   .is_array = true,
                                   .object = &kVariantSchema}};
constexpr Property kMapping[] = {
    refer("material", "materials"),
    {.name = "variants", .kind = integer, .required = true, .is_array = true, .low = 0}};
constexpr Schema kMappingSchema{kMapping, ""};
constexpr Property kMappings[] = {{.name = "mappings",
                                   .kind = object,
                                   .required = true,
                                   .is_array = true,
                                   .object = &kMappingSchema}};

constexpr Property kSpot[] = {
    {.name = "innerConeAngle", .low = 0, .high = 1.5707963267948966},
    {.name = "outerConeAngle", .low = 0, .high = 1.5707963267948966, .above_low = true}};
constexpr Schema kSpotSchema{kSpot, ""};
constexpr Property kLight[] = {colour("color", 1),
                               positive("intensity"),
                               {.name = "range", .low = 0, .above_low = true},
                               {.name = "type", .kind = text, .required = true},
                               {.name = "spot", .kind = object, .object = &kSpotSchema}};
constexpr Schema kLightSchema{kLight, "light"};
constexpr Property kLights[] = {{.name = "lights",
                                 .kind = object,
                                 .required = true,
                                 .is_array = true,
                                 .object = &kLightSchema}};
constexpr Property kLightUse[] = {{.name = "light", .kind = integer, .required = true, .low = 0}};

struct Extension {
  std::string_view name;
  Schema schema;
};

constexpr Extension kExtensions[] = {
    {"KHR_materials_anisotropy", {kAnisotropy, "material"}},
    {"KHR_materials_clearcoat", {kClearcoat, "material"}},
    {"KHR_materials_dispersion", {kDispersion, "material"}},
    {"KHR_materials_emissive_strength", {kStrength, "material"}},
    {"KHR_materials_ior", {kIor, "material"}},
    {"KHR_materials_iridescence", {kIridescence, "material"}},
    {"KHR_materials_sheen", {kSheen, "material"}},
    {"KHR_materials_specular", {kSpecular, "material"}},
    {"KHR_materials_transmission", {kTransmission, "material"}},
    {"KHR_materials_volume", {kVolume, "material"}},
    {"KHR_materials_diffuse_transmission", {kDiffuse, "material"}},
    {"KHR_materials_pbrSpecularGlossiness", {kGlossiness, "material"}},
    {"KHR_materials_unlit", {{}, "material"}},
    {"KHR_materials_variants", {kVariants, "root"}},
    {"KHR_materials_variants", {kMappings, "primitive"}},
    {"KHR_texture_transform", {kTransform, "textureInfo"}},
    {"KHR_texture_basisu", {kSource, "texture"}},
    {"EXT_texture_webp", {kSource, "texture"}},
    {"KHR_lights_punctual", {kLights, "root"}},
    {"KHR_lights_punctual", {kLightUse, "node"}},
    {"KHR_node_visibility", {kVisibility, "node"}},
    {"KHR_mesh_quantization", {{}, "nowhere"}},
    {"KHR_draco_mesh_compression", {kDraco, "primitive"}},
    {"EXT_meshopt_compression", {kMeshopt, "bufferView"}},
    {"EXT_meshopt_compression", {kFallback, "buffer"}},
    {"EXT_mesh_gpu_instancing", {kInstancing, "node"}},
};

}  // namespace

const Schema* extension_schema(std::string_view extension, std::string_view location) {
  for (const Extension& known : kExtensions) {
    if (known.name == extension && known.schema.location == location) return &known.schema;
  }
  return nullptr;
}

bool is_known_extension(std::string_view extension) {
  for (const Extension& known : kExtensions) {
    if (known.name == extension) return true;
  }
  return false;
}

}  // namespace dapple::gltf
