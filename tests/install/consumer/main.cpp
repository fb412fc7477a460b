// The same interface from C++: loads the scene argv[1] and looks at it.
#include <dapple/scene_io.h>

#include <memory>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::unique_ptr<loaded_scene, decltype(&free_loaded_scene)> scene(load_scene(argv[1]),
                                                                          &free_loaded_scene);
  return scene != nullptr && scene_get_num_objects(scene.get()) == 2 ? 0 : 1;
}
