// The one pass that proves a scene file before anything else reads it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "scene/picture_shape.h"
#include "scene/scene_view.h"
#include "util/error.h"

namespace dapple {

enum class VerifyScope {
  everything,
  // What rendering through the stored BVH reads: all but the numbers of the shapes, which the view
  // then lets be counted but which nobody may read. The BVH is proven whole and safe to traverse,
  // with ids of the right kinds; not, since that takes the shapes, that it is the BVH of them. In
  // a file without a BVH this is everything.
  bvh_only,
};

struct VerifyOptions {
  bool hashes = true;  // without, structure and ranges are still checked
  VerifyScope scope = VerifyScope::everything;
  bool copy = false;  // when a file is opened: its bytes are copied first, so that nobody else can
                      // change them while they are read
};

// A scene that lies in the bytes of a file, except for its materials.
struct VerifiedScene {
  std::vector<Material> materials;  // what the view's span points at
  SceneView view;
  PictureShape pictures;
  bool shapes_verified = false;

  VerifiedScene() = default;
  VerifiedScene(VerifiedScene&&) = default;
  VerifiedScene& operator=(VerifiedScene&&) = default;
};

// Whatever the bytes are, this ends, in time and memory proportional to their number, and reads
// nothing outside them. They must begin at a multiple of 64 in memory, as a mapping does, and stay
// as they are for as long as the view is used. An error's message says at which byte; its place
// is left empty. In parallel; the same error whatever the number of threads.
[[nodiscard]] Expected<VerifiedScene> verify(std::span<const std::byte> file,
                                             const VerifyOptions& options = {});

}  // namespace dapple
