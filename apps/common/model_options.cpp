#include "common/model_options.h"

namespace dapple {

std::vector<OptionInfo> import_options() {
  return {
      {.name = "scene",
       .kind = ValueKind::text,
       .value = "NAME",
       .help = "Which scene of a model file with several, by name or index"},
      {.name = "variant",
       .kind = ValueKind::text,
       .value = "NAME",
       .help = "Which variant of its materials"},
      {.name = "time",
       .kind = ValueKind::number,
       .value = "SECONDS",
       .help = "Pose the model as its animations say; without it, the stored pose"},
      {.name = "point-radius",
       .kind = ValueKind::number,
       .value = "R",
       .help = "Radius of points and lines; 0 takes one that suits the model's size",
       .default_value = "0"},
      {.name = "keep-going",
       .help = "Make do without what is missing or broken in a model, with a warning for each; a "
               "missing texture becomes magenta, faces with indices of nothing are left out"},
  };
}

std::vector<OptionInfo> view_options() {
  return {
      {.name = "camera",
       .kind = ValueKind::text,
       .value = "NAME",
       .help = "One of the scene's cameras, by name or index"},
      {.name = "orbit",
       .kind = ValueKind::triple,
       .value = "THETA,PHI,RADIUS",
       .help = "Look at the target from this angle about the y axis, this angle from it (90 is "
               "level) and this distance"},
      {.name = "target",
       .kind = ValueKind::triple,
       .value = "X,Y,Z",
       .help = "What an orbit looks at; without it, the middle of the scene"},
      {.name = "fov",
       .kind = ValueKind::number,
       .value = "DEGREES",
       .help = "Vertical field of view"},
      {.name = "environment",
       .kind = ValueKind::text,
       .value = "FILE",
       .help =
           "What surrounds the scene: an equirectangular picture (HDR, EXR, PFM, PNG, PPM, JPEG or "
           "WebP), studio or none"},
      {.name = "rotate",
       .kind = ValueKind::real,
       .value = "DEGREES",
       .help = "Turn the environment about the y axis"},
      {.name = "transparent", .help = "Leave the background out; PNG and EXR get alpha"},
  };
}

std::vector<OptionInfo> picture_options() {
  return {
      {.name = "filter",
       .kind = ValueKind::choice,
       .help = "How samples spread around a pixel's centre, in pictures of models",
       .default_value = "blackman-harris",
       .choices = {"box", "gaussian", "blackman-harris"}},
      {.name = "clamp-indirect",
       .kind = ValueKind::number,
       .value = "RADIANCE",
       .help =
           "Cut what a single sample brings after its first scattering; less noise, less light. "
           "0 cuts nothing. What was cut is reported",
       .default_value = "0"},
      {.name = "tone-map",
       .kind = ValueKind::choice,
       .help = "How radiance is fitted into PNG and PPM; auto is neutral for models and none for "
               "classic scenes",
       .default_value = "auto",
       .choices = {"auto", "neutral", "none", "agx", "aces"}},
      {.name = "exposure",
       .kind = ValueKind::real,
       .value = "STOPS",
       .help = "Brighten PNG and PPM pictures by two to this power; without it, models that "
               "nothing surrounds are exposed by their own brightness and all else by 0"},
  };
}

}  // namespace dapple
