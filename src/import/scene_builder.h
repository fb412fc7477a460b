// Puts a scene together from what an importer finds, whatever the order it finds it in.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "image/raw_image.h"
#include "import/limits.h"
#include "import/mesh_data.h"
#include "scene/scene.h"
#include "util/error.h"

namespace dapple {

inline constexpr std::uint32_t kNoPrototype = 0xffffffffu;

// Equal materials, images and textures are stored once. Adding fails only where a limit is passed
// or an index is wrong; the error's place is then for the importer to add.
class SceneBuilder {
 public:
  explicit SceneBuilder(std::uint64_t max_bytes) : budget_(max_bytes) {}

  ByteBudget& budget() { return budget_; }

  MaterialId add_material(const LayeredMaterial& given);
  // One of the classic three, stored however often it is added.
  MaterialId add_classic(const Material& material) { return scene_.add_material(material); }
  [[nodiscard]] Expected<ImageId> add_image(const RawImage& image);
  TextureId add_texture(const Texture& texture);
  // What stands for a picture that is missing.
  TextureId magenta_texture();

  // Triangles of the world itself. Those without area or with positions that are not finite or too
  // large are left out, and counted.
  [[nodiscard]] Status add_mesh(const MeshData& mesh);
  // Triangles to be seen through instances: the number of the prototype, or kNoPrototype if no
  // triangle is left.
  [[nodiscard]] Expected<std::uint32_t> add_prototype(const MeshData& mesh);
  [[nodiscard]] Status add_instance(std::uint32_t prototype, const Transformf& to_world);

  void add_sphere(const Vec3d& centre, double radius, MaterialId material);
  void add_cylinder(const Cylinder& cylinder, MaterialId material);
  // Points and lines without a thickness of their own: spheres and cylinders, as thick as finish()
  // is told or finds fitting.
  void add_point(const Vec3d& position, MaterialId material);
  void add_line(const Vec3d& begin, const Vec3d& end, MaterialId material);
  void add_light(const Light& light) { scene_.lights.push_back(light); }
  // `aspect`: width over height of the pictures that the camera is meant for; 0: any.
  void add_camera(std::string_view name, const Camera& camera, double aspect = 0);
  const std::vector<double>& camera_aspects() const { return camera_aspects_; }

  struct LeftOut {
    std::uint64_t without_area = 0;
    std::uint64_t not_finite = 0;
  };
  // Triangles left out so far.
  const LeftOut& left_out() const { return left_out_; }
  bool is_empty() const;

  Environment& environment() { return scene_.environment; }

  // `camera` is the name or index of the one to use; empty: the first. `point_radius` 0: 1/500 of
  // the diagonal of the box around everything.
  [[nodiscard]] Expected<Scene> finish(const std::string& camera, double point_radius = 0);

 private:
  [[nodiscard]] Status add_vertices(const Vertices& vertices);
  void add_triangles(const MeshData& mesh, std::uint32_t first_vertex,
                     std::vector<Triangle>& triangles, std::vector<MaterialId>& materials);
  [[nodiscard]] Status choose_camera(const std::string& camera);
  void add_points_and_lines(double radius);
  void count_runs();

  ByteBudget budget_;
  Scene scene_;
  std::vector<Triangle> prototype_triangles_;
  std::vector<MaterialId> prototype_materials_;
  std::unordered_multimap<std::uint64_t, MaterialId> material_of_hash_;
  std::unordered_multimap<std::uint64_t, ImageId> image_of_hash_;
  struct Point {
    Vec3d position;
    MaterialId material;
  };
  struct Line {
    Vec3d begin, end;
    MaterialId material;
  };
  std::vector<Point> points_;
  std::vector<Line> lines_;
  LeftOut left_out_;
  std::vector<double> camera_aspects_;  // of scene_.cameras
  TextureId magenta_ = kNoTexture;
};

}  // namespace dapple
