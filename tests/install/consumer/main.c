/* Stores two spheres that share a material in argv[1], loads them again and compares. */
#include <dapple/scene_io.h>
#include <stdio.h>

static int same(struct vec a, struct vec b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

int main(int argc, char** argv) {
  struct material glass;
  struct object spheres[2];
  struct vec from = {0, 2, 3}, at = {0.1, 0, 0};
  struct loaded_scene* scene;
  struct object* loaded;
  int i;
  if (argc != 2) return 2;
  glass.type = DIELECTRIC;
  glass.dielectric.ref_idx = 1.5;
  for (i = 0; i < 2; ++i) {
    struct vec centre = {0, 0, 0};
    centre.x = i / 3.0;
    spheres[i].type = SPHERE;
    spheres[i].sphere.centre = centre;
    spheres[i].sphere.radius = 0.1;
    spheres[i].sphere.material = &glass;
  }
  if (store_scene(argv[1], 2, spheres, from, at) != 0 || !(scene = load_scene(argv[1]))) {
    fprintf(stderr, "%s\n", scene_io_last_error());
    return 1;
  }
  if (scene_get_num_objects(scene) != 2) return 3;
  if (!same(*scene_get_lookfrom(scene), from) || !same(*scene_get_lookat(scene), at)) return 4;
  loaded = scene_get_objects(scene);
  for (i = 0; i < 2; ++i) {
    if (loaded[i].type != SPHERE || loaded[i].sphere.radius != 0.1) return 5;
    if (!same(loaded[i].sphere.centre, spheres[i].sphere.centre)) return 6;
    if (loaded[i].sphere.material->dielectric.ref_idx != 1.5) return 7;
  }
  if (loaded[0].sphere.material != loaded[1].sphere.material) return 8;
  free_loaded_scene(scene);
  if (load_scene("no/such/file") != NULL || scene_io_last_error()[0] == '\0') return 9;
  return 0;
}
