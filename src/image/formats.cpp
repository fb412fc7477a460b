#include "image/formats.h"

#include "image/ppm.h"
#include "util/atomic_file.h"

namespace dapple {

Status write_image(const std::string& path, const Image& image, const ImageWriteOptions& options) {
  return write_file_atomically(path, encode_ppm(image, options.transfer));
}

}  // namespace dapple
