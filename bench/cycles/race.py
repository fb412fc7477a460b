#!/usr/bin/env python3
"""Races dapple against Blender's Cycles on the scenarios of tools/references/compare.py.

    race.py SCENARIOS.json --models DIR [--dapple PATH] [--only NAME]... [--size 512] [--spp 16]
            [--threads 1] [--repeat 5] [--json FILE]

Both render the same model, environment, camera, size and samples, one after the other, repeatedly.
A row gives Blender's over dapple's medians: the whole command by the clock and by processor time, the
rendering alone by the clock, all samples but the first by processor time (which other load on the
machine changes least), peak memory. Needs `blender` (3.4, with python3-numpy) in /usr/bin.
"""
import argparse
import json
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent


def timed(command, **options):
    """Seconds by the clock, seconds of processor time, peak kilobytes, output."""
    with tempfile.TemporaryFile("w+") as output:
        start = time.monotonic()
        process = subprocess.Popen(command, stdout=output, stderr=subprocess.STDOUT, **options)
        _, status, usage = os.wait4(process.pid, 0)
        wall = time.monotonic() - start
        output.seek(0)
        text = output.read()
    if status != 0:
        raise RuntimeError(f"{command[0]} failed:\n{text[-2000:]}")
    return wall, usage.ru_utime + usage.ru_stime, usage.ru_maxrss, text


def run_dapple(scenario, size, arguments, folder, spp=None, seed=0, output="dapple.png"):
    orbit, at = scenario["orbit"], scenario["target"]
    command = [arguments.dapple, "render", str(arguments.models / scenario["local_model"]),
               "-o", f"{folder}/{output}", "--json", "--threads", str(arguments.threads),
               "--width", str(size[0]), "--height", str(size[1]), "--spp", str(spp or arguments.spp),
               "--seed", str(seed),
               f"--orbit={orbit['theta']},{orbit['phi']},{max(orbit['radius'], 1e-5)}",
               f"--target={at['x']},{at['y']},{at['z']}", "--fov", "45",
               "--environment", str(arguments.models / scenario["lighting"]), "--transparent"]
    wall, cpu, memory, text = timed(command)
    render = json.loads(text[text.index("{"):])["render_seconds"]
    return {"wall": wall, "cpu": cpu, "memory": memory, "render": render}


def seconds(stamp):
    minutes, rest = stamp.split(":")[-2:]
    return int(minutes) * 60 + float(rest)


def run_blender(scenario, size, arguments, folder, spp=None, seed=0, output="blender.png"):
    job = {"model": str(arguments.models / scenario["local_model"]),
           "environment": str(arguments.models / scenario["lighting"]), "scenario": scenario,
           "size": size, "spp": spp or arguments.spp, "seed": seed, "threads": arguments.threads,
           "output": f"{folder}/{output}"}
    command = ["/usr/bin/blender", "-b", "--factory-startup", "-P", str(HERE / "render.py"), "--",
               json.dumps(job)]
    wall, cpu, memory, text = timed(command, env={**os.environ, "PATH": "/usr/bin:/bin"})
    if not os.path.exists(job["output"]):
        raise RuntimeError("blender wrote no picture:\n" + text[-2000:])
    first = re.search(r"Time:([\d:.]+).*Sample 0/", text).group(1)
    last = re.findall(r"Time:([\d:.]+).*Finished", text)[-1]
    return {"wall": wall, "cpu": cpu, "memory": memory, "render": seconds(last) - seconds(first)}


def size_of(scenario, longest):
    d = scenario["dimensions"]
    scale = longest / max(d["width"], d["height"])
    return [round(d["width"] * scale), round(d["height"] * scale)]


def chosen(arguments):
    for scenario in json.loads(arguments.scenarios.read_text()):
        name = scenario["name"]
        if not arguments.only or any(name.endswith(only) for only in arguments.only):
            yield scenario


def parser_of(description, size, threads):
    """What every comparison asks for: scenarios and how to render them."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("scenarios", type=pathlib.Path)
    parser.add_argument("--models", type=pathlib.Path, required=True)
    parser.add_argument("--dapple", default="dapple")
    parser.add_argument("--only", action="append", default=[])
    parser.add_argument("--size", type=int, default=size)
    parser.add_argument("--threads", type=int, default=threads)
    parser.add_argument("--json", type=pathlib.Path)
    return parser


def main():
    parser = parser_of(__doc__.split("\n")[0], size=512, threads=1)
    parser.add_argument("--spp", type=int, default=16)
    parser.add_argument("--repeat", type=int, default=5)
    arguments = parser.parse_args()
    results = []
    print("scenario                       whole   cpu  render samples  memory   (Blender / dapple)")
    for scenario in chosen(arguments):
        name, size = scenario["name"], size_of(scenario, arguments.size)
        runs = {"dapple": [], "blender": []}
        with tempfile.TemporaryDirectory() as folder:
            for _ in range(arguments.repeat):
                for who, run in (("dapple", run_dapple), ("blender", run_blender)):
                    result = run(scenario, size, arguments, folder)
                    least = run(scenario, size, arguments, folder, 1)
                    result["samples_cpu"] = result["cpu"] - least["cpu"]
                    runs[who].append(result)
        median = {who: {key: statistics.median(run[key] for run in list_) for key in list_[0]}
                  for who, list_ in runs.items()}
        ratio = {key: median["blender"][key] / median["dapple"][key] for key in median["dapple"]}
        print(f"{name:29}{ratio['wall']:7.1f}{ratio['cpu']:6.1f}{ratio['render']:8.1f}"
              f"{ratio['samples_cpu']:8.1f}{ratio['memory']:8.1f}   dapple {median['dapple']['wall']:.2f} s, rendering "
              f"{median['dapple']['render']:.2f} s, {median['dapple']['memory'] / 1024:.0f} MB",
              flush=True)
        results.append({"name": name, "size": size, "spp": arguments.spp,
                        "threads": arguments.threads, "runs": runs, "ratio": ratio})
    if arguments.json:
        arguments.json.write_text(json.dumps(results, indent=1))
    return 0


if __name__ == "__main__":
    sys.exit(main())
