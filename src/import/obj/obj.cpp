#include "import/obj/obj.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "image/transfer.h"
#include "import/default_material.h"
#include "import/model_import.h"
#include "import/obj/layered.h"
#include "import/obj/mesh.h"
#include "import/obj/smoothing.h"
#include "import/text.h"
#include "scene/validate.h"

namespace dapple {
namespace {

using obj::Element;
using obj::ElementKind;
using obj::Geometry;

class ObjImport {
 public:
  ObjImport(ModelImport& import, Geometry geometry)
      : import_(import), geometry_(std::move(geometry)) {}

  Status run() {
    warn();
    for (const obj::Libraries& libraries : geometry_.libraries) {
      if (auto read = read_libraries(libraries); !read) return read;
    }
    if (auto made = make_materials(); !made) return made;
    obj::add_smooth_normals(geometry_);
    MeshData mesh = obj::build_mesh(geometry_);
    for (MaterialId& material : mesh.materials) material = material_of(material);
    for (Vec4f& colour : mesh.vertices.colours) colour = linear(colour);
    if (auto added = import_.builder().add_mesh(mesh); !added) return added;
    return add_points_and_lines();
  }

 private:
  void warn() {
    for (const std::string& warning : geometry_.warnings) import_.log().warn(warning);
    if (geometry_.small_faces > 0) {
      import_.log().warn(fmt::format("{}: {} faces with too few corners are left out",
                                     import_.path(), geometry_.small_faces));
    }
    if (geometry_.broken_elements > 0) {
      import_.log().warn(
          fmt::format("{}: {} faces, lines or points with indices of nothing are left out ({})",
                      import_.path(), geometry_.broken_elements, geometry_.broken_reason));
    }
  }

  // "mtllib" may name one file with blanks in its name, or several.
  Status read_libraries(const obj::Libraries& libraries) {
    const std::string place = line_place(import_.path(), libraries.line);
    if (import_.sandbox().open(libraries.names)) return read_library(libraries.names, place);
    for (const std::string& name : split(libraries.names)) {
      if (auto read = read_library(name, place); !read) return read;
    }
    return {};
  }

  // At blanks, but not at those behind a backslash.
  static std::vector<std::string> split(std::string_view names) {
    std::vector<std::string> words(1);
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i] == '\\' && i + 1 < names.size() && is_blank(names[i + 1])) {
        words.back() += names[++i];
      } else if (!is_blank(names[i])) {
        words.back() += names[i] == '\\' ? '/' : names[i];
      } else if (!words.back().empty()) {
        words.emplace_back();
      }
    }
    if (words.back().empty()) words.pop_back();
    return words;
  }

  // The shapes are there without their materials: a library that is missing is only a warning.
  Status read_library(const std::string& name, const std::string& place) {
    if (!read_.insert(name).second) return {};
    const auto file = import_.open_companion(name);
    if (!file) {
      import_.log().warn(place + ": " + to_string(file.error()));
      return {};
    }
    const std::string path = import_.sandbox().path_of(name);
    obj::MtlLibrary library;
    if (auto read = obj::read_mtl(as_text(file->bytes()), path, library); !read) return read;
    for (std::string& warning : library.warnings) import_.log().warn(std::move(warning));
    for (auto& [material_name, material] : library.materials) {
      library_[material_name] = {std::move(material), path};
    }
    return {};
  }

  Status make_materials() {
    default_ = import_.builder().add_material(default_material());
    for (const std::string& name : geometry_.materials) {
      const auto found = library_.find(name);
      if (found == library_.end()) {
        import_.log().warn(
            fmt::format("{}: the material '{:.80}' is not defined", import_.path(), name));
        materials_.push_back(default_);
        continue;
      }
      const auto layered = to_layered(found->second.material, found->second.file, import_);
      if (!layered) return tl::unexpected(layered.error());
      materials_.push_back(import_.builder().add_material(*layered));
    }
    return {};
  }

  // From an index of Geometry::materials.
  MaterialId material_of(MaterialId index) const {
    return index_of(index) < materials_.size() ? materials_[index_of(index)] : default_;
  }
  static Vec4f linear(const Vec4f& display) {
    const auto decode = [](float value) {
      return to_float(decode_display(std::clamp(double(value), 0.0, 1.0), Transfer::srgb));
    };
    return {decode(display.x), decode(display.y), decode(display.z), display.w};
  }

  Status add_points_and_lines() {
    std::size_t left_out = 0;
    for (std::size_t e = 0; e < geometry_.elements.size(); ++e) {
      const Element& element = geometry_.elements[e];
      if (element.kind == ElementKind::face) continue;
      const MaterialId material = material_of(static_cast<MaterialId>(element.material));
      const std::size_t count = geometry_.end_of(e) - element.first_corner;
      if (auto taken = import_.builder().budget().take(count, sizeof(Cylinder), "lines"); !taken) {
        return taken;
      }
      for (std::size_t c = element.first_corner; c < geometry_.end_of(e); ++c) {
        if (element.kind == ElementKind::line && c == element.first_corner) continue;
        left_out += !add_mark(element.kind, c, material);
      }
    }
    if (left_out > 0) {
      import_.log().warn(fmt::format(
          "{}: {} points and lines with coordinates that are not finite or without length are left "
          "out",
          import_.path(), left_out));
    }
    return {};
  }

  // A point, or the line from the corner before.
  bool add_mark(ElementKind kind, std::size_t corner, MaterialId material) {
    const Vec3d at(geometry_.positions[geometry_.corners[corner].position]);
    if (kind == ElementKind::points) {
      if (!is_valid(Sphere{at, 1})) return false;
      import_.builder().add_point(at, material);
      return true;
    }
    const Vec3d from(geometry_.positions[geometry_.corners[corner - 1].position]);
    if (!is_valid(Sphere{at, 1}) || !is_valid(Sphere{from, 1}) || at == from) return false;
    import_.builder().add_line(from, at, material);
    return true;
  }

  struct LibraryEntry {
    obj::MtlMaterial material;
    std::string file;
  };

  ModelImport& import_;
  Geometry geometry_;
  std::set<std::string> read_;  // libraries
  std::map<std::string, LibraryEntry> library_;
  std::vector<MaterialId> materials_;
  MaterialId default_{};
};

}  // namespace

Expected<ImportResult> import_obj(const std::string& path, const ImportOptions& options) {
  auto import = ModelImport::open(path, options);
  if (!import) return tl::unexpected(import.error());
  auto geometry = obj::read_geometry(as_text(import->bytes()), path, options.keep_going);
  if (!geometry) return tl::unexpected(geometry.error());
  if (auto done = ObjImport(*import, std::move(*geometry)).run(); !done) {
    const Error& error = done.error();
    return fail(error.code, error.place.empty() ? path : error.place, error.message);
  }
  return import->finish();
}

}  // namespace dapple
