// Scene files in memory, whole or deliberately broken.
#pragma once

#include <cstddef>
#include <cstring>
#include <functional>
#include <memory>
#include <new>
#include <span>
#include <vector>

#include "scene/picture_shape.h"
#include "scene/scene_view.h"
#include "scene_file/format.h"

namespace dapple::test {

// At a multiple of 64 and not a byte longer than asked for, so that a sanitizer sees a read past
// the end.
class AlignedBytes {
 public:
  explicit AlignedBytes(std::span<const std::byte> bytes)
      : size_(bytes.size()),
        data_(static_cast<std::byte*>(::operator new (size_, std::align_val_t{64}))) {
    if (size_ > 0) std::memcpy(data_.get(), bytes.data(), size_);
  }
  std::span<const std::byte> bytes() const { return {data_.get(), size_}; }
  std::byte& operator[](std::size_t i) { return data_.get()[i]; }

 private:
  struct Free {
    void operator()(std::byte* p) const { ::operator delete (p, std::align_val_t{64}); }
  };
  std::size_t size_;
  std::unique_ptr<std::byte, Free> data_;
};

// The file that the writer makes of a scene.
[[nodiscard]] std::vector<std::byte> scene_bytes(const SceneView& scene,
                                                 const PictureShape& pictures = {});

// The same with a BVH inside.
[[nodiscard]] std::vector<std::byte> scene_bytes_with_bvh(const Scene& scene,
                                                          std::size_t max_children = 4,
                                                          std::size_t max_leaf = 3);

// A file taken apart so that tests can change anything; bytes() puts it together with all
// checksums right, so that it is not they by which a reader finds the damage.
struct FileParts {
  struct Section {
    SectionEntry entry;  // offset and hash are computed again unless kept
    std::vector<std::byte> bytes;
  };
  FileHeader header;
  std::vector<Section> sections;

  explicit FileParts(std::span<const std::byte> file);

  Section& section(SectionType type);
  bool has(SectionType type) const;
  // Element i of a section as a T that can be changed.
  template <class T>
  T& element(SectionType type, std::size_t i = 0) {
    return reinterpret_cast<T*>(section(type).bytes.data())[i];
  }

  // `change` sees the finished table before it is hashed.
  [[nodiscard]] std::vector<std::byte> bytes(
      const std::function<void(std::span<SectionEntry>)>& change = {}) const;
};

// What views say, compared number for number, bit for bit.
[[nodiscard]] bool same_scene(const SceneView& a, const SceneView& b);

}  // namespace dapple::test
