#include "import/pbrt/spectrum.h"

#include <algorithm>
#include <cmath>

#include "math/functions.h"

namespace dapple::pbrt {
namespace {

constexpr double kFirst = 380, kLast = 780, kStep = 5;  // nanometres
constexpr double kLog2E = 1.44269504088896340736;

double natural_exp(double x) { return binary_exp(x * kLog2E); }

// A bell with a width of its own on each side.
double bell(double x, double middle, double left, double right) {
  const double t = (x - middle) * (x < middle ? left : right);
  return natural_exp(-0.5 * t * t);
}

// Colour matching functions of the CIE 1931 observer, by the fit of [WymanSS13].
Vec3d observer(double nm) {
  return {1.056 * bell(nm, 599.8, 0.0264, 0.0323) + 0.362 * bell(nm, 442.0, 0.0624, 0.0374) -
              0.065 * bell(nm, 501.1, 0.0490, 0.0382),
          0.821 * bell(nm, 568.8, 0.0213, 0.0247) + 0.286 * bell(nm, 530.9, 0.0613, 0.0322),
          1.217 * bell(nm, 437.0, 0.0845, 0.0278) + 0.681 * bell(nm, 459.0, 0.0385, 0.0725)};
}

Vec3d srgb_of(const Vec3d& xyz) {
  return {3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z,
          -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z,
          0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z};
}

// The colour of a function of the wavelength and the luminance of one that is 1.
template <class Value>
Vec3d colour_of(Value&& value) {
  Vec3d sum;
  double luminance = 0;
  for (double nm = kFirst; nm <= kLast; nm += kStep) {
    sum = sum + value(nm) * observer(nm);
    luminance += observer(nm).y;
  }
  return srgb_of(sum / luminance);
}

Vec3f not_negative(const Vec3d& c) {
  return Vec3f(Vec3d(std::max(c.x, 0.0), std::max(c.y, 0.0), std::max(c.z, 0.0)));
}

// Relative to the colour of equal energy, which is taken for white.
template <class Value>
Vec3f reflectance_of(Value&& value) {
  const Vec3d white = colour_of([](double) { return 1.0; });
  const Vec3d colour = colour_of(value);
  return not_negative({colour.x / white.x, colour.y / white.y, colour.z / white.z});
}

template <class Value>
Vec3f emission_of(Value&& value) {
  const Vec3d colour = colour_of(value);
  const double luminance = 0.2126 * colour.x + 0.7152 * colour.y + 0.0722 * colour.z;
  return luminance > 0 && std::isfinite(luminance) ? not_negative(colour / luminance) : Vec3f();
}

double conductor_reflectance(double eta, double k) {
  const double above = (eta - 1) * (eta - 1) + k * k;
  const double below = (eta + 1) * (eta + 1) + k * k;
  return below > 0 ? above / below : 0;
}

constexpr Conductor kConductors[] = {
    {"Ag", {0.155265f, 0.116723f, 0.138381f}, {4.828343f, 3.122246f, 2.147050f}},
    {"Al", {1.657460f, 0.880369f, 0.521229f}, {9.223869f, 6.269523f, 4.837001f}},
    {"Au", {0.143119f, 0.374957f, 1.442479f}, {3.983160f, 2.385721f, 1.603215f}},
    {"Cu", {0.200438f, 0.924033f, 1.102212f}, {3.912949f, 2.452848f, 2.142188f}},
    {"CuZn", {0.444f, 0.527f, 1.094f}, {3.695f, 2.765f, 1.829f}},
    {"MgO", {1.734f, 1.738f, 1.746f}, {0, 0, 0}},
    {"TiO2", {2.58f, 2.65f, 2.79f}, {0, 0, 0}},
};

constexpr Glass kGlasses[] = {
    {"BK7", 1.5168f, 64.2f},   {"BAF10", 1.6700f, 47.1f}, {"FK51A", 1.4866f, 84.5f},
    {"LASF9", 1.8503f, 32.2f}, {"F5", 1.6034f, 38.0f},    {"SF5", 1.6727f, 32.2f},
    {"SF10", 1.7283f, 28.4f},  {"SF11", 1.7847f, 25.8f},
};

}  // namespace

double Spectrum::at(double wavelength) const {
  const auto above = std::ranges::upper_bound(wavelengths, wavelength);
  if (above == wavelengths.begin()) return values.front();
  if (above == wavelengths.end()) return values.back();
  const auto i = static_cast<std::size_t>(above - wavelengths.begin());
  const double t = (wavelength - wavelengths[i - 1]) / (wavelengths[i] - wavelengths[i - 1]);
  return (1 - t) * values[i - 1] + t * values[i];
}

std::optional<Spectrum> make_spectrum(const std::vector<double>& pairs) {
  if (pairs.empty() || pairs.size() % 2 != 0) return std::nullopt;
  Spectrum spectrum;
  for (std::size_t i = 0; i < pairs.size(); i += 2) {
    if (i > 0 && !(pairs[i] > spectrum.wavelengths.back())) return std::nullopt;
    spectrum.wavelengths.push_back(pairs[i]);
    spectrum.values.push_back(pairs[i + 1]);
  }
  return spectrum;
}

Vec3f reflectance_colour(const Spectrum& spectrum) {
  return reflectance_of([&](double nm) { return spectrum.at(nm); });
}

Vec3f emission_colour(const Spectrum& spectrum) {
  return emission_of([&](double nm) { return spectrum.at(nm); });
}

Vec3f blackbody_colour(double kelvin) {
  if (!(kelvin > 0)) return {};
  // Planck's law relative to 560 nm, so that no power of a wavelength in metres appears.
  constexpr double kSecond = 1.438776877e7;  // nm K
  return emission_of([&](double nm) {
    const double t = nm / 560;
    const double exponent = std::min(kSecond / (nm * kelvin), 700.0);
    return 1 / (t * t * t * t * t * (natural_exp(exponent) - 1));
  });
}

Vec3f conductor_colour(const Vec3f& eta, const Vec3f& k) {
  Vec3f colour;
  for (int i = 0; i < 3; ++i) {
    colour[i] = static_cast<float>(conductor_reflectance(double(eta[i]), double(k[i])));
  }
  return colour;
}

Vec3f conductor_colour(const Spectrum& eta, const Spectrum& k) {
  return reflectance_of([&](double nm) { return conductor_reflectance(eta.at(nm), k.at(nm)); });
}

const Conductor* conductor_named(std::string_view name) {
  const auto found = std::ranges::find(kConductors, name, &Conductor::name);
  return found == std::end(kConductors) ? nullptr : found;
}

const Glass* glass_named(std::string_view name) {
  const auto found = std::ranges::find(kGlasses, name, &Glass::name);
  return found == std::end(kGlasses) ? nullptr : found;
}

}  // namespace dapple::pbrt
