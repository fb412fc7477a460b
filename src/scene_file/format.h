// The bytes of a scene file. docs/scene-format.md explains them with a diagram.
//
//     header, 64 bytes | section table, 64 bytes a section | sections, each at the next multiple
//     of its alignment; the gaps between are zero, and the file ends with the last section
//
// Fields are little-endian and of fixed width. Nothing here depends on a compiler's layout: the
// assertions below tie each struct to its offsets.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace dapple {

static_assert(std::endian::native == std::endian::little,
              "scene files are mapped as they stand, which takes a little-endian machine");

// History. A reader accepts any minor version of its own major version: what a later minor adds
// and can be left aside is in sections marked ignorable, what cannot in critical ones, on which an
// older reader gives up. The major version grows when an older reader would misread.
//   1.0  camera, materials, object order, spheres, rectangles, optional 16-wide BVH
//   1.1  meshes, cylinders, prototypes and instances, layered materials, textures, images, lights,
//        environment, further cameras, orthographic cameras
//   1.2  size of the film and shapes of the cameras' pictures, both ignorable
inline constexpr std::uint16_t kFormatMajor = 1;
inline constexpr std::uint16_t kFormatMinor = 2;

// As in PNG: a byte above 127, a name, and the line ends and end-of-file marks that a transfer in
// text mode would change.
inline constexpr std::uint8_t kMagic[8] = {0x89, 'D', 'P', 'L', '\r', '\n', 0x1a, '\n'};
inline constexpr std::uint32_t kEndianMark = 0x01020304;  // bytes 04 03 02 01

struct FileHeader {
  std::uint8_t magic[8];
  std::uint32_t endian_mark;
  std::uint16_t major;
  std::uint16_t minor;
  std::uint64_t file_size;
  std::uint32_t section_count;
  std::uint32_t reserved;      // zero
  std::uint64_t table_hash;    // XXH3-64 of the section table
  std::uint64_t reserved2[2];  // zero
  std::uint64_t header_hash;   // XXH3-64 of the 56 bytes before
};
static_assert(sizeof(FileHeader) == 64 && offsetof(FileHeader, file_size) == 16 &&
              offsetof(FileHeader, table_hash) == 32 && offsetof(FileHeader, header_hash) == 56);

// Four letters that can be read in a hex dump.
constexpr std::uint32_t section_type(const char (&name)[5]) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i) value = value << 8 | static_cast<std::uint8_t>(name[i]);
  return value;
}

enum class SectionType : std::uint32_t {
  camera = section_type("CAMR"),
  materials = section_type("MATL"),
  runs = section_type("RUNS"),
  spheres = section_type("SPHR"),
  sphere_materials = section_type("SPHM"),
  xy_rectangles = section_type("XYRC"),
  xz_rectangles = section_type("XZRC"),
  yz_rectangles = section_type("YZRC"),
  xy_rectangle_materials = section_type("XYRM"),
  xz_rectangle_materials = section_type("XZRM"),
  yz_rectangle_materials = section_type("YZRM"),
  positions = section_type("POSN"),
  normals = section_type("NRML"),
  tangents = section_type("TANG"),
  uvs0 = section_type("UVS0"),
  uvs1 = section_type("UVS1"),
  colours = section_type("COLR"),
  triangles = section_type("TRIS"),
  triangle_materials = section_type("TRIM"),
  cylinders = section_type("CYLN"),
  cylinder_materials = section_type("CYLM"),
  prototypes = section_type("PROT"),
  instances = section_type("INST"),
  layered_materials = section_type("LAYR"),
  textures = section_type("TXTR"),
  images = section_type("IMGS"),
  texels = section_type("TXEL"),
  lights = section_type("LGHT"),
  environment = section_type("ENVR"),
  cameras = section_type("CAMS"),
  orthographic = section_type("ORTH"),
  film = section_type("FILM"),
  camera_aspects = section_type("ASPC"),
  bvh_nodes = section_type("BVHN"),
  bvh_leaves = section_type("BVHL"),
};

// A reader that does not know a critical section refuses the file; one that is not critical it
// skips.
inline constexpr std::uint32_t kSectionCritical = 1;

inline constexpr std::uint32_t kSectionAlignment = 64;
inline constexpr std::uint32_t kMaxSectionAlignment = 1u << 21;
inline constexpr std::uint32_t kMaxSectionCount = 256;

// In the order of offsets. A section without elements is left out by the writer.
struct SectionEntry {
  std::uint32_t type;
  std::uint32_t flags;
  std::uint64_t offset;  // from the start of the file: the end before it, rounded up to alignment
  std::uint64_t size;    // bytes: count times stride
  std::uint64_t count;
  std::uint32_t stride;
  std::uint32_t alignment;    // a power of two, kSectionAlignment to kMaxSectionAlignment
  std::uint64_t hash;         // see kHashChunk
  std::uint64_t reserved[2];  // zero
};
static_assert(sizeof(SectionEntry) == 64 && offsetof(SectionEntry, offset) == 8 &&
              offsetof(SectionEntry, stride) == 32 && offsetof(SectionEntry, hash) == 40);

// A section's hash is the XXH3-64 of the little-endian XXH3-64s of its pieces of this size (the
// last one may be shorter), so that many threads can compute it and a writer can stream.
inline constexpr std::size_t kHashChunk = std::size_t{1} << 20;

// What the camera's picture is as high as, when it is not in perspective, is in a section of its
// own.
struct CameraRecord {
  double look_from[3];
  double look_at[3];
  double up[3];
  double vertical_fov;  // degrees
  double aperture;
  double focus_distance;
};
static_assert(sizeof(CameraRecord) == 96);

// Tag is the index in Material. Numbers, the unused ones +0.0:
//   0 lambertian  albedo[3]
//   1 metal       albedo[3] fuzz
//   2 dielectric  ref_idx
//   3 layered     index
struct MaterialRecord {
  std::uint32_t tag;
  std::uint32_t reserved;  // zero
  double numbers[4];
};
static_assert(sizeof(MaterialRecord) == 40);

// ObjectRun as it stands in memory, its padding zero.
struct RunRecord {
  std::uint32_t kind;
  std::uint32_t reserved;  // zero
  std::uint64_t count;
};
static_assert(sizeof(RunRecord) == 16);

// The size in pixels that a picture has unless another is asked for.
struct FilmRecord {
  std::uint32_t width;
  std::uint32_t height;
};
static_assert(sizeof(FilmRecord) == 8);

constexpr std::uint64_t align_up(std::uint64_t value, std::uint64_t alignment) {
  return (value + alignment - 1) & ~(alignment - 1);
}

}  // namespace dapple
