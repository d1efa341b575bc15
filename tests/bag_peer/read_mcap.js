// read_mcap.js FILE: lists an MCAP file by its index, checks its checksums, and decodes every message by the text
// that the file holds. Written again, each message must have the very same bytes.
const fs = require("fs");
const { McapIndexedReader, McapStreamReader } = require("@mcap/core");
const { decompress } = require("fzstd");
const { MessageReader, MessageWriter } = require("@foxglove/rosmsg2-serialization");
const { definitionsOf } = require("../idl/definitions.js");

const [, , file] = process.argv;
const bytes = fs.readFileSync(file);
const decompressHandlers = { zstd: (data, size) => decompress(data, new Uint8Array(Number(size))) };

/** Whether `raw` is `again` and, where it came over the wire, the zeros that fill its last word. */
function sameBytes(raw, again) {
  const rest = raw.subarray(again.length);
  return again.equals(raw.subarray(0, again.length)) && rest.length < 4 && rest.every((byte) => byte === 0);
}

async function main() {
  const readable = {
    size: async () => BigInt(bytes.length),
    read: async (offset, length) => bytes.subarray(Number(offset), Number(offset + length)),
  };
  const reader = await McapIndexedReader.Initialize({ readable, decompressHandlers });
  if (reader.header.profile !== "ros2") throw new Error(`profile ${reader.header.profile}`);
  const codecs = new Map();
  for (const [id, channel] of reader.channelsById) {
    const schema = reader.schemasById.get(channel.schemaId);
    if (schema.encoding !== "ros2msg") throw new Error(`${channel.topic}: encoding ${schema.encoding}`);
    if (!channel.metadata.get("offered_qos_profiles")) throw new Error(`${channel.topic}: no QoS profile`);
    const definitions = definitionsOf(schema.name, new TextDecoder().decode(schema.data));
    codecs.set(id, { reader: new MessageReader(definitions), writer: new MessageWriter(definitions) });
  }
  let messages = 0;
  let before = 0n;
  for await (const message of reader.readMessages()) {
    const codec = codecs.get(message.channelId);
    const again = Buffer.from(codec.writer.writeMessage(codec.reader.readMessage(message.data)));
    if (!sameBytes(Buffer.from(message.data), again)) throw new Error(`channel ${message.channelId}: other bytes`);
    if (message.logTime < before) throw new Error("log times do not rise");
    before = message.logTime;
    ++messages;
  }
  // Record by record, as one reads what has no index.
  const stream = new McapStreamReader({ decompressHandlers, validateCrcs: true });
  stream.append(bytes);
  let streamed = 0;
  for (let record = stream.nextRecord(); record; record = stream.nextRecord()) streamed += record.type === "Message" ? 1 : 0;
  if (!stream.done()) throw new Error("it does not end as it should");
  if (streamed !== messages || reader.statistics.messageCount !== BigInt(messages))
    throw new Error(`${streamed} streamed, ${reader.statistics.messageCount} counted, ${messages} read`);
  console.log(JSON.stringify({ topics: reader.channelsById.size, messages, chunks: reader.chunkIndexes.length }));
}

main().catch((error) => {
  console.error(error.stack);
  process.exit(1);
});
