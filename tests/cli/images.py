"""Writers of small pictures, byte by byte. A picture is a list of rows of numbers or tuples."""

import struct
import zlib


def disc(size, height=None, radius=None, open_value=255, opaque=0):
    """A round opening in the middle, a little off the axis so that no symmetry hides a swap."""
    height = height or size
    radius = radius or 0.4 * min(size, height)
    center_x, center_y = 0.5 * size + 1, 0.5 * height + 2

    def value(x, y):
        inside = (x - center_x) ** 2 + (y - center_y) ** 2 < radius ** 2
        bar = abs(y - center_y - 3) < 1.5 and x > center_x
        return open_value if inside and not bar else opaque
    return [[value(x, y) for x in range(size)] for y in range(height)]


def constant(width, height, value):
    return [[value] * width for _ in range(height)]


def mapped(rows, function):
    return [[function(value) for value in row] for row in rows]


def flat(rows):
    """All samples of all pixels in one list."""
    return [s for row in rows for value in row
            for s in (value if isinstance(value, tuple) else (value,))]


# PNG.

GREY, RGB, PALETTE, GREY_ALPHA, RGBA = 0, 2, 3, 4, 6


def _chunk(name, data):
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def png_header(width, height, bits=8, kind=GREY):
    return b"\x89PNG\r\n\x1a\n" + _chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, bits, kind,
                                                             0, 0, 0))


def png(rows, bits=8, kind=GREY, palette=None):
    code = "B" if bits == 8 else "H"
    lines = b"".join(b"\0" + struct.pack(f">{len(s)}{code}", *s) for s in (flat([r]) for r in rows))
    colors = _chunk(b"PLTE", bytes(c for color in palette for c in color)) if palette else b""
    return (png_header(len(rows[0]), len(rows), bits, kind) + colors
            + _chunk(b"IDAT", zlib.compress(lines)) + _chunk(b"IEND", b""))


def png_size(data):
    """Width and height of a whole PNG file; checks every chunk and the length of the pixels."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at, chunks = 8, []
    while at < len(data):
        length, = struct.unpack_from(">I", data, at)
        name, content = data[at + 4:at + 8], data[at + 8:at + 8 + length]
        assert struct.unpack_from(">I", data, at + 8 + length)[0] == zlib.crc32(name + content)
        chunks.append((name, content))
        at += 12 + length
    assert chunks[0][0] == b"IHDR" and chunks[-1] == (b"IEND", b"")
    width, height, bits, kind = struct.unpack_from(">IIBB", chunks[0][1])
    channels = {GREY: 1, RGB: 3, RGBA: 4}[kind]
    pixels = zlib.decompress(b"".join(c for n, c in chunks if n == b"IDAT"))
    assert len(pixels) == height * (1 + width * channels * bits // 8)
    return width, height, bits, kind, pixels


# PNM, BMP, TIFF.

def pgm(rows, maximum=255):
    code = "B" if maximum < 256 else "H"
    values = flat(rows)
    return (f"P5\n{len(rows[0])} {len(rows)}\n{maximum}\n".encode()
            + struct.pack(f">{len(values)}{code}", *values))


def pfm(rows):
    """Grey, 32-bit float, rows from the bottom up."""
    values = flat(rows[::-1])
    return (f"Pf\n{len(rows[0])} {len(rows)}\n-1.0\n".encode()
            + struct.pack(f"<{len(values)}f", *values))


def bmp(rows):
    """24 bits a pixel."""
    width, height = len(rows[0]), len(rows)
    padding = b"\0" * (-3 * width % 4)
    lines = b"".join(b"".join(bytes((v, v, v)) for v in row) + padding for row in rows[::-1])
    return (b"BM" + struct.pack("<IHHI", 54 + len(lines), 0, 0, 54)
            + struct.pack("<IiiHHIIiiII", 40, width, height, 1, 24, 0, len(lines), 2835, 2835, 0, 0)
            + lines)


def tiff(rows, code="B", width=None, height=None):
    """Uncompressed, one channel, one strip; `code` is B, H or f. The sizes said may be false."""
    values = flat(rows)
    pixels = struct.pack(f"<{len(values)}{code}", *values)
    bits = 8 * struct.calcsize(code)
    start = 8 + 2 + 12 * 10 + 4
    tags = [(256, len(rows[0]) if width is None else width),
            (257, len(rows) if height is None else height), (258, bits), (259, 1), (262, 1),
            (273, start), (277, 1), (278, len(rows)), (279, len(pixels)),
            (339, 3 if code == "f" else 1)]
    directory = struct.pack("<H", len(tags))
    directory += b"".join(struct.pack("<HHII", tag, 4, 1, value) for tag, value in tags)
    return b"II*\0" + struct.pack("<I", 8) + directory + struct.pack("<I", 0) + pixels


def cut(data, share=0.6):
    return data[:int(len(data) * share)]
