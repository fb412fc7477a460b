#include "import/gltf/deform.h"

#include <algorithm>
#include <cmath>

namespace dapple::gltf {
namespace {

Vec3f unit_or_zero(const Vec3d& v) {
  const double norm = length(v);
  return norm > 0 && std::isfinite(norm) ? Vec3f(v / norm) : Vec3f();
}

// Normals go by the inverse transpose. Its multiple by the determinant exists for every matrix; the
// determinant's sign keeps them outside.
struct NormalMap {
  Transformd cofactors;
  double sign = 1;

  explicit NormalMap(const Transformd& m) : sign(determinant(m) < 0 ? -1 : 1) {
    const auto& r = m.rows;
    for (int i = 0; i < 3; ++i) {
      const int a = (i + 1) % 3, b = (i + 2) % 3;
      for (int j = 0; j < 3; ++j) {
        const int c = (j + 1) % 3, d = (j + 2) % 3;
        cofactors.rows[i][j] = r[a][c] * r[b][d] - r[a][d] * r[b][c];
      }
    }
  }
  Vec3f operator()(const Vec3f& n) const { return unit_or_zero(sign * cofactors.vector(Vec3d(n))); }
};

// Moves one vertex.
void move(const Transformd& m, const NormalMap& normal_map, std::size_t i, Vertices& v) {
  v.positions[i] = Vec3f(m.point(Vec3d(v.positions[i])));
  if (!v.normals.empty()) v.normals[i] = normal_map(v.normals[i]);
  if (!v.tangents.empty()) {
    const Vec3f t = unit_or_zero(m.vector(Vec3d(v.tangents[i].xyz())));
    v.tangents[i] = {t.x, t.y, t.z, v.tangents[i].w * static_cast<float>(normal_map.sign)};
  }
}

template <class T>
void add(float weight, const std::vector<T>& delta, std::vector<T>& to) {
  if (delta.size() != to.size()) return;
  for (std::size_t i = 0; i < to.size(); ++i) to[i] = to[i] + weight * delta[i];
}

void add_tangents(float weight, const std::vector<Vec3f>& delta, std::vector<Vec4f>& to) {
  if (delta.size() != to.size()) return;
  for (std::size_t i = 0; i < to.size(); ++i) {
    to[i] = to[i] + weight * Vec4f{delta[i].x, delta[i].y, delta[i].z, 0};
  }
}

Transformd blend(const Influences& influences, std::span<const Transformd> joints,
                 std::size_t vertex) {
  Transformd sum;
  double total = 0;
  for (auto& row : sum.rows) std::fill(std::begin(row), std::end(row), 0.0);
  for (std::size_t k = 0; k < influences.per_vertex; ++k) {
    const double weight = influences.weights[vertex * influences.per_vertex + k];
    if (weight == 0) continue;
    total += weight;
    const Transformd& joint = joints[influences.joints[vertex * influences.per_vertex + k]];
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 4; ++j) sum.rows[i][j] += weight * joint.rows[i][j];
    }
  }
  // Weights are meant to add up to one.
  if (total != 0) {
    for (auto& row : sum.rows) {
      for (double& value : row) value /= total;
    }
  }
  return sum;
}

}  // namespace

Vertices morphed(const Primitive& primitive, std::span<const double> weights) {
  Vertices v = primitive.vertices;
  const std::size_t count = std::min(primitive.targets.size(), weights.size());
  for (std::size_t t = 0; t < count; ++t) {
    const auto weight = static_cast<float>(weights[t]);
    if (weight == 0) continue;
    const MorphTarget& target = primitive.targets[t];
    add(weight, target.positions, v.positions);
    add(weight, target.normals, v.normals);
    add_tangents(weight, target.tangents, v.tangents);
    for (std::size_t set = 0; set < kUvSetCount; ++set) add(weight, target.uvs[set], v.uvs[set]);
    add(weight, target.colours, v.colours);
  }
  if (count > 0) {
    for (Vec3f& n : v.normals) n = unit_or_zero(Vec3d(n));
    for (Vec4f& t : v.tangents) {
      const Vec3f unit = unit_or_zero(Vec3d(t.xyz()));
      t = {unit.x, unit.y, unit.z, t.w};
    }
  }
  for (Vec4f& c : v.colours) {
    c = {std::clamp(c.x, 0.0f, 1.0f), std::clamp(c.y, 0.0f, 1.0f), std::clamp(c.z, 0.0f, 1.0f),
         std::clamp(c.w, 0.0f, 1.0f)};
  }
  return v;
}

bool skin(const Influences& influences, std::span<const Transformd> joints, Vertices& vertices) {
  for (std::size_t k = 0; k < influences.joints.size(); ++k) {
    if (influences.weights[k] != 0 && influences.joints[k] >= joints.size()) return false;
  }
  for (std::size_t i = 0; i < vertices.positions.size(); ++i) {
    const Transformd m = blend(influences, joints, i);
    move(m, NormalMap(m), i, vertices);
  }
  return true;
}

void place(const Transformd& to_world, Vertices& vertices) {
  const NormalMap normal_map(to_world);
  for (std::size_t i = 0; i < vertices.positions.size(); ++i) {
    move(to_world, normal_map, i, vertices);
  }
}

}  // namespace dapple::gltf
