// Reads MCAP files: messages by topic, as far as the tests look.
import assert from "node:assert/strict";

/** Times (s) and bytes of the messages of each topic, `{ topic: [[time, bytes], ...] }`. */
export function messagesOf(file) {
  assert.equal(file.subarray(1, 6).toString(), "MCAP0");
  const topics = new Map();
  const messages = {};
  const records = (bytes) => {
    for (let at = 0; at < bytes.length; ) {
      const length = Number(bytes.readBigUInt64LE(at + 1));
      const record = bytes.subarray(at + 9, at + 9 + length);
      // What follows the end of the data repeats it.
      if (bytes[at] === 0x0f) return;
      if (bytes[at] === 0x04) topics.set(record.readUInt16LE(0), record.subarray(8, 8 + record.readUInt32LE(4)).toString());
      if (bytes[at] === 0x05) (messages[topics.get(record.readUInt16LE(0))] ??= []).push([Number(record.readBigUInt64LE(6)) / 1e9, record.subarray(22)]);
      if (bytes[at] === 0x06) {
        const name = record.readUInt32LE(28);
        assert.equal(name, 0, "not compressed");
        records(record.subarray(40, 40 + Number(record.readBigUInt64LE(32))));
      }
      at += 9 + length;
    }
  };
  records(file.subarray(8));
  return messages;
}

/** Positions of `nav_msgs/Odometry` in the frame of that name: they follow two strings. */
export function positions(messages, frame) {
  return messages.map(([, bytes]) => {
    // After the encapsulation, everything is aligned to its size.
    const align = (at, size) => at + ((size - ((at - 4) % size)) % size);
    const text = (at) => [bytes.subarray(at + 4, at + 3 + bytes.readUInt32LE(at)).toString(), at + 4 + bytes.readUInt32LE(at)];
    const [name, child] = text(12);
    assert.equal(name, frame);
    const at = align(text(align(child, 4))[1], 8);
    return [bytes.readDoubleLE(at), bytes.readDoubleLE(at + 8)];
  });
}
