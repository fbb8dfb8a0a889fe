#!/usr/bin/env python3
"""Writes the yard: the scene of the agreement tests. Everything in it is computed here.

Run it in its own folder; the results are kept beside it, so building and testing need no Python.
"""
import math
import random
import struct
import zlib

# ---- textures -------------------------------------------------------------------------------------------------------


def write_png(name, width, height, channels, pixel):
    rows = b""
    for y in range(height):
        rows += b"\0" + b"".join(bytes(max(0, min(255, round(c))) for c in pixel(x, y)) for x in range(width))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, {3: 2, 4: 6}[channels], 0, 0, 0)
    with open(name, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) +
                   chunk(b"IEND", b""))


def tileable_noise(seed, size):
    """Smooth noise of period `size`."""
    rng = random.Random(seed)
    waves = [(rng.randint(1, 4), rng.randint(1, 4), rng.random() * 6.283) for _ in range(8)]
    return lambda x, y: sum(math.sin(6.283185307 * (a * x + b * y) / size + p) for a, b, p in waves) / 8


def paving(size=64):
    rng = random.Random(3)
    shade = {(i, j): rng.uniform(-26, 26) for i in range(4) for j in range(4)}
    noise = tileable_noise(5, size)

    def pixel(x, y):
        row = y // 16
        xx = (x + (8 if row % 2 else 0)) % size
        if y % 16 == 0 or xx % 16 == 0:
            return 88, 82, 74
        s = shade[xx // 16, row] + 14 * noise(x, y)
        return 168 + s, 154 + s, 136 + s
    write_png("paving.png", size, size, 3, pixel)


def planks(size=32):
    noise = tileable_noise(9, size)

    def pixel(x, y):
        if x % 8 == 0:
            return 96, 66, 40
        s = 18 * noise(x * 3 % size, y) + 8 * ((x // 8) % 2)
        return 190 + s, 148 + s, 96 + s
    write_png("planks.png", size, size, 3, pixel)


def fence(width=32, height=48):
    """One picket and its two rails, cut out of nothing."""
    def pixel(x, y):
        d = abs(x - 15.5)
        picket = d < 9 and y > d * 0.8
        rail = 14 <= y < 19 or 36 <= y < 41
        grain = 10 * math.sin(x * 1.7) + 5 * math.sin(y * 0.9)
        if picket:
            return 214 + grain, 206 + grain, 190 + grain, 255
        if rail:
            return 176 + grain, 166 + grain, 150 + grain, 255
        return 200, 192, 176, 0
    write_png("fence.png", width, height, 4, pixel)


def leaves(size=48):
    rng = random.Random(11)
    blobs = [(rng.uniform(8, 40), rng.uniform(8, 44), rng.uniform(0, 3.1416), rng.uniform(0.8, 1.2)) for _ in range(22)]

    def pixel(x, y):
        for i, (cx, cy, turn, shade) in enumerate(blobs):
            dx, dy = x - cx, y - cy
            a, b = dx * math.cos(turn) + dy * math.sin(turn), -dx * math.sin(turn) + dy * math.cos(turn)
            if (a / 6.5) ** 2 + (b / 2.8) ** 2 < 1:
                vein = 22 if abs(b) < 0.6 else 0
                return (58 + vein) * shade, (120 + vein) * shade, (44 + 5 * (i % 4)) * shade, 255
        return 60, 110, 44, 0
    write_png("leaves.png", size, size, 4, pixel)


# ---- geometry -------------------------------------------------------------------------------------------------------


class Obj:
    def __init__(self, name, library):
        self.lines = [f"mtllib {library}"]
        self.name = name
        self.v = self.vt = self.vn = 0

    def group(self, name, material):
        self.lines += [f"o {name}", f"usemtl {material}"]

    def vertex(self, p, color=None):
        self.lines.append("v " + " ".join(f"{c:.5g}" for c in (*p, *(color or ()))))
        self.v += 1
        return self.v

    def uv(self, u, v):
        self.lines.append(f"vt {u:.5g} {v:.5g}")
        self.vt += 1
        return self.vt

    def normal(self, n):
        length = math.sqrt(sum(c * c for c in n))
        self.lines.append("vn " + " ".join(f"{c / length:.6g}" for c in n))
        self.vn += 1
        return self.vn

    def face(self, *corners):
        self.lines.append("f " + " ".join("/".join("" if i is None else str(i) for i in c).rstrip("/") for c in corners))

    def quad(self, corners, repeat=(1, 1)):
        uvs = [(0, 0), (repeat[0], 0), repeat, (0, repeat[1])]
        self.face(*[(self.vertex(p), self.uv(*uv)) for p, uv in zip(corners, uvs)])

    def box(self, low, high):
        (x, y, z), (X, Y, Z) = low, high
        self.quad([(x, y, Z), (X, y, Z), (X, Y, Z), (x, Y, Z)])
        self.quad([(X, y, z), (x, y, z), (x, Y, z), (X, Y, z)])
        self.quad([(X, y, Z), (X, y, z), (X, Y, z), (X, Y, Z)])
        self.quad([(x, y, z), (x, y, Z), (x, Y, Z), (x, Y, z)])
        self.quad([(x, Y, Z), (X, Y, Z), (X, Y, z), (x, Y, z)])

    def grid(self, columns, rows, point, normal, color=None):
        """A smooth patch; point, normal and colour are functions of 0..1 x 0..1."""
        index = {}
        for j in range(rows + 1):
            for i in range(columns + 1):
                s, t = i / columns, j / rows
                index[i, j] = (self.vertex(point(s, t), color(s, t) if color else None), None, self.normal(normal(s, t)))
        for j in range(rows):
            for i in range(columns):
                self.face(index[i, j], index[i + 1, j], index[i + 1, j + 1], index[i, j + 1])

    def write(self):
        with open(self.name, "w", encoding="ascii") as file:
            file.write("\n".join(self.lines) + "\n")


def add_vase(obj, x, z, scale):
    """A surface of revolution that shows smooth normals and a highlight."""
    def radius(t):
        return scale * (0.2 + 0.22 * math.sin(3.1416 * (0.1 + 1.25 * t)) ** 2 + 0.06 * t ** 6)

    def point(s, t):
        a = 6.283185307 * s
        return x + radius(t) * math.cos(a), scale * 1.3 * t, z - radius(t) * math.sin(a)

    def normal(s, t):
        a = 6.283185307 * s
        slope = (radius(t + 1e-4) - radius(t - 1e-4)) / 2e-4 / (scale * 1.3)
        return math.cos(a), -slope, -math.sin(a)
    obj.grid(28, 14, point, normal)


def add_banner(obj):
    """Waving cloth with a colour at each vertex."""
    def point(s, t):
        return -3.4 + 1.5 * s, 1.0 + 1.5 * t, -2.2 + 0.16 * math.sin(7 * s + 2 * t)

    def normal(s, t):
        return -0.16 * 7 / 1.5 * math.cos(7 * s + 2 * t), -0.16 * 2 / 1.5 * math.cos(7 * s + 2 * t), 1

    def color(s, t):
        stripe = 0.5 + 0.5 * math.cos(12.566 * t)
        return 0.75 * stripe + 0.1, 0.12 + 0.5 * s * (1 - stripe), 0.15 + 0.6 * (1 - stripe)
    obj.grid(14, 10, point, normal, color)


def add_bush(obj, x, z):
    rng = random.Random(2)
    for i in range(9):
        a = 6.283 * i / 9 + rng.uniform(-0.2, 0.2)
        w, h, lean = 0.5, 0.95, rng.uniform(0.05, 0.3)
        cx, cz = x + 0.2 * math.cos(a), z + 0.2 * math.sin(a)
        tx, tz = -math.sin(a) * w, math.cos(a) * w
        ox, oz = lean * math.cos(a), lean * math.sin(a)
        obj.quad([(cx - tx, 0, cz - tz), (cx + tx, 0, cz + tz), (cx + tx + ox, h, cz + tz + oz),
                  (cx - tx + ox, h, cz - tz + oz)])


def yard():
    obj = Obj("yard.obj", "yard.mtl")
    obj.group("ground", "paving")
    obj.quad([(-5, 0, 5), (5, 0, 5), (5, 0, -5), (-5, 0, -5)], (7, 7))
    obj.group("fence_back", "fence")
    obj.quad([(-4, 0, -3), (4, 0, -3), (4, 1.2, -3), (-4, 1.2, -3)], (14, 1))
    obj.group("fence_side", "fence")
    obj.quad([(4, 0, -3), (4, 0, 3), (4, 1.2, 3), (4, 1.2, -3)], (10.5, 1))
    obj.group("bush", "leaves")
    add_bush(obj, 2.9, -2.0)
    obj.group("wall", "plaster")
    obj.quad([(-4, 0, 3), (-4, 0, -3), (-4, 2.6, -3), (-4, 2.6, 3)])
    obj.group("crate", "red_planks")
    obj.box((-2.6, 0, -0.9), (-1.5, 1.0, 0.2))
    obj.group("bench", "planks")
    obj.box((0.6, 0.42, -1.9), (2.2, 0.5, -1.3))
    obj.box((0.7, 0, -1.85), (0.8, 0.42, -1.35))
    obj.box((2.0, 0, -1.85), (2.1, 0.42, -1.35))
    obj.group("vase", "glaze")
    add_vase(obj, 0.1, 0.4, 1.0)
    obj.group("small_vase", "terracotta")
    add_vase(obj, 1.6, 0.9, 0.55)
    obj.group("banner", "cloth")
    add_banner(obj)
    obj.group("lantern", "lantern")
    obj.box((-2.15, 1.0, -0.45), (-1.95, 1.3, -0.25))
    obj.write()


def stone():
    obj = Obj("stone.obj", "yard.mtl")
    obj.group("stone", "stone")

    def point(s, t):
        a, b = 6.283185307 * s, 3.1415926 * (t - 0.5)
        return math.cos(b) * math.cos(a), math.sin(b), -math.cos(b) * math.sin(a)
    obj.grid(24, 12, point, point)
    obj.write()


paving()
planks()
fence()
leaves()
yard()
stone()
