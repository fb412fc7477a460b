#include "image/exr.h"

#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfTileDescription.h>
#include <ImfVersion.h>
#include <fmt/format.h>
#include <half.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "image/decoding.h"
#include "image/exr_header.h"

namespace dapple {
namespace {

constexpr float kLargestHalf = 65504.0f;
constexpr const char* kChannels[3] = {"R", "G", "B"};

using Bytes = std::vector<std::byte>;

// ---- Files in memory ----

class MemoryInput : public Imf::IStream {
 public:
  explicit MemoryInput(std::span<const std::byte> bytes) : IStream("picture"), bytes_(bytes) {}

  bool read(char out[], int size) override {
    if (size < 0 || position_ > bytes_.size() ||
        static_cast<std::uint64_t>(size) > bytes_.size() - position_) {
      throw Iex::InputExc("the file ends early");
    }
    std::memcpy(out, bytes_.data() + position_, static_cast<std::size_t>(size));
    position_ += static_cast<std::uint64_t>(size);
    return position_ < bytes_.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  std::span<const std::byte> bytes_;
  std::uint64_t position_ = 0;
};

class MemoryOutput : public Imf::OStream {
 public:
  explicit MemoryOutput(Bytes& bytes) : OStream("picture"), bytes_(bytes) {}

  void write(const char data[], int size) override {
    const auto end = position_ + static_cast<std::size_t>(size);
    if (bytes_.size() < end) bytes_.resize(end);
    std::memcpy(bytes_.data() + position_, data, static_cast<std::size_t>(size));
    position_ = end;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }

 private:
  Bytes& bytes_;
  std::size_t position_ = 0;
};

// ---- Writing ----

half half_from_float(float value) {
  if (std::isfinite(value)) value = std::clamp(value, -kLargestHalf, kLargestHalf);
  return half(value);
}

std::vector<half> halves(const float* values, std::size_t count) {
  std::vector<half> result(count);
  std::transform(values, values + count, result.begin(), half_from_float);
  return result;
}

// Colours, three values a pixel, and alpha, one a pixel or null.
struct Planes {
  Imf::PixelType type;
  const void* colours;
  const void* alpha;
};

void write_exr(const Image& image, const Planes& planes, Bytes& bytes) {
  Imf::Header header(image.width, image.height);
  header.compression() = Imf::ZIP_COMPRESSION;
  Imf::addChromaticities(header, Imf::Chromaticities());  // Rec. 709 is the default
  const std::size_t value_size = planes.type == Imf::HALF ? sizeof(half) : sizeof(float);
  const auto width = static_cast<std::size_t>(image.width);
  Imf::FrameBuffer frame;
  const auto add = [&](const char* name, const void* values, std::size_t channel,
                       std::size_t channel_count) {
    header.channels().insert(name, Imf::Channel(planes.type));
    const std::size_t stride = channel_count * value_size;
    auto* base = static_cast<char*>(const_cast<void*>(values)) + channel * value_size;
    frame.insert(name,
                 Imf::Slice::Make(planes.type, base, header.dataWindow(), stride, stride * width));
  };
  for (std::size_t c = 0; c < 3; ++c) add(kChannels[c], planes.colours, c, 3);
  if (planes.alpha != nullptr) add("A", planes.alpha, 0, 1);
  MemoryOutput stream(bytes);
  Imf::OutputFile file(stream, header, /*numThreads=*/0);
  file.setFrameBuffer(frame);
  file.writePixels(image.height);
}

// ---- Reading ----

// Blocks of lines, or tiles: the unit that is packed.
struct Chunks {
  std::uint64_t count = 0;
  std::uint64_t pixels = 0;  // of one of them
};

std::uint64_t lines_of_chunk(Imf::Compression compression) {
  switch (compression) {
    case Imf::ZIP_COMPRESSION:
    case Imf::PXR24_COMPRESSION:
      return 16;
    case Imf::PIZ_COMPRESSION:
    case Imf::B44_COMPRESSION:
    case Imf::B44A_COMPRESSION:
    case Imf::DWAA_COMPRESSION:
      return 32;
    case Imf::DWAB_COMPRESSION:
      return 256;
    default:
      return 1;
  }
}

std::uint64_t rounded_up_quotient(std::uint64_t a, std::uint64_t b) { return (a + b - 1) / b; }

Chunks chunks_of(const Imf::Header& header, std::uint64_t width, std::uint64_t height) {
  if (!header.hasTileDescription()) {
    const std::uint64_t lines = lines_of_chunk(header.compression());
    return {rounded_up_quotient(height, lines), width * lines};
  }
  const std::uint64_t x = header.tileDescription().xSize;
  const std::uint64_t y = header.tileDescription().ySize;
  return {rounded_up_quotient(width, x) * rounded_up_quotient(height, y), x * y};
}

std::uint64_t pixel_size(const Imf::ChannelList& channels) {
  std::uint64_t size = 0;
  for (auto c = channels.begin(); c != channels.end(); ++c) {
    size += c.channel().type == Imf::HALF ? 2 : 4;
  }
  return size;
}

// The three channels to read: R G B, or Y three times.
Expected<const char*> first_channel(const Imf::ChannelList& channels) {
  const char* first = nullptr;
  std::string names;
  for (auto c = channels.begin(); c != channels.end(); ++c) {
    const std::string name = c.name();
    names += " " + name;
    const bool colour = name == "R" || name == "G" || name == "B";
    if (!colour && name != "Y") continue;
    if (c.channel().xSampling != 1 || c.channel().ySampling != 1) {
      return fail(Errc::bad_data, "", "subsampled channels are not supported");
    }
    if (first == nullptr || colour) first = colour ? "R" : "Y";
  }
  if (first == nullptr) return fail(Errc::bad_data, "", "no channel R, G, B or Y among:" + names);
  return first;
}

// Never more memory than this for one chunk, and no more pixels for a byte of the file than any
// compression makes of a picture worth keeping.
constexpr std::uint64_t kMaxChunkSize = 1ull << 30;
constexpr std::uint64_t kMaxPixelsPerByte = 16384;

Expected<Image> make_image(const Imf::Header& header, std::uint64_t file_size,
                           const ImageReadOptions& options) {
  const auto& window = header.dataWindow();
  const auto width = static_cast<std::uint64_t>(std::int64_t{window.max.x} - window.min.x + 1);
  const auto height = static_cast<std::uint64_t>(std::int64_t{window.max.y} - window.min.y + 1);
  const Chunks chunks = chunks_of(header, width, height);
  const std::uint64_t entries = chunks.count * 16;  // an offset, a position and a size for each
  auto image = allocate_image(width, height, std::max(entries, width * height / kMaxPixelsPerByte),
                              file_size, options);
  if (image && chunks.pixels > kMaxChunkSize / pixel_size(header.channels())) {
    return fail(Errc::bad_data, "", "the blocks or tiles are too large");
  }
  return image;
}

Expected<Image> read_exr(std::span<const std::byte> bytes, const ImageReadOptions& options) {
  MemoryInput stream(bytes);
  int version = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    version |= std::to_integer<int>(bytes[4 + i]) << (8 * i);
  }
  if (Imf::isMultiPart(version) || Imf::isNonImage(version)) {
    return fail(Errc::bad_data, "",
                "EXR files with several parts or deep pixels are not supported");
  }
  stream.seekg(8);
  Imf::Header header;
  header.readFrom(stream, version);
  header.sanityCheck(Imf::isTiled(version));
  const auto channel = first_channel(header.channels());
  if (!channel) return tl::unexpected(channel.error());
  auto image = make_image(header, bytes.size(), options);
  if (!image) return image;

  stream.seekg(0);
  Imf::InputFile file(stream, /*numThreads=*/0);
  Imf::FrameBuffer frame;
  const auto& window = header.dataWindow();
  const bool grey = (*channel)[0] == 'Y';
  for (std::size_t c = 0; c < (grey ? 1 : 3); ++c) {
    char* base = reinterpret_cast<char*>(image->pixels.data()) + c * sizeof(float);
    frame.insert(grey ? *channel : kChannels[c],
                 Imf::Slice::Make(Imf::FLOAT, base, window, sizeof(Vec3f),
                                  sizeof(Vec3f) * static_cast<std::size_t>(image->width)));
  }
  const Imf::Channel* alpha = header.channels().findChannel("A");
  if (options.alpha && alpha != nullptr && alpha->xSampling == 1 && alpha->ySampling == 1) {
    image->alpha.resize(image->pixels.size());
    frame.insert("A", Imf::Slice::Make(Imf::FLOAT, image->alpha.data(), window, sizeof(float),
                                       sizeof(float) * static_cast<std::size_t>(image->width)));
  }
  file.setFrameBuffer(frame);
  file.readPixels(window.min.y, window.max.y);
  if (grey) {
    for (Vec3f& pixel : image->pixels) pixel = {pixel.x, pixel.x, pixel.x};
  }
  return image;
}

}  // namespace

Expected<Bytes> encode_exr(const Image& image, const ImageWriteOptions& options) try {
  Bytes bytes;
  const bool opaque = image.alpha.empty();
  if (options.exr_float) {
    const float* alpha = opaque ? nullptr : image.alpha.data();
    write_exr(image, {Imf::FLOAT, image.pixels.data(), alpha}, bytes);
  } else {
    const auto colours = halves(&image.pixels.data()->x, 3 * image.pixels.size());
    const auto alpha = halves(image.alpha.data(), image.alpha.size());
    write_exr(image, {Imf::HALF, colours.data(), opaque ? nullptr : alpha.data()}, bytes);
  }
  return bytes;
} catch (const Iex::BaseExc& error) {
  return fail(Errc::internal, "", std::string("cannot encode EXR: ") + error.what());
}

Expected<Image> decode_exr(std::span<const std::byte> bytes, const ImageReadOptions& options) try {
  if (auto checked = check_exr_header(bytes); !checked) return tl::unexpected(checked.error());
  return read_exr(bytes, options);
} catch (const Iex::BaseExc& error) {
  return fail(Errc::bad_data, "", std::string("damaged EXR: ") + error.what());
}

}  // namespace dapple
