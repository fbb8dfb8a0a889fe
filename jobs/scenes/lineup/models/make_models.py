#!/usr/bin/env python3
"""Writes the models and textures of the line-up. Everything in them is computed here.

Run it in its own folder; the results are kept beside it, so building and testing need no Python.
"""
import math
import random
import struct
import zlib


def write_png(name, size, channels, pixel):
    rows = b"".join(b"\0" + b"".join(bytes(pixel(x, y)) for x in range(size)) for y in range(size))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", size, size, 8, {3: 2, 4: 6}[channels], 0, 0, 0)
    with open(name, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) +
                   chunk(b"IEND", b""))


def write_lines(name, lines):
    with open(name, "w") as file:
        file.write("\n".join(lines) + "\n")


def textures():
    colors = random.Random(4)
    coarse = [[[colors.randrange(256) for _ in range(3)] for _ in range(5)] for _ in range(5)]
    write_png("coarse.png", 5, 3, lambda x, y: coarse[y][x])

    def stripes(x, y):
        return round(128 + 100 * math.sin(math.tau * (x + 2 * y) / 16)), 40 + 6 * (y % 32), 90 + 5 * (x % 32)
    write_png("stripes.png", 32, 3, stripes)

    def holes(x, y):
        ring = math.hypot(x - 7.5, y - 7.5)
        return 230, 170, 60, 255 if 3 < ring < 7 or (x + y) % 16 == 0 else 0
    write_png("holes.png", 16, 4, holes)


def ball(name, rings, segments, normals):
    """A sphere of radius 1 that stands on y = 0."""
    points = [(0, 1, 0)]
    for i in range(1, rings):
        polar = math.pi * i / rings
        for j in range(segments):
            turn = math.tau * j / segments
            points.append((math.sin(polar) * math.cos(turn), math.cos(polar), -math.sin(polar) * math.sin(turn)))
    points.append((0, -1, 0))
    last = len(points)

    def at(i, j):
        return 1 if i == 0 else last if i == rings else 2 + (i - 1) * segments + j % segments

    lines = ["v %.6g %.6g %.6g" % (x, y + 1, z) for x, y, z in points]
    if normals:
        lines += ["vn %.6g %.6g %.6g" % p for p in points]
    corner = "%d//%d" if normals else "%d"
    for i in range(rings):
        for j in range(segments):
            corners = list(dict.fromkeys([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]))
            lines.append("f " + " ".join(corner % ((c, c) if normals else c) for c in corners))
    write_lines(name, ["mtllib models.mtl", "usemtl ball"] + lines)


def panel(name, material, repeat, colors=None):
    """The upright square -1..1, 0..2 that faces +z, its texture repeated."""
    corners = [(-1, 0), (1, 0), (1, 2), (-1, 2)]
    lines = ["mtllib models.mtl", "usemtl " + material]
    for i, (x, y) in enumerate(corners):
        lines.append("v %g %g 0" % (x, y) + (" %g %g %g" % colors[i] if colors else ""))
    for u, v in ((0, 0), (1, 0), (1, 1), (0, 1)):
        lines.append("vt %g %g" % (u * repeat, v * repeat))
    write_lines(name, lines + ["f 1/1 2/2 3/3 4/4"])


def wedge():
    """A form without any symmetry, so that a mirrored or turned one shows; z is up."""
    points = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0), (-1, -1, 2), (-0.2, -1, 2), (-1, 0.4, 1.2)]
    faces = ["1 4 3 2", "1 2 6 5", "1 5 7 4", "5 6 7", "2 3 6", "3 7 6", "3 4 7"]
    write_lines("wedge.obj", ["mtllib models.mtl", "usemtl wedge"] + ["v %g %g %g" % p for p in points] +
                ["f " + f for f in faces])


def materials():
    write_lines("models.mtl", [
        "# Linear reflectances.",
        "newmtl ball", "Kd 0.7 0.7 0.7",
        "newmtl wedge", "Kd 0.6 0.4 0.2",
        "newmtl coarse", "Kd 1 1 1", "map_Kd coarse.png",
        "newmtl stripes", "Kd 1 1 1", "map_Kd stripes.png",
        "newmtl tinted", "Kd 0.9 0.45 0.2", "map_Kd stripes.png", "Ks 0.3 0.3 0.3", "Ns 12",
        "newmtl plain", "Kd 1 1 1",
        "newmtl holes", "Kd 1 1 1", "map_Kd holes.png", "map_d holes.png",
    ])


if __name__ == "__main__":
    textures()
    materials()
    ball("ball.obj", 12, 24, normals=True)
    ball("faceted.obj", 6, 10, normals=False)
    panel("coarse.obj", "coarse", 2.5)
    panel("stripes.obj", "stripes", 6)
    panel("tinted.obj", "tinted", 1)
    panel("colors.obj", "plain", 1, [(1, 0.1, 0.1), (0.1, 1, 0.1), (0.2, 0.2, 1), (1, 1, 0.3)])
    panel("colored_stripes.obj", "stripes", 1, [(1, 0.1, 0.1), (0.1, 1, 0.1), (0.2, 0.2, 1), (1, 1, 0.3)])
    panel("holes.obj", "holes", 2)
    wedge()
