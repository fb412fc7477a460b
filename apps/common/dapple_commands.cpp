#include "common/command_table.h"
#include "common/model_options.h"
#include "common/scaling_command.h"
#include "common/shared_options.h"
#include "render/settings.h"

namespace dapple {
namespace {

constexpr int kMaxDepth = 1000;

CommandInfo bench() {
  OptionInfo accel = accel_option("Structure to measure: none, textbook BVH or fast BVH", "fast");
  accel.repeatable = true;
  return {
      .name = "dapple bench",
      .summary = "measure building and tracing of a scene",
      .paragraphs = {"Builds the acceleration structure of SCENE and traces rays through it: "
                     "coherent ones from the camera, and incoherent ones that leave the surfaces "
                     "the first ones hit in random directions. Prints build time, surface area "
                     "cost, memory and rays per second; a figure is the median of the repeats. "
                     "A hierarchy that a scene file holds is not used: it is built anew."},
      .arguments = {scene_argument()},
      .options = {accel,
                  bvh_quality_option(),
                  bvh_compact_option(),
                  size_option("width", "Columns of camera rays", "1000"),
                  size_option("height", "Rows of camera rays", "1000"),
                  {.name = "repeat",
                   .letter = 'r',
                   .kind = ValueKind::integer,
                   .value = "N",
                   .help = "How often each measurement is made",
                   .default_value = "5",
                   .low = 1,
                   .high = 1000},
                  seed_option(),
                  threads_option(),
                  trust_option(),
                  copy_option(),
                  json_option("Print the figures as JSON"),
                  help_option()},
      .examples = {{"dapple bench irreg:1000", "The default structure on a million spheres."},
                   {"dapple bench --accel median --accel fast rgbbox",
                    "The textbook BVH and the fast one, side by side."},
                   {"OMP_PROC_BIND=true dapple bench --threads 1 --json spheres:1000000",
                    "One pinned thread, for a script to read."}},
      .exit_codes = {{75, "Interrupted by a signal; the same command line can run again."}},
  };
}

CommandInfo compare() {
  return {
      .name = "dapple compare",
      .summary = "compare two images",
      .paragraphs =
          {"Reads two images of the same size in any format that dapple writes and "
           "prints how much they differ in linear light: root mean square error, mean "
           "and maximum absolute difference. Where either has alpha, that is compared too, a "
           "picture without it counting as opaque. The exit code is 0 when the root "
           "mean square errors of colour and of alpha are at most the threshold, and 1 "
           "when one is above."},
      .arguments = {{.name = "A",
                     .kind = ValueKind::input_file,
                     .help = "The first image",
                     .required = true},
                    {.name = "B",
                     .kind = ValueKind::input_file,
                     .help = "The second image",
                     .required = true}},
      .options = {{.name = "threshold",
                   .letter = 't',
                   .kind = ValueKind::number,
                   .value = "RMSE",
                   .help = "Largest root mean square error that counts as equal",
                   .default_value = "0"},
                  transfer_option("Curve of PNG and PPM files that do not name their own"),
                  json_option("Print the differences as JSON"),
                  quiet_option(),
                  help_option()},
      .examples = {{"dapple compare a.png b.png", "Are they the same picture?"},
                   {"dapple compare --threshold 0.01 noisy.exr reference.exr",
                    "Is it within 0.01 of the reference?"}},
      .exit_codes = {{1, "The images differ by more than the threshold."}},
  };
}

CommandInfo convert() {
  return {
      .name = "dapple convert",
      .summary = "store a scene in a scene file",
      .paragraphs = {"Reads SCENE and writes it as a scene file, with its finished bounding volume "
                     "hierarchy, so that it opens in milliseconds, or without."},
      .arguments = {scene_argument()},
      .options = {output_option("The scene file to write"),
                  {.name = "bvh", .help = "Store the hierarchy too; this is the default"},
                  {.name = "no-bvh", .help = "Store the scene alone: a smaller file"},
                  bvh_quality_option(),
                  threads_option(),
                  trust_option(),
                  copy_option(),
                  quiet_option(),
                  help_option()},
      .examples = {{"dapple convert spheres:10000000 -o cloud.scene",
                    "Ten million spheres, ready to be rendered."},
                   {"dapple convert --no-bvh nice -o nice.scene", "What store_scene writes."}},
  };
}

CommandInfo info() {
  return {
      .name = "dapple info",
      .summary = "describe a scene",
      .paragraphs = {"Prints the camera, the counts and every object of SCENE, as text or as "
                     "JSON."},
      .arguments = {scene_argument()},
      .options = {json_option("Print the whole scene as JSON"), trust_option(), copy_option(),
                  help_option()},
      .examples = {{"dapple info nice", "A named scene as text."},
                   {"dapple info --json my.scene | jq .counts", "How much is in a file?"}},
  };
}

std::vector<OptionInfo> image_options() {
  return {{.name = "bits",
           .kind = ValueKind::choice,
           .help = "Bits for each channel of a PNG file",
           .default_value = "8",
           .choices = {"8", "16"}},
          {.name = "exr-type",
           .kind = ValueKind::choice,
           .help = "Channel type of an EXR file",
           .default_value = "half",
           .choices = {"half", "float"}},
          transfer_option("Curve of PNG and PPM files; gamma2 is that of ray and ray_bvh")};
}

CommandInfo render() {
  CommandInfo command{
      .name = "dapple render",
      .summary = "render a scene to an image",
      .paragraphs = {"Renders SCENE and writes the image when it is complete. The ending of FILE "
                     "chooses the format: .png, .exr, .pfm, .hdr, or PPM for .ppm and others, "
                     "except for those of formats that are not written, such as .jpg. The same "
                     "options give the same image, bit for bit, on any number of threads.",
                     "A model without a camera is shown whole, from a little to the right and "
                     "above. One without light stands in a neutral studio.",
                     "A file that describes a film, as those of pbrt do, is rendered at its size, "
                     "and one whose camera says so in the shape of picture that it is meant for. "
                     "Of --width and --height, the one that is missing then follows the other.",
                     "A sample counts with at most 16384 in each channel; a warning says how many "
                     "were brighter.",
                     "On a terminal, a rendering of more than a second shows its progress. SIGINT, "
                     "SIGTERM and SIGHUP stop it; nothing is written then."},
      .arguments = {scene_argument()},
      .options = {output_option("The image to write"),
                  size_option("width", "Width in pixels", "800"),
                  size_option("height", "Height in pixels", "600"),
                  {.name = "spp",
                   .letter = 's',
                   .kind = ValueKind::integer,
                   .value = "N",
                   .help =
                       "Samples for each pixel; 0 takes 16 for classic scenes and 64 for models",
                   .default_value = "0",
                   .low = 0,
                   .high = kMaxSamplesPerPixel},
                  {.name = "depth",
                   .kind = ValueKind::integer,
                   .value = "N",
                   .help =
                       "Scatterings after which a path is cut; 0 takes 5 for classic scenes and "
                       "12 for models",
                   .default_value = "0",
                   .low = 0,
                   .high = kMaxDepth},
                  seed_option(),
                  threads_option(),
                  accel_option("How hits are found: brute force, textbook BVH or fast BVH; the "
                               "image is the same",
                               "fast"),
                  bvh_quality_option(),
                  bvh_compact_option()},
      .examples = {{"dapple render nice -o nice.png", "A named scene with the default settings."},
                   {"dapple render model.glb -o model.png",
                    "A model of an editor, in a studio if it brings no light."},
                   {"dapple render model.glb -o model.png --environment sky.hdr --orbit 45,60,3",
                    "In other surroundings, from elsewhere."},
                   {"dapple render my.scene -o my.exr --width 1920 --height 1080 --spp 256",
                    "A scene file, to an image with high dynamic range."},
                   {"dapple render irreg:1000 -o big.png --threads 4 --json",
                    "A generated scene on four threads, with figures for a script."}},
      .exit_codes = {{75, "Interrupted by a signal; the same command line can run again."}},
  };
  for (const auto& list : {view_options(), import_options(), picture_options(), image_options()}) {
    command.options.insert(command.options.end(), list.begin(), list.end());
  }
  for (const OptionInfo& option :
       {trust_option(), copy_option(),
        json_option("Print settings and times as JSON on standard output"), quiet_option(),
        help_option()}) {
    command.options.push_back(option);
  }
  return command;
}

CommandInfo scenes() {
  return {
      .name = "dapple scenes",
      .summary = "list the named scenes",
      .paragraphs = {"Lists the scenes that need no file. Where a scene has a size, NAME:N chooses "
                     "it."},
      .options = {json_option("Print the list as JSON"), help_option()},
      .examples = {{"dapple scenes", "Names and what they show."}},
  };
}

// The numbers of Errc, which are those of sysexits.h.
const std::vector<ExitCode> kExitCodes = {
    {0, "The output is written and safely in place."},
    {64, "The command line is wrong."},
    {65, "An input file is damaged, of a foreign format or of a future version."},
    {66, "An input file does not exist or cannot be read."},
    {70, "An internal error."},
    {71, "Out of memory."},
    {73, "The output cannot be created."},
    {74, "Reading or writing failed half-way."},
};

// `command` can open models too.
CommandInfo with_import_options(CommandInfo command) {
  const auto options = import_options();
  command.options.insert(command.options.begin() + 1, options.begin(), options.end());
  return command;
}

std::vector<ExitCode> with_common_codes(const std::vector<ExitCode>& own) {
  std::vector<ExitCode> all = kExitCodes;
  all.insert(own.empty() || own[0].code > 1 ? all.end() : all.begin() + 1, own.begin(), own.end());
  return all;
}

CommandInfo make_dapple() {
  CommandInfo program{
      .name = "dapple",
      .summary = "a fast, small, headless ray tracer",
      .paragraphs = {"Renders scenes on the processors of this machine, without a display. `dapple "
                     "COMMAND --help` explains a command."},
      .arguments = {{.name = "COMMAND", .help = "What to do", .required = true}},
      .options = {{.name = "version",
                   .letter = 'V',
                   .help = "Show version, instruction sets and libraries, and exit"},
                  help_option()},
      .examples = {{"dapple render nice -o nice.png", "Render a picture."},
                   {"dapple scenes", "Which scenes are there?"}},
      .exit_codes = {{75, "Interrupted by a signal; the same command line can run again."}},
      .commands = {with_import_options(bench()), compare(), with_import_options(convert()),
                   with_import_options(info()), render(), with_import_options(scaling_command()),
                   scenes()},
  };
  program.exit_codes = with_common_codes(program.exit_codes);
  for (CommandInfo& command : program.commands) {
    command.exit_codes = with_common_codes(command.exit_codes);
  }
  return program;
}

}  // namespace

const CommandInfo& dapple_program() {
  static const CommandInfo program = make_dapple();
  return program;
}

}  // namespace dapple
