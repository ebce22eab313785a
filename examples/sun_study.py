# SPDX-License-Identifier: MIT
"""sun_study.py [PICTURE.png]: hours of sun on the south front of a house, on three days of the year.

The house stands in a small block of boxes. Every 5 minutes of a day each point of a grid on the front is asked which
part of the sun's disk it sees; the sum of that is its hours of sun. Needs NumPy, and gnuplot for the plot.
"""
import subprocess
import sys

import numpy as np

import penumbra

LATITUDE_DEG = 52.5
MINUTES = 5
# x0, x1, y0, y1, height in metres; x is east, y north, z up. The front is that of the first, in the plane y = 0.
BLOCK = [(0, 40, 0, 12, 18),
         (-18, -3, -34, -18, 16), (1, 9, -30, -18, 34), (13, 27, -36, -18, 13), (31, 40, -34, -18, 22),
         (-18, -3, 0, 12, 21), (43, 58, -14, 12, 15)]
DAYS = {"21 June": 172, "20 March": 79, "21 December": 355}


def towards_sun(day_of_year, solar_hour, latitude_deg):
    """Unit vector (east, north, up); at 12 the sun stands in the south. The declination is Spencer's series, good to
    0.04 degrees: J. W. Spencer, Fourier series representation of the position of the sun, Search 2(5), 1971."""
    g = 2 * np.pi * (day_of_year - 1) / 365
    declination = (0.006918 - 0.399912 * np.cos(g) + 0.070257 * np.sin(g) - 0.006758 * np.cos(2 * g)
                   + 0.000907 * np.sin(2 * g) - 0.002697 * np.cos(3 * g) + 0.00148 * np.sin(3 * g))
    hour, latitude = np.radians(15 * (solar_hour - 12)), np.radians(latitude_deg)
    east = -np.cos(declination) * np.sin(hour)
    north = np.cos(latitude) * np.sin(declination) - np.sin(latitude) * np.cos(declination) * np.cos(hour)
    up = np.sin(latitude) * np.sin(declination) + np.cos(latitude) * np.cos(declination) * np.cos(hour)
    return np.array([east, north, up])


def boxes(block):
    """The block as one mesh: positions (n, 3), triangles (m, 3)."""
    corners = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)])
    sides = np.array([[0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4], [2, 6, 7], [2, 7, 3],
                      [0, 4, 6], [0, 6, 2], [1, 3, 7], [1, 7, 5]])
    lows = np.array([[x0, y0, 0] for x0, _, y0, _, _ in block])
    sizes = np.array([[x1 - x0, y1 - y0, height] for x0, x1, y0, y1, height in block])
    positions = lows[:, None] + corners * sizes[:, None]
    triangles = sides + 8 * np.arange(len(block))[:, None, None]
    return positions.reshape(-1, 3).astype(np.float32), triangles.reshape(-1, 3).astype(np.uint32)


def front(block, step):
    """Points in the middles of squares of this size on the front of the first box: (rows from below, columns, 3)."""
    x0, x1, y0, _, height = block[0]
    z, x = np.mgrid[step / 2:height:step, x0 + step / 2:x1:step]
    return np.stack([x, np.full_like(x, y0), z], axis=-1).astype(np.float32)


def hours_of_sun(block, points, normal, day, latitude_deg=LATITUDE_DEG, minutes=MINUTES):
    """Hours of each point, of the shape of `points` without its last axis."""
    occluders = penumbra.Occluders()
    occluders.add_triangles(*boxes(block))
    occluders.commit()
    hours = np.zeros(points.shape[:-1])
    for hour in np.arange(minutes / 120, 24, minutes / 60):
        towards = towards_sun(day, hour, latitude_deg)
        if towards[2] > 0:
            sun = penumbra.Sun(towards, diameter_deg=0.533)
            hours += occluders.visible_fraction(points, sun, normals=normal, shadow_samples=16) * minutes / 60
    return hours


def plot(path, block, step, results):
    """A map of the front a day, and the plan of the block, by gnuplot."""
    x0, x1, _, _, height = block[0]
    most = max(hours.max() for hours in results.values())
    commands = ["set terminal pngcairo size 1240,700 font 'sans,11'", f"set output '{path}'",
                "set multiplot layout 2,2", "set tics out nomirror",
                "set palette defined (0 '#1b1e3c', 0.35 '#8a3b6b', 0.7 '#f2884b', 1 '#fff3b0')",
                f"set cbrange [0:{most:.3g}]", "set cblabel 'hours'", "set size ratio -1", "unset key"]
    for title, hours in results.items():
        rows = "\n".join(" ".join(f"{value:.3f}" for value in row) for row in hours)
        commands += [f"$hours << end\n{rows}\nend", f"set title '{title}: {hours.mean():.1f} hours in the mean'",
                     f"set xrange [{x0}:{x1}]; set yrange [0:{height}]", "set xlabel 'm east'; set ylabel 'm up'",
                     f"plot $hours matrix using (({x0})+($1+0.5)*{step}):(($2+0.5)*{step}):3 with image"]
    xs, ys = [b[i] for b in block for i in (0, 1)], [b[i] for b in block for i in (2, 3)]
    commands += [f"set xrange [{min(xs) - 3}:{max(xs) + 3}]; set yrange [{min(ys) - 3}:{max(ys) + 3}]",
                 "set title 'The block: heights in m, the front red'; set ylabel 'm north'"]
    for a, b, c, d, height in block:
        commands += [f"set object rectangle from {a},{c} to {b},{d} fillcolor '#d9d9de' fillstyle solid border",
                     f"set label '{height}' at {(a + b) / 2},{(c + d) / 2} center front"]
    commands += [f"set arrow from {x0},0 to {x1},0 nohead linewidth 4 linecolor '#c02020' front", "plot NaN"]
    subprocess.run(["gnuplot"], input="\n".join(commands) + "\n", text=True, check=True)


def main():
    path = sys.argv[1] if len(sys.argv) > 1 else "sun_study.png"
    step = 0.25
    points = front(BLOCK, step)
    results = {name: hours_of_sun(BLOCK, points, (0, -1, 0), day) for name, day in DAYS.items()}
    for name, hours in results.items():
        print(f"{name:12} {hours.min():5.2f} to {hours.max():5.2f} hours, {hours.mean():5.2f} in the mean")
    plot(path, BLOCK, step, results)
    print(f"wrote {path}")


if __name__ == "__main__":
    main()
