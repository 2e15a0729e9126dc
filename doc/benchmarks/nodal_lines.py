#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Do the nodal lines of a disc stand or turn? Splits the motion of the disc in a
transient, normal to its face, into standing and travelling waves of m diameters.

usage: /usr/bin/python3 doc/benchmarks/nodal_lines.py RUN... [-m 6 ...]
           [--frequency 7870 ...] [--window 0.002] [--last 0.02]
           [--titles TITLE ...] [--picture FILE.png]

RUN is the directory of a transient with Transient/Animation frames > 0, whose disc
turns about z, m its doublet, the frequency where its line is looked for, within 2 %.
Of a run of 'Analysis = cea' each unstable shape is split in place of a motion.

At the edge w(theta, t) = a(t) cos(m theta) + b(t) sin(m theta) + other diameters,
fitted to all nodes of its upper face z = 0; a is the motion of the member (0,m+)
with its antinode at theta = 0, b that of (0,m-). In each window a and b are fitted by
the line and its harmonics, a = Re A exp(i omega t). A travelling wave has |B| = |A|
and 90 degrees between them, a standing one 0 or 180 degrees. Of both, F and R are the
waves that run with the disc and against it, F, R = (A +- i B) / 2, and
  travel = (|F| - |R|) / (|F| + |R|): 1 or -1 travelling, 0 standing,
  nodes  = the angle from theta = 0 to the nodal line of the part that stands.
"""
import argparse
import base64
import pathlib
import re
import struct
import subprocess
import zlib

import numpy as np

MOST_DIAMETERS = 10
HARMONICS = 3


def array(text, name, kind):
    """One array of a .vtu file as deal.II compresses it."""
    found = re.search(rf'<DataArray[^>]*Name="{name}"[^>]*>\s*(\S+)', text)
    data = found.group(1)
    n_blocks = struct.unpack("<I", base64.b64decode(data[:8])[:4])[0]
    n_header = 4 * ((4 * (3 + n_blocks) + 2) // 3)
    sizes = struct.unpack(f"<{3 + n_blocks}I",
                          base64.b64decode(data[:n_header])[:4 * (3 + n_blocks)])
    packed, at, blocks = base64.b64decode(data[n_header:]), 0, []
    for size in sizes[3:]:
        blocks.append(zlib.decompress(packed[at:at + size]))
        at += size
    return np.frombuffer(b"".join(blocks), kind)


def rim(text):
    """The nodes on the edge of the disc's face z = 0 and their angles."""
    points = array(text, "Points", "<f4").reshape(-1, 3)
    radius = np.hypot(points[:, 0], points[:, 1])
    top = np.abs(points[:, 2]) < 1e-6
    nodes = np.flatnonzero(top & (radius > radius[top].max() - 1e-5))
    return nodes, np.arctan2(points[nodes, 1], points[nodes, 0])


def fit_of(theta, m):
    """Takes values at the angles to the amplitudes of cos and sin(m theta)."""
    columns = [np.ones_like(theta)]
    for n in range(1, MOST_DIAMETERS + 1):
        columns += [np.cos(n * theta), np.sin(n * theta)]
    return np.linalg.pinv(np.array(columns).T)[2 * m - 1:2 * m + 1]


def shapes(run, m):
    """Prints the waves of each unstable shape."""
    for file in sorted(run.glob("shapes/mode_*_unstable_00.vtu")):
        text = file.read_text(encoding="utf-8")
        nodes, theta = rim(text)
        parts = [array(text, f"displacement_{part}", "<f4").reshape(-1, 3)[nodes, 2]
                 for part in ("real", "imag")]
        a, b = fit_of(theta, m) @ (parts[0] + 1j * parts[1])
        _, size_a, size_b, phase, travel, nodes, _ = describe([(0, a, b, 0)], m)[0]
        print(f"{file.stem}: |(0,{m}-)| / |(0,{m}+)| {size_b / size_a:.3f}, phase "
              f"{phase:.1f} deg, travel {travel:.3f}, nodes at {nodes:.2f} deg")


def motion(run, m):
    """Times, and the amplitudes of cos(m theta) and sin(m theta)."""
    text = (run / "motion.pvd").read_text(encoding="utf-8")
    frames = re.findall(r'timestep="([^"]+)"[^>]*file="([^"]+)"', text)
    times, rows, fit = [], [], None
    for time, file in frames:
        text = (run / file).read_text(encoding="utf-8")
        if fit is None:
            nodes, theta = rim(text)
            fit = fit_of(theta, m)
        w = array(text, "deviation", "<f4").reshape(-1, 3)[nodes, 2]
        times.append(float(time))
        rows.append(fit @ w)
    return np.array(times), np.array(rows)


def line(times, rows, near):
    """Frequency of the largest line of both members within 2 %, by the fit that
    leaves least."""
    def left(frequency):
        base = np.exp(2j * np.pi * frequency * times)
        basis = np.array([np.ones_like(times), base.real, base.imag]).T
        fit = np.linalg.lstsq(basis, rows, rcond=None)[0]
        return np.linalg.norm(rows - basis @ fit)
    width = 0.02 * near
    for _ in range(6):
        tried = np.linspace(near - width, near + width, 41)
        near = min(tried, key=left)
        width /= 8
    return near


def waves(times, rows, frequency, window):
    """Of each window: its middle, A and B, the largest residual of both."""
    found = []
    n = max(1, round((times[-1] - times[0]) / window))
    for part in np.array_split(np.arange(len(times)), n):
        t = times[part]
        columns = [np.ones_like(t)]
        for k in range(1, HARMONICS + 1):
            phase = 2 * np.pi * k * frequency * t
            columns += [np.cos(phase), np.sin(phase)]
        basis = np.array(columns).T
        fit = np.linalg.lstsq(basis, rows[part], rcond=None)[0]
        rest = np.linalg.norm(rows[part] - basis @ fit) / np.linalg.norm(
            rows[part] - rows[part].mean(axis=0))
        a, b = fit[1] - 1j * fit[2]
        found.append((t.mean(), a, b, rest))
    return found


def describe(found, m):
    """Table of the windows: time, |A|, |B|, phase, travel, nodes, residual."""
    table = []
    for time, a, b, rest in found:
        # cos(omega t - m theta) has b = a shifted by -90 degrees: B = -i A.
        with_disc, against = abs(a + 1j * b) / 2, abs(a - 1j * b) / 2
        phase = np.degrees(np.angle(b / a))
        standing = 0.5 * np.angle((a - 1j * b) * np.conj(a + 1j * b))
        # The antinode of the standing part, half a lobe beside its node.
        nodes = (np.degrees(-standing) + 90) / m
        table.append((time, abs(a), abs(b), phase,
                      (with_disc - against) / (with_disc + against),
                      nodes % (180 / m), rest))
    return np.array(table)


def circular(angles, period):
    """Mean and standard deviation of angles in degrees."""
    z = np.exp(2j * np.pi * np.asarray(angles) / period).mean()
    spread = np.sqrt(-2 * np.log(min(abs(z), 1)))
    return (np.degrees(np.angle(z)) * period / 360 % period,
            np.degrees(spread) * period / 360)


def report(run, table, frequency, m):
    """What the windows say together."""
    ratio = np.minimum(table[:, 1], table[:, 2]) / np.maximum(
        table[:, 1], table[:, 2])
    phase, phase_spread = circular(table[:, 3], 360)
    nodes, nodes_spread = circular(table[:, 5], 180 / m)
    amplitude = 1e9 * np.hypot(table[:, 1], table[:, 2])
    print(f"{run.name}, {table[0, 0]:.4f} to {table[-1, 0]:.4f} s, {len(table)} "
          f"windows: {frequency:.1f} Hz, amplitude {amplitude.mean():.4g} +- "
          f"{amplitude.std():.2g} nm, smaller over larger member {ratio.mean():.3f} "
          f"+- {ratio.std():.3f}, phase {(phase + 180) % 360 - 180:.1f} +- "
          f"{phase_spread:.1f} deg, travel {table[:, 4].mean():.3f} +- "
          f"{table[:, 4].std():.3f}, nodes at {nodes:.2f} +- {nodes_spread:.2f} deg, "
          f"beside the line {table[:, 6].mean():.2f}")


def picture(file, results):
    """For each run the amplitudes of both members, travel, and the path of both."""
    data, plots = [], []
    for i, (title, table, path, m) in enumerate(results):
        data.append("\n".join(" ".join(f"{v:.6g}" for v in row) for row in table))
        data.append("\n".join(f"{1e6 * a:.6g} {1e6 * b:.6g}" for a, b in path))
        reach = 1.1e6 * np.abs(path).max()
        plots.append(f"""
set title "{title}"
set xlabel "time, s"
set xrange [{table[0, 0]:.3f}:{table[-1, 0]:.3f}]
set xtics 0.02
set ytics auto
set logscale y
set yrange [*:*]
set ylabel "amplitude, um"
plot $data index {2 * i} using 1:(1e6*$2) with lines lw 2 lc rgb "#0072b2" \\
       title "(0,{m}+)", \\
     $data index {2 * i} using 1:(1e6*$3) with lines lw 2 lc rgb "#d55e00" \\
       title "(0,{m}-)"
unset logscale y
set title " "
set yrange [-1:1]
set ytics 0.5
set ylabel "travel"
plot $data index {2 * i} using 1:5 with lines lw 2 lc rgb "#000000" notitle
set xrange [{-reach}:{reach}]
set yrange [{-reach}:{reach}]
set xtics auto
set ytics auto
set size square
set xlabel "(0,{m}+), um"
set ylabel "(0,{m}-), um"
plot $data index {2 * i + 1} using 1:2 with lines lc rgb "#0072b2" notitle
set size nosquare
""")
    script = f"""
set terminal pngcairo size {600 * len(results)},1300 font "DejaVu Sans,14"
set output "{file}"
$data << EOD
{(chr(10) * 3).join(data)}
EOD
set grid
set format y "%g"
set key at graph 0.6, 0.16
set multiplot layout 3,{len(results)} columnsfirst
{"".join(plots)}
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("runs", type=pathlib.Path, nargs="+")
    parser.add_argument("-m", type=int, nargs="+", default=[6])
    parser.add_argument("--frequency", type=float, nargs="+", default=[7870])
    parser.add_argument("--window", type=float, default=0.002)
    parser.add_argument("--last", type=float, default=0.02,
                        help="s at the end that the sentence is about")
    parser.add_argument("--titles", nargs="+")
    parser.add_argument("--picture")
    options = parser.parse_args()
    results = []
    for i, run in enumerate(options.runs):
        m = options.m[min(i, len(options.m) - 1)]
        near = options.frequency[min(i, len(options.frequency) - 1)]
        if not (run / "motion.pvd").exists():
            shapes(run, m)
            continue
        times, rows = motion(run, m)
        late = times > times[-1] - options.last
        frequency = line(times[late], rows[late], near)
        table = describe(waves(times, rows, frequency, options.window), m)
        report(run, table[table[:, 0] > times[-1] - options.last], frequency, m)
        title = options.titles[i] if options.titles else run.name
        results.append((title, table, rows[-200:], m))
    if options.picture:
        picture(options.picture, results)


if __name__ == "__main__":
    main()
