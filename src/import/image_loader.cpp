#include "import/image_loader.h"

#include <optional>

#include "image/raw_image.h"
#include "parallel/parallel.h"

namespace dapple {
namespace {

// Decoded at once: a few, so that they do not lie twice in memory all together.
constexpr std::size_t kBatch = 8;

Error at_place(Error error, const std::string& place) {
  error.place = error.place.empty() ? place : place + ", " + error.place;
  return error;
}

}  // namespace

Expected<std::vector<ImageId>> load_images(const std::vector<EncodedImage>& images, bool keep_going,
                                           SceneBuilder& builder, ImportLog& log) {
  std::vector<ImageId> ids;
  for (std::size_t begin = 0; begin < images.size(); begin += kBatch) {
    const std::size_t count = std::min(kBatch, images.size() - begin);
    std::vector<std::optional<Expected<RawImage>>> decoded(count);
    parallel_for_dynamic(count, [&](std::size_t i) {
      decoded[i] = decode_raw_image(images[begin + i].bytes, kMaxImagePixels);
    });
    for (std::size_t i = 0; i < count; ++i) {
      auto id =
          decoded[i]->and_then([&](const RawImage& image) { return builder.add_image(image); });
      if (!id) {
        const Error error = at_place(id.error(), images[begin + i].place);
        if (!keep_going) return tl::unexpected(error);
        log.warn(to_string(error));
      }
      ids.push_back(id.value_or(kNoImage));
      decoded[i].reset();
    }
  }
  return ids;
}

}  // namespace dapple
