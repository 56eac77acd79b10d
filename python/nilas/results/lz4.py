"""Blocks of the LZ4 format, in which the files of a trajectory are packed."""

from __future__ import annotations

# https://github.com/lz4/lz4/blob/dev/doc/lz4_Block_format.md
_SMALLEST_MATCH = 4
_NIBBLE, _BYTE = 15, 255


def expand(block: bytes, size: int) -> bytes:
    """The ``size`` bytes that a block holds. Raises ``ValueError`` where it is damaged.

    >>> expand(bytes([0x14, 97, 1, 0, 0x10, 98]), 10)
    b'aaaaaaaaab'
    """
    out = bytearray()
    at = 0
    try:
        while True:
            token = block[at]
            literals, at = _length(block, at + 1, token >> 4)
            out += block[at : at + literals]
            at += literals
            if at >= len(block):
                break
            distance = block[at] | block[at + 1] << 8
            match, at = _length(block, at + 2, token & _NIBBLE)
            _repeat(out, distance, match + _SMALLEST_MATCH)
    except IndexError:
        raise ValueError("a packed block ends too early") from None
    if len(out) != size:
        raise ValueError(f"a packed block holds {len(out)} bytes in place of {size}")
    return bytes(out)


def _length(block: bytes, at: int, nibble: int) -> tuple[int, int]:
    """A length whose first four bits are ``nibble``, and the place after it."""
    if nibble < _NIBBLE:
        return nibble, at
    while True:
        more = block[at]
        at += 1
        nibble += more
        if more < _BYTE:
            return nibble, at


def _repeat(out: bytearray, distance: int, count: int) -> None:
    """Appends ``count`` bytes that stand ``distance`` bytes before the end, and so on."""
    if not 0 < distance <= len(out):
        raise ValueError("a packed block repeats what stands before its beginning")
    piece = out[-distance:]
    whole, rest = divmod(count, distance)
    out += piece * whole + piece[:rest]
