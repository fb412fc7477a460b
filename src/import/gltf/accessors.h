// Accessors, read into plain arrays whatever their type, layout and sparseness.
#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <set>
#include <vector>

#include "import/gltf/accessor_layout.h"
#include "import/gltf/buffers.h"

namespace dapple::gltf {

// Elements of `components` numbers each, one after the other. Matrices are column by column.
template <class T>
struct Elements {
  std::size_t components = 0;
  std::vector<T> values;

  std::size_t count() const { return components == 0 ? 0 : values.size() / components; }
  const T* operator[](std::size_t i) const { return values.data() + i * components; }
};
using FloatElements = Elements<float>;
using IntegerElements = Elements<std::uint32_t>;

// False where nothing but zeros is meant, or what an extension puts in their place.
bool is_stored(const JsonValue& accessor);
class Accessors {
 public:
  explicit Accessors(Buffers& buffers) : buffers_(buffers) {}

  // Normalised integers become numbers in [0, 1] or [-1, 1], others their own value. Numbers that
  // are not finite are an error, or a warning with keep_going.
  [[nodiscard]] Expected<std::shared_ptr<const FloatElements>> floats(std::uint32_t index);
  // Only of unsigned integers.
  [[nodiscard]] Expected<IntegerElements> integers(std::uint32_t index);
  bool was_read(std::uint32_t index) const { return read_.contains(index); }
  Buffers& buffers() { return buffers_; }
  const Context& context() const { return buffers_.context(); }

 private:
  template <class T>
  [[nodiscard]] Expected<Elements<T>> read(std::uint32_t index);

  Buffers& buffers_;
  std::set<std::uint32_t> read_;
  // Primitives that share vertices follow each other: the last few are kept.
  std::list<std::pair<std::uint32_t, std::shared_ptr<const FloatElements>>> recent_;
};

}  // namespace dapple::gltf
