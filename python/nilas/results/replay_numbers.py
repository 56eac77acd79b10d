"""Numbers of a replay frame, which are packed by arithmetic coding.

``docs/reference/replay-file.md`` describes the coding under "Coded numbers".
"""

from __future__ import annotations

NO_PAST = 6  # there was no number before
_MOST_DIGITS = 5
_PASTS = NO_PAST + 1
_LENGTHS = 20
_SHARE_BITS, _LEARNING = 12, 5
_ONE = 1 << _SHARE_BITS
_EVEN = _ONE // 2
_LEAST_RANGE = 1 << 24
_WHOLE = 0xFFFFFFFF
# Places of the shares of one kind and past: that of zero, that of the sign, then two lists.
_ZERO, _SIGN, _LONGER, _SECOND = 0, 1, 1, 1 + _LENGTHS
_SHARES = 2 + 2 * _LENGTHS


class NumberReader:
    """Reads the coded numbers of frames in turn.

    >>> reader = NumberReader()
    >>> reader.begin(bytes(4))
    >>> reader.numbers(0, [NO_PAST, NO_PAST])
    [0, 0]
    """

    def __init__(self) -> None:
        self._shares: dict[tuple[int, int], list[int]] = {}
        self._data = b""
        self._at = 0
        self._range = _WHOLE
        self._code = 0

    def forget(self) -> None:
        """All shares are even again, as at a key frame.

        >>> reader, data = NumberReader(), bytes([200, 1, 2, 3])
        >>> reader.begin(data)
        >>> first = reader.numbers(0, [NO_PAST] * 4)
        >>> reader.forget()
        >>> reader.begin(data)
        >>> reader.numbers(0, [NO_PAST] * 4) == first
        True
        """
        self._shares.clear()

    def begin(self, data: bytes) -> None:
        """Starts with the bytes of the next frame.

        >>> reader = NumberReader()
        >>> reader.begin(bytes(4))
        >>> reader.numbers(0, [NO_PAST])
        [0]
        """
        self._data = data
        self._at = 4
        self._range = _WHOLE
        self._code = int.from_bytes(data[:4].ljust(4, b"\0"), "big")

    def numbers(self, kind: int, pasts: list[int]) -> list[int]:
        """The next numbers of a kind. ``pasts`` has the past of each, and afterwards its own.

        >>> reader, pasts = NumberReader(), [NO_PAST]
        >>> reader.begin(bytes(4))
        >>> reader.numbers(0, pasts), pasts
        ([0], [0])
        """
        numbers = []
        for place, past in enumerate(pasts):
            shares = self._shares.get((kind, past))
            if shares is None:
                shares = self._shares[kind, past] = [_EVEN] * _SHARES
            number = self._number(shares)
            pasts[place] = min(_MOST_DIGITS, abs(number).bit_length())
            numbers.append(number)
        return numbers

    def _number(self, shares: list[int]) -> int:
        if self._digit(shares, _ZERO) == 0:
            return 0
        negative = self._digit(shares, _SIGN)
        digits = 1
        while self._digit(shares, _LONGER + min(digits, _LENGTHS)):
            digits += 1
        size = 1
        if digits > 1:
            size = 2 | self._digit(shares, _SECOND + min(digits, _LENGTHS))
            for _ in range(digits - 2):
                size = size << 1 | self._even_digit()
        return -size if negative else size

    def _digit(self, shares: list[int], place: int) -> int:
        share = shares[place]
        bound = (self._range >> _SHARE_BITS) * share
        if self._code < bound:
            self._range = bound
            shares[place] = share + ((_ONE - share) >> _LEARNING)
            digit = 0
        else:
            self._range -= bound
            self._code -= bound
            shares[place] = share - (share >> _LEARNING)
            digit = 1
        if self._range < _LEAST_RANGE:
            self._narrow()
        return digit

    def _even_digit(self) -> int:
        self._range >>= 1
        digit = 0
        if self._code >= self._range:
            self._code -= self._range
            digit = 1
        if self._range < _LEAST_RANGE:
            self._narrow()
        return digit

    def _narrow(self) -> None:
        while self._range < _LEAST_RANGE:
            byte = self._data[self._at] if self._at < len(self._data) else 0
            self._at += 1
            self._range <<= 8
            self._code = self._code << 8 | byte
