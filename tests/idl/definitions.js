// What a message looks like to the packages: for standard types by their own texts, never by ours.
const { parse } = require("@foxglove/rosmsg");
const { ros2humble } = require("@foxglove/rosmsg-msgs-common");

const short = (rosName) => rosName.replace("/msg/", "/");

// A byte is one octet; the parser takes it for an int8, the package for an uint8.
function parseOurs(text) {
  return parse(text.replace(/^byte /gm, "uint8 "), { ros2: true });
}

// Root first, as MessageReader and MessageWriter want it.
function definitionsOf(rosName, text) {
  const root = ros2humble[short(rosName)];
  if (!root) return parseOurs(text);
  return [{ definitions: root.definitions }, ...Object.values(ros2humble)];
}

module.exports = { definitionsOf, parseOurs, short };
