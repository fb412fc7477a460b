#include "common/command_table.h"
#include "render/settings.h"

namespace dapple {
namespace {

std::vector<OptionInfo> render_arguments() {
  return {
      {.name = "OUTFILE",
       .kind = ValueKind::output_file,
       .help =
           "The picture to write: binary PPM, or what the ending .png, .exr, .pfm or .hdr names",
       .required = true},
      {.name = "NX",
       .kind = ValueKind::integer,
       .help = "Width in pixels",
       .low = 1,
       .high = kMaxImageSide,
       .required = true},
      {.name = "NY",
       .kind = ValueKind::integer,
       .help = "Height in pixels",
       .low = 1,
       .high = kMaxImageSide,
       .required = true},
      {.name = "NS",
       .kind = ValueKind::integer,
       .help = "Samples for each pixel",
       .low = 1,
       .high = kMaxSamplesPerPixel,
       .required = true},
      {.name = "SCENE",
       .kind = ValueKind::scene,
       .help = "A named scene (empty, irreg, nice, rgbbox) or the path of a scene file",
       .default_value = "nice"},
  };
}

const std::vector<ExitCode> kExitCodes = {
    {0, "The whole output is in place."},
    {1,
     "It failed; one line on standard error names the file and the reason. An output file that "
     "was there before is untouched."},
    {2, "The command line is wrong."},
};

constexpr std::string_view kThreads =
    "OMP_NUM_THREADS and the other OpenMP variables choose the threads. The picture is the same, "
    "bit for bit, for every number of threads.";

CommandInfo ray() {
  return {
      .name = "ray",
      .summary = "render a scene by testing every ray against every object",
      .paragraphs = {"Renders SCENE without any acceleration structure and writes the picture with "
                     "a gamma of 2. The time of rendering goes to standard output.",
                     kThreads},
      .arguments = render_arguments(),
      .examples = {{"ray nice.ppm 800 600 100", "The scene nice, 100 samples for each pixel."},
                   {"OMP_NUM_THREADS=1 ray box.png 200 200 10 rgbbox", "On one thread, as PNG."}},
      .exit_codes = kExitCodes,
  };
}

CommandInfo ray_bvh() {
  return {
      .name = "ray_bvh",
      .summary = "render a scene through a bounding volume hierarchy",
      .paragraphs = {"Renders the same picture as ray(1), bit for bit, but finds what rays hit "
                     "through a bounding volume hierarchy. The times of building the hierarchy and "
                     "of rendering go to standard output.",
                     kThreads},
      .arguments = render_arguments(),
      .examples = {{"ray_bvh irreg.ppm 1000 1000 20 irreg", "2500 mirror spheres."},
                   {"ray_bvh mine.png 800 600 100 mine.scene", "A stored scene."}},
      .exit_codes = kExitCodes,
  };
}

CommandInfo store_scene() {
  return {
      .name = "store_scene",
      .summary = "store a named scene in a file",
      .paragraphs = {"Writes SCENE to the scene file OUTFILE, from which the other programs read "
                     "it back without any loss."},
      .arguments = {{.name = "OUTFILE",
                     .kind = ValueKind::output_file,
                     .help = "The scene file to write",
                     .required = true},
                    {.name = "SCENE",
                     .kind = ValueKind::scene,
                     .help = "A named scene, or a scene file to store again",
                     .required = true}},
      .examples = {{"store_scene nice.scene nice", "Stores the scene nice."}},
      .exit_codes = kExitCodes,
  };
}

CommandInfo describe_scene() {
  return {
      .name = "describe_scene",
      .summary = "describe the objects of a stored scene",
      .paragraphs = {"Prints each object of the scene file FILE with its place and its material, "
                     "in the order in which they are stored."},
      .arguments = {{.name = "FILE",
                     .kind = ValueKind::input_file,
                     .help = "The scene file to read",
                     .required = true}},
      .options = {{.name = "full", .help = "Also print the camera, the counts and the radii"},
                  {.name = "json", .help = "Print the whole scene as JSON"}},
      .examples = {{"describe_scene nice.scene", "The objects as text."},
                   {"describe_scene --json nice.scene | jq .camera", "The camera only."}},
      .exit_codes = kExitCodes,
  };
}

}  // namespace

const std::vector<CommandInfo>& classic_programs() {
  static const std::vector<CommandInfo> programs = {ray(), ray_bvh(), store_scene(),
                                                    describe_scene()};
  return programs;
}

}  // namespace dapple
