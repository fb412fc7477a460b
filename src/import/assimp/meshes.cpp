#include "import/assimp/meshes.h"

#include <cmath>

#include "scene/validate.h"

namespace dapple::assimp {
namespace {

Vec3f vec(const aiVector3D& v) { return {v.x, v.y, v.z}; }

Vec3f unit_or_zero(const Vec3d& v) {
  const double size = length(v);
  return size > 0 && std::isfinite(size) ? Vec3f(v / size) : Vec3f();
}

// assimp's v grows upwards.
void copy_uvs(const aiMesh& from, Vertices& to) {
  for (unsigned set = 0; set < kUvSetCount; ++set) {
    if (!from.HasTextureCoords(set)) continue;
    for (unsigned i = 0; i < from.mNumVertices; ++i) {
      const aiVector3D& uv = from.mTextureCoords[set][i];
      to.uvs[set].push_back({uv.x, 1 - uv.y});
    }
  }
}

bool is_position(const Vec3d& p) { return is_valid(Sphere{p, 1}); }

}  // namespace

MeshData mesh_of(const aiMesh& from, MaterialId material) {
  MeshData to;
  Vertices& vertices = to.vertices;
  for (unsigned i = 0; i < from.mNumVertices; ++i) {
    vertices.positions.push_back(vec(from.mVertices[i]));
    if (from.HasNormals()) vertices.normals.push_back(unit_or_zero(Vec3d(vec(from.mNormals[i]))));
    if (from.HasVertexColors(0)) {
      const aiColor4D& c = from.mColors[0][i];
      vertices.colours.push_back({c.r, c.g, c.b, c.a});
    }
  }
  copy_uvs(from, vertices);
  for (unsigned i = 0; i < from.mNumFaces; ++i) {
    const aiFace& face = from.mFaces[i];
    if (face.mNumIndices != 3) continue;
    to.triangles.push_back({{face.mIndices[0], face.mIndices[1], face.mIndices[2]}});
  }
  to.materials.assign(to.triangles.size(), material);
  return to;
}

void move(const Transformd& to_world, MeshData& mesh) {
  for (Vec3f& p : mesh.vertices.positions) p = Vec3f(to_world.point(Vec3d(p)));
  const Transformd to_own = inverse(to_world);
  for (Vec3f& n : mesh.vertices.normals) n = unit_or_zero(to_own.transposed_vector(Vec3d(n)));
  if (determinant(to_world) > 0) return;
  for (Triangle& triangle : mesh.triangles) std::swap(triangle.vertices[1], triangle.vertices[2]);
}

void add_points_and_lines(const aiMesh& mesh, const Transformd& to_world, MaterialId material,
                          SceneBuilder& builder) {
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const aiFace& face = mesh.mFaces[i];
    if (face.mNumIndices != 1 && face.mNumIndices != 2) continue;
    const Vec3d begin = to_world.point(Vec3d(vec(mesh.mVertices[face.mIndices[0]])));
    const Vec3d end =
        to_world.point(Vec3d(vec(mesh.mVertices[face.mIndices[face.mNumIndices - 1]])));
    if (!is_position(begin) || !is_position(end)) continue;
    if (face.mNumIndices == 1) builder.add_point(begin, material);
    if (face.mNumIndices == 2 && !(begin == end)) builder.add_line(begin, end, material);
  }
}

}  // namespace dapple::assimp
