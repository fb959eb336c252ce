"""Records of a key and a payload, one after the other in a file that is only ever appended to.

A record: ``_MARK``, length of the key (4 bytes), of the payload (8 bytes), CRC-32 of the key, CRC-32 of both lengths
and that, BLAKE2 of both lengths, the key and the payload (16 bytes), key (UTF-8), payload; numbers little-endian.
"""
from __future__ import annotations

import struct
import zlib
from collections.abc import Iterator
from hashlib import blake2b
from typing import BinaryIO, NamedTuple

_MARK = b"\xa5Rec"  # no UTF-8, by which records are found again behind a damaged place
_HEAD = struct.Struct("<4sIQII16s")
_LENGTHS = struct.Struct("<IQ")
_SUMMED = struct.Struct("<IQI")
_AT_ONCE = 2**20  # bytes that are searched in one step


class _Head(NamedTuple):
    name_length: int
    payload_length: int
    name_sum: int
    checksum: bytes
    end: int
    """Where the next record begins."""


def _head_at(file: BinaryIO, place: int) -> _Head | None:
    """None where none stands whole and undamaged. Raises OSError."""
    file.seek(place)
    head = read_all(file, _HEAD.size)
    if len(head) < _HEAD.size:
        return None
    mark, name_length, payload_length, name_sum, head_sum, checksum = _HEAD.unpack(head)
    if mark != _MARK or zlib.crc32(_SUMMED.pack(name_length, payload_length, name_sum)) != head_sum:
        return None
    return _Head(name_length, payload_length, name_sum, checksum, place + _HEAD.size + name_length + payload_length)


def append_record(file: BinaryIO, end: int, key: str, payload: bytes) -> int:
    """Write a record at the end; the new end. Raises OSError."""
    name = key.encode()
    lengths = _LENGTHS.pack(len(name), len(payload))
    file.seek(end)
    summed = len(name), len(payload), zlib.crc32(name)
    head = _HEAD.pack(_MARK, *summed, zlib.crc32(_SUMMED.pack(*summed)), _checksum(lengths, name, payload))
    write_all(file, head + name + payload)
    return end + _HEAD.size + len(name) + len(payload)


def record_at(file: BinaryIO, place: int, size: int) -> tuple[str, bytes] | None:
    """Key and payload of the record at a place; None where none stands there whole. Raises OSError."""
    head = _head_at(file, place)
    if head is None or head.end > size:
        return None
    name, payload = read_all(file, head.name_length), read_all(file, head.payload_length)
    if _checksum(_LENGTHS.pack(len(name), len(payload)), name, payload) != head.checksum:
        return None
    return name.decode(), payload


def record_ends(file: BinaryIO, place: int, size: int) -> Iterator[tuple[str, int, int, int]]:
    """Of all records from a place on: key, where it begins, bytes of its payload, where it ends.

    Their payloads are not read, so that what was damaged within one shows only when it is. What stands between two of
    them is the rest of damaged ones. Raises OSError.
    """
    while True:
        head = _head_at(file, place)
        if head is not None and head.end <= size:
            name = read_all(file, head.name_length)
            if zlib.crc32(name) == head.name_sum:
                yield name.decode(), place, head.payload_length, head.end
            place = head.end
        elif (found := _next_record(file, place + 1, size)) is not None:
            place = found
        else:
            return


def _next_record(file: BinaryIO, place: int, size: int) -> int | None:
    """Where the first whole record begins that stands at a place or behind it. Raises OSError."""
    while place < size:
        file.seek(place)
        part = read_all(file, _AT_ONCE)
        found = part.find(_MARK)
        while found >= 0:
            if record_at(file, place + found, size) is not None:
                return place + found
            found = part.find(_MARK, found + 1)
        place += max(len(part) - len(_MARK) + 1, 1)
    return None


def is_cut_off(file: BinaryIO, place: int, size: int) -> bool:
    """Whether what follows the last whole record is no more than one that was being written, or nothing.

    After a power loss its pages may be there in part, the others zero.
    """
    file.seek(place)
    head = read_all(file, _HEAD.size)
    if len(head) < _HEAD.size or not head.strip(b"\0"):
        return True
    whole = _head_at(file, place)
    return whole is not None and whole.end >= size


def record_size(key: str, payload: bytes) -> int:
    """Bytes of a record in its file."""
    return _HEAD.size + len(key.encode()) + len(payload)


def _checksum(lengths: bytes, name: bytes, payload: bytes) -> bytes:
    digest = blake2b(lengths, digest_size=16)
    digest.update(name)
    digest.update(payload)
    return digest.digest()


def write_all(file: BinaryIO, data: bytes) -> None:
    """Raises OSError."""
    rest = memoryview(data)
    while rest:
        rest = rest[file.write(rest):]


def read_all(file: BinaryIO, length: int) -> bytes:
    """That many bytes, or those up to the end of the file. Raises OSError."""
    parts, rest = [], length
    while rest and (part := file.read(rest)):
        parts.append(part)
        rest -= len(part)
    return b"".join(parts)
