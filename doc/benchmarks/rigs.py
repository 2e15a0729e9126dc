#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two rigs of chapter 2 of F. Massi's thesis over what was not swept on one mesh:
the laboratory brake over the distance of two pads (table 2.1), and the beam on a
disc over its length and angle (figure 2.2).

usage: /usr/bin/python3 doc/benchmarks/rigs.py distance [--geometry NAME]
           [--cells fine] [--degree 3] [--distances 74 106]
       /usr/bin/python3 doc/benchmarks/rigs.py mesh [--degree 3]
       /usr/bin/python3 doc/benchmarks/rigs.py picture
       /usr/bin/python3 doc/benchmarks/rigs.py length [--angle -15]
       /usr/bin/python3 doc/benchmarks/rigs.py angle

Each point is a run of squeal of its own. Tables go to output/benchmarks/rigs_*.csv;
what they show is in doc/studies/laboratory_brake.md and beam_on_disc.md.
"""
import argparse
import csv
import math
import pathlib
import re
import statistics
import subprocess

import nodal_lines

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = ROOT / "output" / "benchmarks"
RADIUS = 0.168  # of the pads, by the numbers of table 2.1
# Table 2.1: D in mm; the member of (0,m) that squeals, "b" where both do.
TABLE = {
    0: "4+ 5+ 6+ 7+ 8+ 9+",
    36: "7b 8-",
    42: "6b 7- 8- 9-",
    51: "4+ 5- 6- 8- 9-",
    74: "4- 5- 6- 7- 8-",
    106: "5- 6- 7+ 8+ 9+",
    134: "6b 7+ 8+ 9+",
    160: "8+ 9-",
    168: "7+ 8- 9-",
}
GEOMETRIES = {
    "aluminium_disc": {},
    "thin_disc": {
        "Scene/Body disc/Height": 0.0075,
        "Scene/Body disc/Position": "0, 0, -0.0075",
    },
    "slender_beams": {"Scene/Body beam/Size": "0.010, 0.300, 0.010"},
}
# Moduli about the one at which the pad's motion along the disc meets a doublet,
# in decades. A pad of this loss factor meets it over some 0.07 decades.
OFFSETS = [-0.09, -0.03, 0.03, 0.09]
LEAST_SHARE = 0.25  # of the disc in the energy of a pair, as in doublets.csv


def run(program, scene, folder, settings):
    """Runs squeal and returns its eigenvalues and undamped modes."""
    settings = {
        "Output directory": FOLDER / folder,
        "Overwrite": "true",
        "Output/Shapes": "unstable",
        "Output/Plots": "false",
        "Output/Report": "false",
    } | settings
    command = [program, "--quiet", str(ROOT / "prm" / scene)]
    for name, value in settings.items():
        command += ["--set", f"{name} = {value}"]
    result = subprocess.run(command, capture_output=True, text=True)
    if result.returncode != 0:
        raise SystemExit(f"{folder}: {result.stderr}")
    tables = []
    for table in ("eigenvalues.csv", "modes.csv"):
        with open(FOLDER / folder / table, encoding="utf-8") as file:
            tables.append(list(csv.DictReader(
                line for line in file if not line.startswith("#"))))
    return tables


def edge_amplitudes(folder, m):
    """Of each unstable pair, in the order of eigenvalues.csv: the amplitudes of the
    members + and - in the motion of the disc's edge across its face."""
    found = []
    for file in sorted((FOLDER / folder / "shapes").glob("mode_*_unstable_00.vtu")):
        text = file.read_text(encoding="utf-8")
        nodes, theta = nodal_lines.rim(text)
        real, imag = (
            nodal_lines.array(text, f"displacement_{part}", "<f4")
            .reshape(-1, 3)[nodes, 2] for part in ("real", "imag"))
        found.append([abs(a) for a in
                      nodal_lines.fit_of(theta, m) @ (real + 1j * imag)])
    return found


def write(rows, name):
    with open(FOLDER / name, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, fieldnames=rows[0])
        writer.writeheader()
        writer.writerows(rows)


def places(distance):
    """The scene with the pads a distance in mm apart, and its settings."""
    if distance == 0:
        return "laboratory_brake/pressed.prm", {}
    angle = distance / 2000 / RADIUS
    x, y = RADIUS * math.cos(angle), RADIUS * math.sin(angle)
    return "laboratory_brake/two_pads.prm", {
        "Scene/Body pad/Position": f"{x:.7f}, {y:.7f}, 0",
        "Scene/Body second_pad/Position": f"{x:.7f}, {-y:.7f}, 0",
        "Scene/Body beam/Position": f"{x:.7f}, 0, 0.010",
    }


def moduli(distance, exponent):
    bodies = ["pad"] + (["second_pad"] if distance else [])
    return {f"Scene/Body {b}/Young modulus": f"10^{exponent:.3f}" for b in bodies}


def members(name, m):
    return {s for n, s in re.findall(r"\(0,(\d)([+-])\)", name) if int(n) == m}


def frequencies(program, settings, folder):
    """Of the doublets: the member with its node at the pad, with one pad."""
    pairs, _ = run(program, "laboratory_brake/pressed.prm", folder, settings | {
        "Eigenvalues/Lowest frequency": 1500,
        "Eigenvalues/Highest frequency": 17000})
    result = {}
    for m in range(4, 10):
        own = [p for p in pairs if p["name"] == f"(0,{m}-)"]
        best = max(own, key=lambda p: float(p["ke_share_disc"]))
        result[m] = float(best["frequency_hz"])
    return result


def exponent_at(frequency):
    """Of ten, the modulus in Pa at which the motion of one pad of 10 mm along the
    disc has a frequency, for the beams of pressed.prm."""
    return 9.26 + 2.08 * math.log10(frequency / 10190)


def split(modes, m):
    """Frequency of + less that of -, of the modes with most of the disc."""
    found = {}
    for sign in "+-":
        own = [row for row in modes if row["name"] == f"(0,{m}{sign})"]
        if not own:
            return None
        found[sign] = float(own[0]["frequency_hz"])
    return found["+"] - found["-"]


def entry(program, geometry, settings, distance, m, frequency, cells):
    """One doublet at one distance: the loudest pair over the moduli."""
    scene, placed = places(distance)
    row = {"geometry": geometry, "distance_mm": distance, "doublet": f"(0,{m})",
           "R": round(distance / 1000 * m / (2 * math.pi * RADIUS), 3),
           "thesis": "", "squeals": "none", "by_elimination": "none",
           "larger": "none", "smaller_over_larger": None, "sigma_per_s": None, "frequency_hz": None, "log10_modulus": None,
           "disc_share": None, "split_hz": None}
    for word in TABLE[distance].split():
        if int(word[0]) == m:
            row["thesis"] = word[1].replace("b", "both")
    loudest = 0
    for offset in OFFSETS:
        exponent = exponent_at(frequency) + offset
        folder = f"rigs/{geometry}{cells}_{distance}_{m}"
        pairs, modes = run(
            program, scene, folder,
            settings | placed | moduli(distance, exponent) | {
                "Eigenvalues/Lowest frequency": round(0.96 * frequency),
                "Eigenvalues/Highest frequency": round(1.05 * frequency)})
        if row["split_hz"] is None:
            row["split_hz"] = split(modes, m)
        unstable = [p for p in pairs if p["unstable"] == "1"]
        for pair, (plus, minus) in zip(unstable, edge_amplitudes(folder, m),
                                       strict=True):
            pair["amplitudes"] = plus, minus
        own = [p for p in pairs if members(p["name"], m) and
               float(p["ke_share_disc"]) >= LEAST_SHARE]
        for pair in own:
            sigma = float(pair["sigma_per_s"])
            if sigma <= loudest:
                continue
            loudest = sigma
            signs = members(pair["name"], m)
            stable = {p["name"][-2] for p in own
                      if p["name"] in (f"(0,{m}+)", f"(0,{m}-)") and
                      float(p["sigma_per_s"]) < 0 and
                      float(p["ke_share_disc"]) > 0.9}
            left = signs - stable
            plus, minus = pair["amplitudes"]
            row |= {"squeals": "both" if len(signs) == 2 else min(signs),
                    "by_elimination": "both" if len(left) != 1 else min(left),
                    "larger": "+" if plus > minus else "-",
                    "smaller_over_larger": round(
                        min(plus, minus) / max(plus, minus), 2),
                    "sigma_per_s": round(sigma, 1),
                    "frequency_hz": round(float(pair["frequency_hz"]), 1),
                    "log10_modulus": round(exponent, 3),
                    "disc_share": round(float(pair["ke_share_disc"]), 3)}
    return row


def verdict(row):
    """Ours, marked where the shape of the pair has both members."""
    mixed = row["squeals"] == "both" != row["by_elimination"]
    return row["by_elimination"] + ("*" if mixed else "")


def score(rows):
    """Prints the table and how many of the entries with one member are met."""
    print("| D, mm | " + " | ".join(f"(0,{m})" for m in range(4, 10)) + " |")
    print("| --- " * 7 + "|")
    for d in TABLE:
        cells = []
        for m in range(4, 10):
            own = [row for row in rows if int(row["distance_mm"]) == d and
                   row["doublet"] == f"(0,{m})"]
            cells += [f"{r['thesis']} / {verdict(r)}, {float(r['R']):.2f}"
                      for r in own] or [""]
        print(f"| {d} | " + " | ".join(cells) + " |")
    single = [row for row in rows if row["thesis"] in ("+", "-")]
    for column in ("squeals", "by_elimination", "larger"):
        hits = sum(row[column] == row["thesis"] for row in single)
        print(f"{rows[0]['geometry']}, {column}: {hits} of {len(single)}")


def distance(options):
    settings = {"Analysis": "cea"} | GEOMETRIES[options.geometry]
    cells = ""
    if options.degree != 2:
        cells = f"_degree_{options.degree}"
        settings |= {"Discretization/Degree": options.degree}
    if options.cells == "fine":
        cells += "_fine"
        settings |= {"Scene/Body disc/Cells": "48, 4, 1",
                     "Scene/Body beam/Cells": "1, 30, 1"}
    if options.again:
        with open(FOLDER / f"rigs_{options.geometry}{cells}.csv",
                  encoding="utf-8") as file:
            return score(list(csv.DictReader(file)))
    found = frequencies(options.squeal, settings,
                        f"rigs/{options.geometry}{cells}_modes")
    print(found, flush=True)
    rows = []
    for d in options.distances:
        for word in TABLE[d].split():
            m = int(word[0])
            rows.append(entry(options.squeal, options.geometry, settings, d, m,
                              found[m], cells))
            print(" ".join(str(v) for v in rows[-1].values()), flush=True)
            write(rows, f"rigs_{options.geometry}{cells}.csv")
    score(rows)


def mesh(options):
    """What elements of another degree change in the table of distance."""
    tables = []
    for suffix in ("", f"_degree_{options.degree}"):
        path = FOLDER / f"rigs_{options.geometry}{suffix}.csv"
        with open(path, encoding="utf-8") as file:
            tables.append({(r["distance_mm"], r["doublet"]): r
                           for r in csv.DictReader(file)})
    moved = {"frequency_hz": [], "sigma_per_s": [], "split_hz": []}
    pairs = [(r, tables[1][key]) for key, r in tables[0].items()
             if key in tables[1]]
    for one, other in pairs:
        if verdict(one) != verdict(other):
            print(f"D {one['distance_mm']} mm, {one['doublet']}, R {one['R']}, thesis "
                  f"{one['thesis']}: {verdict(one)} becomes {verdict(other)}")
        for column, differences in moved.items():
            if one[column] and other[column]:
                differences.append((float(one[column]), float(other[column])))
    for column, values in moved.items():
        change = [y - x for x, y in values]
        share = [abs(y / x - 1) for x, y in values]
        print(f"{column} of {len(values)}: changes by {min(change):.1f} to "
              f"{max(change):.1f}, median size "
              f"{statistics.median(map(abs, change)):.1f}; relative size "
              f"{min(share):.4f} to {max(share):.4f}, median "
              f"{statistics.median(share):.4f}")
    print("signs of the split that change:",
          [(x, y) for x, y in moved["split_hz"] if x * y < 0])
    for column in ("squeals", "by_elimination"):
        single = [p for p in pairs if p[0]["thesis"] in ("+", "-")]
        print(column, [sum(p[i][column] == p[0]["thesis"] for p in single)
                       for i in (0, 1)], "of", len(single))


def blocks(name, choose):
    """Data of gnuplot from the table of a geometry: what choose makes of a row, or
    nothing where it makes None."""
    path = FOLDER / f"rigs_{name}.csv"
    rows = []
    if path.exists():
        with open(path, encoding="utf-8") as file:
            rows = [choose(row) for row in csv.DictReader(file)]
    return "\n".join(row for row in rows if row) or "NaN NaN"


def picture(_):
    """The split of the doublets and the member that squeals over R."""
    def split_of(row):
        return row["split_hz"] and f"{row['R']} {row['split_hz']}"

    def of(member):
        return lambda row: row["by_elimination"] == member and (
            f"{row['R']} {row['sigma_per_s']}")

    def stated(member):
        return lambda row: row["thesis"] == member and f"{row['R']} 1"

    data = [blocks(name, split_of) for name in GEOMETRIES]
    n = len(GEOMETRIES)
    styles = [(7, "#0072b2"), (9, "#d55e00")]
    splits = ", ".join(
        f"$data index {i} using 1:2 with points pt {point} ps 1.4 "
        f'lc rgb "{ink}" title "{name.replace("_", " ")}"'
        for i, (name, (point, ink)) in enumerate(zip(GEOMETRIES, styles))
        if data[i] != "NaN NaN")
    data += [blocks("aluminium_disc", of(m)) for m in ("+", "-", "both")]
    data += [blocks("aluminium_disc", stated(m)) for m in ("+", "-", "both")]
    script = f"""
set terminal pngcairo size 1400,1000 font "DejaVu Sans,15" linewidth 1.5
set output "{ROOT / 'doc' / 'pictures' / 'laboratory_brake_split.png'}"
$data << EOD
{(chr(10) * 3).join(data)}
EOD
set multiplot layout 2,1
set xrange [-0.05:1.6]
set xtics 0.25
set grid xtics
set key outside right top
set lmargin 9
set rmargin 26
set ylabel "f(+) - f(-), Hz"
set xzeroaxis lt -1
plot {splits}
set logscale y
set yrange [5:3000]
set ylabel "largest sigma, 1/s"
set xlabel "R, distance of the pads over the wavelength"
set label 1 "thesis" at graph 1.01, first 1500
plot $data index {n} using 1:2 with points pt 7 ps 1.4 lc rgb "#0072b2" \\
       title "(0,m+) squeals", \\
     $data index {n + 1} using 1:2 with points pt 6 ps 1.4 lc rgb "#0072b2" \\
       title "(0,m-) squeals", \\
     $data index {n + 2} using 1:2 with points pt 2 ps 1.4 lc rgb "#0072b2" \\
       title "both", \\
     $data index {n + 3} using 1:(1500) with points pt 7 ps 1.4 lc rgb "#000000" notitle, \\
     $data index {n + 4} using 1:(1500) with points pt 6 ps 1.4 lc rgb "#000000" notitle, \\
     $data index {n + 5} using 1:(1500) with points pt 2 ps 1.4 lc rgb "#000000" notitle
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


def beam_runs(options, lengths, angle):
    """The pairs with friction and the modes without it over the length in mm."""
    points = []
    for length in lengths:
        points.append((length, *run(
            options.squeal, "beam_on_disc/scene.prm", f"rigs/beam_{angle}", {
                "Analysis": "cea",
                "Discretization/Estimate error": "false",
                "Scene/Body beam/Size": f"0.0095, 0.0095, {length / 1000}",
                "Scene/Body beam/Angle": angle,
                "Eigenvalues/Lowest frequency": 100})))
        print(angle, length, [
            (round(float(p["frequency_hz"])), round(float(p["sigma_per_s"])))
            for p in points[-1][1] if p["unstable"] == "1"], flush=True)
    return points


def bends_at_tip(mode):
    """Whether a mode is not one of the disc with its node at the tip."""
    return not re.fullmatch(r"\(\d,\d-\)", mode["name"])


def crossings(points):
    """Lengths at which two neighbouring modes without friction come closest, one
    of the beam and one (0,m+)."""
    levels = [(length, [(float(m["frequency_hz"]), m["name"])
                        for m in modes if bends_at_tip(m)])
              for length, _, modes in points]
    found = []
    for before, here, after in zip(levels, levels[1:], levels[2:]):
        for i in range(min(len(before[1]), len(here[1]), len(after[1])) - 1):
            gaps = [at[1][i + 1][0] - at[1][i][0] for at in (before, here, after)]
            names = here[1][i][1] + "|" + here[1][i + 1][1]
            disc = set(re.findall(r"\(0,\d\+\)", names))
            beam = set(re.findall(r"beam \w+ \d", names))
            if gaps[1] < gaps[0] and gaps[1] <= gaps[2] and disc and beam:
                found.append({
                    "length_mm": here[0],
                    "frequency_hz": 0.5 * (here[1][i][0] + here[1][i + 1][0]),
                    "gap_hz": gaps[1],
                    "disc": " or ".join(sorted(disc)),
                    "beam": " or ".join(sorted(beam))})
    return found


def ranges(points):
    """Unstable ranges of the length: pairs at neighbouring lengths whose
    frequencies differ by less than 3 %."""
    found = []
    for at, (length, pairs, _) in enumerate(points):
        for pair in pairs:
            if pair["unstable"] != "1":
                continue
            f, sigma = float(pair["frequency_hz"]), float(pair["sigma_per_s"])
            same = [r for r in found if r["last"] == at - 1 and
                    abs(r["f"] - f) < 0.03 * f]
            r = min(same, key=lambda r: abs(r["f"] - f), default=None)
            if r is None:
                r = {"from_mm": length, "sigma_per_s": 0}
                found.append(r)
            r |= {"last": at, "f": f, "to_mm": length}
            if sigma > r["sigma_per_s"]:
                r |= {"sigma_per_s": sigma, "frequency_hz": f,
                      "name": pair["name"]}
    for r in found:
        del r["last"], r["f"]
    return sorted(found, key=lambda r: r["frequency_hz"])


def length(options):
    points = beam_runs(options, options.lengths, options.angle)
    for name, rows in (("crossings", crossings(points)),
                       ("ranges", ranges(points))):
        for row in rows:
            print(name, " ".join(f"{v:.1f}" if isinstance(v, float) else str(v)
                                 for v in row.values()))
        if rows:
            write(rows, f"rigs_length_{name}_{options.angle}.csv")


def angle(_):
    """Unstable ranges over the angle of the beam, and the least friction at each."""
    def rows(scene):
        path = ROOT / "output" / "beam_on_disc" / scene / "unstable_ranges.csv"
        with open(path, encoding="utf-8") as file:
            return list(csv.DictReader(
                line for line in file if not line.startswith("#")))

    bars = [(float(r["angle"]), float(r["lower"]) / 1e9, float(r["upper"]) / 1e9,
             float(r["peak_sigma_per_s"])) for r in rows("angle")]
    edges = [(float(r["angle"]), float(r["lower"])) for r in rows("angle_friction")]
    data = ["\n".join(" ".join(f"{v:.5g}" for v in row) for row in rows)
            for rows in (bars, edges)]
    script = f"""
set terminal pngcairo size 1400,650 font "DejaVu Sans,15" linewidth 1.5
set output "{ROOT / 'doc' / 'pictures' / 'beam_on_disc_angle.png'}"
$data << EOD
{(chr(10) * 3).join(data)}
EOD
set multiplot layout 1,2
set grid
set xlabel "angle of the beam, degrees"
set xrange [-36:12]
set logscale y
set yrange [9:350]
set ylabel "unstable, modulus of the beam, GPa"
set logscale cb
set cblabel "largest sigma, 1/s"
set cbrange [5:500]
set palette defined (0 "#c6dbef", 0.5 "#4292c6", 1 "#08306b")
plot $data index 0 using 1:2:(0):($3-$2):4 with vectors nohead lw 7 lc palette notitle
unset logscale y
set yrange [0:0.8]
set ylabel "coefficient of friction"
set key top right
plot $data index 1 using 1:2 with points pt 7 ps 1.4 lc rgb "#0072b2" \\
       title "least that squeals, 90 GPa", \\
     x < 0 ? tan(-x * pi / 180) : NaN with lines lw 2 lc rgb "#d55e00" \\
       title "tangent of the angle"
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("what", choices=["distance", "mesh", "picture", "length",
                                 "angle"])
    parser.add_argument("--squeal", default=str(ROOT / "build" / "squeal"))
    parser.add_argument("--geometry", choices=GEOMETRIES,
                        default="aluminium_disc")
    parser.add_argument("--cells", choices=["coarse", "fine"], default="coarse")
    parser.add_argument("--degree", type=int,
                        help="of the elements; 2 for distance, 3 for mesh")
    parser.add_argument("--again", action="store_true",
                        help="show the table of an earlier run of distance")
    parser.add_argument("--distances", type=int, nargs="+", choices=TABLE,
                        default=list(TABLE))
    parser.add_argument("--angle", type=float, default=-15)
    parser.add_argument("--lengths", type=int, nargs="+",
                        default=list(range(140, 261)))
    options = parser.parse_args()
    if options.degree is None:
        options.degree = 3 if options.what == "mesh" else 2
    FOLDER.mkdir(parents=True, exist_ok=True)
    {"distance": distance, "mesh": mesh, "picture": picture,
     "length": length, "angle": angle}[options.what](options)


if __name__ == "__main__":
    main()
