#include "import/pbrt/shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "import/pbrt/surfaces.h"
#include "import/ply/model.h"
#include "import/text.h"
#include "math/functions.h"

namespace dapple::pbrt {
namespace {

constexpr std::uint32_t kColumns = 128, kRows = 64;  // of curved surfaces

// Groups of `corners` indices. One that names no vertex is an error, or with `keep_going` leaves
// out its group.
Status indices(const Context& context, const Params& params, std::size_t corners,
               std::size_t vertex_count, std::vector<std::uint32_t>& result) {
  const std::vector<double> numbers = params.numbers("indices");
  if (numbers.size() % corners != 0) {
    return fail(Errc::bad_data, params.place(),
                fmt::format("the number of indices is no multiple of {}", corners));
  }
  const auto is_vertex = [&](double number) {
    return number >= 0 && number < double(vertex_count) && std::floor(number) == number;
  };
  std::size_t broken = 0;
  for (std::size_t i = 0; i < numbers.size(); i += corners) {
    const auto group = std::span(numbers).subspan(i, corners);
    const auto wrong = std::find_if_not(group.begin(), group.end(), is_vertex);
    if (wrong == group.end()) {
      for (const double number : group) result.push_back(static_cast<std::uint32_t>(number));
    } else if (!context.import.options().keep_going) {
      return fail(Errc::bad_data, params.place(),
                  fmt::format("the index {} of {} vertices", *wrong, vertex_count));
    } else {
      ++broken;
    }
  }
  if (broken > 0) {
    context.warn(params.place(),
                 fmt::format("{} faces with indices of nothing are left out", broken));
  }
  if (numbers.empty() && vertex_count == corners) {
    for (std::uint32_t i = 0; i < corners; ++i) result.push_back(i);
  }
  return {};
}

// Attributes that come with the vertices: as many as positions, or none.
Status attributes(const Params& params, Vertices& vertices) {
  const std::size_t count = vertices.positions.size();
  const auto check = [&](std::size_t there, std::string_view what) -> Status {
    if (there == 0 || there == count) return {};
    return fail(Errc::bad_data, params.place(),
                fmt::format("{} {} for {} vertices", there, what, count));
  };
  vertices.normals = params.vectors("N");
  if (auto s = check(vertices.normals.size(), "normals"); !s) return s;
  for (Vec3f& normal : vertices.normals) {
    const float size = length(normal);
    normal = size > 0 && std::isfinite(size) ? normal / size : Vec3f();
  }
  auto uvs = params.numbers("uv");
  if (uvs.empty()) uvs = params.numbers("st");
  for (std::size_t i = 0; i + 1 < uvs.size(); i += 2) {
    vertices.uvs[0].push_back({to_float(uvs[i]), to_float(1 - uvs[i + 1])});
  }
  return check(vertices.uvs[0].size(), "texture coordinates");
}

// With normals, the side of a triangle is theirs.
void face_normals(MeshData& mesh) {
  const Vertices& vertices = mesh.vertices;
  if (vertices.normals.empty()) return;
  for (Triangle& triangle : mesh.triangles) {
    auto& [a, b, c] = triangle.vertices;
    const Vec3d normal = cross(Vec3d(vertices.positions[b]) - Vec3d(vertices.positions[a]),
                               Vec3d(vertices.positions[c]) - Vec3d(vertices.positions[a]));
    const Vec3d given(vertices.normals[a] + vertices.normals[b] + vertices.normals[c]);
    if (dot(normal, given) < 0) std::swap(b, c);
  }
}

Expected<Shape> triangle_mesh(const Context& context, const Params& params) {
  Shape shape;
  shape.mesh.vertices.positions = params.vectors("P");
  std::vector<std::uint32_t> index;
  const std::size_t count = shape.mesh.vertices.positions.size();
  if (auto s = indices(context, params, 3, count, index); !s) return tl::unexpected(s.error());
  if (auto s = attributes(params, shape.mesh.vertices); !s) return tl::unexpected(s.error());
  for (std::size_t i = 0; i < index.size(); i += 3) {
    shape.mesh.triangles.push_back({{index[i], index[i + 1], index[i + 2]}});
  }
  face_normals(shape.mesh);
  return shape;
}

// Patches with the corners (0,0), (1,0), (0,1) and (1,1), each as two triangles.
Expected<Shape> bilinear_mesh(const Context& context, const Params& params) {
  Shape shape;
  shape.mesh.vertices.positions = params.vectors("P");
  std::vector<std::uint32_t> index;
  const std::size_t count = shape.mesh.vertices.positions.size();
  if (auto s = indices(context, params, 4, count, index); !s) return tl::unexpected(s.error());
  if (auto s = attributes(params, shape.mesh.vertices); !s) return tl::unexpected(s.error());
  for (std::size_t i = 0; i < index.size(); i += 4) {
    shape.mesh.triangles.push_back({{index[i], index[i + 1], index[i + 3]}});
    shape.mesh.triangles.push_back({{index[i], index[i + 3], index[i + 2]}});
  }
  face_normals(shape.mesh);
  return shape;
}

// A ring or disc at a height, with its normal along z.
Shape disk(const Params& params) {
  const double outer = params.number("radius", 1), inner = params.number("innerradius", 0);
  const double z = params.number("height", 0), turns = params.number("phimax", 360) / 360;
  return {grid_mesh(kColumns, 1,
                    [&](double u, double v) {
                      const auto [s, c] = sin_cos_turns(turns * u);
                      const double r = outer + v * (inner - outer);
                      return SurfacePoint{{r * c, r * s, z}, {0, 0, 1}};
                    }),
          {}};
}

// An open tube around z.
Shape cylinder(const Params& params) {
  const double r = params.number("radius", 1), turns = params.number("phimax", 360) / 360;
  const double low = params.number("zmin", -1), high = params.number("zmax", 1);
  return {grid_mesh(kColumns, 1,
                    [&](double u, double v) {
                      const auto [s, c] = sin_cos_turns(turns * u);
                      return SurfacePoint{{r * c, r * s, low + v * (high - low)}, {c, s, 0}};
                    }),
          {}};
}

Shape sphere(const Context& context, const Params& params) {
  const double radius = std::fabs(params.number("radius", 1));
  const bool whole = params.number("zmin", -radius) <= -radius &&
                     params.number("zmax", radius) >= radius && params.number("phimax", 360) >= 360;
  if (!whole) context.warn(params.place(), "a part of a sphere is taken for the whole");
  return {{}, radius};
}

}  // namespace

MeshData sphere_mesh(double radius) {
  return grid_mesh(kColumns, kRows, [&](double u, double v) {
    const auto around = sin_cos_turns(u);
    const auto up = sin_cos_turns(0.5 * v);
    const Vec3d normal(up.sin * around.cos, up.sin * around.sin, -up.cos);
    return SurfacePoint{radius * normal, normal};
  });
}

Expected<Shape> Shapes::ply_mesh(const Context& context, const Params& params) {
  const std::string name = params.text("filename", "");
  params.find("edgelength", {"float"});
  const auto known = files_.find(name);
  if (known != files_.end()) return Shape{known->second, {}};
  const auto file = context.import.open_companion(name);
  if (!file) return fail(file.error().code, params.place(), to_string(file.error()));
  auto model = ply::read(file->bytes(), context.import.sandbox().path_of(name),
                         context.import.options().keep_going);
  if (!model) return tl::unexpected(model.error());
  if (model->broken_faces > 0) {
    context.warn(params.place(), fmt::format("{} faces with indices of nothing are left out ({})",
                                             model->broken_faces, model->broken_reason));
  }
  if (model->is_cloud()) context.warn(params.place(), "the file holds no triangles");
  face_normals(model->mesh);
  const MeshData& mesh = files_.emplace(name, std::move(model->mesh)).first->second;
  return Shape{mesh, {}};
}

Expected<std::optional<Shape>> Shapes::make(const Context& context, const std::string& kind,
                                            const Params& params) {
  Expected<Shape> shape;
  if (kind == "trianglemesh" || kind == "loopsubdiv") {
    shape = triangle_mesh(context, params);
    if (kind == "loopsubdiv") context.warn(params.place(), "a surface is left without subdivision");
  } else if (kind == "plymesh") {
    shape = ply_mesh(context, params);
  } else if (kind == "sphere") {
    shape = sphere(context, params);
  } else if (kind == "disk") {
    shape = disk(params);
  } else if (kind == "cylinder") {
    shape = cylinder(params);
  } else if (kind == "bilinearmesh") {
    shape = bilinear_mesh(context, params);
  } else {
    context.warn(params.place(), fmt::format("shapes '{:.40}' are left out", kind));
    return std::nullopt;
  }
  if (!shape) return tl::unexpected(shape.error());
  context.warn_of_unused(params);
  return std::move(*shape);
}

Status place(const Transformd& to_world, bool reversed, MeshData& mesh) {
  const double size = determinant(to_world);
  if (!(std::fabs(size) > 0 && std::isfinite(size))) {
    return fail(Errc::bad_data, "", "the transformation has no inverse");
  }
  for (Vec3f& p : mesh.vertices.positions) {
    const Vec3d q = to_world.point(Vec3d(p));
    p = {to_float(q.x), to_float(q.y), to_float(q.z)};
  }
  const Transformd to_own = inverse(to_world);
  for (Vec3f& n : mesh.vertices.normals) {
    const Vec3d turned = to_own.transposed_vector(Vec3d(n));
    const double turned_size = length(turned);
    n = turned_size > 0 && std::isfinite(turned_size)
            ? Vec3f((reversed ? -1.0 : 1.0) / turned_size * turned)
            : Vec3f();
  }
  if ((size < 0) != reversed) {
    for (Triangle& triangle : mesh.triangles) {
      std::swap(triangle.vertices[1], triangle.vertices[2]);
    }
  }
  return {};
}

}  // namespace dapple::pbrt
