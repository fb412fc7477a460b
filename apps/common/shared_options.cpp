#include "common/shared_options.h"

#include <utility>

#include "render/settings.h"

namespace dapple {
namespace {

constexpr std::int64_t kMaxSeed = INT64_MAX;
constexpr int kMaxThreads = 4096;

}  // namespace

OptionInfo help_option() {
  return {.name = "help", .letter = 'h', .help = "Show this help and exit"};
}

OptionInfo quiet_option() {
  return {.name = "quiet", .letter = 'q', .help = "Print nothing but warnings and errors"};
}

OptionInfo trust_option() {
  return {.name = "trust",
          .help =
              "Skip the checksums of scene files; their structure is checked "
              "all the same"};
}

OptionInfo copy_option() {
  return {.name = "copy",
          .help =
              "Copy scene files into memory before they are checked, for files "
              "that somebody else may change meanwhile"};
}

OptionInfo seed_option() {
  return {.name = "seed",
          .kind = ValueKind::integer,
          .value = "N",
          .help = "Seed of all random numbers",
          .default_value = "0",
          .low = 0,
          .high = kMaxSeed};
}

OptionInfo threads_option() {
  return {.name = "threads",
          .letter = 'j',
          .kind = ValueKind::integer,
          .value = "N",
          .help =
              "Number of threads; 0 leaves the choice to OMP_NUM_THREADS, or "
              "else takes all processors",
          .default_value = "0",
          .low = 0,
          .high = kMaxThreads};
}

OptionInfo scene_argument() {
  return {.name = "SCENE",
          .kind = ValueKind::scene,
          .help = "A named scene, such as nice or irreg:1000, a scene file, or a model file",
          .required = true};
}

OptionInfo json_option(std::string_view help) { return {.name = "json", .help = help}; }

OptionInfo output_option(std::string_view help) {
  return {.name = "output",
          .letter = 'o',
          .kind = ValueKind::output_file,
          .value = "FILE",
          .help = help,
          .required = true};
}

OptionInfo accel_option(std::string_view help, std::string default_value) {
  return {.name = "accel",
          .letter = 'a',
          .kind = ValueKind::choice,
          .help = help,
          .default_value = std::move(default_value),
          .choices = {"linear", "median", "fast"}};
}

OptionInfo bvh_quality_option() {
  return {.name = "bvh-quality",
          .kind = ValueKind::choice,
          .help =
              "How much work goes into the fast BVH; high pays where long thin triangles "
              "overlap. A stored one is taken as it is",
          .default_value = "medium",
          .choices = {"low", "medium", "high"}};
}

OptionInfo bvh_compact_option() {
  return {.name = "bvh-compact",
          .help =
              "Keep indices instead of coordinates in the fast BVH, which takes less than half "
              "the memory for triangles and is slower; a stored one is taken as it is"};
}

OptionInfo size_option(std::string_view name, std::string_view help, std::string default_value) {
  return {.name = name,
          .kind = ValueKind::integer,
          .value = "N",
          .help = help,
          .default_value = std::move(default_value),
          .low = 1,
          .high = kMaxImageSide};
}

OptionInfo transfer_option(std::string_view help) {
  return {.name = "transfer",
          .kind = ValueKind::choice,
          .help = help,
          .default_value = "srgb",
          .choices = {"srgb", "gamma2"}};
}

}  // namespace dapple
