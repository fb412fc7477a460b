/*
 * Storing and loading scenes from C99 and C++.
 *
 *     struct material matt = {.type = LAMBERTIAN, .lambertian = {{0.8, 0.8, 0.8}}};
 *     struct object ball = {.type = SPHERE, .sphere = {{0, 1, 0}, 1, &matt}};
 *     struct vec from = {0, 3, 3}, at = {0, 0, 0};
 *     if (store_scene("ball.scene", 1, &ball, from, at) != 0) puts(scene_io_last_error());
 *
 * Lengths are in the scene's own unit, y is up, colours are linear and usually in [0, 1].
 * Coordinates must be finite and at most 1e18 in magnitude, all other numbers finite.
 *
 * Nothing here prints, exits or throws. Different scenes may be used by different threads at once.
 */
#ifndef DAPPLE_SCENE_IO_H
#define DAPPLE_SCENE_IO_H

#include <stddef.h>

#include "dapple/version.h"

#ifdef __cplusplus
extern "C" {
#endif

struct vec {
  double x, y, z;
};

enum MATERIAL_TYPE { LAMBERTIAN, METAL, DIELECTRIC };

struct lambertian {
  struct vec albedo;
};

struct dielectric {
  double ref_idx; /* of the inside over the outside */
};

struct metal {
  struct vec albedo;
  double fuzz; /* 0 is a perfect mirror */
};

/* Anonymous unions are older than their place in the standard. */
#ifdef __GNUC__
#define DAPPLE_EXTENSION __extension__
#else
#define DAPPLE_EXTENSION
#endif

struct material {
  enum MATERIAL_TYPE type; /* says which member is meant */
  DAPPLE_EXTENSION union {
    struct lambertian lambertian;
    struct dielectric dielectric;
    struct metal metal;
  };
};

enum OBJECT_TYPE { SPHERE, XY_RECTANGLE, XZ_RECTANGLE, YZ_RECTANGLE };

struct sphere {
  struct vec centre;
  double radius; /* negative: inside out */
  struct material* material;
};

struct xy_rectangle {
  double x0, x1, y0, y1, k; /* k is its z */
  struct material* material;
};

struct xz_rectangle {
  double x0, x1, z0, z1, k; /* k is its y */
  struct material* material;
};

struct yz_rectangle {
  double y0, y1, z0, z1, k; /* k is its x */
  struct material* material;
};

struct object {
  enum OBJECT_TYPE type; /* says which member is meant */
  DAPPLE_EXTENSION union {
    struct sphere sphere;
    struct xy_rectangle xy_rectangle;
    struct xz_rectangle xz_rectangle;
    struct yz_rectangle yz_rectangle;
  };
};

/*
 * Writes a scene file. Each material that an object points at is stored once, however many objects
 * share the pointer; objects keep their order. The rest of the camera is that of the classic
 * scenes: up (0, 1, 0), 75 degrees, aperture 0.01, focus distance 10.
 *
 * `objects` may be NULL if there are none. All that is passed stays the caller's and is not kept.
 *
 * Returns 0 when the whole file is safely in place. Otherwise scene_io_last_error() has the reason,
 * and a file that was there before is still what it was.
 */
DAPPLE_API int store_scene(char* fname, size_t num_objects, struct object* objects,
                           struct vec lookfrom, struct vec lookat);

struct loaded_scene; /* opaque */

/*
 * Reads a scene file whole, checking all of it. A scene with anything that the structs above cannot
 * say, such as triangles or lights, is refused. Free the result with free_loaded_scene().
 * NULL on failure: scene_io_last_error() has the reason.
 */
DAPPLE_API struct loaded_scene* load_scene(const char* fname);

/*
 * What pointers point at belongs to the scene and lives as long as it does. The numbers may be
 * changed by the caller. Objects stand in stored order; those that shared a material when they were
 * stored share one again. With NULL for a scene the results are 0 and NULL.
 */
DAPPLE_API size_t scene_get_num_objects(struct loaded_scene* scene);
DAPPLE_API struct object* scene_get_objects(struct loaded_scene* scene);
DAPPLE_API struct vec* scene_get_lookfrom(struct loaded_scene* scene);
DAPPLE_API struct vec* scene_get_lookat(struct loaded_scene* scene);

/* NULL is fine. */
DAPPLE_API void free_loaded_scene(struct loaded_scene* scene);

/*
 * One line without a line end: why the last call of store_scene() or load_scene() on this thread
 * failed, or "" if it did not. Valid until the next such call on this thread.
 */
DAPPLE_API const char* scene_io_last_error(void);

#ifdef __cplusplus
}
#endif

#endif
