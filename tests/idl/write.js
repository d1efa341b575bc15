// write.js CATALOG FOLDER: writes FOLDER/<package>.<Name>.cdr for every type, each field with another value.
const fs = require("fs");
const path = require("path");
const { MessageWriter } = require("@foxglove/rosmsg2-serialization");
const { definitionsOf } = require("./definitions.js");

let count = 0;
const primitive = {
  bool: () => ++count % 2 === 0,
  int8: () => -(++count % 100), uint8: () => ++count % 250,
  int16: () => -++count, uint16: () => ++count, int32: () => -++count, uint32: () => ++count,
  int64: () => -BigInt(++count) << 33n, uint64: () => BigInt(++count) << 33n,
  float32: () => ++count + 0.5, float64: () => ++count + 0.125,
  string: () => "text " + "x".repeat(++count % 7),
  time: () => ({ sec: ++count, nsec: ++count }), duration: () => ({ sec: -++count, nsec: ++count }),
};

function value(field, all) {
  const one = () => field.isComplex ? message(all.get(field.type), all) : primitive[field.type]();
  if (!field.isArray) return one();
  return Array.from({ length: field.arrayLength ?? 3 }, one);
}

function message(fields, all) {
  return Object.fromEntries(fields.filter((field) => !field.isConstant).map((field) => [field.name, value(field, all)]));
}

const [, , catalogFile, folder] = process.argv;
for (const [rosName, text] of Object.entries(JSON.parse(fs.readFileSync(catalogFile, "utf8")))) {
  const definitions = definitionsOf(rosName, text);
  const all = new Map(definitions.map((one) => [one.name ?? "", one.definitions]));
  const bytes = new MessageWriter(definitions).writeMessage(message(definitions[0].definitions, all));
  fs.writeFileSync(path.join(folder, rosName.replace("/msg/", ".") + ".cdr"), bytes);
}
