#include "import/pbrt/context.h"

#include <fmt/format.h>

#include <cmath>

#include "import/text.h"

namespace dapple::pbrt {
namespace {

constexpr std::size_t kMaxSpectrumBytes = 1u << 20;

Expected<Spectrum> spectrum_file(const Context& context, const Param& param) {
  const auto file = context.import.open_companion(param.texts[0]);
  if (!file) return fail(file.error().code, param.place, to_string(file.error()));
  const auto damaged = [&] {
    return fail(Errc::bad_data, context.import.sandbox().path_of(param.texts[0]),
                "does not hold pairs of growing wavelengths and values");
  };
  if (file->bytes().size() > kMaxSpectrumBytes) return damaged();
  std::vector<double> numbers;
  LineReader lines(as_text(file->bytes()));
  for (std::string_view line; lines.next(line);) {
    WordReader words(line.substr(0, line.find('#')));
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
      const auto value = to_number(word);
      if (!value || !std::isfinite(*value)) return damaged();
      numbers.push_back(*value);
    }
  }
  auto spectrum = make_spectrum(numbers);
  if (!spectrum) return damaged();
  return std::move(*spectrum);
}

// "metal-Ag-eta", "metal-Ag-k", "glass-BK7" and illuminants.
std::optional<Vec3f> named_colour(const Context& context, const Param& param) {
  const std::string_view name = param.texts[0];
  if (name.starts_with("metal-")) {
    const std::size_t end = name.rfind('-');
    const Conductor* conductor = conductor_named(name.substr(6, end < 6 ? 0 : end - 6));
    if (conductor != nullptr) return name.ends_with("-k") ? conductor->k : conductor->eta;
  }
  if (name.starts_with("glass-")) {
    if (const Glass* glass = glass_named(name.substr(6))) {
      return Vec3f(glass->ior, glass->ior, glass->ior);
    }
  }
  if (name.starts_with("stdillum-") || name.starts_with("illum-")) {
    if (name != "stdillum-D65") {
      context.warn(param.place, fmt::format("the illuminant '{:.40}' is taken for white", name));
    }
    return Vec3f(1, 1, 1);
  }
  return std::nullopt;
}

Vec3f colour_of(const Spectrum& spectrum, ColourKind kind) {
  return kind == ColourKind::reflectance ? reflectance_colour(spectrum) : emission_colour(spectrum);
}

}  // namespace

void Context::warn(const std::string& place, std::string_view message) const {
  import.log().warn(fmt::format("{}: {}", place, message));
}

void Context::warn_of_unused(const Params& params) const {
  for (const Param* param : params.unused()) {
    warn(param->place, fmt::format("the parameter '{:.60}' is not used", param->name));
  }
}

Expected<std::optional<Spectrum>> spectrum(const Context& context, const Params& params,
                                           std::string_view name) {
  const Param* param = params.find(name, {"spectrum"});
  if (param == nullptr) return std::nullopt;
  if (param->texts.empty()) {
    auto made = make_spectrum(param->numbers);
    if (!made) {
      return fail(Errc::bad_data, param->place,
                  "a spectrum needs pairs of growing wavelengths and values");
    }
    return made;
  }
  auto read = spectrum_file(context, *param);
  if (!read) return tl::unexpected(read.error());
  return std::move(*read);
}

Expected<std::optional<Vec3f>> colour(const Context& context, const Params& params,
                                      std::string_view name, ColourKind kind) {
  const Param* param = params.find(name, {"rgb", "color", "blackbody", "spectrum"});
  if (param == nullptr) return std::nullopt;
  const auto& n = param->numbers;
  if (param->type == "blackbody") {
    if (n.empty()) return fail(Errc::bad_data, param->place, "a temperature is missing");
    return blackbody_colour(n[0]);
  }
  if (param->type == "spectrum") {
    if (!param->texts.empty()) {
      if (const auto named = named_colour(context, *param)) return named;
    }
    const auto sampled = spectrum(context, params, name);
    if (!sampled) return tl::unexpected(sampled.error());
    return colour_of(**sampled, kind);
  }
  if (n.size() < 3) return fail(Errc::bad_data, param->place, "a colour needs three numbers");
  return Vec3f(to_float(n[0]), to_float(n[1]), to_float(n[2]));
}

}  // namespace dapple::pbrt
