"""A minimal reader and writer of OpenEXR: one part, scan lines, no subsampling."""

import array
import itertools
import struct
import zlib
from dataclasses import dataclass

MAGIC = b"\x76\x2f\x31\x01"
UNCOMPRESSED, ZIPS, ZIP = 0, 2, 3
LINES_PER_BLOCK = {UNCOMPRESSED: 1, ZIPS: 1, ZIP: 16}
PIXEL_TYPES = {0: ("uint", "I"), 1: ("half", "e"), 2: ("float", "f")}
NUMBERS = {"int": "i", "float": "f", "double": "d", "v2f": "2f", "v3f": "3f", "v2i": "2i",
           "box2i": "4i", "chromaticities": "8f", "compression": "B", "lineOrder": "B"}


@dataclass
class Picture:
    size: tuple  # width, height
    types: dict  # attribute -> name of its type
    attributes: dict  # attribute -> value; one number, a tuple or text
    channel_types: dict  # channel -> "half" or "float"
    channels: dict  # channel -> array of its values, row by row

    def luminance(self):
        """Y of every pixel, from the chromaticities."""
        if "Y" in self.channels:
            return list(self.channels["Y"])
        weights = luminance_weights(self.attributes["chromaticities"])
        return [sum(w * v for w, v in zip(weights, rgb)) for rgb in self.pixels()]

    def pixels(self):
        names = "XYZ" if "Y" in self.channels else "RGB"
        return zip(*(self.channels[name] for name in names))

    def sums(self):
        names = "XYZ" if "Y" in self.channels else "RGB"
        return [sum(self.channels[name]) for name in names]


def luminance_weights(chromaticities):
    """The Y row of the matrix from RGB to XYZ: solves sum of weights * primary = white."""
    def xyz(x, y):
        return (x / y, 1.0, (1 - x - y) / y)
    columns = [xyz(*chromaticities[i:i + 2]) for i in (0, 2, 4)]
    white = xyz(*chromaticities[6:8])

    def determinant(a, b, c):
        return (a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1])
                + c[0] * (a[1] * b[2] - a[2] * b[1]))
    whole = determinant(*columns)
    return [determinant(*(white if i == k else c for i, c in enumerate(columns))) / whole
            for k in range(3)]


def _text_z(data, at):
    end = data.index(0, at)
    return data[at:end].decode(), end + 1


def _value(kind, raw):
    if kind == "string":
        return raw.decode()
    if kind in NUMBERS:
        numbers = struct.unpack("<" + NUMBERS[kind], raw)
        return numbers[0] if len(numbers) == 1 else numbers
    return raw


def read_header(data):
    """Attributes as {name: (type, raw bytes)} and where the header ends."""
    if data[:4] != MAGIC:
        raise ValueError("no OpenEXR file")
    attributes, at = {}, 8
    while data[at]:
        name, at = _text_z(data, at)
        kind, at = _text_z(data, at)
        size, = struct.unpack_from("<i", data, at)
        attributes[name] = (kind, data[at + 4:at + 4 + size])
        at += 4 + size
    return attributes, at + 1


def _channel_list(raw):
    channels, at = {}, 0
    while raw[at]:
        name, at = _text_z(raw, at)
        channels[name] = PIXEL_TYPES[struct.unpack_from("<i", raw, at)[0]]
        at += 16
    return channels


def _unzipped(data):
    data = zlib.decompress(data)
    data = bytes(itertools.accumulate(data, lambda a, b: (a + b - 128) & 255))
    result = bytearray(len(data))
    half = (len(data) + 1) // 2
    result[0::2], result[1::2] = data[:half], data[half:]
    return bytes(result)


def read(path):
    with open(path, "rb") as file:
        data = file.read()
    header, at = read_header(data)
    attributes = {name: _value(*attribute) for name, attribute in header.items()}
    kinds = _channel_list(attributes["channels"])
    left, top, right, bottom = attributes["dataWindow"]
    width, height = right - left + 1, bottom - top + 1
    per_block = LINES_PER_BLOCK[attributes["compression"]]
    offsets = struct.unpack_from(f"<{-(-height // per_block)}Q", data, at)
    channels = {name: array.array("f") for name in kinds}
    for offset in offsets:
        line, size = struct.unpack_from("<ii", data, offset)
        lines = min(per_block, bottom + 1 - line)
        raw_size = lines * width * sum(struct.calcsize(code) for _, code in kinds.values())
        block = data[offset + 8:offset + 8 + size]
        if size < raw_size:
            block = _unzipped(block)
        at = 0
        for _ in range(lines):
            for name, (_, code) in kinds.items():
                channels[name].extend(struct.unpack_from(f"<{width}{code}", block, at))
                at += width * struct.calcsize(code)
    return Picture((width, height), {name: kind for name, (kind, _) in header.items()}, attributes,
                   {name: kind for name, (kind, _) in kinds.items()}, channels)


def header_bytes(attributes):
    """A header of {name: (type, raw bytes)}."""
    parts = [MAGIC, struct.pack("<I", 2)]
    for name, (kind, raw) in attributes.items():
        parts += [name.encode(), b"\0", kind.encode(), b"\0", struct.pack("<i", len(raw)), raw]
    return b"".join(parts) + b"\0"


def plain_attributes(names, width, height, halves=(), corner=(0, 0)):
    box = struct.pack("<4i", *corner, corner[0] + width - 1, corner[1] + height - 1)
    channels = b"".join(n.encode() + b"\0" + struct.pack("<iB3xii", 1 if n in halves else 2, 0, 1, 1)
                        for n in sorted(names))
    return {"channels": ("chlist", channels + b"\0"), "compression": ("compression", b"\0"),
            "dataWindow": ("box2i", box), "displayWindow": ("box2i", box),
            "lineOrder": ("lineOrder", b"\0"), "pixelAspectRatio": ("float", struct.pack("<f", 1)),
            "screenWindowCenter": ("v2f", struct.pack("<2f", 0, 0)),
            "screenWindowWidth": ("float", struct.pack("<f", 1))}


def encode(channels, width, height, attributes=None, halves=(), corner=(0, 0)):
    """An uncompressed file of {name: values row by row}: 32-bit floats but for the `halves`. The
    data window begins at `corner`; `attributes` are {name: (type, raw bytes)}."""
    header = header_bytes(plain_attributes(channels, width, height, halves, corner)
                          | (attributes or {}))
    lines = []
    for y in range(height):
        rows = b"".join(struct.pack(f"<{width}{'e' if n in halves else 'f'}",
                                    *channels[n][y * width:(y + 1) * width])
                        for n in sorted(channels))
        lines.append(struct.pack("<ii", corner[1] + y, len(rows)) + rows)
    offset, offsets = len(header) + 8 * height, []
    for line in lines:
        offsets.append(offset)
        offset += len(line)
    return header + struct.pack(f"<{height}Q", *offsets) + b"".join(lines)


def with_attributes(data, change):
    """The file with its header changed by `change`, a function of {name: (type, raw bytes)}."""
    attributes, end = read_header(data)
    changed = dict(attributes)
    change(changed)
    header = header_bytes(changed)
    _, _, _, bottom = struct.unpack("<4i", attributes["dataWindow"][1])
    _, top, _, _ = struct.unpack("<4i", attributes["dataWindow"][1])
    count = -(-(bottom - top + 1) // LINES_PER_BLOCK[attributes["compression"][1][0]])
    offsets = struct.unpack_from(f"<{count}Q", data, end)
    moved = [offset + len(header) - end for offset in offsets]
    return header + struct.pack(f"<{count}Q", *moved) + data[end + 8 * count:]
