// From the radiance of a scene to what a display can show.
#pragma once

#include <string_view>

#include "image/image.h"
#include "util/error.h"

namespace dapple {

enum class ToneMap {
  neutral,  // Khronos PBR Neutral: base colours under plain light stay as they are, highlights fade
  none,     // cut at 1
  agx,      // Sobotka's AgX, base look: strong highlights lose their colour as in film
  aces,     // the ACES reference and output transforms, fitted by Hill
};

// Names as on the command line; an unknown one is an error that lists them.
[[nodiscard]] Expected<ToneMap> parse_tone_map(std::string_view name);

// One colour, linear Rec. 709 to linear Rec. 709 in [0, 1]. Negative and NaN count as 0.
[[nodiscard]] Vec3f tone_map(ToneMap curve, const Vec3f& colour);

// The exposure, in stops, that brings the mean brightness of what is not black to middle grey: for
// pictures whose light is of any strength. 0 for a black picture.
[[nodiscard]] float automatic_exposure(const Image& image);

// The whole picture, after multiplying it by 2^exposure. Alpha stays as it is.
void apply_tone_map(Image& image, ToneMap curve, float exposure);

}  // namespace dapple
