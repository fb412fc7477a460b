#include "import/pbrt/textures.h"

#include <fmt/format.h>

#include <cstring>

#include "image/transfer.h"
#include "import/text.h"

namespace dapple::pbrt {
namespace {

struct UvMapping {
  float su = 1, sv = 1, du = 0, dv = 0;
};

UvMapping mapping_of(const Context& context, const Params& params) {
  if (const std::string name = params.text("mapping", "uv"); name != "uv") {
    context.warn(params.place(), fmt::format("the mapping '{:.40}' is taken for 'uv'", name));
  }
  return {to_float(params.number("uscale", 1)), to_float(params.number("vscale", 1)),
          to_float(params.number("udelta", 0)), to_float(params.number("vdelta", 0))};
}

RawImage float_picture(std::uint32_t width, std::uint32_t height,
                       const std::vector<Vec3f>& texels) {
  RawImage image{width, height, RawFormat::rgb32f, {}};
  image.texels.resize(texels.size() * sizeof(Vec3f));
  std::memcpy(image.texels.data(), texels.data(), image.texels.size());
  return image;
}

// Integers are taken for sRGB where a colour is asked for, so linear ones become floats.
RawImage linear_picture(const RawImage& image) {
  if (image.format == RawFormat::rgb32f) return image;
  std::vector<Vec3f> texels(std::size_t{image.width} * image.height);
  const std::size_t stride = raw_pixel_bytes(image.format);
  for (std::size_t i = 0; i < texels.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint8_t* at = image.texels.data() + i * stride;
      const float value = image.format == RawFormat::rgba8
                              ? static_cast<float>(at[c]) / 255.0f
                              : static_cast<float>(at[2 * c] | at[2 * c + 1] << 8) / 65535.0f;
      texels[i][static_cast<int>(c)] = value;
    }
  }
  return float_picture(image.width, image.height, texels);
}

Wrap wrap_of(const Context& context, const Params& params) {
  const std::string name = params.text("wrap", "repeat");
  if (name == "repeat") return Wrap::repeat;
  if (name != "clamp") {
    context.warn(params.place(), fmt::format("wrapping '{:.40}' is taken for 'clamp'", name));
  }
  return Wrap::clamp_to_edge;
}

Expected<SurfaceTexture> image_map(const Context& context, const Params& params) {
  const std::string name = params.text("filename", "");
  if (name.empty()) return fail(Errc::bad_data, params.place(), "an image needs a file name");
  const Wrap wrap = wrap_of(context, params);
  const Filter filter =
      params.text("filter", "bilinear") == "point" ? Filter::nearest : Filter::linear;
  const Texture settings{kNoImage, wrap, wrap, filter};
  const std::string encoding = params.text("encoding", "sRGB");
  const bool linear = encoding == "linear";
  if (!linear && encoding != "sRGB") {
    context.warn(params.place(), fmt::format("the encoding '{:.40}' is taken for sRGB", encoding));
  }
  const auto id = linear ? context.import.texture(context.import.picture(name).map(linear_picture),
                                                  params.place(), settings)
                         : context.import.texture(name, params.place(), settings);
  if (!id) return tl::unexpected(id.error());
  SurfaceTexture texture;
  texture.slot.texture = *id;
  const float scale = to_float(params.number("scale", 1));
  texture.factor = {scale, scale, scale};
  // pbrt's v grows upwards, a scene's downwards: v' = 1 - (sv (1 - v) + dv).
  const UvMapping m = mapping_of(context, params);
  texture.slot.to_uv[0][0] = m.su;
  texture.slot.to_uv[0][2] = m.du;
  texture.slot.to_uv[1][1] = m.sv;
  texture.slot.to_uv[1][2] = 1 - m.sv - m.dv;
  return texture;
}

// Two by two fields, repeated: field (i, j) shows tex1 where i + j is even.
Expected<SurfaceTexture> checkerboard(const Context& context, const Params& params,
                                      const SurfaceTexture& even, const SurfaceTexture& odd) {
  if (params.number("dimension", 2) != 2) {
    context.warn(params.place(), "a checkerboard in space is taken for one in the plane");
  }
  if (even.has_picture() || odd.has_picture()) {
    context.warn(params.place(), "pictures in the fields of a checkerboard are not used");
  }
  const Texture settings{kNoImage, Wrap::repeat, Wrap::repeat, Filter::nearest};
  const auto picture = float_picture(2, 2, {even.factor, odd.factor, odd.factor, even.factor});
  const auto id = context.import.texture(picture, params.place(), settings);
  if (!id) return tl::unexpected(id.error());
  SurfaceTexture texture;
  texture.slot.texture = *id;
  const UvMapping m = mapping_of(context, params);
  texture.slot.to_uv[0][0] = 0.5f * m.su;
  texture.slot.to_uv[0][2] = 0.5f * m.du;
  texture.slot.to_uv[1][1] = -0.5f * m.sv;
  texture.slot.to_uv[1][2] = 0.5f * (m.sv + m.dv);
  return texture;
}

}  // namespace

Status Textures::add(const Context& context, const std::string& name, const std::string& kind,
                     const Params& params) {
  const auto part = [&](std::string_view part_name, float otherwise) {
    return find(context, params, part_name).map([&](const auto& found) {
      return found.value_or(SurfaceTexture{{otherwise, otherwise, otherwise}, {}});
    });
  };
  Expected<SurfaceTexture> texture = SurfaceTexture{{0.5f, 0.5f, 0.5f}, {}};
  if (kind == "constant") {
    texture = part("value", 1);
  } else if (kind == "imagemap") {
    texture = image_map(context, params);
  } else if (kind == "checkerboard") {
    const auto even = part("tex1", 1), odd = part("tex2", 0);
    if (!even) return tl::unexpected(even.error());
    if (!odd) return tl::unexpected(odd.error());
    texture = checkerboard(context, params, *even, *odd);
  } else if (kind == "scale") {
    auto base = part("tex", 1), scale = part("scale", 1);
    if (!base) return tl::unexpected(base.error());
    if (!scale) return tl::unexpected(scale.error());
    if (!base->has_picture()) std::swap(*base, *scale);
    if (scale->has_picture()) context.warn(params.place(), "one of two pictures is not used");
    base->factor = base->factor * scale->factor;
    texture = *base;
  } else {
    context.warn(params.place(), fmt::format("textures '{:.40}' are taken for grey", kind));
  }
  if (!texture) return tl::unexpected(texture.error());
  context.warn_of_unused(params);
  textures_[name] = *texture;
  return {};
}

Expected<std::optional<SurfaceTexture>> Textures::find(const Context& context, const Params& params,
                                                       std::string_view name) const {
  if (const Param* param = params.find(name, {"texture"})) {
    const auto found = param->texts.empty() ? textures_.end() : textures_.find(param->texts[0]);
    if (found == textures_.end()) {
      return fail(Errc::bad_data, param->place, "there is no texture of this name");
    }
    return found->second;
  }
  if (const Param* param = params.find(name, {"float"})) {
    const float value = param->numbers.empty() ? 0.0f : to_float(param->numbers[0]);
    return SurfaceTexture{{value, value, value}, {}};
  }
  const auto plain = colour(context, params, name, ColourKind::reflectance);
  if (!plain) return tl::unexpected(plain.error());
  if (!*plain) return std::nullopt;
  return SurfaceTexture{**plain, {}};
}

Expected<double> Textures::number(const Context& context, const Params& params,
                                  std::string_view name, double otherwise) const {
  const auto found = find(context, params, name);
  if (!found) return tl::unexpected(found.error());
  if (!*found) return otherwise;
  if ((*found)->has_picture()) {
    context.warn(params.place(), fmt::format("the picture for '{:.40}' counts as a number", name));
  }
  return double((*found)->factor.y);
}

}  // namespace dapple::pbrt
