/* The C interface as a C99 program meets it. Exit code 0 when all of it holds. */
#include <dapple/scene_io.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failures = 0;

#define EXPECT(condition)                                                     \
  do {                                                                        \
    if (!(condition)) {                                                       \
      ++failures;                                                             \
      fprintf(stderr, "%s:%d: not so: %s\n", __FILE__, __LINE__, #condition); \
    }                                                                         \
  } while (0)

static const struct vec from = {0.1, 12, -3e-300};
static const struct vec at = {-0.0, 5e-324, 1e18};

static struct material grey, mirror, glass;
static struct object objects[6];

static void make_scene(void) {
  memset(objects, 0, sizeof objects);
  grey.type = LAMBERTIAN;
  grey.lambertian.albedo.x = 0.8;
  grey.lambertian.albedo.y = 0.1;
  grey.lambertian.albedo.z = 1.0 / 3;
  mirror.type = METAL;
  mirror.metal.albedo.y = 1;
  mirror.metal.fuzz = 0.9;
  glass.type = DIELECTRIC;
  glass.dielectric.ref_idx = 1.5;
  objects[0].type = YZ_RECTANGLE;
  objects[0].yz_rectangle = (struct yz_rectangle){-5, 0, -5, 5, -4, &mirror};
  objects[1].type = SPHERE;
  objects[1].sphere = (struct sphere){{4, 1.0 / 3, -6}, 2, &grey};
  objects[2].type = XY_RECTANGLE;
  objects[2].xy_rectangle = (struct xy_rectangle){-4, 4, -5, 0, -5, &mirror};
  objects[3].type = SPHERE;
  objects[3].sphere = (struct sphere){{1e18, -1e18, 5e-324}, -0.5, &glass};
  objects[4].type = XZ_RECTANGLE;
  objects[4].xz_rectangle = (struct xz_rectangle){1, 2, 3, 4, 5, &grey};
  objects[5].type = SPHERE;
  objects[5].sphere = (struct sphere){{0, 0, 0}, 1, &mirror};
}

static int same(const void* a, const void* b, size_t size) { return memcmp(a, b, size) == 0; }

static struct material* material_of(struct object* o) {
  switch (o->type) {
    case SPHERE:
      return o->sphere.material;
    case XY_RECTANGLE:
      return o->xy_rectangle.material;
    case XZ_RECTANGLE:
      return o->xz_rectangle.material;
    default:
      return o->yz_rectangle.material;
  }
}

static void test_round_trip(char* path) {
  struct loaded_scene* scene;
  struct object* loaded;
  size_t i, j;
  EXPECT(store_scene(path, 6, objects, from, at) == 0);
  EXPECT(strcmp(scene_io_last_error(), "") == 0);
  scene = load_scene(path);
  EXPECT(scene != NULL);
  if (scene == NULL) return;
  EXPECT(scene_get_num_objects(scene) == 6);
  EXPECT(same(scene_get_lookfrom(scene), &from, sizeof from));
  EXPECT(same(scene_get_lookat(scene), &at, sizeof at));
  loaded = scene_get_objects(scene);
  for (i = 0; i < 6; ++i) EXPECT(loaded[i].type == objects[i].type);
  EXPECT(same(&loaded[0].yz_rectangle, &objects[0].yz_rectangle, 5 * sizeof(double)));
  EXPECT(same(&loaded[1].sphere, &objects[1].sphere, 4 * sizeof(double)));
  EXPECT(same(&loaded[2].xy_rectangle, &objects[2].xy_rectangle, 5 * sizeof(double)));
  EXPECT(same(&loaded[3].sphere, &objects[3].sphere, 4 * sizeof(double)));
  EXPECT(same(&loaded[4].xz_rectangle, &objects[4].xz_rectangle, 5 * sizeof(double)));
  for (i = 0; i < 6; ++i) {
    for (j = 0; j < 6; ++j) {
      EXPECT((material_of(&loaded[i]) == material_of(&loaded[j])) ==
             (material_of(&objects[i]) == material_of(&objects[j])));
    }
  }
  EXPECT(loaded[0].yz_rectangle.material->type == METAL);
  EXPECT(same(&loaded[0].yz_rectangle.material->metal, &mirror.metal, sizeof mirror.metal));
  EXPECT(loaded[1].sphere.material->type == LAMBERTIAN);
  EXPECT(same(&loaded[1].sphere.material->lambertian, &grey.lambertian, sizeof grey.lambertian));
  EXPECT(loaded[3].sphere.material->type == DIELECTRIC);
  EXPECT(loaded[3].sphere.material->dielectric.ref_idx == 1.5);
  free_loaded_scene(scene);
}

static void test_no_objects(char* path) {
  struct loaded_scene* scene;
  EXPECT(store_scene(path, 0, NULL, from, at) == 0);
  scene = load_scene(path);
  EXPECT(scene != NULL);
  EXPECT(scene_get_num_objects(scene) == 0);
  free_loaded_scene(scene);
}

/* A refused call returns nonzero, has a reason, and leaves nothing at a path where nothing was. */
static void expect_refused(char* path, size_t count, struct object* os, struct vec f, struct vec t,
                           const char* reason) {
  FILE* file;
  remove(path);
  EXPECT(store_scene(path, count, os, f, t) != 0);
  EXPECT(strstr(scene_io_last_error(), reason) != NULL);
  file = fopen(path, "rb");
  EXPECT(file == NULL);
  if (file != NULL) fclose(file);
}

static void test_bad_scenes(char* path) {
  const struct vec nan_vec = {NAN, 0, 0};
  const struct vec far_vec = {0, 1.1e18, 0};
  expect_refused(path, 1, NULL, from, at, "NULL");
  expect_refused(path, 6, objects, nan_vec, at, "camera");
  expect_refused(path, 6, objects, from, far_vec, "camera");
  objects[3].sphere.radius = INFINITY;
  expect_refused(path, 6, objects, from, at, "object 3");
  make_scene();
  objects[0].yz_rectangle.k = NAN;
  expect_refused(path, 6, objects, from, at, "object 0");
  make_scene();
  objects[2].xy_rectangle.material = NULL;
  expect_refused(path, 6, objects, from, at, "object 2");
  make_scene();
  mirror.metal.fuzz = NAN;
  expect_refused(path, 6, objects, from, at, "material 0");
  make_scene();
  objects[5].type = (enum OBJECT_TYPE)77;
  expect_refused(path, 6, objects, from, at, "object 5");
  make_scene();
  glass.type = (enum MATERIAL_TYPE) - 1;
  expect_refused(path, 6, objects, from, at, "object 3");
  make_scene();
}

static void test_bad_paths(char* path) {
  char folder_missing[] = "no/such/folder/anywhere.scene";
  char folder[] = ".";
  char full[] = "/dev/full";
  char nothing[] = "";
  EXPECT(store_scene(NULL, 6, objects, from, at) != 0);
  EXPECT(store_scene(folder_missing, 6, objects, from, at) != 0);
  EXPECT(strstr(scene_io_last_error(), "no/such/folder") != NULL);
  EXPECT(store_scene(folder, 6, objects, from, at) != 0);
  EXPECT(store_scene(full, 6, objects, from, at) != 0);
  EXPECT(store_scene(nothing, 6, objects, from, at) != 0);
  EXPECT(load_scene(NULL) == NULL);
  EXPECT(load_scene(".") == NULL);
  EXPECT(load_scene("/dev/zero") == NULL);
  remove(path);
  EXPECT(load_scene(path) == NULL);
  EXPECT(strstr(scene_io_last_error(), path) != NULL);
}

static void test_nothing(void) {
  EXPECT(scene_get_num_objects(NULL) == 0);
  EXPECT(scene_get_objects(NULL) == NULL);
  EXPECT(scene_get_lookfrom(NULL) == NULL);
  EXPECT(scene_get_lookat(NULL) == NULL);
  free_loaded_scene(NULL);
}

/* A file that is there stays what it is when storing fails. */
static void test_failure_keeps_the_old_file(char* path) {
  struct loaded_scene* scene;
  EXPECT(store_scene(path, 2, objects, from, at) == 0);
  objects[1].sphere.radius = NAN;
  EXPECT(store_scene(path, 6, objects, from, at) != 0);
  make_scene();
  scene = load_scene(path);
  EXPECT(scene_get_num_objects(scene) == 2);
  free_loaded_scene(scene);
}

static void test_every_cut_is_refused(char* path) {
  static char bytes[1 << 16];
  size_t size, cut;
  FILE* file;
  EXPECT(store_scene(path, 6, objects, from, at) == 0);
  file = fopen(path, "rb");
  if (file == NULL) {
    EXPECT(file != NULL);
    return;
  }
  size = fread(bytes, 1, sizeof bytes, file);
  fclose(file);
  EXPECT(size > 64 && size < sizeof bytes);
  for (cut = 0; cut < size; cut += 37) {
    file = fopen(path, "wb");
    EXPECT(file != NULL && fwrite(bytes, 1, cut, file) == cut);
    if (file != NULL) fclose(file);
    EXPECT(load_scene(path) == NULL);
    EXPECT(strlen(scene_io_last_error()) > 0);
  }
}

int main(int argc, char** argv) {
  char default_path[] = "scene_io_c99_test.scene";
  char* path = argc > 1 ? argv[1] : default_path;
  make_scene();
  test_round_trip(path);
  test_no_objects(path);
  test_bad_scenes(path);
  test_bad_paths(path);
  test_nothing();
  test_failure_keeps_the_old_file(path);
  test_every_cut_is_refused(path);
  remove(path);
  if (failures == 0) puts("the C interface holds");
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
