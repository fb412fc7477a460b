#include "import/pbrt/materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "import/text.h"
#include "math/functions.h"

namespace dapple::pbrt {
namespace {

float clamped(double value) { return static_cast<float>(std::clamp(value, 0.0, 1.0)); }
Vec3f clamped(const Vec3f& c) {
  return {clamped(double(c.x)), clamped(double(c.y)), clamped(double(c.z))};
}
Vec3f grey(float value) { return {value, value, value}; }

// What of light that comes diffusely from inside a dielectric is reflected back [JensenMLH01].
double inner_reflectance(double eta) {
  return -1.4399 / (eta * eta) + 0.7099 / eta + 0.6681 + 0.0636 * eta;
}

// The base below a dielectric coat is lit by what the coat reflects inwards too. Here the coat only
// covers it, so the base gets the colour that all these reflections add up to.
float below_coat(float albedo, double inner) {
  return static_cast<float>(double(albedo) * (1 - inner) / (1 - double(albedo) * inner));
}

class MaterialMaker {
 public:
  MaterialMaker(const Context& context, const Textures& textures, const Params& params)
      : context_(context), textures_(textures), params_(params) {}

  Expected<LayeredMaterial> make(const std::string& kind) {
    struct Kind {
      std::string_view name;
      Status (MaterialMaker::*set)();
    };
    static constexpr Kind kKinds[] = {
        {"diffuse", &MaterialMaker::diffuse},
        {"matte", &MaterialMaker::diffuse},
        {"coateddiffuse", &MaterialMaker::coated_diffuse},
        {"plastic", &MaterialMaker::coated_diffuse},
        {"conductor", &MaterialMaker::conductor},
        {"metal", &MaterialMaker::conductor},
        {"coatedconductor", &MaterialMaker::coated_conductor},
        {"dielectric", &MaterialMaker::dielectric},
        {"glass", &MaterialMaker::dielectric},
        {"thindielectric", &MaterialMaker::thin_dielectric},
        {"diffusetransmission", &MaterialMaker::diffuse_transmission},
        {"mirror", &MaterialMaker::mirror},
        {"interface", &MaterialMaker::interface},
        {"none", &MaterialMaker::interface},
        {"", &MaterialMaker::interface},
    };
    const auto found = std::ranges::find(kKinds, kind, &Kind::name);
    if (found == std::end(kKinds)) {
      context_.warn(params_.place(), fmt::format("materials '{:.40}' are taken for grey", kind));
      m_.base_colour = grey(0.5f);
      return m_;
    }
    if (auto set = (this->*found->set)(); !set) return tl::unexpected(set.error());
    params_.find("type", {"string"});
    context_.warn_of_unused(params_);
    return m_;
  }

 private:
  // v4's name for it, or v3's.
  Status base_colour(std::string_view name, std::string_view old_name) {
    auto found = textures_.find(context_, params_, name);
    if (found && !*found) found = textures_.find(context_, params_, old_name);
    if (!found) return tl::unexpected(found.error());
    const SurfaceTexture texture = found->value_or(SurfaceTexture{grey(0.5f), {}});
    m_.base_colour = clamped(texture.factor);
    m_.map(MapUse::base_colour) = texture.slot;
    return {};
  }

  Status diffuse() {
    m_.specular = 0;
    return base_colour("reflectance", "Kd");
  }

  // The width of the distribution is the roughness, or its square root where it is remapped;
  // a layered material's roughness is the square root of the width.
  Expected<float> roughness(const std::string& prefix, double otherwise) {
    const auto both = textures_.number(context_, params_, prefix + "roughness", otherwise);
    if (!both) return tl::unexpected(both.error());
    const auto u = textures_.number(context_, params_, prefix + "uroughness", *both);
    const auto v = textures_.number(context_, params_, prefix + "vroughness", *both);
    if (!u || !v) return tl::unexpected((!u ? u : v).error());
    const auto width = [&](double r) { return remapped_ ? std::sqrt(std::max(r, 0.0)) : r; };
    const double wide = std::max(width(*u), width(*v)), narrow = std::min(width(*u), width(*v));
    if (wide > narrow) {
      // Along the tangent a layered material is as wide as its strength squared brings it from its
      // roughness towards 1.
      m_.anisotropy = clamped(std::sqrt((wide - narrow) / std::max(1 - narrow, 1e-6)));
      m_.anisotropy_rotation = width(*u) < width(*v) ? 1.57079632679489662f : 0.0f;
    }
    return clamped(std::sqrt(std::max(narrow, 0.0)));
  }

  Status set_roughness(const std::string& prefix, double otherwise, float& result) {
    remapped_ = params_.truth("remaproughness", true);
    const auto read = roughness(prefix, otherwise);
    if (!read) return tl::unexpected(read.error());
    result = *read;
    return {};
  }

  Expected<double> ior(std::string_view name, double otherwise) {
    const Param* param = params_.find(name, {"spectrum"});
    if (param != nullptr && !param->texts.empty() && param->texts[0].starts_with("glass-")) {
      if (const Glass* glass = glass_named(std::string_view(param->texts[0]).substr(6))) {
        m_.dispersion = 20 / glass->abbe;
        return double(glass->ior);
      }
    }
    return textures_.number(context_, params_, name, otherwise);
  }

  Status set_ior(std::string_view name) {
    auto eta = ior(name, 1.5);
    if (eta && params_.find("index", {"float"}) != nullptr) eta = params_.number("index", 1.5);
    if (!eta) return tl::unexpected(eta.error());
    if (*eta < 1) {
      context_.warn(params_.place(), "an index of refraction below 1 is taken for 1");
    }
    m_.ior = static_cast<float>(std::clamp(*eta, 1.0, 10.0));
    return {};
  }

  Status coated_diffuse() {
    if (auto s = base_colour("reflectance", "Kd"); !s) return s;
    if (auto s = set_ior("eta"); !s) return s;
    if (m_.map(MapUse::base_colour).texture == kNoTexture) {
      const double inner = inner_reflectance(double(m_.ior));
      for (int i = 0; i < 3; ++i) m_.base_colour[i] = below_coat(m_.base_colour[i], inner);
    }
    ignore({"thickness", "albedo", "g", "maxdepth", "nsamples", "Ks"});
    return set_roughness("", 0, m_.roughness);
  }

  Expected<Vec3f> metal_colour(const std::string& prefix) {
    const auto reflectance = textures_.find(context_, params_, "reflectance");
    if (!reflectance) return tl::unexpected(reflectance.error());
    if (*reflectance) {
      m_.map(MapUse::base_colour) = (*reflectance)->slot;
      return clamped((*reflectance)->factor);
    }
    const std::string eta_name = prefix + "eta", k_name = prefix + "k";
    if (is_sampled(eta_name) && is_sampled(k_name)) {
      const auto eta = spectrum(context_, params_, eta_name);
      const auto k = spectrum(context_, params_, k_name);
      if (!eta || !k) return tl::unexpected((!eta ? eta : k).error());
      return conductor_colour(**eta, **k);
    }
    const Conductor& copper = *conductor_named("Cu");
    const auto eta = textures_.find(context_, params_, eta_name);
    const auto k = textures_.find(context_, params_, k_name);
    if (!eta || !k) return tl::unexpected((!eta ? eta : k).error());
    return conductor_colour(*eta ? (*eta)->factor : copper.eta, *k ? (*k)->factor : copper.k);
  }

  bool is_sampled(const std::string& name) const {
    const Param* param = params_.find(name, {"spectrum"});
    return param != nullptr && (param->texts.empty() || !param->texts[0].starts_with("metal-"));
  }

  Status conductor() { return metal("", 0); }

  Status metal(const std::string& prefix, double roughness_otherwise) {
    const auto colour = metal_colour(prefix);
    if (!colour) return tl::unexpected(colour.error());
    m_.base_colour = clamped(*colour);
    m_.metallic = 1;
    return set_roughness(prefix, roughness_otherwise, m_.roughness);
  }

  Status coated_conductor() {
    if (auto s = metal("conductor.", 0); !s) return s;
    const float anisotropy = m_.anisotropy, rotation = m_.anisotropy_rotation;
    if (auto s = set_roughness("interface.", 0, m_.clearcoat_roughness); !s) return s;
    m_.anisotropy = anisotropy, m_.anisotropy_rotation = rotation;
    m_.clearcoat = 1;
    ignore({"thickness", "albedo", "g", "maxdepth", "nsamples", "interface.eta"});
    return {};
  }

  Status dielectric() {
    m_.transmission = 1;
    m_.thickness = 1;
    if (auto s = set_ior("eta"); !s) return s;
    ignore({"Kr", "Kt"});
    return set_roughness("", 0, m_.roughness);
  }

  Status thin_dielectric() {
    m_.transmission = 1;
    m_.roughness = 0;
    return set_ior("eta");
  }

  Status diffuse_transmission() {
    m_.specular = 0;
    const auto reflected = textures_.find(context_, params_, "reflectance");
    const auto transmitted = textures_.find(context_, params_, "transmittance");
    if (!reflected || !transmitted) {
      return tl::unexpected((!reflected ? reflected : transmitted).error());
    }
    const float scale = to_float(params_.number("scale", 1));
    const auto one = SurfaceTexture{grey(0.25f), {}};
    const Vec3f r = scale * reflected->value_or(one).factor;
    const Vec3f t = scale * transmitted->value_or(one).factor;
    // (1 - part) base is reflected, part times the other colour transmitted.
    const float all = max_abs_component(r) + max_abs_component(t);
    const float part = all > 0 ? max_abs_component(t) / all : 0.5f;
    m_.diffuse_transmission = clamped(double(part));
    m_.base_colour = part < 1 ? clamped(r / (1 - part)) : Vec3f();
    m_.diffuse_transmission_colour = part > 0 ? clamped(t / part) : Vec3f();
    if (*reflected) m_.map(MapUse::base_colour) = (*reflected)->slot;
    if (*transmitted) m_.map(MapUse::diffuse_transmission_colour) = (*transmitted)->slot;
    return {};
  }

  Status mirror() {
    m_.metallic = 1;
    m_.roughness = 0;
    return base_colour("reflectance", "Kr");
  }

  // No surface at all: where a medium ends.
  Status interface() {
    m_.transmission = 1;
    m_.thickness = 1;
    m_.roughness = 0;
    m_.ior = 1;
    m_.specular = 0;
    return {};
  }

  void ignore(std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) params_.find(name, {""});
  }

  const Context& context_;
  const Textures& textures_;
  const Params& params_;
  LayeredMaterial m_;
  bool remapped_ = true;
};

}  // namespace

Expected<LayeredMaterial> make_material(const Context& context, const Textures& textures,
                                        const std::string& kind, const Params& params) {
  return MaterialMaker(context, textures, params).make(kind);
}

Expected<Medium> make_medium(const Context& context, const Params& params) {
  const auto absorption = colour(context, params, "sigma_a", ColourKind::reflectance);
  const auto scattering = colour(context, params, "sigma_s", ColourKind::reflectance);
  if (!absorption || !scattering) {
    return tl::unexpected((!absorption ? absorption : scattering).error());
  }
  if (const std::string kind = params.text("type", "homogeneous"); kind != "homogeneous") {
    context.warn(params.place(), fmt::format("media '{:.40}' are taken for homogeneous", kind));
  }
  const float scale = std::max(0.0f, to_float(params.number("scale", 1)));
  const auto coefficient = [&](const Vec3f& c) {
    return scale * Vec3f(std::max(c.x, 0.0f), std::max(c.y, 0.0f), std::max(c.z, 0.0f));
  };
  Medium medium;
  medium.absorption = coefficient(absorption->value_or(Vec3f(0.0011f, 0.0024f, 0.014f)));
  medium.scattering = coefficient(scattering->value_or(Vec3f(2.55f, 3.21f, 3.77f)));
  medium.g = std::clamp(to_float(params.number("g", 0)), -0.99f, 0.99f);
  context.warn_of_unused(params);
  return medium;
}

void fill_with(const Medium& medium, LayeredMaterial& material) {
  material.thickness = 1;
  material.scattering = medium.scattering;
  material.scattering_anisotropy = medium.g;
  const float densest = max_abs_component(medium.absorption);
  if (!(densest > 0)) return;
  material.attenuation_distance = 1 / densest;
  constexpr double kLog2E = 1.44269504088896340736;
  for (int i = 0; i < 3; ++i) {
    const double depth = double(medium.absorption[i]) / double(densest);
    material.attenuation_colour[i] = static_cast<float>(binary_exp(-depth * kLog2E));
  }
}

}  // namespace dapple::pbrt
