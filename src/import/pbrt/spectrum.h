// Spectra as linear sRGB colours.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "math/vec3.h"

namespace dapple::pbrt {

// Values at wavelengths in nanometres, linear in between; the wavelengths grow.
struct Spectrum {
  std::vector<double> wavelengths;
  std::vector<double> values;

  double at(double wavelength) const;  // beyond its ends: the value there
};

// Wavelengths and values in turn; nothing if they are not.
[[nodiscard]] std::optional<Spectrum> make_spectrum(const std::vector<double>& pairs);

// The colour of a reflectance; one that is 1 everywhere is white.
[[nodiscard]] Vec3f reflectance_colour(const Spectrum& spectrum);
// The colour of emission, its luminance 1.
[[nodiscard]] Vec3f emission_colour(const Spectrum& spectrum);
[[nodiscard]] Vec3f blackbody_colour(double kelvin);

// Reflectance of a conductor at normal incidence.
[[nodiscard]] Vec3f conductor_colour(const Vec3f& eta, const Vec3f& k);
[[nodiscard]] Vec3f conductor_colour(const Spectrum& eta, const Spectrum& k);

struct Conductor {
  std::string_view name;  // "Ag" of "metal-Ag-eta"
  Vec3f eta, k;           // in red, green and blue
};
[[nodiscard]] const Conductor* conductor_named(std::string_view name);

struct Glass {
  std::string_view name;  // "BK7" of "glass-BK7"
  float ior = 1.5f;
  float abbe = 60;  // number of dispersion
};
[[nodiscard]] const Glass* glass_named(std::string_view name);

}  // namespace dapple::pbrt
