#include "import/gltf/document.h"

#include "import/gltf/container.h"
#include "import/limits.h"

namespace dapple::gltf {
namespace {

tl::unexpected<Error> in_file(Error error, const std::string& path) {
  error.place = error.place.empty() ? path : path + ", " + error.place;
  return tl::unexpected(std::move(error));
}

}  // namespace

Expected<Document> Document::open(const std::string& path) {
  auto file = MappedFile::open(path);
  if (!file) return tl::unexpected(file.error());
  const auto container = split_container(file->bytes());
  if (!container) return in_file(container.error(), path);
  if (container->text.size() > kMaxJsonBytes)
    return fail(Errc::bad_data, path, "its JSON is too long");
  auto root = parse_json(container->text);
  if (!root) return in_file(root.error(), path);
  auto folder = Sandbox::around(path);
  if (!folder) return tl::unexpected(folder.error());
  Document document(path, std::move(*file), std::move(*folder));
  document.root_ = std::move(*root);
  document.bin_ = container->bin;
  document.has_mark_ = container->text.starts_with("\xef\xbb\xbf");
  return document;
}

std::string Document::place(const std::string& pointer) const {
  return pointer.empty() ? path_ : path_ + ", " + pointer;
}

tl::unexpected<Error> Document::error(const std::string& pointer, std::string message) const {
  return fail(Errc::bad_data, place(pointer), std::move(message));
}

}  // namespace dapple::gltf
