// Both interfaces from C++: the scene argv[1] holds two spheres; a picture of it has pixels.
#include <dapple/scene_io.h>

#include <dapple/dapple.hpp>
#include <memory>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::unique_ptr<loaded_scene, decltype(&free_loaded_scene)> stored(load_scene(argv[1]),
                                                                           &free_loaded_scene);
  if (stored == nullptr || scene_get_num_objects(stored.get()) != 2) return 3;
  const auto scene = dapple::Scene::open(argv[1]);
  if (!scene) return 4;
  const auto accelerator = dapple::Accelerator::build(*scene);
  if (!accelerator) return 5;
  const auto picture = dapple::render(*accelerator, {.width = 4, .height = 3});
  return picture && picture->save("from_cpp.png") ? 0 : 6;
}
