// What the parts of the C++ interface share. dapple::v0 is what users see as dapple, dapple:: is
// the library inside.
#pragma once

#define DAPPLE_API_NAMESPACE namespace v0
#include <exception>
#include <new>
#include <optional>

#include "dapple/dapple.hpp"
#include "scene_file/scene_source.h"
#include "util/error.h"

namespace dapple::v0 {

namespace lib = ::dapple;

inline Error to_error(const lib::Error& error) {
  return {static_cast<int>(error.code), lib::to_string(error)};
}
inline Error to_error(lib::Errc code, const char* message) {
  return {static_cast<int>(code), message};
}
inline Status to_status(const lib::Status& status) {
  return status ? Status() : Status(to_error(status.error()));
}

// Runs `call` and turns what it throws into what it would have returned.
template <class Call>
auto guarded(Call&& call) noexcept -> decltype(call()) {
  try {
    return call();
  } catch (const std::bad_alloc&) {
    return to_error(lib::Errc::memory, "out of memory");
  } catch (const std::exception& e) {
    return to_error(lib::Errc::internal, e.what());
  } catch (...) {
    return to_error(lib::Errc::internal, "unknown error");
  }
}

inline Vec3d to_vec3(const Point& p) { return {p.x, p.y, p.z}; }
inline Vec3d to_vec3(const Colour& c) { return {c.r, c.g, c.b}; }
inline Vec3f to_vec3f(const Colour& c) { return Vec3f(to_vec3(c)); }
inline Point to_point(const Vec3d& v) { return {v.x, v.y, v.z}; }

// A scene in memory, or what was opened and has not been changed since.
struct Scene::State {
  lib::Scene scene;
  std::optional<SceneSource> source;
  PictureShape pictures = {};  // what the file that was opened says, kept for saving

  SceneView view() const { return source ? source->view() : SceneView(scene); }
};

}  // namespace dapple::v0
