#include "import/registry.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <new>

#include "import/assimp/assimp.h"
#include "import/gltf/gltf.h"
#include "import/obj/obj.h"
#include "import/pbrt/pbrt.h"
#include "import/ply/ply.h"
#include "import/stl/stl.h"
#include "scene/validate.h"
#include "util/mapped_file.h"

namespace dapple {
namespace {

using Import = Expected<ImportResult> (*)(const std::string&, const ImportOptions&);

struct ImportFormat {
  std::array<std::string_view, 4> endings;  // lower case; empty ones match nothing
  bool (*matches)(std::string_view head);   // by the first bytes of a file, or nullptr
  Import import;
};

bool is_glb(std::string_view head) { return head.starts_with("glTF"); }
bool is_ply(std::string_view head) {
  return head.starts_with("ply\n") || head.starts_with("ply\r");
}

// A new format is one line here.
constexpr ImportFormat kFormats[] = {
    {{".gltf", ".glb"}, is_glb, import_gltf},
    {{".obj"}, nullptr, import_obj},
    {{".pbrt"}, nullptr, import_pbrt},
    {{".ply"}, is_ply, import_ply},
    {{".stl"}, nullptr, import_stl},
    {{".fbx", ".dae", ".3ds", ".3mf"}, nullptr, import_with_assimp},
    {{".blend", ".lwo", ".off", ".x3d"}, nullptr, import_with_assimp},
};

constexpr std::size_t kHeadBytes = 512;

bool ends_in(std::string_view name, std::string_view ending) {
  if (ending.empty() || name.size() < ending.size()) return false;
  name.remove_prefix(name.size() - ending.size());
  return std::equal(name.begin(), name.end(), ending.begin(), [](char a, char b) {
    return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
  });
}

const ImportFormat* format_of_name(std::string_view name) {
  for (const ImportFormat& format : kFormats) {
    for (const std::string_view ending : format.endings) {
      if (ends_in(name, ending)) return &format;
    }
  }
  return nullptr;
}

const ImportFormat* format_of_content(std::string_view head) {
  for (const ImportFormat& format : kFormats) {
    if (format.matches != nullptr && format.matches(head)) return &format;
  }
  return nullptr;
}

Expected<const ImportFormat*> format_of(const std::string& path) {
  if (const ImportFormat* format = format_of_name(path)) return format;
  const auto file = MappedFile::open(path);
  if (!file) return tl::unexpected(file.error());
  const auto head = file->bytes().first(std::min(file->bytes().size(), kHeadBytes));
  const std::string_view text(reinterpret_cast<const char*>(head.data()), head.size());
  if (const ImportFormat* format = format_of_content(text)) return format;
  return fail(Errc::bad_data, path,
              "not in a format that can be imported (" + importable_endings() + ")");
}

}  // namespace

Expected<ImportResult> import_scene(const std::string& path, const ImportOptions& options) try {
  const auto format = format_of(path);
  if (!format) return tl::unexpected(format.error());
  auto result = (*format)->import(path, options);
  if (!result) return result;
  // Whatever an importer overlooks ends here, not in a picture.
  if (auto valid = validate(result->scene); !valid) {
    return fail(valid.error().code, path + ", " + valid.error().place, valid.error().message);
  }
  return result;
} catch (const std::bad_alloc&) {
  return fail(Errc::memory, path, "out of memory during import");
}

bool is_importable(std::string_view path) { return format_of_name(path) != nullptr; }

std::string importable_endings() {
  std::string text;
  for (const ImportFormat& format : kFormats) {
    for (const std::string_view ending : format.endings) {
      if (!ending.empty()) text += fmt::format("{}{}", text.empty() ? "" : ", ", ending);
    }
  }
  return text;
}

}  // namespace dapple
