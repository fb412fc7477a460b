#include "scene_file/records.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>

#include "scene/scene_view.h"
#include "scene/validate.h"

namespace dapple {
namespace {

// What makes it right to look at the bytes of a file as these types.
static_assert(sizeof(Sphere) == 32 && offsetof(Sphere, radius) == 24);
static_assert(sizeof(Rectangle) == 40 && offsetof(Rectangle, k) == 32);
static_assert(sizeof(MaterialId) == 4);
static_assert(sizeof(Vec2f) == 8 && sizeof(Vec3f) == 12 && sizeof(Vec4f) == 16);
static_assert(sizeof(Triangle) == 12 && sizeof(Prototype) == 8);
static_assert(sizeof(Cylinder) == 56 && offsetof(Cylinder, end) == 24 &&
              offsetof(Cylinder, radius) == 48);
static_assert(sizeof(Instance) == 52 && offsetof(Instance, prototype) == 48);
static_assert(sizeof(Texture) == 16 && offsetof(Texture, filter) == 12);
static_assert(sizeof(TextureImage) == 24 && offsetof(TextureImage, format) == 8 &&
              offsetof(TextureImage, offset) == 16);
static_assert(sizeof(Light) == 48 && offsetof(Light, position) == 4 &&
              offsetof(Light, direction) == 16 && offsetof(Light, intensity) == 28 &&
              offsetof(Light, inner_angle) == 40);
static_assert(sizeof(Environment) == 24 && offsetof(Environment, colour) == 8 &&
              offsetof(Environment, rotation) == 20);
static_assert(sizeof(NamedCamera) == 168 && offsetof(NamedCamera, camera) == 64 &&
              offsetof(Camera, look_at) == 24 && offsetof(Camera, up) == 48 &&
              offsetof(Camera, vertical_fov) == 72 && offsetof(Camera, aperture) == 80 &&
              offsetof(Camera, focus_distance) == 88 &&
              offsetof(Camera, orthographic_height) == 96);
static_assert(sizeof(TextureSlot) == 32 && offsetof(TextureSlot, to_uv) == 8);
static_assert(sizeof(LayeredMaterial) == 772 && offsetof(LayeredMaterial, maps) == 196);
static_assert(sizeof(ObjectRun) == sizeof(RunRecord) && offsetof(ObjectRun, count) == 8);
static_assert(sizeof(WideNode) == 448 && offsetof(WideNode, hi) == 192 &&
              offsetof(WideNode, children) == 384);

Vec3d vec3(const double* numbers) { return {numbers[0], numbers[1], numbers[2]}; }

void put(const Vec3d& v, double* numbers) {
  numbers[0] = v.x;
  numbers[1] = v.y;
  numbers[2] = v.z;
}

// How many of a record's numbers a material of each tag uses.
constexpr int kNumbersUsed[] = {3, 4, 1, 1};
static_assert(std::size(kNumbersUsed) == std::variant_size_v<Material>);

bool unused_are_zero(const MaterialRecord& record) {
  for (int i = kNumbersUsed[record.tag]; i < 4; ++i) {
    if (std::bit_cast<std::uint64_t>(record.numbers[i]) != 0) return false;
  }
  return record.reserved == 0;
}

}  // namespace

CameraRecord encode(const Camera& camera) {
  CameraRecord record{};
  put(camera.look_from, record.look_from);
  put(camera.look_at, record.look_at);
  put(camera.up, record.up);
  record.vertical_fov = camera.vertical_fov;
  record.aperture = camera.aperture;
  record.focus_distance = camera.focus_distance;
  return record;
}

MaterialRecord encode(const Material& material) {
  MaterialRecord record{};
  record.tag = static_cast<std::uint32_t>(material.index());
  if (const auto* lambertian = std::get_if<Lambertian>(&material)) {
    put(lambertian->albedo, record.numbers);
  } else if (const auto* metal = std::get_if<Metal>(&material)) {
    put(metal->albedo, record.numbers);
    record.numbers[3] = metal->fuzz;
  } else if (const auto* dielectric = std::get_if<Dielectric>(&material)) {
    record.numbers[0] = dielectric->ref_idx;
  } else if (const auto* layered = std::get_if<Layered>(&material)) {
    record.numbers[0] = layered->index;
  }
  return record;
}

RunRecord encode(const ObjectRun& run) {
  return {static_cast<std::uint32_t>(run.kind), 0, run.count};
}

FilmRecord encode(const std::array<int, 2>& film) {
  return {static_cast<std::uint32_t>(film[0]), static_cast<std::uint32_t>(film[1])};
}

Expected<Camera> decode_camera(const CameraRecord& record) {
  Camera camera;
  camera.look_from = vec3(record.look_from);
  camera.look_at = vec3(record.look_at);
  camera.up = vec3(record.up);
  camera.vertical_fov = record.vertical_fov;
  camera.aperture = record.aperture;
  camera.focus_distance = record.focus_distance;
  if (auto status = validate(camera); !status) return tl::unexpected(status.error());
  return camera;
}

Expected<Material> decode_material(const MaterialRecord& record) {
  if (record.tag >= std::size(kNumbersUsed)) {
    return fail(Errc::bad_data, "", "its type is not known to this version");
  }
  if (!unused_are_zero(record)) return fail(Errc::bad_data, "", "unused fields are not zero");
  const double* n = record.numbers;
  Material material = Lambertian{vec3(n)};
  if (record.tag == 1) material = Metal{vec3(n), n[3]};
  if (record.tag == 2) material = Dielectric{n[0]};
  if (record.tag == 3) {
    // Whole and small enough, so that converting it is exact and storing it again the same.
    const bool is_index =
        n[0] >= 0 && n[0] < 0x1p32 && n[0] == std::trunc(n[0]) && !std::signbit(n[0]);
    if (!is_index) return fail(Errc::bad_data, "", "its index is not one");
    material = Layered{static_cast<std::uint32_t>(n[0])};
  }
  if (auto status = validate(material); !status) return tl::unexpected(status.error());
  return material;
}

std::array<int, 2> decode_film(const FilmRecord& record) {
  const auto side = [](std::uint32_t pixels) {
    return static_cast<int>(std::min<std::uint32_t>(pixels, kMaxFilmSide + 1));
  };
  return {side(record.width), side(record.height)};
}

}  // namespace dapple
