#include "common/scaling_command.h"

#include "common/shared_options.h"
#include "render/settings.h"

namespace dapple {
namespace {

constexpr int kMaxThreads = 4096;
constexpr int kMaxObjects = 20'000'000;

OptionInfo count_option(std::string_view name, std::string_view help, std::string default_value,
                        std::int64_t high) {
  return {.name = name,
          .kind = ValueKind::integer,
          .value = "N",
          .help = help,
          .default_value = std::move(default_value),
          .low = 1,
          .high = high};
}

std::vector<OptionInfo> work_options() {
  return {{.name = "work",
           .letter = 'w',
           .kind = ValueKind::choice,
           .help = "What to measure; everything unless given",
           .choices = {"ray", "ray_bvh", "build"},
           .repeatable = true},
          size_option("width", "Width of the pictures in pixels", "400"),
          size_option("height", "Height of the pictures in pixels", "400"),
          count_option("spp", "Samples for each pixel of ray on one thread", "4",
                       kMaxSamplesPerPixel / kMaxThreads),
          count_option("bvh-spp", "Samples for each pixel of ray_bvh on one thread", "16",
                       kMaxSamplesPerPixel / kMaxThreads),
          count_option("objects", "Spheres to build a hierarchy over on one thread", "500000",
                       kMaxObjects)};
}

}  // namespace

CommandInfo scaling_command() {
  OptionInfo scene = scene_argument();
  scene.required = false;
  scene.default_value = "rgbbox";
  CommandInfo command{
      .name = "dapple scaling",
      .summary = "measure strong and weak scaling over threads",
      .paragraphs =
          {"Measures how rendering by brute force (ray), rendering through the fast hierarchy "
           "(ray_bvh) and building that hierarchy (build) gain from threads. Strong scaling gives "
           "the same work to more threads; weak scaling gives them as much more work as threads: "
           "samples per pixel for the renderings, which leaves every path as likely as before, "
           "and objects for building.",
           "Every configuration runs once to warm up and then once a round, in turn, with threads "
           "tied to cores. Times and ratios within a round are medians; intervals hold 95 % of "
           "2000 bootstrap draws of "
           "rounds. A run during which others had more than a twentieth of the machine is repeated "
           "while there is patience. Amdahl's law is fitted to strong and Gustafson's to weak "
           "scaling, over the "
           "points that have a core for each thread.",
           "The folder receives points.csv (times, speed-ups, efficiencies, load imbalance), "
           "fits.csv (serial fractions), threads.csv (busy time of each thread of each run), "
           "machine.csv (the machine, what else ran on it, and warnings), scaling.json (all of "
           "these) and plots as SVG. A machine that is too noisy or has fewer cores than threads "
           "is named in a warning and in these files."},
      .arguments = {scene},
      .options = {{.name = "output",
                   .letter = 'o',
                   .kind = ValueKind::output_file,
                   .value = "FOLDER",
                   .help = "Folder for tables and plots, made if there is none",
                   .required = true},
                  {.name = "threads",
                   .letter = 'j',
                   .kind = ValueKind::integers,
                   .value = "N,N...",
                   .help = "Numbers of threads, to which 1 is added; powers of two up to all "
                           "processors unless given",
                   .low = 1,
                   .high = kMaxThreads},
                  {.name = "repeat",
                   .letter = 'r',
                   .kind = ValueKind::integer,
                   .value = "N",
                   .help = "How often each measurement is made",
                   .default_value = "7",
                   .low = 1,
                   .high = 1000},
                  {.name = "patience",
                   .kind = ValueKind::integer,
                   .value = "SECONDS",
                   .help = "Time in all to wait until other programs are quiet, and to repeat "
                           "runs that they disturbed",
                   .default_value = "30",
                   .low = 0,
                   .high = 86400},
                  {.name = "no-pin", .help = "Leave threads to the system's scheduler"}},
      .examples = {{"dapple scaling -o scaling", "Everything, on as many threads as processors."},
                   {"dapple scaling --threads 1,2,4,8 --repeat 15 -o box rgbbox",
                    "More threads and more repetitions."},
                   {"dapple scaling --work build --objects 2000000 -o build",
                    "Building alone, with larger scenes."}},
      .exit_codes = {{75, "Interrupted by a signal; the same command line can run again."}},
  };
  for (const OptionInfo& option : work_options()) command.options.push_back(option);
  for (const OptionInfo& option :
       {trust_option(), copy_option(), json_option("Print everything as JSON on standard output"),
        quiet_option(), help_option()}) {
    command.options.push_back(option);
  }
  return command;
}

}  // namespace dapple
