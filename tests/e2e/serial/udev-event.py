#!/usr/bin/env python3
"""Tells programs that listen to udev that a serial port was plugged in or out: udev-event.py add|remove ttyS0

The message has the form of libudev's monitor (systemd, src/libsystemd/sd-device/device-monitor.c): a header with hashes of
subsystem and device type to filter by, then properties, each ended by a zero byte. Listeners believe it from root only."""

import os
import socket
import struct
import sys
import time


def murmur2(data):
    """MurmurHash2 with seed 0, by which udev's messages are filtered."""
    factor, mask = 0x5BD1E995, 0xFFFFFFFF
    value = len(data)
    whole = len(data) // 4 * 4
    for (word,) in struct.iter_unpack("<I", data[:whole]):
        word = word * factor & mask
        word = (word ^ word >> 24) * factor & mask
        value = (value * factor & mask) ^ word
    if rest := data[whole:]:
        value = (value ^ int.from_bytes(rest, "little")) * factor & mask
    value = (value ^ value >> 13) * factor & mask
    return value ^ value >> 15


action, name = sys.argv[1:]
path = os.path.realpath(f"/sys/class/tty/{name}")
major, minor = open(f"{path}/dev").read().strip().split(":")
properties = {
    "ACTION": action,
    "DEVPATH": path.removeprefix("/sys"),
    "SUBSYSTEM": "tty",
    "DEVNAME": f"/dev/{name}",
    "MAJOR": major,
    "MINOR": minor,
    "SEQNUM": time.monotonic_ns() // 1000,
    "USEC_INITIALIZED": 1,
    "ID_BUS": "usb",
    "ID_VENDOR_ID": "0403",
    "ID_MODEL_ID": "6001",
    "ID_MODEL": "Test_cable",
    "ID_SERIAL_SHORT": "TEST0001",
}
body = b"".join(f"{key}={value}".encode() + b"\0" for key, value in properties.items())
header = struct.pack("=8s", b"libudev\0") + struct.pack(">I", 0xFEEDCAFE)
header += struct.pack("=III", 40, 40, len(body)) + struct.pack(">IIII", murmur2(b"tty"), 0, 0, 0)
# 15 is NETLINK_KOBJECT_UEVENT; its group 2 is udev's.
monitor = socket.socket(socket.AF_NETLINK, socket.SOCK_RAW, 15)
monitor.bind((0, 0))
monitor.sendto(header + body, (0, 2))
