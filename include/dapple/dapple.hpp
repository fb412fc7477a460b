// dapple for C++20: scenes, ray queries and pictures.
//
//     dapple::Scene scene;
//     const auto grey = scene.add_material(dapple::Lambertian{{0.8, 0.8, 0.8}});
//     scene.add_sphere({0, 1, 0}, 1, *grey);
//     const auto accelerator = dapple::Accelerator::build(scene);
//     const auto picture = dapple::render(*accelerator, {.width = 640, .height = 480});
//     if (!picture || !picture->save("ball.png")) ...
//
// Nothing here throws, prints or exits; what can fail returns a Result or a Status. Lengths are in
// the scene's own unit, y is up, colours are linear. Scene and Accelerator are handles: copies are
// cheap and behave as values. Different objects may be used by different threads at once, and the
// const functions of one object too.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "dapple/version.h"

// The library itself, in which dapple:: has other things too, spells out v0.
#ifndef DAPPLE_API_NAMESPACE
#define DAPPLE_API_NAMESPACE inline namespace v0
#endif

namespace dapple {
DAPPLE_API_NAMESPACE {
  // Codes are the exit codes of the `dapple` command: 64 usage, 65 bad data, 66 no such input,
  // 70 internal, 71 memory, 73 cannot create output, 74 I/O, 75 interrupted.
  struct Error {
    int code = 70;
    std::string message;  // one line that names the file or object
  };

  // A T or the reason why there is none.
  template <class T>
  class [[nodiscard]] Result {
   public:
    Result(T value) : content_(std::move(value)) {}
    Result(Error error) : content_(std::move(error)) {}

    explicit operator bool() const noexcept { return content_.index() == 0; }
    // Only when there is a value.
    T& operator*() noexcept { return *std::get_if<0>(&content_); }
    const T& operator*() const noexcept { return *std::get_if<0>(&content_); }
    T* operator->() noexcept { return std::get_if<0>(&content_); }
    const T* operator->() const noexcept { return std::get_if<0>(&content_); }
    // Only when there is none.
    const Error& error() const noexcept { return *std::get_if<1>(&content_); }

   private:
    std::variant<T, Error> content_;
  };

  class [[nodiscard]] Status {
   public:
    Status() = default;
    Status(Error error) : error_(std::move(error)) {}

    explicit operator bool() const noexcept { return !error_.has_value(); }
    const Error& error() const noexcept { return *error_; }

   private:
    std::optional<Error> error_;
  };

  struct Point {
    double x = 0, y = 0, z = 0;
  };
  struct Colour {
    double r = 0, g = 0, b = 0;
  };

  struct Lambertian {
    Colour albedo;
  };
  struct Metal {
    Colour albedo;
    double fuzz = 0;  // 0 is a perfect mirror
  };
  struct Dielectric {
    double ref_idx = 1.5;  // of the inside over the outside
  };

  // These are of the scene that made them.
  enum class MaterialId : std::uint32_t {};
  enum class PrototypeId : std::uint32_t {};
  enum class TextureId : std::uint32_t {};
  inline constexpr TextureId no_texture{0xffffffffu};

  // The surface of models: glTF's metallic-roughness model with its usual extensions. A scene with
  // such materials is rendered with its lights, in single precision.
  struct Layered {
    Colour base_colour{1, 1, 1};
    double alpha = 1;  // below 1: seen through in part
    double metallic = 0;
    double roughness = 1;
    Colour emission = {};  // radiance
    double ior = 1.5;
    double specular = 1;
    Colour specular_colour{1, 1, 1};
    double transmission = 0;
    double thickness = 0;  // 0: a thin wall, which bends no light
    double attenuation_distance = std::numeric_limits<double>::infinity();
    Colour attenuation_colour{1, 1, 1};  // what is left after that distance inside
    double clearcoat = 0;
    double clearcoat_roughness = 0;
    Colour sheen_colour = {};
    double sheen_roughness = 0;
    double anisotropy = 0;
    double anisotropy_rotation = 0;  // radians counter-clockwise from the tangent
    bool double_sided = true;
    TextureId base_colour_map = no_texture;         // sRGB; multiplies colour and alpha
    TextureId metallic_roughness_map = no_texture;  // g roughness, b metallic
    TextureId normal_map = no_texture;              // tangent space
    TextureId emissive_map = no_texture;            // sRGB
  };
  using Material = std::variant<Lambertian, Metal, Dielectric, Layered>;

  enum class Shape : std::uint32_t {
    sphere,
    xy_rectangle,
    xz_rectangle,
    yz_rectangle,
    triangle,
    cylinder,
    instance,
  };

  // Axis-aligned: u and v are the axes in the shape's name, k is its place on the third.
  struct Rectangle {
    double u0 = 0, u1 = 0, v0 = 0, v1 = 0, k = 0;
  };

  struct Camera {
    Point look_from{0, 0, 0};
    Point look_at{0, 0, -1};
    Point up{0, 1, 0};
    double vertical_fov = 75;  // degrees
    double aperture = 0.01;    // diameter of the lens
    double focus_distance = 10;
    double orthographic_height = 0;  // what the picture's height spans; 0: in perspective
  };

  // Triangles with vertices of their own. Attributes are there for every vertex or left out.
  struct Mesh {
    std::span<const float> positions;          // x y z
    std::span<const std::uint32_t> triangles;  // three vertices each, counter-clockwise outside
    std::span<const float> normals = {};       // x y z of any length; zero: that of the triangle
    std::span<const float> uvs = {};           // u v; (0, 0) is the corner of the first texel
    std::span<const float> colours = {};       // r g b a, linear
  };

  // Rows of an affine map, the last column the translation. It must have an inverse.
  struct Transform {
    float rows[3][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};
  };

  struct Light {
    enum class Kind : std::uint32_t { point, spot, directional };
    Kind kind = Kind::point;
    Point position = {};
    Point direction{0, 0, -1};        // the way light travels, of any length
    Colour intensity{1, 1, 1};        // per steradian; directional: irradiance at right angles
    double inner_angle = 0;           // spot: radians from the axis, full light up to here
    double outer_angle = 0.78539816;  // and none from here on
  };

  struct Environment {
    enum class Kind : std::uint32_t {
      classic_sky,  // the blue sky and the light transport of the classic scenes
      none,         // black
      constant,     // `colour` from everywhere
      image,        // `image` around the scene, equirectangular
      studio,       // a neutral studio
    };
    Kind kind = Kind::classic_sky;
    Colour colour{1, 1, 1};  // multiplies all kinds but the classic sky
    TextureId image = no_texture;
    double rotation = 0;  // degrees about the y axis
  };

  class Accelerator;

  class DAPPLE_API Scene {
   public:
    Scene() noexcept;  // no objects; the default camera

    // One of the named scenes (`nice`, `irreg:100`, ...), or else a scene file or a model.
    static Result<Scene> open(const std::string& name_or_path) noexcept;

    Result<MaterialId> add_material(const Material& material) noexcept;
    // Errors: an unknown material, a number that is not finite or too large.
    Status add_sphere(const Point& centre, double radius, MaterialId material) noexcept;
    Status add_rectangle(Shape shape, const Rectangle& rectangle, MaterialId material) noexcept;
    // Solid, with flat ends.
    Status add_cylinder(const Point& begin, const Point& end, double radius,
                        MaterialId material) noexcept;
    // Errors also: an index that is not below the number of vertices, spans whose sizes disagree.
    Status add_mesh(const Mesh& mesh, MaterialId material) noexcept;
    // A mesh that is seen only where instances place it, however often.
    Result<PrototypeId> add_prototype(const Mesh& mesh, MaterialId material) noexcept;
    Status add_instance(PrototypeId prototype, const Transform& to_world) noexcept;

    // Texels from the top row down, four bytes (red, green, blue, alpha) or three floats (linear
    // red, green, blue) each.
    Result<TextureId> add_texture(int width, int height,
                                  std::span<const std::uint8_t> rgba) noexcept;
    Result<TextureId> add_texture(int width, int height, std::span<const float> rgb) noexcept;
    Status add_light(const Light& light) noexcept;
    Status set_environment(const Environment& environment) noexcept;
    Status set_camera(const Camera& camera) noexcept;

    Camera camera() const noexcept;
    std::size_t object_count() const noexcept;

    // A scene file; with its BVH inside it is larger, and opens and renders without building one.
    enum class Contents { scene, scene_and_bvh };
    Status save(const std::string& path, Contents contents = Contents::scene) const noexcept;

   private:
    friend class Accelerator;
    struct State;
    explicit Scene(std::shared_ptr<State> state) noexcept;
    State& own_state();

    std::shared_ptr<State> state_;  // shared until somebody changes it
  };

  struct Ray {
    float origin[3] = {0, 0, 0};
    float t_min = 1e-3f;
    float direction[3] = {0, 0, 1};  // of any length; t counts in units of it
    float t_max = std::numeric_limits<float>::infinity();
  };

  inline constexpr std::uint32_t no_instance = 0xffffffffu;

  struct Hit {
    float t = std::numeric_limits<float>::infinity();  // infinity: nothing was hit
    Shape shape = Shape::sphere;
    // Of the object among those of its shape, in the order of adding; of triangles those of meshes
    // come first, then those of prototypes.
    std::uint32_t index = 0;
    std::uint32_t instance = no_instance;  // the one through which the triangle is seen

    bool found() const noexcept { return t < std::numeric_limits<float>::infinity(); }
  };

  struct RenderOptions {
    int width = 800;
    int height = 600;
    int samples_per_pixel = 16;
    std::uint64_t seed = 0;
  };

  struct Picture {
    int width = 0;
    int height = 0;
    std::vector<float> rgb;  // linear, 3 * width * height, top row first

    // The ending of the name chooses the format; any other name is PPM.
    DAPPLE_API Status save(const std::string& path) const noexcept;
  };

  // Finds what rays hit. Keeps the scene as it was when this was built.
  class DAPPLE_API Accelerator {
   public:
    enum class Kind {
      linear,  // every ray against every object
      median,  // the textbook BVH
      fast,    // wide BVH, SIMD; that of the file when the scene came with one
    };
    static Result<Accelerator> build(const Scene& scene, Kind kind = Kind::fast) noexcept;

    // The nearest hit of each ray in [t_min, t_max]; all kinds agree to the bit. The spans must
    // have the same length.
    Status intersect(std::span<const Ray> rays, std::span<Hit> hits) const noexcept;
    // 1 for each ray that hits anything, else 0.
    Status occluded(std::span<const Ray> rays, std::span<std::uint8_t> results) const noexcept;

   private:
    friend DAPPLE_API Result<Picture> render(const Accelerator&, const RenderOptions&) noexcept;
    struct State;
    explicit Accelerator(std::shared_ptr<const State> state) noexcept;

    std::shared_ptr<const State> state_;
  };

  // The picture from the scene's camera, on all threads that OMP_NUM_THREADS allows; the same to
  // the bit for any number of them.
  DAPPLE_API Result<Picture> render(const Accelerator& accelerator,
                                    const RenderOptions& options = {}) noexcept;

}  // namespace v0
}  // namespace dapple
