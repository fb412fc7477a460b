#!/usr/bin/env python3
"""How long dapple and Blender's Cycles take to the same error, on the scenarios of race.py.

    equal_error.py SCENARIOS.json --models DIR [--dapple PATH] [--only NAME]... [--size 256]
                   [--reference-spp 1024] [--threads 2] [--json FILE]

Each renderer is held to a converged picture of its own, with other random numbers: what the two
take a material to be may differ, how fast their noise goes does not depend on it. The error is the
root mean square over the pixels of values as they are seen: clipped to 1, gamma 2.2. Between the
numbers of samples that are rendered time is interpolated by powers. Printed is Blender's time over
dapple's to the error that Blender has at 16 samples, for the rendering alone and for the command.
Needs what race.py needs, and the Python packages numpy and OpenEXR.
"""
import json
import tempfile

import numpy as np
import OpenEXR

import race

SAMPLES = (4, 8, 16, 32, 64)


def seen(path):
    with OpenEXR.File(str(path), separate_channels=True) as file:
        channels = file.channels()
        planes = [channels[c].pixels.astype(np.float64) for c in "RGB"]
    return np.clip(np.stack(planes, axis=-1), 0, 1) ** (1 / 2.2)


def measure(run, scenario, size, arguments, folder, name):
    """Error, seconds of rendering and seconds of the command for each number of samples."""
    run(scenario, size, arguments, folder, arguments.reference_spp, 1, f"{name}-reference.exr")
    reference = seen(f"{folder}/{name}-reference.exr")
    points = []
    for spp in SAMPLES:
        result = run(scenario, size, arguments, folder, spp, 0, f"{name}.exr")
        error = np.sqrt(np.mean((seen(f"{folder}/{name}.exr") - reference) ** 2))
        points.append({"spp": spp, "error": float(error), "render": result["render"],
                       "wall": result["wall"]})
    return points


def time_to(error, points, key):
    """Interpolated between, and beyond the ends extrapolated from, the logarithms."""
    x = np.log([point["error"] for point in points])
    y = np.log([point[key] for point in points])
    at = np.log(error)
    order = np.argsort(x)
    x, y = x[order], y[order]
    i = int(np.clip(np.searchsorted(x, at) - 1, 0, len(x) - 2))
    return float(np.exp(y[i] + (at - x[i]) * (y[i + 1] - y[i]) / (x[i + 1] - x[i])))


def main():
    parser = race.parser_of(__doc__.split("\n")[0], size=256, threads=2)
    parser.add_argument("--reference-spp", type=int, default=1024)
    arguments = parser.parse_args()
    arguments.spp = None
    results = []
    print("scenario                     rendering  command   (Blender / dapple, to equal error)")
    for scenario in race.chosen(arguments):
        size = race.size_of(scenario, arguments.size)
        with tempfile.TemporaryDirectory() as folder:
            ours = measure(race.run_dapple, scenario, size, arguments, folder, "dapple")
            theirs = measure(race.run_blender, scenario, size, arguments, folder, "blender")
        error = theirs[SAMPLES.index(16)]["error"]
        ratio = {key: time_to(error, theirs, key) / time_to(error, ours, key)
                 for key in ("render", "wall")}
        at_16 = ours[SAMPLES.index(16)]["error"]
        print(f"{scenario['name']:29}{ratio['render']:9.1f}{ratio['wall']:9.1f}   error at 16 "
              f"samples: {error:.4f}, dapple {at_16:.4f}", flush=True)
        results.append({"name": scenario["name"], "size": size, "dapple": ours, "blender": theirs,
                        "ratio": ratio})
    if arguments.json:
        arguments.json.write_text(json.dumps(results, indent=1))


if __name__ == "__main__":
    main()
