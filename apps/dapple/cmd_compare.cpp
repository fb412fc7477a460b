#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "common/standard_output.h"
#include "dapple/commands.h"
#include "image/compare.h"
#include "image/formats.h"

namespace dapple {
namespace {

constexpr int kDifferent = 1;

std::string as_text(const ImageDifference& d) {
  std::string text = fmt::format(
      "rmse     {:g}\n"
      "mean     {:g}\n"
      "maximum  {:g} at column {}, row {}\n"
      "psnr     {:g} dB\n",
      d.rmse, d.mean_absolute, d.maximum, d.max_x, d.max_y, d.psnr());
  if (d.has_alpha) {
    text += fmt::format("alpha    {:g} rmse, {:g} maximum\n", d.alpha_rmse, d.alpha_maximum);
  }
  return text;
}

std::string as_json(const ImageDifference& d, bool within) {
  // JSON has no infinity: infinite numbers become null.
  const nlohmann::ordered_json json = {
      {"within_threshold", within},
      {"rmse", d.rmse},
      {"mean_absolute", d.mean_absolute},
      {"relative_mse", d.relative_mse},
      {"maximum", d.maximum},
      {"maximum_at", {d.max_x, d.max_y}},
      {"psnr", d.psnr()},
      {"alpha_rmse", d.alpha_rmse},
      {"alpha_maximum", d.alpha_maximum},
      {"differing_values", d.differing},
      {"non_finite_values", d.non_finite},
  };
  return json.dump(2) + "\n";
}

}  // namespace

Expected<int> run_compare(const Arguments& arguments) {
  ImageReadOptions options;
  options.untagged = arguments.text("transfer") == "gamma2" ? Transfer::gamma2 : Transfer::srgb;
  options.alpha = true;
  const auto a = read_image(arguments.text("A"), options);
  if (!a) return tl::unexpected(a.error());
  const auto b = read_image(arguments.text("B"), options);
  if (!b) return tl::unexpected(b.error());
  const auto difference = compare_images(*a, *b);
  if (!difference) return tl::unexpected(difference.error());

  const bool within =
      std::max(difference->rmse, difference->alpha_rmse) <= arguments.number("threshold");
  const int exit_code = within ? 0 : kDifferent;
  if (arguments.given("json")) {
    return print_output(as_json(*difference, within)).map([&] { return exit_code; });
  }
  if (arguments.given("quiet")) return exit_code;
  return print_output(as_text(*difference)).map([&] { return exit_code; });
}

}  // namespace dapple
