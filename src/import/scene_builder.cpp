#include "import/scene_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

#include "import/scene_extent.h"
#include "import/vertex_arrays.h"
#include "scene/validate.h"
#include "util/hash.h"

namespace dapple {
namespace {

constexpr std::uint64_t kImageAlignment = 16;

template <class T>
std::uint64_t hash_of(const T& value) {
  return hash_bytes(std::as_bytes(std::span(&value, 1)));
}

bool is_coordinate(float value) { return std::fabs(value) <= static_cast<float>(kMaxCoordinate); }

bool is_point(const Vec3f& p) {
  return is_coordinate(p.x) && is_coordinate(p.y) && is_coordinate(p.z);
}

bool has_area(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return !(cross(b - a, c - a) == Vec3d());
}

std::array<char, 64> camera_name(std::string_view name) {
  std::array<char, 64> text{};
  std::size_t length = std::min(name.size(), text.size() - 1);
  // Not in the middle of a UTF-8 sequence.
  while (length > 0 && length < name.size() && (name[length] & 0xc0) == 0x80) --length;
  std::memcpy(text.data(), name.data(), length);
  return text;
}

// Angles of many turns have few digits left, and fast functions none.
float within_a_turn(float radians) {
  constexpr double kTurn = 6.283185307179586;
  if (!(std::fabs(radians) > kTurn) || !std::isfinite(radians)) return radians;
  return static_cast<float>(radians - kTurn * std::floor(radians / kTurn));
}

TexelFormat texel_format(RawFormat format) {
  switch (format) {
    case RawFormat::rgba8:
      return TexelFormat::rgba8;
    case RawFormat::rgba16:
      return TexelFormat::rgba16;
    default:
      return TexelFormat::rgb32f;
  }
}

RawImage magenta_picture() { return {1, 1, RawFormat::rgba8, {255, 0, 255, 255}}; }

}  // namespace

MaterialId SceneBuilder::add_material(const LayeredMaterial& given) {
  LayeredMaterial material = given;
  material.anisotropy_rotation = within_a_turn(given.anisotropy_rotation);
  const std::uint64_t hash = hash_of(material);
  for (auto [it, end] = material_of_hash_.equal_range(hash); it != end; ++it) {
    const auto index = std::get<Layered>(scene_.materials[index_of(it->second)]).index;
    if (scene_.layered_materials[index] == material) return it->second;
  }
  scene_.layered_materials.push_back(material);
  const auto index = static_cast<std::uint32_t>(scene_.layered_materials.size() - 1);
  const MaterialId id = scene_.add_material(Layered{index});
  material_of_hash_.emplace(hash, id);
  return id;
}

Expected<ImageId> SceneBuilder::add_image(const RawImage& image) {
  TextureImage entry{image.width, image.height, texel_format(image.format), 0, 0};
  const std::uint64_t hash = hash_bytes(std::as_bytes(std::span(image.texels)));
  for (auto [it, end] = image_of_hash_.equal_range(hash); it != end; ++it) {
    entry.offset = scene_.images[static_cast<std::size_t>(it->second)].offset;
    const bool same = scene_.images[static_cast<std::size_t>(it->second)] == entry &&
                      std::equal(image.texels.begin(), image.texels.end(),
                                 scene_.texels.begin() + static_cast<std::ptrdiff_t>(entry.offset));
    if (same) return it->second;
  }
  if (auto taken = budget_.take(image.texels.size(), 1, "image"); !taken) {
    return tl::unexpected(taken.error());
  }
  auto& texels = scene_.texels;
  texels.resize((texels.size() + kImageAlignment - 1) / kImageAlignment * kImageAlignment);
  entry.offset = texels.size();
  texels.insert(texels.end(), image.texels.begin(), image.texels.end());
  scene_.images.push_back(entry);
  const auto id = static_cast<ImageId>(scene_.images.size() - 1);
  image_of_hash_.emplace(hash, id);
  return id;
}

TextureId SceneBuilder::add_texture(const Texture& texture) {
  auto& textures = scene_.textures;
  const auto found = std::find(textures.begin(), textures.end(), texture);
  if (found == textures.end()) {
    textures.push_back(texture);
    return static_cast<TextureId>(textures.size() - 1);
  }
  return static_cast<TextureId>(found - textures.begin());
}

TextureId SceneBuilder::magenta_texture() {
  if (magenta_ == kNoTexture) {
    const auto image = add_image(magenta_picture());
    if (image) magenta_ = add_texture({*image, Wrap::repeat, Wrap::repeat, Filter::nearest});
  }
  return magenta_;
}

Status SceneBuilder::add_vertices(const Vertices& vertices) {
  const std::uint64_t count = vertices.positions.size();
  if (count > kMaxVertexCount - scene_.vertices.positions.size()) {
    return fail(Errc::bad_data, "", fmt::format("more than {} vertices", kMaxVertexCount));
  }
  if (auto taken = budget_.take(count, kMaxVertexBytes, "vertices"); !taken) return taken;
  append_vertices(vertices, scene_.vertices);
  // Triangles with such corners are left out; the corners must be points all the same.
  auto& positions = scene_.vertices.positions;
  std::replace_if(
      positions.end() - static_cast<std::ptrdiff_t>(count), positions.end(),
      [](const Vec3f& p) { return !is_point(p); }, Vec3f());
  return {};
}

void SceneBuilder::add_triangles(const MeshData& mesh, std::uint32_t first_vertex,
                                 std::vector<Triangle>& triangles,
                                 std::vector<MaterialId>& materials) {
  const auto& positions = mesh.vertices.positions;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i].vertices;
    if (!is_point(positions[a]) || !is_point(positions[b]) || !is_point(positions[c])) {
      ++left_out_.not_finite;
    } else if (!has_area(Vec3d(positions[a]), Vec3d(positions[b]), Vec3d(positions[c]))) {
      ++left_out_.without_area;
    } else {
      triangles.push_back({{first_vertex + a, first_vertex + b, first_vertex + c}});
      materials.push_back(mesh.materials[i]);
    }
  }
}

namespace {

Status check_mesh(const MeshData& mesh, std::uint64_t triangles_there) {
  if (mesh.triangles.size() > kMaxTriangleCount - triangles_there) {
    return fail(Errc::bad_data, "", fmt::format("more than {} triangles", kMaxTriangleCount));
  }
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle.vertices) {
      if (vertex < mesh.vertices.positions.size()) continue;
      return fail(
          Errc::bad_data, "",
          fmt::format("vertex {} of {} does not exist", vertex, mesh.vertices.positions.size()));
    }
  }
  return {};
}

}  // namespace

Status SceneBuilder::add_mesh(const MeshData& mesh) {
  const auto there = scene_.triangles.size() + prototype_triangles_.size();
  if (auto checked = check_mesh(mesh, there); !checked) return checked;
  const auto first = static_cast<std::uint32_t>(scene_.vertices.positions.size());
  if (auto added = add_vertices(mesh.vertices); !added) return added;
  add_triangles(mesh, first, scene_.triangles, scene_.triangle_materials);
  return {};
}

Expected<std::uint32_t> SceneBuilder::add_prototype(const MeshData& mesh) {
  const auto there = scene_.triangles.size() + prototype_triangles_.size();
  if (auto checked = check_mesh(mesh, there); !checked) return tl::unexpected(checked.error());
  const auto first = static_cast<std::uint32_t>(scene_.vertices.positions.size());
  if (auto added = add_vertices(mesh.vertices); !added) return tl::unexpected(added.error());
  const std::size_t before = prototype_triangles_.size();
  add_triangles(mesh, first, prototype_triangles_, prototype_materials_);
  const std::size_t count = prototype_triangles_.size() - before;
  if (count == 0) return kNoPrototype;
  scene_.prototypes.push_back(
      {static_cast<std::uint32_t>(before), static_cast<std::uint32_t>(count)});
  return static_cast<std::uint32_t>(scene_.prototypes.size() - 1);
}

Status SceneBuilder::add_instance(std::uint32_t prototype, const Transformf& to_world) {
  if (auto taken = budget_.take(1, sizeof(Instance), "instances"); !taken) return taken;
  scene_.instances.push_back({to_world, prototype});
  return {};
}

void SceneBuilder::add_sphere(const Vec3d& centre, double radius, MaterialId material) {
  scene_.spheres.push_back({centre, radius});
  scene_.sphere_materials.push_back(material);
}

void SceneBuilder::add_cylinder(const Cylinder& cylinder, MaterialId material) {
  scene_.cylinders.push_back(cylinder);
  scene_.cylinder_materials.push_back(material);
}

void SceneBuilder::add_point(const Vec3d& position, MaterialId material) {
  if (is_point(Vec3f(position))) {
    points_.push_back({position, material});
  } else {
    ++left_out_.not_finite;
  }
}

void SceneBuilder::add_line(const Vec3d& begin, const Vec3d& end, MaterialId material) {
  if (!is_point(Vec3f(begin)) || !is_point(Vec3f(end))) {
    ++left_out_.not_finite;
  } else if (begin == end) {
    ++left_out_.without_area;
  } else {
    lines_.push_back({begin, end, material});
  }
}

void SceneBuilder::add_points_and_lines(double radius) {
  if (points_.empty() && lines_.empty()) return;
  if (!(radius > 0)) {
    Extent extent = extent_of(scene_, prototype_triangles_);
    for (const Point& point : points_) extent.include(point.position);
    for (const Line& line : lines_) {
      extent.include(line.begin);
      extent.include(line.end);
    }
    const double diagonal = extent.diagonal();
    radius = diagonal > 0 ? diagonal / 500 : 1;
  }
  for (const Point& point : points_) add_sphere(point.position, radius, point.material);
  for (const Line& line : lines_) add_cylinder({line.begin, line.end, radius}, line.material);
}

void SceneBuilder::add_camera(std::string_view name, const Camera& camera, double aspect) {
  scene_.cameras.push_back({camera_name(name), camera});
  camera_aspects_.push_back(aspect > 0 && std::isfinite(aspect) ? aspect : 0);
}

bool SceneBuilder::is_empty() const {
  return scene_.triangles.empty() && scene_.instances.empty() && scene_.spheres.empty() &&
         scene_.cylinders.empty() && points_.empty() && lines_.empty();
}

Status SceneBuilder::choose_camera(const std::string& wanted) {
  scene_.camera.aperture = 0;
  const auto& cameras = scene_.cameras;
  if (wanted.empty()) {
    if (!cameras.empty()) scene_.camera = cameras[0].camera;
    return {};
  }
  std::size_t index = cameras.size();
  for (std::size_t i = cameras.size(); i-- > 0;) {
    if (cameras[i].name == camera_name(wanted)) index = i;
  }
  if (index == cameras.size()) {
    const char* end = wanted.data() + wanted.size();
    const auto [stop, error] = std::from_chars(wanted.data(), end, index);
    if (error != std::errc() || stop != end) index = cameras.size();
  }
  if (index >= cameras.size()) {
    std::string names;
    for (const NamedCamera& camera : cameras) {
      names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", camera.name.data());
    }
    return fail(Errc::usage, "camera",
                fmt::format("there is no camera \"{}\"; the {} of the file: {}", wanted,
                            cameras.size(), names.empty() ? "none" : names));
  }
  scene_.camera = cameras[index].camera;
  return {};
}

void SceneBuilder::count_runs() {
  const auto run = [&](ShapeKind kind, std::size_t count) {
    if (count > 0) scene_.runs.push_back({kind, count});
  };
  const std::size_t in_prototypes = prototype_triangles_.size();
  run(ShapeKind::triangle, scene_.triangles.size() - in_prototypes);
  run(ShapeKind::sphere, scene_.spheres.size());
  run(ShapeKind::cylinder, scene_.cylinders.size());
  run(ShapeKind::instance, scene_.instances.size());
}

Expected<Scene> SceneBuilder::finish(const std::string& camera, double point_radius) {
  if (auto chosen = choose_camera(camera); !chosen) return tl::unexpected(chosen.error());
  add_points_and_lines(point_radius);
  const auto world_triangles = static_cast<std::uint32_t>(scene_.triangles.size());
  for (Prototype& prototype : scene_.prototypes) prototype.first_triangle += world_triangles;
  scene_.triangles.insert(scene_.triangles.end(), prototype_triangles_.begin(),
                          prototype_triangles_.end());
  scene_.triangle_materials.insert(scene_.triangle_materials.end(), prototype_materials_.begin(),
                                   prototype_materials_.end());
  count_runs();
  return std::move(scene_);
}

}  // namespace dapple
