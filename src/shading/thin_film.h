// Iridescence: a thin film on an interface.
#pragma once

#include "math/vec3.h"

namespace dapple {

// What a film of index `film_ior` and `thickness_nm` nanometres on a base of reflectance `base_f0`
// reflects of light from air at `cosine` to the normal: Belcour and Barla [BelcourB17] in the
// simplified form of KHR_materials_iridescence.
[[nodiscard]] Vec3f thin_film_reflectance(float cosine, float film_ior, float thickness_nm,
                                          const Vec3f& base_f0);

}  // namespace dapple
