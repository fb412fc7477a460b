// What all readers of parts of a pbrt scene share.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "import/model_import.h"
#include "import/pbrt/params.h"
#include "import/pbrt/spectrum.h"
#include "math/transform.h"

namespace dapple::pbrt {

struct Context {
  ModelImport& import;
  // pbrt's coordinates are left-handed unless its camera is a mirrored one, those of a scene are
  // right-handed: in the first case everything is mirrored in z.
  Transformd to_scene;

  void warn(const std::string& place, std::string_view message) const;
  // A warning for each parameter that was given and never asked for.
  void warn_of_unused(const Params& params) const;
};

enum class ColourKind { reflectance, emission };

// A parameter of type rgb, spectrum, blackbody or the like; nothing if it is not there.
[[nodiscard]] Expected<std::optional<Vec3f>> colour(const Context& context, const Params& params,
                                                    std::string_view name, ColourKind kind);

// The sampled spectrum of a parameter: pairs of numbers, or the name of a file with them.
[[nodiscard]] Expected<std::optional<Spectrum>> spectrum(const Context& context,
                                                         const Params& params,
                                                         std::string_view name);

}  // namespace dapple::pbrt
