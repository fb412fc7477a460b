#include "import/ply/model.h"

#include "import/ply/faces.h"
#include "import/ply/vertices.h"

namespace dapple::ply {
namespace {

Status skip(ValueReader& values, const Element& element, Model& model) {
  model.ignored.push_back("element " + element.name);
  for (std::uint64_t row = 0; row < element.count; ++row) {
    for (const Property& property : element.properties) values.skip(property);
    if (values.bad()) return values.error();
  }
  return {};
}

Status read_element(ValueReader& values, const Element& element, Model& model) {
  if (element.name == "vertex") return read_vertices(values, element, model);
  if (element.name == "face") return read_faces(values, element, model);
  if (element.name == "tristrips") return read_strips(values, element, model);
  return skip(values, element, model);
}

}  // namespace

Expected<Model> read(std::span<const std::byte> bytes, std::string_view name, bool keep_going) {
  auto header = read_header(bytes, name);
  if (!header) return tl::unexpected(header.error());
  Model model;
  model.keep_going = keep_going;
  model.texture_file = std::move(header->texture_file);
  ValueReader values(bytes, *header, name);
  bool has_vertices = false;
  for (const Element& element : header->elements) {
    if (element.name == "vertex") {
      if (has_vertices) return values.error("a second element 'vertex'");
      has_vertices = true;
    }
    if (auto status = read_element(values, element, model); !status) {
      return tl::unexpected(status.error());
    }
  }
  return model;
}

}  // namespace dapple::ply
