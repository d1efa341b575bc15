// read_bag.js FILE METADATA: lists a bag and decodes every message of it, standard types by the packages' own
// texts, ours by the text that the bag holds. Written again, each message must have the very same bytes.
const fs = require("fs");
const { SqliteSqljs } = require("@foxglove/rosbag2-web");
const { Rosbag2, parseQosProfiles, parseYaml } = require("@foxglove/rosbag2");
const { MessageReader, MessageWriter } = require("@foxglove/rosmsg2-serialization");
const { definitionsOf } = require("../idl/definitions.js");

const [, , file, metadataFile] = process.argv;
global.File ??= class File {}; // older node: the package asks whether it is given one

/** Whether `raw` is `again` and, where it came over the wire, the zeros that fill its last word. */
function sameBytes(raw, again) {
  const rest = raw.subarray(again.length);
  return again.equals(raw.subarray(0, again.length)) && rest.length < 4 && rest.every((byte) => byte === 0);
}

function count(of, key) {
  of[key] = (of[key] ?? 0) + 1;
}

async function main() {
  const wasmBinary = fs.readFileSync(require.resolve("@foxglove/sql.js").replace("sql-wasm.js", "sql-wasm.wasm"));
  const SQL = await SqliteSqljs.Initialize({ wasmBinary });
  const bytes = fs.readFileSync(file);

  const tables = new SQL.Database({ data: bytes });
  const texts = new Map(
    (tables.exec("SELECT topic_type, encoded_message_definition, encoding FROM message_definitions")[0]?.values ?? [])
      .filter((row) => row[2] === "ros2msg"));
  tables.close();

  const bag = new Rosbag2([new SqliteSqljs(bytes)]);
  await bag.open();
  const topics = await bag.readTopics();
  const codecs = new Map(topics.map((topic) => {
    if (!texts.has(topic.type)) throw new Error(`${topic.type}: the bag holds no text of it`);
    if (topic.offeredQosProfiles.length !== 1) throw new Error(`${topic.name}: expected one QoS profile`);
    const definitions = definitionsOf(topic.type, texts.get(topic.type));
    return [topic.name, { reader: new MessageReader(definitions), writer: new MessageWriter(definitions) }];
  }));
  const read = {};
  for await (const raw of bag.readMessages({ rawMessages: true })) {
    const { reader, writer } = codecs.get(raw.topic.name);
    const again = Buffer.from(writer.writeMessage(reader.readMessage(raw.data)));
    if (!sameBytes(Buffer.from(raw.data), again)) throw new Error(`${raw.topic.type}: other bytes when written again`);
    count(read, raw.topic.name);
  }
  const counts = await bag.messageCounts();
  for (const [topic, number] of counts) {
    if ((read[topic] ?? 0) !== number) throw new Error(`${topic}: ${number} messages listed, ${read[topic]} read`);
  }
  const { rosbag2_bagfile_information: metadata } = parseYaml(fs.readFileSync(metadataFile, "utf8"));
  for (const { topic_metadata: topic, message_count: number } of metadata.topics_with_message_count) {
    if ((read[topic.name] ?? 0) !== Number(number)) throw new Error(`metadata.yaml: ${topic.name}: ${number} messages`);
    if (parseQosProfiles(topic.offered_qos_profiles).length !== 1) throw new Error(`${topic.name}: no QoS profile`);
  }
  console.log(JSON.stringify({ topics: topics.length, messages: Number(metadata.message_count),
    file: metadata.relative_file_paths[0] }));
  await bag.close();
}

main().catch((error) => {
  console.error(error);
  process.exit(1);
});
