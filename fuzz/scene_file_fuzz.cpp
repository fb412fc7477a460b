// Any bytes as a scene file: verify() must refuse them or give a scene that can be walked, drawn
// from and stored again.
//
// Checksums would keep a fuzzer from every other check, so the input is read twice: as it is, and
// without looking at checksums.
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <string>

#include "accel/wide_accel.h"
#include "scene/describe.h"
#include "scene/scene_arrays.h"
#include "scene/validate.h"
#include "scene_file/verify.h"
#include "scene_file/writer.h"

namespace {

using namespace dapple;

// Ends the process, which is how a fuzzer is told.
void require(bool condition) {
  if (!condition) std::abort();
}

// Reads every byte of the scene's arrays; the sum keeps the reads.
double walk(const SceneView& scene) {
  double sum = scene.camera.focus_distance;
  for_each_array(
      [&](SceneArray, const auto& elements) {
        for (const std::byte b : std::as_bytes(elements)) sum += std::to_integer<int>(b);
      },
      scene);
  for (const Material& material : scene.materials) sum += static_cast<double>(material.index());
  return sum;
}

// What follows an index finds something.
void follow(const SceneView& scene) {
  for (std::size_t k = 0; k < kShapeKindCount; ++k) {
    for (const MaterialId id : scene.materials_of(static_cast<ShapeKind>(k))) {
      require(index_of(id) < scene.materials.size());
    }
  }
  for (const Triangle& t : scene.triangles) {
    for (const std::uint32_t v : t.vertices) require(v < scene.vertices.positions.size());
  }
  for (const Instance& instance : scene.instances) {
    const Prototype& p = scene.prototypes[instance.prototype];
    require(std::uint64_t{p.first_triangle} + p.triangle_count <= scene.triangles.size());
  }
  for (const Texture& texture : scene.textures) {
    const TextureImage& image = scene.images[static_cast<std::size_t>(texture.image)];
    require(image.offset + image.bytes() <= scene.texels.size());
  }
}

// Text of any scene ends, and the JSON with its last bracket.
void describe_it(const SceneView& scene) {
  std::string text;
  const TextSink keep = [&](std::string_view piece) -> Status {
    text = piece;
    return {};
  };
  require(describe(scene, DescribeDetail::full, keep).has_value());
  require(describe_json(scene, keep).has_value() && text.ends_with("}\n"));
}

// Rays through a proven BVH end, and find only primitives of the scene.
void trace(const SceneView& scene) {
  const WideAccel accel(scene);
  for (int i = 0; i < 8; ++i) {
    Ray ray;
    ray.origin = {static_cast<float>(i), 3, -10};
    ray.direction = {0.1f * static_cast<float>(i % 3), -0.2f, 1};
    const Hit hit = static_cast<const Accel&>(accel).intersect(ray);
    require(!hit.found() || hit.prim < prim_count(scene));
  }
}

void read(std::span<const std::byte> file, const VerifyOptions& options) {
  const auto loaded = verify(file, options);
  if (!loaded) return require(!loaded.error().message.empty());
  if (!loaded->view.bvh.empty()) trace(loaded->view);
  if (!loaded->shapes_verified) return;
  require(validate(loaded->view).has_value());
  volatile double sum = walk(loaded->view);
  static_cast<void>(sum);
  follow(loaded->view);
  describe_it(loaded->view);
  const auto ignore = [](std::span<const std::byte>) -> Status { return {}; };
  require(write_scene_bytes(loaded->view, ignore).has_value());
}

struct FreeAligned {
  void operator()(std::byte* p) const { ::operator delete (p, std::align_val_t{64}); }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // Aligned as a mapping is, and no longer than the input.
  const std::unique_ptr<std::byte, FreeAligned> copy(
      static_cast<std::byte*>(::operator new (size, std::align_val_t{64})));
  if (size > 0) std::memcpy(copy.get(), data, size);
  const std::span<const std::byte> file(copy.get(), size);
  read(file, {true, VerifyScope::everything});
  read(file, {false, VerifyScope::everything});
  read(file, {false, VerifyScope::bvh_only});
  return 0;
}
