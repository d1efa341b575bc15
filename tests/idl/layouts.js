// layouts.js CATALOG: compares the message texts of our catalog (JSON: ROS name -> text) with those of the
// package @foxglove/rosmsg-msgs-common: names, types, order, array lengths and constants of all fields.
const fs = require("fs");
const { ros2humble } = require("@foxglove/rosmsg-msgs-common");
const { parseOurs, short } = require("./definitions.js");

const catalog = JSON.parse(fs.readFileSync(process.argv[2], "utf8"));
// Messages of packages that it does not have, with their fields as ROS's documentation lists them.
const field = (type, name, more) => ({ type, name, ...more });
const elsewhere = {
  "map_msgs/msg/OccupancyGridUpdate": { definitions: [field("std_msgs/Header", "header"), field("int32", "x"),
    field("int32", "y"), field("uint32", "width"), field("uint32", "height"),
    field("int8", "data", { isArray: true })] },
  "ffmpeg_image_transport_msgs/msg/FFMPEGPacket": { definitions: [field("std_msgs/Header", "header"),
    field("int32", "width"), field("int32", "height"), field("string", "encoding"), field("uint64", "pts"),
    field("uint8", "flags"), field("bool", "is_bigendian"), field("uint8", "data", { isArray: true })] },
  "foxglove_msgs/msg/CompressedVideo": { definitions: [field("time", "timestamp"),
    field("string", "frame_id"), field("uint8", "data", { isArray: true }), field("string", "format")] },
  "livox_ros_driver2/msg/CustomPoint": { definitions: [field("uint32", "offset_time"), field("float32", "x"),
    field("float32", "y"), field("float32", "z"), field("uint8", "reflectivity"), field("uint8", "tag"),
    field("uint8", "line")] },
  "livox_ros_driver2/msg/CustomMsg": { definitions: [field("std_msgs/Header", "header"), field("uint64", "timebase"),
    field("uint32", "point_num"), field("uint8", "lidar_id"), field("uint8", "rsvd", { isArray: true, arrayLength: 3 }),
    field("livox_ros_driver2/CustomPoint", "points", { isArray: true })] },
  "vision_msgs/msg/ObjectHypothesis": { definitions: [field("string", "class_id"), field("float64", "score")] },
  "vision_msgs/msg/ObjectHypothesisWithPose": { definitions: [field("vision_msgs/ObjectHypothesis", "hypothesis"),
    field("geometry_msgs/PoseWithCovariance", "pose")] },
  "vision_msgs/msg/BoundingBox3D": { definitions: [field("geometry_msgs/Pose", "center"),
    field("geometry_msgs/Vector3", "size")] },
  "vision_msgs/msg/Detection3D": { definitions: [field("std_msgs/Header", "header"),
    field("vision_msgs/ObjectHypothesisWithPose", "results", { isArray: true }),
    field("vision_msgs/BoundingBox3D", "bbox"), field("string", "id")] },
  "vision_msgs/msg/Detection3DArray": { definitions: [field("std_msgs/Header", "header"),
    field("vision_msgs/Detection3D", "detections", { isArray: true })] },
  "vision_msgs/msg/Point2D": { definitions: [field("float64", "x"), field("float64", "y")] },
  "vision_msgs/msg/Pose2D": { definitions: [field("vision_msgs/Point2D", "position"), field("float64", "theta")] },
  "vision_msgs/msg/BoundingBox2D": { definitions: [field("vision_msgs/Pose2D", "center"), field("float64", "size_x"),
    field("float64", "size_y")] },
  "vision_msgs/msg/Detection2D": { definitions: [field("std_msgs/Header", "header"),
    field("vision_msgs/ObjectHypothesisWithPose", "results", { isArray: true }),
    field("vision_msgs/BoundingBox2D", "bbox"), field("string", "id")] },
  "vision_msgs/msg/Detection2DArray": { definitions: [field("std_msgs/Header", "header"),
    field("vision_msgs/Detection2D", "detections", { isArray: true })] },
};
const faults = [];
let compared = 0;

// What of a field decides about its bytes, and about the meaning of its numbers.
function layout({ name, type, isArray, arrayLength, arrayUpperBound, upperBound, isConstant, value }) {
  return JSON.stringify({ name, type: short(type), isArray: !!isArray, arrayLength, arrayUpperBound, upperBound,
                          isConstant: !!isConstant, value: isConstant ? Number(value) : undefined });
}

for (const [rosName, text] of Object.entries(catalog)) {
  const [ours, ...held] = parseOurs(text); // of our own messages it is enough that all of them can be parsed
  const held_names = held.map((one) => one.name);
  for (const field of ours.definitions) {
    if (field.isComplex && !held_names.includes(field.type)) faults.push(`${rosName}: ${field.type} is missing`);
  }
  if (rosName.startsWith("leitstand_msgs/")) continue;
  const theirs = ros2humble[short(rosName)] ?? elsewhere[rosName];
  if (!theirs) {
    faults.push(`${rosName}: the package does not know it`);
    continue;
  }
  ++compared;
  // Where constants stand among the fields decides nothing.
  const inOrder = (all) => [...all.filter((one) => one.isConstant), ...all.filter((one) => !one.isConstant)];
  const our = inOrder(ours.definitions).map(layout), their = inOrder(theirs.definitions).map(layout);
  for (let i = 0; i < Math.max(our.length, their.length); ++i) {
    if (our[i] !== their[i]) faults.push(`${rosName}, field ${i}: ours ${our[i]}, theirs ${their[i]}`);
  }
}
if (compared < 30) faults.push(`only ${compared} messages were compared`);
console.log(`${compared} layouts compared`);
if (faults.length > 0) {
  console.error(faults.join("\n"));
  process.exit(1);
}
