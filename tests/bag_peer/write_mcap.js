// write_mcap.js FILE chunked|plain: writes an MCAP file as Foxglove's own writer does: 500 messages of /talk and /walk, every
// other one, 10 ms after each other, with or without chunks and their indexes.
const { open } = require("fs/promises");
const { McapWriter } = require("@mcap/core");

const [, , file, how] = process.argv;

async function main() {
  const handle = await open(file, "w");
  let at = 0n;
  const writable = {
    write: async (bytes) => {
      at += BigInt((await handle.write(bytes)).bytesWritten);
    },
    position: () => at,
  };
  const writer = new McapWriter({ writable, useChunks: how === "chunked", chunkSize: 2000 });
  await writer.start({ profile: "ros2", library: "peer" });
  const schemaId = await writer.registerSchema({ name: "std_msgs/msg/String", encoding: "ros2msg",
    data: new TextEncoder().encode("string data") });
  const channels = [];
  for (const topic of ["/talk", "/walk"]) {
    channels.push(await writer.registerChannel({ topic, schemaId, messageEncoding: "cdr",
      metadata: new Map([["offered_qos_profiles", "[]"]]) }));
  }
  for (let i = 0; i < 500; ++i) {
    const text = `number ${i}`;
    const data = Buffer.alloc(4 + 4 + text.length + 1);
    data[1] = 1;
    data.writeUInt32LE(text.length + 1, 4);
    data.write(text, 8);
    const time = 1_700_000_000_000_000_000n + BigInt(i) * 10_000_000n;
    await writer.addMessage({ channelId: channels[i % 2], sequence: i, logTime: time, publishTime: time, data });
  }
  await writer.end();
  await handle.close();
}

main().catch((error) => {
  console.error(error.stack);
  process.exit(1);
});
