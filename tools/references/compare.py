#!/usr/bin/env python3
"""Renders scenarios with dapple and compares them with reference pictures.

    compare.py SCENARIOS.json --models DIR --references DIR [--dapple PATH] [--only NAME]...
               [--spp N] [--out DIR] [-- RENDER-OPTION...]

SCENARIOS.json is a list of scenarios as model viewers use for fidelity tests: model, lighting,
dimensions, target, orbit (degrees), renderSkybox. Each is rendered to OUT/NAME.exr unless that file
is newer than dapple, compared after ACES tone mapping and a blur of 5 x 5 pixels, and shown on
OUT/sheet-N.png as ours | reference | difference times four. A line for each says the mean absolute
difference of colour and of alpha; the exit code is 1 if one is above the limits.

Needs Python packages numpy, pillow and OpenEXR.
"""
import argparse
import json
import math
import pathlib
import subprocess
import sys

import numpy as np
import OpenEXR
from PIL import Image, ImageDraw

COLOUR_LIMIT, ALPHA_LIMIT = 0.03, 0.002


def read_exr(path):
    """RGBA as float32, alpha 1 where the file has none; colours multiplied by alpha."""
    with OpenEXR.File(str(path), separate_channels=True) as file:
        channels = file.channels()
        planes = [channels[c].pixels.astype(np.float32) for c in "RGB"]
        alpha = channels["A"].pixels if "A" in channels else np.ones_like(planes[0])
    return np.stack(planes + [alpha.astype(np.float32)], axis=-1)


def aces(rgb):
    """Hill's fit of the ACES transforms, then sRGB."""
    to_aces = np.array([[0.59719, 0.35458, 0.04823], [0.07600, 0.90834, 0.01566],
                        [0.02840, 0.13383, 0.83777]])
    from_aces = np.array([[1.60475, -0.53108, -0.07367], [-0.10208, 1.10813, -0.00605],
                          [-0.00327, -0.07276, 1.07602]])
    v = np.maximum(np.nan_to_num(rgb), 0) / 0.6 @ to_aces.T
    v = (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081)
    v = np.clip(v @ from_aces.T, 0, 1)
    return np.where(v <= 0.0031308, 12.92 * v, 1.055 * v ** (1 / 2.4) - 0.055)


def displayed(rgba):
    """Tone mapped colours, multiplied by alpha again, and alpha."""
    alpha = rgba[..., 3:]
    plain = np.divide(rgba[..., :3], alpha, out=np.zeros_like(rgba[..., :3]), where=alpha > 0)
    return np.concatenate([aces(plain) * alpha, alpha], axis=-1)


def blur(picture, radius=2):
    for axis in (0, 1):
        pad = [(0, 0)] * 3
        pad[axis] = (radius, radius)
        padded = np.pad(picture, pad, mode="edge")
        size = picture.shape[axis]
        picture = sum(np.take(padded, range(i, i + size), axis=axis)
                      for i in range(2 * radius + 1)) / (2 * radius + 1)
    return picture


def half_size(picture):
    h, w = picture.shape[0] // 2 * 2, picture.shape[1] // 2 * 2
    p = picture[:h, :w]
    return (p[::2, ::2] + p[1::2, ::2] + p[::2, 1::2] + p[1::2, 1::2]) / 4


def vertical_fov(scenario, size):
    """The references' cameras have the horizontal field of view of the exact aspect ratio, which
    their whole numbers of pixels miss a little."""
    fov = scenario.get("verticalFoV", 45)
    aspect = scenario["dimensions"]["width"] / scenario["dimensions"]["height"]
    if aspect <= 1:
        return fov
    stretch = aspect / (size[0] / size[1])
    return math.degrees(2 * math.atan(math.tan(math.radians(fov) / 2) * stretch))


def is_animated(path):
    """The references show the first frame of animations, at 1/24 s, but skins as they were bound."""
    data = path.read_bytes()
    if data[:4] == b"glTF":
        data = data[20:20 + int.from_bytes(data[12:16], "little")]
    model = json.loads(data)
    return bool(model.get("animations")) and not model.get("skins")


def render(scenario, size, target, arguments):
    model = arguments.models / scenario["local_model"]
    orbit, at = scenario["orbit"], scenario["target"]
    command = [arguments.dapple, "render", str(model), "-o", str(target), "--exr-type", "float", "--quiet",
               "--width", str(size[0]), "--height", str(size[1]), "--spp", str(arguments.spp),
               f"--orbit={orbit['theta']},{orbit['phi']},{max(orbit['radius'], 1e-5)}",
               f"--target={at['x']},{at['y']},{at['z']}",
               "--fov", str(vertical_fov(scenario, size)),
               "--environment", str(arguments.models / scenario["lighting"]),
               "--clamp-indirect", "10"]
    if is_animated(model):
        command += ["--time", str(1 / 24)]
    if not scenario.get("renderSkybox"):
        command.append("--transparent")
    return subprocess.run(command + arguments.extra).returncode == 0


def panel(name, ours, reference, colour, alpha):
    """One row of the sheet: ours, reference, difference."""
    background = 0.5
    def opaque(p):
        return p[..., :3] + background * (1 - p[..., 3:])
    difference = np.clip(np.abs(ours - reference)[..., :3] * 4, 0, 1)
    row = np.concatenate([opaque(ours), opaque(reference), difference], axis=1)
    image = Image.fromarray((np.clip(row, 0, 1) * 255 + 0.5).astype(np.uint8))
    image.thumbnail((1200, 320))
    ImageDraw.Draw(image).text((4, 4), f"{name}: {colour:.4f}, alpha {alpha:.5f}",
                               fill=(255, 255, 0))
    return image


def save_sheets(panels, folder, rows=8):
    for number, begin in enumerate(range(0, len(panels), rows)):
        part = panels[begin:begin + rows]
        sheet = Image.new("RGB", (max(p.width for p in part), sum(p.height for p in part)))
        y = 0
        for image in part:
            sheet.paste(image, (0, y))
            y += image.height
        sheet.save(folder / f"sheet-{number}.png")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("scenarios", type=pathlib.Path)
    parser.add_argument("--models", type=pathlib.Path, required=True)
    parser.add_argument("--references", type=pathlib.Path, required=True)
    parser.add_argument("--dapple", default="dapple")
    parser.add_argument("--only", action="append", default=[])
    parser.add_argument("--spp", type=int, default=64)
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("references"))
    parser.epilog = "Further options of dapple render follow --."
    own = sys.argv[1:]
    split = own.index("--") if "--" in own else len(own)
    arguments = parser.parse_args(own[:split])
    arguments.extra = own[split + 1:]
    arguments.out.mkdir(parents=True, exist_ok=True)
    panels, failures = [], 0
    for scenario in json.loads(arguments.scenarios.read_text()):
        name = scenario["name"]
        if arguments.only and not any(only in name for only in arguments.only):
            continue
        reference = read_exr(arguments.references / f"{name}.exr")
        target = arguments.out / f"{name}.exr"
        fresh = target.exists() and target.stat().st_mtime > pathlib.Path(
            arguments.dapple).stat().st_mtime
        if not fresh and not render(scenario, reference.shape[1::-1], target, arguments):
            print(f"FAILED {name}: not rendered")
            failures += 1
            continue
        ours, theirs = displayed(read_exr(target)), displayed(reference)
        difference = np.abs(blur(ours) - blur(theirs))
        colour, alpha = difference[..., :3].mean(), difference[..., 3].mean()
        good = colour <= COLOUR_LIMIT and alpha <= ALPHA_LIMIT
        failures += not good
        print(f"{'ok    ' if good else 'BEYOND'} {colour:.4f} {alpha:.5f} {name}", flush=True)
        panels.append(panel(name, half_size(ours), half_size(theirs), colour, alpha))
    save_sheets(panels, arguments.out)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
