// What is compared: structures that find hits, and the ways of asking them.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "accel/hit.h"
#include "math/ray.h"
#include "scene/scene_view.h"

namespace dapple::bench {

enum class Query { closest, any };

// What one ray found; for Query::any only whether `prim` is kNoPrim says something.
struct Found {
  float t = 0;
  PrimId prim = kNoPrim;
  bool hit() const { return prim != kNoPrim; }
};

// Rays are handed to every structure in pieces of this many, as a renderer that works through
// tiles would: what is in flight stays in the second-level cache.
inline constexpr std::size_t kRaysPerPiece = 4096;

// One way of tracing one set of rays, which lie ready in whatever layout that way wants.
class Tracer {
 public:
  virtual ~Tracer() = default;
  virtual std::string name() const = 0;
  // Lays the rays ready and forgets the hits; not measured. Must come before trace().
  virtual void reset() = 0;
  // Finds all hits, on as many threads as parallel loops use now.
  virtual void trace() = 0;
  virtual std::vector<Found> found() const = 0;
};

// Something that builds a structure over a scene.
class Contender {
 public:
  virtual ~Contender() = default;
  virtual std::string name() const = 0;
  // Builds on as many threads as parallel loops use now.
  virtual void build(const SceneView& scene) = 0;
  virtual void discard() = 0;
  // Of the finished structure with the shapes in it, in bytes.
  virtual std::size_t bytes() const = 0;
  // Of the finished structure; 0 where it is not known.
  virtual double sah_cost() const = 0;
  // All ways worth comparing; the rays must outlive them.
  virtual std::vector<std::unique_ptr<Tracer>> tracers(std::span<const Ray> rays,
                                                       Query query) const = 0;
};

// The first way of tracing the rays, once.
[[nodiscard]] std::vector<Found> trace_once(const Contender& contender, std::span<const Ray> rays,
                                            Query query);

}  // namespace dapple::bench
