#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""CPU time and memory of the complex eigenvalue analysis over the number of
unknowns, with the factors in memory and on disk: the ventilated brake with
elements of second degree on four meshes, all its pairs from 0.9 to 8 kHz.

usage: /usr/bin/python3 doc/benchmarks/sizes.py [--squeal PROGRAM] [--picture]
           [--sizes 50 150 400 1000] [--paths direct "out of core"]

Prints a table with the exponents of a power law through the points, and writes
it to output/benchmarks/sizes.csv; --picture draws doc/pictures/sizes.png.
"""
import argparse
import csv
import json
import math
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = ROOT / "output" / "benchmarks"
SCENE = ROOT / "prm" / "benchmarks" / "million.prm"
# Thousand unknowns: mesh file and uniform refinements.
MESHES = {
    50: ("../ventilated_brake/graded.msh", 0),
    150: ("million.msh", 0),
    400: ("../ventilated_brake/graded.msh", 1),
    1000: ("million.msh", 1),
}
STAGES = {
    "factor": ["Solve: factorisation"],
    "modes": ["Solve: undamped modes"],
    "pairs": ["Solve: certified eigenvalues"],
}


def run(program, size, path):
    mesh, refinements = MESHES[size]
    folder = FOLDER / f"sizes_{size}_{path.replace(' ', '_')}"
    settings = {
        "Output directory": folder,
        "Discretization/Refinement": "uniform" if refinements else "none",
        "Discretization/Refinements": refinements,
        "Eigenvalues/Linear solver": path,
        "Output/Shapes": "none",
        "Output/Plots": "false",
    }
    for body in ("disc", "pad_lower", "pad_upper"):
        settings[f"Scene/Body {body}/Mesh file"] = (SCENE.parent / mesh).resolve()
    command = [program, "--quiet", str(SCENE)]
    for name, value in settings.items():
        command += ["--set", f"{name} = {value}"]
    result = subprocess.run(command, capture_output=True, text=True)
    if result.returncode != 0:
        text = f"{size} thousand unknowns, {path}: {result.stderr.strip()}"
        if "GB" in result.stderr:
            print(text)  # more than this machine has, refused before any work
            return None
        raise SystemExit(text)
    with open(folder / "run.json", encoding="utf-8") as file:
        record = json.load(file)
    with open(folder / "eigenvalues.csv", encoding="utf-8") as file:
        rows = [line for line in file if not line.startswith("#")]
    pairs = list(csv.DictReader(rows))
    loudest = max(pairs, key=lambda pair: float(pair["sigma_per_s"]))
    own = {entry["section"]: entry["own_cpu_s"] for entry in record["timings"]}
    row = {
        "path": path,
        "unknowns": record["dofs"],
        "cpu_s": record["cpu_s"],
        "wall_s": record["wall_s"],
        "memory_gb": record["peak_memory_mb"] / 1000,
    }
    for stage, names in STAGES.items():
        row[stage + "_cpu_s"] = sum(own.get(name, 0.0) for name in names)
    row["pairs"] = len(pairs)
    row["frequency_hz"] = float(loudest["frequency_hz"])
    row["sigma_per_s"] = float(loudest["sigma_per_s"])
    return row


def exponent(rows, column):
    """Of the power law through the points by least squares."""
    x = [math.log(row["unknowns"]) for row in rows]
    y = [math.log(row[column]) for row in rows]
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    return (sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) /
            sum((a - mean_x) ** 2 for a in x))


def print_table(rows):
    columns = ["path", "unknowns", "cpu_s", "factor_cpu_s", "modes_cpu_s",
               "pairs_cpu_s", "memory_gb", "frequency_hz", "sigma_per_s"]
    print("| " + " | ".join(columns) + " |")
    for row in rows:
        print("| " + " | ".join(
            f"{row[c]:.4g}" if isinstance(row[c], float) else str(row[c])
            for c in columns) + " |")
    for path in dict.fromkeys(row["path"] for row in rows):
        own = [row for row in rows if row["path"] == path]
        if len(own) > 1:
            print(f"{path}: CPU time ~ N^{exponent(own, 'cpu_s'):.2f}, "
                  f"memory ~ N^{exponent(own, 'memory_gb'):.2f}")


def draw(rows):
    data = "\n\n\n".join(
        "\n".join(f"{row['unknowns'] / 1000} {row['cpu_s']} {row['memory_gb']}"
                  for row in rows if row["path"] == path)
        for path in ("direct", "out of core"))
    script = f"""
set terminal pngcairo size 1200,480 font "DejaVu Sans,12" linewidth 1.5
set output "{ROOT / 'doc' / 'pictures' / 'sizes.png'}"
$data << EOD
{data}
EOD
set multiplot layout 1,2
set logscale xy
set xlabel "thousand unknowns"
set xrange [40:1500]
set key left top
set grid
set ylabel "CPU time in s"
plot $data index 0 using 1:2 with linespoints pt 7 title "factors in memory", \\
     $data index 1 using 1:2 with linespoints pt 5 title "factors on disk"
set ylabel "peak memory in GB"
plot $data index 0 using 1:3 with linespoints pt 7 title "factors in memory", \\
     $data index 1 using 1:3 with linespoints pt 5 title "factors on disk"
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--squeal", default=str(ROOT / "build" / "squeal"))
    parser.add_argument("--sizes", type=int, nargs="+", choices=MESHES,
                        default=list(MESHES))
    parser.add_argument("--paths", nargs="+", choices=["direct", "out of core"],
                        default=["direct", "out of core"])
    parser.add_argument("--picture", action="store_true")
    options = parser.parse_args()
    rows = []
    for path in options.paths:
        for size in options.sizes:
            row = run(options.squeal, size, path)
            if row:
                rows.append(row)
                print(f"{row}", flush=True)
    FOLDER.mkdir(parents=True, exist_ok=True)
    with open(FOLDER / "sizes.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, fieldnames=rows[0])
        writer.writeheader()
        writer.writerows(rows)
    print_table(rows)
    if options.picture:
        draw(rows)


if __name__ == "__main__":
    main()
