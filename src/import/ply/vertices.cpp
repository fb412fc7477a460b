#include "import/ply/vertices.h"

#include <array>
#include <optional>

#include "image/transfer.h"
#include "import/text.h"

namespace dapple::ply {
namespace {

// What a property may be; the order is that of a row below.
enum Slot : std::size_t { x, y, z, nx, ny, nz, u, v, red, green, blue, alpha, radius, slot_count };

struct SlotName {
  std::string_view name;
  Slot slot;
};
constexpr SlotName kSlotNames[] = {
    {"x", x},
    {"y", y},
    {"z", z},
    {"nx", nx},
    {"ny", ny},
    {"nz", nz},
    {"u", u},
    {"v", v},
    {"s", u},
    {"t", v},
    {"texture_u", u},
    {"texture_v", v},
    {"red", red},
    {"green", green},
    {"blue", blue},
    {"diffuse_red", red},
    {"diffuse_green", green},
    {"diffuse_blue", blue},
    {"r", red},
    {"g", green},
    {"b", blue},
    {"alpha", alpha},
    {"a", alpha},
    {"radius", radius},
};

std::optional<Slot> slot_of(const Property& property) {
  if (property.is_list) return std::nullopt;
  for (const SlotName& known : kSlotNames) {
    if (known.name == property.name) return known.slot;
  }
  return std::nullopt;
}

bool is_real(Type type) { return type == Type::f32 || type == Type::f64; }

double largest(Type type) {
  return bytes_of(type) == 1 ? 255 : bytes_of(type) == 2 ? 65535 : 4294967295.0;
}

class VertexParser {
 public:
  VertexParser(const Element& element, Model& model) : element_(element), model_(model) {
    has_.fill(false);
    type_of_.fill(Type::f32);
    for (const Property& property : element.properties) {
      slots_.push_back(slot_of(property));
      if (slots_.back()) {
        has_[*slots_.back()] = true;
        type_of_[*slots_.back()] = property.type;
      } else {
        model.ignored.push_back("vertex property " + property.name);
      }
    }
  }

  bool has_positions() const { return has_[x] && has_[y] && has_[z]; }

  Status parse(ValueReader& values) {
    reserve();
    for (std::uint64_t i = 0; i < element_.count; ++i) {
      read_row(values);
      if (values.bad()) return values.error();
      add_row();
    }
    return {};
  }

 private:
  bool has_normals() const { return has_[nx] && has_[ny] && has_[nz]; }
  bool has_uvs() const { return has_[u] && has_[v]; }
  bool has_colours() const { return has_[red] && has_[green] && has_[blue]; }

  void reserve() {
    Vertices& vertices = model_.mesh.vertices;
    vertices.positions.reserve(element_.count);
    if (has_normals()) vertices.normals.reserve(element_.count);
    if (has_uvs()) vertices.uvs[0].reserve(element_.count);
    if (has_colours()) vertices.colours.reserve(element_.count);
  }

  void read_row(ValueReader& values) {
    for (std::size_t i = 0; i < slots_.size(); ++i) {
      if (slots_[i]) {
        row_[*slots_[i]] = values.next(element_.properties[i].type);
      } else {
        values.skip(element_.properties[i]);
      }
    }
  }

  // Integers are display values over their whole range, reals are linear. An ascii file may say
  // anything where an unsigned byte is declared.
  float colour(Slot slot) const {
    if (is_real(type_of_[slot])) return to_float(row_[slot]);
    if (bytes_of(type_of_[slot]) == 1)
      return srgb_[static_cast<std::size_t>(clamped(slot) * 255 + 0.5)];
    return to_float(decode_display(clamped(slot), Transfer::srgb));
  }
  double clamped(Slot slot) const {
    const double value = row_[slot] / largest(type_of_[slot]);
    return value > 0 ? (value < 1 ? value : 1) : 0;
  }
  float opacity() const {
    if (!has_[alpha]) return 1;
    return is_real(type_of_[alpha]) ? to_float(row_[alpha]) : to_float(clamped(alpha));
  }

  void add_row() {
    Vertices& vertices = model_.mesh.vertices;
    vertices.positions.push_back(vec(x));
    if (has_normals()) vertices.normals.push_back(unit_or_zero(vec(nx)));
    // The file's v grows upwards.
    if (has_uvs()) vertices.uvs[0].push_back({to_float(row_[u]), to_float(1 - row_[v])});
    if (has_colours()) {
      vertices.colours.push_back({colour(red), colour(green), colour(blue), opacity()});
    }
    if (has_[radius]) model_.radii.push_back(to_float(row_[radius]));
  }

  Vec3f vec(Slot first) const {
    return {to_float(row_[first]), to_float(row_[first + 1]), to_float(row_[first + 2])};
  }

  static Vec3f unit_or_zero(const Vec3f& n) {
    const float size = length(n);
    return size > 0 && std::isfinite(size) ? n / size : Vec3f();
  }

  const Element& element_;
  Model& model_;
  std::vector<std::optional<Slot>> slots_;
  std::array<bool, slot_count> has_;
  std::array<Type, slot_count> type_of_;
  std::array<double, slot_count> row_{};
  std::vector<float> srgb_ = decode_table(255, Transfer::srgb);
};

}  // namespace

Status read_vertices(ValueReader& values, const Element& element, Model& model) {
  VertexParser parser(element, model);
  if (!parser.has_positions()) return values.error("the vertices have no x, y and z");
  return parser.parse(values);
}

}  // namespace dapple::ply
