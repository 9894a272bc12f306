"""Small good files of every mesh format, written from the formats' definitions.

All meshes are the same: a square pyramid of one quad and four triangles. All terrains are the
same: three rows of four heights, one of them not known.
"""

import base64
import io
import json
import struct
import zipfile
import zlib

import numpy as np

POINTS = [(0.0, 0.0, 0.0), (2.0, 0.0, 0.0), (2.0, 2.0, 0.0), (0.0, 2.0, 0.0), (1.0, 1.0, 1.5)]
FACES = [(3, 2, 1, 0), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]
UV = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.5, 0.5)]
HEIGHTS = np.array([[9.0, 8.0, 7.0, 6.0], [5.0, 4.0, 3.0, 2.0], [1.0, 0.0, 1.0, np.nan]])
KNOWN_CELLS = 5


def obj(*, uv=True, end="\n"):
    lines = ["# a pyramid", "o Pyramid", *(f"v {x} {y} {z}" for x, y, z in POINTS)]
    lines += [f"vt {u} {v}" for u, v in UV] if uv else []
    for i, face in enumerate(FACES):
        lines += ["g Base" if i == 0 else "g Sides"] if i < 2 else []
        lines += ["f " + " ".join(f"{n + 1}/{n + 1}" if uv else f"{n + 1}" for n in face)]
    return (end.join(lines) + end).encode()


def ply(order="ascii", *, uv=True):
    kinds = {"ascii": "ascii", "<": "binary_little_endian", ">": "binary_big_endian"}
    header = ["ply", f"format {kinds[order]} 1.0", "comment a pyramid", "element vertex 5"]
    header += [f"property float {name}" for name in ("xyz" if not uv else "xyzst")]
    header += ["element face 5", "property list uchar int vertex_indices", "end_header\n"]
    head = "\n".join(header).encode()
    rows = [(*p, *(t if uv else ())) for p, t in zip(POINTS, UV, strict=True)]
    if order == "ascii":
        lines = [" ".join(map(str, row)) for row in rows]
        lines += [" ".join(map(str, (len(face), *face))) for face in FACES]
        return head + ("\n".join(lines) + "\n").encode()
    body = b"".join(struct.pack(f"{order}{len(row)}f", *row) for row in rows)
    return head + body + b"".join(struct.pack(f"{order}B{len(f)}i", len(f), *f) for f in FACES)


def triangles():
    """The faces as triangles, each with its three points."""
    fans = [(f[0], f[i], f[i + 1]) for f in FACES for i in range(1, len(f) - 1)]
    return [[POINTS[n] for n in fan] for fan in fans]


def stl_binary(head=b"solid or not"):
    facets = [struct.pack("<12fH", 0, 0, 0, *np.ravel(t), 0) for t in triangles()]
    return head.ljust(80) + struct.pack("<I", len(facets)) + b"".join(facets)


def stl_text():
    lines = ["solid Pyramid"]
    for triangle in triangles():
        lines += ["  facet normal 0 0 0", "    outer loop"]
        lines += [f"      vertex {x:e} {y:e} {z:e}" for x, y, z in triangle]
        lines += ["    endloop", "  endfacet"]
    return "\n".join([*lines, "endsolid Pyramid\n"]).encode()


def off(header="OFF\n5 5 0"):
    lines = [header, *(f"{x} {y} {z}" for x, y, z in POINTS)]
    lines += [" ".join(map(str, (len(face), *face))) for face in FACES]
    return ("\n".join(lines) + "\n").encode()


def gltf_parts():
    """The document, and the buffer that it is about."""
    order = [POINTS.index(tuple(p)) for triangle in triangles() for p in triangle]
    parts = [np.array(POINTS, "<f4"), np.array(UV, "<f4"), np.array(order, "<u2")]
    raw = [part.tobytes() for part in parts]
    starts = np.cumsum([0, *map(len, raw)]).tolist()
    views = [
        {"buffer": 0, "byteOffset": start, "byteLength": len(part)}
        for start, part in zip(starts[:-1], raw, strict=True)
    ]
    accessors = [
        {"bufferView": 0, "componentType": 5126, "count": 5, "type": "VEC3"},
        {"bufferView": 1, "componentType": 5126, "count": 5, "type": "VEC2"},
        {"bufferView": 2, "componentType": 5123, "count": len(order), "type": "SCALAR"},
    ]
    primitive = {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2}
    document = {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"name": "Pyramid", "primitives": [primitive]}],
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [{"byteLength": starts[-1]}],
    }
    return document, b"".join(raw)


def glb(document=None, buffer=None):
    own, raw = gltf_parts()
    text = json.dumps(document or own).encode()
    text += b" " * (-len(text) % 4)
    chunk = raw if buffer is None else buffer
    chunk += b"\0" * (-len(chunk) % 4)
    parts = [struct.pack("<I4s", len(text), b"JSON"), text]
    parts += [struct.pack("<I4s", len(chunk), b"BIN\0"), chunk]
    body = b"".join(parts)
    return struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body


def gltf(**changes):
    document, raw = gltf_parts()
    uri = "data:application/octet-stream;base64," + base64.b64encode(raw).decode()
    document["buffers"][0]["uri"] = uri
    return json.dumps({**document, **changes}).encode()


def esri_grid(header="ncols 4\nnrows 3\nxllcorner 100\nyllcorner 200\ncellsize 10\n"):
    rows = "\n".join(" ".join(map(str, row)) for row in np.nan_to_num(HEIGHTS, nan=-9999.0))
    return f"{header}NODATA_value -9999\n{rows}\n".encode()


def xyz(separator=" "):
    rows = [
        f"{500 + 10 * column}{separator}{300 - 10 * row}{separator}{height}"
        for (row, column), height in np.ndenumerate(HEIGHTS)
        if np.isfinite(height)
    ]
    return ("\n".join(rows) + "\n").encode()


def npy(array=HEIGHTS):
    stream = io.BytesIO()
    np.save(stream, array)
    return stream.getvalue()


def npz(**arrays):
    stream = io.BytesIO()
    np.savez_compressed(stream, **(arrays or {"elevation": HEIGHTS, "dx": 10.0, "dy": 10.0}))
    return stream.getvalue()


def hgt(side=201):
    heights = np.zeros((side, side), ">i2")
    heights[:3, :4] = np.nan_to_num(HEIGHTS, nan=-32768)
    return heights.tobytes()


def png(pixels, *, filters=(0,)):
    """A picture (rows, columns, channels) of 8 or 16 bits, row i with filter i of `filters`."""
    rows, columns, channels = pixels.shape
    raw = pixels.astype(">u2" if pixels.dtype == np.uint16 else "u1").tobytes()
    bits, color = 8 * pixels.dtype.itemsize, {1: 0, 2: 4, 3: 2, 4: 6}[channels]
    lines = np.frombuffer(raw, "u1").reshape(rows, -1).astype(int)
    packed = bytearray()
    for i, line in enumerate(lines):
        kind = filters[i % len(filters)]
        above = lines[i - 1] if i else np.zeros_like(line)
        packed.append(kind)
        packed += bytes(filtered(kind, line, above, channels * bits // 8))
    header = struct.pack(">IIBBBBB", columns, rows, bits, color, 0, 0, 0)
    parts = [(b"IHDR", header), (b"IDAT", zlib.compress(bytes(packed))), (b"IEND", b"")]
    return b"\x89PNG\r\n\x1a\n" + b"".join(png_part(*part) for part in parts)


def png_part(kind, content):
    check = zlib.crc32(kind + content)
    return struct.pack(">I4s", len(content), kind) + content + struct.pack(">I", check)


def filtered(kind, line, above, back):
    """The differences that a filter writes, byte by byte, as the standard has them."""
    for i, value in enumerate(line):
        a, b = (line[i - back] if i >= back else 0), above[i]
        c = above[i - back] if i >= back else 0
        guesses = sorted((a, b, c), key=lambda guess: abs(a + b - c - guess))
        yield (value - (0, a, b, (a + b) // 2, guesses[0])[kind]) % 256


def height_picture(**how):
    pixels = np.nan_to_num(100 * HEIGHTS).astype(np.uint16)[..., None]
    opaque = np.isfinite(HEIGHTS).astype(np.uint16)[..., None] * 65535
    return png(np.concatenate([pixels, opaque], axis=2), **how)


def usgs_dem():
    """Profiles from south to north, one for each column; the last begins one row later."""
    head = f"{'A SMALL SHEET':<144}{1:6}{1:6}{1:6}{10:6}{'0.0D+00':>24}".ljust(528)
    head += f"{2:6}{2:6}{4:6}".ljust(816 - 528)
    head += "".join(f"{step:12.6E}" for step in (10.0, 10.0, 1.0)) + "     1     4"
    records = [head.ljust(1024)]
    for column, heights in enumerate(HEIGHTS.T[:, ::-1]):
        known = [int(height) for height in heights if np.isfinite(height)]
        place = (1000.0 + 10.0 * column, 2000.0 + 10.0 * (len(heights) - len(known)), 0.0)
        record = f"{1:6}{column + 1:6}{len(known):6}{1:6}"
        record += "".join(f"{x:24.15E}".replace("E", "D") for x in (*place, 0.0, 9.0))
        records.append((record + "".join(f"{height:6}" for height in known)).ljust(1024))
    return "".join(records).encode()


def zip_of(**members):
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in members.items():
            archive.writestr(name, content)
    return stream.getvalue()


MESHES = {
    "a.obj": obj(),
    "text.ply": ply(),
    "little.ply": ply("<"),
    "big.ply": ply(">"),
    "text.stl": stl_text(),
    "binary.stl": stl_binary(),
    "a.off": off(),
    "a.glb": glb(),
    "a.gltf": gltf(),
}
TERRAINS = {
    "a.asc": esri_grid(),
    "a.xyz": xyz(),
    "a.npy": npy(),
    "a.npz": npz(),
    "N46W123.hgt": hgt(),
    "a.png": height_picture(filters=(0, 1, 4)),
    "a.dem": usgs_dem(),
}
ALL = MESHES | TERRAINS
