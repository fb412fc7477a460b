#include "import/pbrt/environment_image.h"

#include <algorithm>
#include <cstring>

#include "image/formats.h"
#include "math/fast_functions.h"
#include "math/vec2.h"
#include "parallel/parallel.h"

namespace dapple::pbrt {
namespace {

float fraction(float x) { return x - static_cast<float>(floor_to_int(x)); }

// Equirectangular with z up: u around, v from the pole down.
Vec2f uv_of_globe(const Vec3f& d) {
  return {fraction(fast_atan2(d.y, d.x) * (0.5f * kInvPi) + 1.0f), fast_acos(d.z) * kInvPi};
}

// The octahedron unfolded over the unit square so that equal areas of the sphere have equal areas.
Vec2f uv_of_octahedron(const Vec3f& d) {
  const float x = std::fabs(d.x), y = std::fabs(d.y), z = std::fabs(d.z);
  const float r = std::sqrt(std::max(0.0f, 1.0f - z));
  float phi = fast_atan2(y, x) * (2.0f * kInvPi);  // 0 to 1 over the quarter
  float v = phi * r, u = r - v;
  if (d.z < 0) {
    phi = u;
    u = 1 - v;
    v = 1 - phi;
  }
  u = d.x < 0 ? -u : u;
  v = d.y < 0 ? -v : v;
  return {0.5f * (u + 1), 0.5f * (v + 1)};
}

struct Source {
  const Image& image;
  bool octahedral = false;

  const Vec3f& texel(int x, int y) const {
    x = octahedral ? std::clamp(x, 0, image.width - 1) : (x + image.width) % image.width;
    return image.at(x, std::clamp(y, 0, image.height - 1));
  }
  Vec3f lookup(const Vec3f& direction) const {
    const Vec2f uv = octahedral ? uv_of_octahedron(direction) : uv_of_globe(direction);
    const float x = uv.x * static_cast<float>(image.width) - 0.5f;
    const float y = uv.y * static_cast<float>(image.height) - 0.5f;
    const int i = floor_to_int(x), j = floor_to_int(y);
    const float fx = x - static_cast<float>(i), fy = y - static_cast<float>(j);
    return (1 - fy) * ((1 - fx) * texel(i, j) + fx * texel(i + 1, j)) +
           fy * ((1 - fx) * texel(i, j + 1) + fx * texel(i + 1, j + 1));
  }
};

// The direction of a pixel's centre in a scene's environment.
Vec3f direction_of(const Image& image, int x, int y) {
  const auto polar = sin_cos_turns(0.5f * (static_cast<float>(y) + 0.5f) / float(image.height));
  const auto around = sin_cos_turns((static_cast<float>(x) + 0.5f) / float(image.width) - 0.5f);
  return {polar.sin * around.cos, polar.cos, polar.sin * around.sin};
}

Image resampled(const Source& source, const Transformd& from_scene) {
  const int height = source.octahedral ? source.image.height : source.image.height;
  Image image(2 * height, height);
  parallel_for_dynamic(static_cast<std::size_t>(height), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < image.width; ++x) {
      const Vec3d d = from_scene.vector(Vec3d(direction_of(image, x, y)));
      image.at(x, y) = source.lookup(Vec3f(normalize(d)));
    }
  });
  return image;
}

RawImage as_raw(const Image& image) {
  RawImage raw{static_cast<std::uint32_t>(image.width),
               static_cast<std::uint32_t>(image.height),
               RawFormat::rgb32f,
               {}};
  raw.texels.resize(image.pixels.size() * sizeof(Vec3f));
  std::memcpy(raw.texels.data(), image.pixels.data(), raw.texels.size());
  return raw;
}

Expected<RawImage> read(const Context& context, const Transformd& to_scene,
                        const std::string& name) {
  const auto file = context.import.open_companion(name);
  if (!file) return tl::unexpected(file.error());
  auto image = decode_image(file->bytes(), {Transfer::srgb, kMaxImagePixels / 4});
  if (!image) {
    Error error = image.error();
    error.place = context.import.sandbox().path_of(name) + ", " + error.place;
    return tl::unexpected(error);
  }
  if (!(std::fabs(determinant(to_scene)) > 0)) {
    return fail(Errc::bad_data, name, "the light's transformation has no inverse");
  }
  const Source source{*image, image->width == image->height};
  return as_raw(resampled(source, inverse(to_scene)));
}

}  // namespace

Expected<ImageId> environment_image(const Context& context, const Transformd& to_scene,
                                    const std::string& name, const std::string& place) {
  const auto id = read(context, to_scene, name).and_then([&](const RawImage& image) {
    return context.import.builder().add_image(image);
  });
  if (id) return *id;
  const Error error{id.error().code, to_string(id.error()), place};
  if (!context.import.options().keep_going) return tl::unexpected(error);
  context.warn(place, error.message);
  return context.import.builder().add_image(as_raw([] {
    Image magenta(2, 1);
    for (Vec3f& pixel : magenta.pixels) pixel = {1, 0, 1};
    return magenta;
  }()));
}

}  // namespace dapple::pbrt
