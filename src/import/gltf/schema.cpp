#include "import/gltf/schema.h"

namespace dapple::gltf {
namespace {

using enum JsonKind;

constexpr Property reference(std::string_view name, std::string_view array, bool required = false) {
  return {.name = name, .kind = integer, .required = required, .refers = array};
}
constexpr Property references(std::string_view name, std::string_view array,
                              bool required = false) {
  return {.name = name, .kind = integer, .required = required, .is_array = true, .refers = array};
}
constexpr Property at_least(std::string_view name, double low, bool required = false) {
  return {.name = name, .kind = integer, .required = required, .low = low};
}
constexpr Property within(std::string_view name, double low, double high) {
  return {.name = name, .kind = number, .low = low, .high = high};
}
constexpr Property numbers(std::string_view name, std::size_t count, double low, double high) {
  return {.name = name,
          .kind = number,
          .is_array = true,
          .low = low,
          .high = high,
          .least_items = count,
          .most_items = count};
}
constexpr Property text_of(std::string_view name, bool required = false,
                           std::string_view choices = {}) {
  return {.name = name, .kind = text, .required = required, .choices = choices};
}
constexpr Property one(std::string_view name, const Schema* of, bool required = false) {
  return {.name = name, .kind = object, .required = required, .object = of};
}
constexpr Property many(std::string_view name, const Schema* of, bool required = false) {
  return {.name = name, .kind = object, .required = required, .is_array = true, .object = of};
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr Property kAsset[] = {text_of("version", true), text_of("minVersion"),
                               text_of("generator"), text_of("copyright")};
constexpr Schema kAssetSchema{kAsset, "asset"};

// ---- Buffers and accessors ----

constexpr Property kBuffer[] = {text_of("uri"), at_least("byteLength", 1, true), text_of("name")};
constexpr Schema kBufferSchema{kBuffer, "buffer"};
constexpr Property kView[] = {reference("buffer", "buffers", true),
                              at_least("byteOffset", 0),
                              at_least("byteLength", 1, true),
                              {.name = "byteStride", .kind = integer, .low = 4, .high = 252},
                              {.name = "target", .kind = integer, .choices = "|34962|34963|"},
                              text_of("name")};
constexpr Schema kViewSchema{kView, "bufferView"};
constexpr Property kSparseIndices[] = {
    reference("bufferView", "bufferViews", true),
    at_least("byteOffset", 0),
    {.name = "componentType", .kind = integer, .required = true, .choices = "|5121|5123|5125|"}};
constexpr Schema kSparseIndicesSchema{kSparseIndices, ""};
constexpr Property kSparseValues[] = {reference("bufferView", "bufferViews", true),
                                      at_least("byteOffset", 0)};
constexpr Schema kSparseValuesSchema{kSparseValues, ""};
constexpr Property kSparse[] = {at_least("count", 1, true),
                                one("indices", &kSparseIndicesSchema, true),
                                one("values", &kSparseValuesSchema, true)};
constexpr Schema kSparseSchema{kSparse, ""};
constexpr Property kAccessor[] = {reference("bufferView", "bufferViews"),
                                  at_least("byteOffset", 0),
                                  {.name = "componentType",
                                   .kind = integer,
                                   .required = true,
                                   .choices = "|5120|5121|5122|5123|5125|5126|"},
                                  {.name = "normalized", .kind = boolean},
                                  at_least("count", 1, true),
                                  text_of("type", true),
                                  {.name = "min", .is_array = true, .most_items = 16},
                                  {.name = "max", .is_array = true, .most_items = 16},
                                  one("sparse", &kSparseSchema),
                                  text_of("name")};
constexpr Schema kAccessorSchema{kAccessor, "accessor"};

// ---- Cameras, images, textures ----

constexpr Property kPerspective[] = {
    {.name = "yfov", .required = true, .low = 0, .above_low = true},
    {.name = "znear", .required = true, .low = 0, .above_low = true},
    {.name = "aspectRatio", .low = 0, .above_low = true},
    {.name = "zfar", .low = 0, .above_low = true}};
constexpr Schema kPerspectiveSchema{kPerspective, ""};
constexpr Property kOrthographic[] = {
    {.name = "xmag", .required = true},
    {.name = "ymag", .required = true},
    {.name = "zfar", .required = true, .low = 0, .above_low = true},
    {.name = "znear", .required = true, .low = 0}};
constexpr Schema kOrthographicSchema{kOrthographic, ""};
constexpr Property kCamera[] = {text_of("type", true, "|perspective|orthographic|"),
                                one("perspective", &kPerspectiveSchema),
                                one("orthographic", &kOrthographicSchema), text_of("name")};
constexpr Schema kCameraSchema{kCamera, "camera"};
constexpr Property kImage[] = {text_of("uri"), text_of("mimeType"),
                               reference("bufferView", "bufferViews"), text_of("name")};
constexpr Schema kImageSchema{kImage, "image"};
constexpr Property kSampler[] = {
    {.name = "magFilter", .kind = integer, .choices = "|9728|9729|"},
    {.name = "minFilter", .kind = integer, .choices = "|9728|9729|9984|9985|9986|9987|"},
    {.name = "wrapS", .kind = integer, .choices = "|33071|33648|10497|"},
    {.name = "wrapT", .kind = integer, .choices = "|33071|33648|10497|"},
    text_of("name")};
constexpr Schema kSamplerSchema{kSampler, "sampler"};
constexpr Property kTexture[] = {reference("sampler", "samplers"), reference("source", "images"),
                                 text_of("name")};
constexpr Schema kTextureSchema{kTexture, "texture"};
constexpr Property kTextureInfo[] = {reference("index", "textures", true),
                                     at_least("texCoord", 0),
                                     {.name = "scale"},
                                     within("strength", 0, 1)};

// ---- Materials ----

constexpr Property map(std::string_view name) { return one(name, &kTextureInfoSchema); }

constexpr Property kRoughness[] = {numbers("baseColorFactor", 4, 0, 1), map("baseColorTexture"),
                                   within("metallicFactor", 0, 1), within("roughnessFactor", 0, 1),
                                   map("metallicRoughnessTexture")};
constexpr Schema kRoughnessSchema{kRoughness, ""};
constexpr Property kMaterial[] = {one("pbrMetallicRoughness", &kRoughnessSchema),
                                  map("normalTexture"),
                                  map("occlusionTexture"),
                                  map("emissiveTexture"),
                                  numbers("emissiveFactor", 3, 0, 1),
                                  text_of("alphaMode", false, "|OPAQUE|MASK|BLEND|"),
                                  within("alphaCutoff", 0, kInfinity),
                                  {.name = "doubleSided", .kind = boolean},
                                  text_of("name")};
constexpr Schema kMaterialSchema{kMaterial, "material"};

// ---- Meshes, nodes, skins, scenes ----

constexpr Property kPrimitive[] = {{.name = "attributes", .kind = object, .required = true},
                                   reference("indices", "accessors"),
                                   reference("material", "materials"),
                                   {.name = "mode", .kind = integer, .low = 0, .high = 6},
                                   {.name = "targets", .kind = object, .is_array = true}};
constexpr Schema kPrimitiveSchema{kPrimitive, "primitive"};
constexpr Property kMesh[] = {many("primitives", &kPrimitiveSchema, true),
                              {.name = "weights", .is_array = true},
                              text_of("name")};
constexpr Schema kMeshSchema{kMesh, "mesh"};
constexpr Property kNode[] = {reference("camera", "cameras"),
                              references("children", "nodes"),
                              reference("skin", "skins"),
                              numbers("matrix", 16, -kInfinity, kInfinity),
                              reference("mesh", "meshes"),
                              numbers("rotation", 4, -1, 1),
                              numbers("scale", 3, -kInfinity, kInfinity),
                              numbers("translation", 3, -kInfinity, kInfinity),
                              {.name = "weights", .is_array = true},
                              text_of("name")};
constexpr Schema kNodeSchema{kNode, "node"};
constexpr Property kSkin[] = {reference("inverseBindMatrices", "accessors"),
                              reference("skeleton", "nodes"), references("joints", "nodes", true),
                              text_of("name")};
constexpr Schema kSkinSchema{kSkin, "skin"};
constexpr Property kScene[] = {references("nodes", "nodes"), text_of("name")};
constexpr Schema kSceneSchema{kScene, "scene"};

// ---- Animations ----

constexpr Property kTarget[] = {reference("node", "nodes"), text_of("path", true)};
constexpr Schema kTargetSchema{kTarget, "animationTarget"};
constexpr Property kChannel[] = {at_least("sampler", 0, true), one("target", &kTargetSchema, true)};
constexpr Schema kChannelSchema{kChannel, "animationChannel"};
constexpr Property kTrack[] = {reference("input", "accessors", true),
                               reference("output", "accessors", true),
                               text_of("interpolation", false, "|LINEAR|STEP|CUBICSPLINE|")};
constexpr Schema kTrackSchema{kTrack, "animationSampler"};
constexpr Property kAnimation[] = {many("channels", &kChannelSchema, true),
                                   many("samplers", &kTrackSchema, true), text_of("name")};
constexpr Schema kAnimationSchema{kAnimation, "animation"};

constexpr Property kRoot[] = {{.name = "extensionsUsed", .kind = text, .is_array = true},
                              {.name = "extensionsRequired", .kind = text, .is_array = true},
                              one("asset", &kAssetSchema, true),
                              many("buffers", &kBufferSchema),
                              many("bufferViews", &kViewSchema),
                              many("accessors", &kAccessorSchema),
                              many("cameras", &kCameraSchema),
                              many("images", &kImageSchema),
                              many("samplers", &kSamplerSchema),
                              many("textures", &kTextureSchema),
                              many("materials", &kMaterialSchema),
                              many("meshes", &kMeshSchema),
                              many("nodes", &kNodeSchema),
                              many("skins", &kSkinSchema),
                              many("animations", &kAnimationSchema),
                              many("scenes", &kSceneSchema),
                              reference("scene", "scenes")};

}  // namespace

const Schema kRootSchema{kRoot, "root"};
const Schema kTextureInfoSchema{kTextureInfo, "textureInfo"};

}  // namespace dapple::gltf
