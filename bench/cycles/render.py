"""Runs inside Blender: renders one job of race.py with Cycles on the processor."""
import json
import math
import sys

import numpy as np

# The glTF importer of Debian's Blender 3.4 is older than Debian's numpy.
for name, kind in (("bool", bool), ("int", int), ("float", float), ("object", object)):
    if name not in np.__dict__:
        setattr(np, name, kind)

import bpy  # noqa: E402

job = json.loads(sys.argv[sys.argv.index("--") + 1])
scenario, (width, height) = job["scenario"], job["size"]
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath=job["model"])
scene = bpy.context.scene

# The camera hangs on an empty at the target, so that the orbit is the empty's rotation.
target = bpy.data.objects.new("target", None)
scene.collection.objects.link(target)
at = scenario["target"]
target.location = (at["x"], -at["z"], at["y"])
orbit = scenario["orbit"]
target.rotation_euler = (math.radians(orbit["phi"]), 0, math.radians(orbit["theta"]))
camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
scene.collection.objects.link(camera)
camera.parent = target
radius = max(orbit["radius"], 1e-5)
camera.location = (0, 0, radius)
camera.data.lens_unit = "FOV"
aspect = width / height
vertical = math.radians(45)
camera.data.angle = 2 * math.atan(math.tan(vertical / 2) * aspect) if aspect > 1 else vertical
# What dapple sees: all there is, even where the orbit's radius is nearly nothing.
camera.data.clip_start, camera.data.clip_end = radius / 1000, max(radius, 1) * 1000
scene.camera = camera

world = bpy.data.worlds.new("world")
scene.world = world
world.use_nodes = True
nodes = world.node_tree.nodes
nodes.clear()
image = nodes.new("ShaderNodeTexEnvironment")
image.image = bpy.data.images.load(job["environment"])
background, output = nodes.new("ShaderNodeBackground"), nodes.new("ShaderNodeOutputWorld")
world.node_tree.links.new(image.outputs[0], background.inputs[0])
world.node_tree.links.new(background.outputs[0], output.inputs[0])

render = scene.render
render.engine = "CYCLES"
scene.cycles.samples, scene.cycles.seed = job["spp"], job["seed"]
scene.cycles.use_denoising = False
scene.cycles.use_adaptive_sampling = False
render.film_transparent = True
render.threads_mode, render.threads = "FIXED", job["threads"]
render.resolution_x, render.resolution_y, render.resolution_percentage = width, height, 100
render.image_settings.file_format = "OPEN_EXR" if job["output"].endswith(".exr") else "PNG"
if job["output"].endswith(".exr"):
    render.image_settings.color_depth = "32"
render.filepath = job["output"]
bpy.ops.render.render(write_still=True)
