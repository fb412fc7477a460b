#include "import/obj/mesh.h"

#include "import/corner_table.h"
#include "import/polygon.h"

namespace dapple::obj {
namespace {

class MeshBuilder {
 public:
  explicit MeshBuilder(const Geometry& geometry)
      : geometry_(geometry), table_(geometry.positions.size()) {}

  MeshData build() {
    for (std::size_t e = 0; e < geometry_.elements.size(); ++e) {
      if (geometry_.elements[e].kind == ElementKind::face) add_face(e);
    }
    add_vertices();
    return std::move(mesh_);
  }

 private:
  void add_face(std::size_t e) {
    const Element& element = geometry_.elements[e];
    polygon_.clear();
    indices_.clear();
    cut_.clear();
    for (std::size_t c = element.first_corner; c < geometry_.end_of(e); ++c) {
      const Corner& corner = geometry_.corners[c];
      polygon_.push_back(geometry_.positions[corner.position]);
      indices_.push_back(table_.vertex(corner.position, corner.uv, corner.normal));
    }
    triangulate(polygon_, cut_);
    for (const Corners& corners : cut_) {
      mesh_.triangles.push_back(
          {{indices_[corners[0]], indices_[corners[1]], indices_[corners[2]]}});
      mesh_.materials.push_back(static_cast<MaterialId>(element.material));
    }
  }

  void add_vertices() {
    Vertices& vertices = mesh_.vertices;
    const auto& corners = table_.vertices();
    bool with_uvs = false, with_normals = false;
    for (const CornerTable::Vertex& corner : corners) {
      with_uvs |= corner.uv != kNone;
      with_normals |= corner.normal != kNone;
    }
    vertices.positions.reserve(corners.size());
    for (const CornerTable::Vertex& corner : corners) {
      vertices.positions.push_back(geometry_.positions[corner.position]);
      if (with_normals) {
        vertices.normals.push_back(corner.normal == kNone ? Vec3f()
                                                          : geometry_.normals[corner.normal]);
      }
      if (with_uvs) vertices.uvs[0].push_back(uv_of(corner));
      if (!geometry_.colours.empty()) {
        const Vec3f& colour = geometry_.colours[corner.position];
        vertices.colours.push_back({colour.x, colour.y, colour.z, 1});
      }
    }
  }

  // The file's v grows upwards.
  Vec2f uv_of(const CornerTable::Vertex& corner) const {
    if (corner.uv == kNone) return {};
    const Vec2f& uv = geometry_.uvs[corner.uv];
    return {uv.x, 1 - uv.y};
  }

  const Geometry& geometry_;
  CornerTable table_;
  MeshData mesh_;
  std::vector<Vec3f> polygon_;
  std::vector<std::uint32_t> indices_;
  std::vector<Corners> cut_;
};

}  // namespace

MeshData build_mesh(const Geometry& geometry) { return MeshBuilder(geometry).build(); }

}  // namespace dapple::obj
