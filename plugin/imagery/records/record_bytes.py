"""Records of a key and a payload, one after the other in a file that is only ever appended to.

A record: length of the key (4 bytes), of the payload (8 bytes), BLAKE2 of both lengths, the key and the payload
(16 bytes), key (UTF-8), payload; numbers little-endian.
"""
from __future__ import annotations

import struct
from collections.abc import Iterator
from hashlib import blake2b
from typing import BinaryIO

_HEAD = struct.Struct("<IQ16s")
_LENGTHS = struct.Struct("<IQ")


def append_record(file: BinaryIO, end: int, key: str, payload: bytes) -> int:
    """Write a record at the end; the new end. Raises OSError."""
    name = key.encode()
    lengths = _LENGTHS.pack(len(name), len(payload))
    file.seek(end)
    write_all(file, _HEAD.pack(len(name), len(payload), _checksum(lengths, name, payload)) + name + payload)
    return end + _HEAD.size + len(name) + len(payload)


def record_at(file: BinaryIO, place: int, size: int) -> tuple[str, bytes] | None:
    """Key and payload of the record at a place; None where none stands there whole. Raises OSError."""
    file.seek(place)
    head = read_all(file, _HEAD.size)
    if len(head) < _HEAD.size:
        return None
    name_length, payload_length, checksum = _HEAD.unpack(head)
    if place + _HEAD.size + name_length + payload_length > size:
        return None
    name, payload = read_all(file, name_length), read_all(file, payload_length)
    if _checksum(head[: _LENGTHS.size], name, payload) != checksum:
        return None
    return name.decode(), payload


def record_ends(file: BinaryIO, place: int, size: int) -> Iterator[tuple[str, int, int, int]]:
    """Of all records from a place on: key, where it begins, bytes of its payload, where the next one begins.

    Their payloads are not read, so that what was damaged within one shows only when it is. Raises OSError.
    """
    while True:
        file.seek(place)
        head = read_all(file, _HEAD.size)
        if len(head) < _HEAD.size:
            return
        name_length, payload_length, _ = _HEAD.unpack(head)
        end = place + _HEAD.size + name_length + payload_length
        if end > size or not head.strip(b"\0"):
            return
        yield read_all(file, name_length).decode(errors="replace"), place, payload_length, end
        place = end


def is_cut_off(file: BinaryIO, place: int, size: int) -> bool:
    """Whether what follows the last whole record is no more than one that was being written, or nothing.

    After a power loss its pages may be there in part, the others zero.
    """
    file.seek(place)
    head = read_all(file, _HEAD.size)
    if len(head) < _HEAD.size or not head.strip(b"\0"):
        return True
    name_length, payload_length, _ = _HEAD.unpack(head)
    return bool(place + _HEAD.size + name_length + payload_length >= size)


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
