#!/usr/bin/env python3
"""Tests of tools/sentences/shrink.mjs: a small network, read back."""

import json
import pathlib
import shutil
import struct
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
NODE = shutil.which("node")

STACK = "module/Encoder_en/Encode"


def layer(number, width, wide, head):
    base = f"{STACK}/Layer_{number}/TransformerLayer"
    attention = base + "/MultiheadAttention/"
    made = {
        attention + "qkv_transform_single/kernel": [1, 1, width, 3 * width],
        attention + "qkv_transform_single/bias": [3 * width],
        attention + "output_transform_single/kernel": [1, 1, width, wide],
        attention + "output_transform_single/bias": [wide],
        base + "/FFN/conv1/Tensordot/Reshape_1": [wide, 6],
        base + "/FFN/conv1/bias": [6],
        base + "/FFN/conv2/Tensordot/Reshape_1": [6, wide],
        base + "/FFN/conv2/bias": [wide],
    }
    for part, size in (("", width), ("/FFN", wide)):
        for what in ("scale", "bias"):
            name = f"{base}{part}/layer_prepostprocess/layer_norm/layer_norm_{what}"
            made[name] = [size]
    if wide != width:
        made[base + "/dense/kernel"] = [width, wide]
        made[base + "/dense/bias"] = [wide]
    return made, {attention + "split_heads/split_last_dimension/Reshape/shape/3": head}


class Reader:
    def __init__(self, data):
        self.data, self.at = data, 0

    def number(self):
        value = shift = 0
        while True:
            byte = self.data[self.at]
            self.at += 1
            value |= (byte & 0x7F) << shift
            shift += 7
            if byte < 0x80:
                return value

    def block(self):
        size = self.number()
        self.at += size
        return self.data[self.at - size:self.at]

    def floats(self):
        block = self.block()
        return list(struct.unpack(f"<{len(block) // 4}f", block))

    def table(self):
        rows, columns = self.number(), self.number()
        steps = self.floats()
        numbers = struct.unpack(f"<{rows * columns}b", self.block())
        return [[step * one for one in numbers[at * columns:(at + 1) * columns]]
                for at, step in enumerate(steps)]

    def dense(self):
        return self.table(), self.floats()


@unittest.skipUnless(NODE, "node is not installed: it is untested")
class Shrink(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shapes = {"module/Embeddings_en": [4, 2],
                  "module/tanh_layer_0/weights": [4, 3],
                  "module/tanh_layer_0/bias": [3]}
        heads = {}
        for one, more in (layer(0, 2, 4, 1), layer(1, 4, 4, 2)):
            shapes |= one
            heads |= more
        cls.weights, manifest, data = {}, [], b""
        for name, shape in shapes.items():
            count = 1
            for size in shape:
                count *= size
            # As different as they can be, and each told from the others.
            numbers = [((7 * at + len(cls.weights)) % 255 - 127) / 127
                       for at in range(count)]
            cls.weights[name] = numbers
            manifest.append({"name": name, "shape": shape, "dtype": "float32"})
            data += struct.pack(f"<{count}f", *numbers)
        for name, head in heads.items():
            manifest.append({"name": name, "shape": [], "dtype": "int32"})
            data += struct.pack("<i", head)
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            half = len(data) // 2
            (folder / "one").write_bytes(data[:half])
            (folder / "two").write_bytes(data[half:])
            (folder / "vocab.json").write_text(json.dumps(
                [["?", 0], ["\u2581taxi", -3.5], ["s", -4]]))
            (folder / "model.json").write_text(json.dumps({"weightsManifest": [
                {"paths": ["one", "two"], "weights": manifest}]}))
            made = folder / "sentences.encoder"
            subprocess.run([NODE, ROOT / "tools/sentences/shrink.mjs", folder,
                            made], timeout=60, check=True)
            cls.data = made.read_bytes()

    def close(self, left, right):
        self.assertEqual(len(left), len(right))
        for one, other in zip(left, right):
            self.assertAlmostEqual(one, other, delta=0.005)

    def same_dense(self, reader, kernel, bias):
        rows, added = reader.dense()
        numbers = self.weights[kernel]
        self.close(added, self.weights[bias])
        for column, row in enumerate(rows):
            self.close(row, numbers[column::len(added)])

    def test_writes_all_parts_in_their_order(self):
        self.assertEqual(self.data[:8], b"PARLOURS")
        reader = Reader(self.data[8:])
        pieces = [reader.block().decode() for _ in range(reader.number())]
        self.assertEqual(pieces, ["?", "\u2581taxi", "s"])
        self.close(reader.floats(), [0, -3.5, -4])
        meanings = reader.table()
        # Of pieces that have no text, there is nothing.
        self.close(sum(meanings, []), self.weights["module/Embeddings_en"][:6])
        self.assertEqual(reader.number(), 2)
        for number in range(2):
            base = f"{STACK}/Layer_{number}/TransformerLayer"
            attention = base + "/MultiheadAttention/"
            norm = "/layer_prepostprocess/layer_norm/layer_norm_"
            self.assertEqual(reader.number(), 2)
            for what in ("scale", "bias"):
                self.close(reader.floats(), self.weights[base + norm + what])
            for step in ("qkv", "output"):
                self.same_dense(reader, f"{attention}{step}_transform_single/kernel",
                                f"{attention}{step}_transform_single/bias")
            if number == 0:
                self.same_dense(reader, base + "/dense/kernel", base + "/dense/bias")
            for what in ("scale", "bias"):
                self.close(reader.floats(), self.weights[base + "/FFN" + norm + what])
            for step in ("conv1", "conv2"):
                self.same_dense(reader, f"{base}/FFN/{step}/Tensordot/Reshape_1",
                                f"{base}/FFN/{step}/bias")
        self.same_dense(reader, "module/tanh_layer_0/weights",
                        "module/tanh_layer_0/bias")
        self.assertEqual(reader.at, len(reader.data))


if __name__ == "__main__":
    unittest.main()
