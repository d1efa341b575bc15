// read.js CATALOG FOLDER: reads FOLDER/<package>.<Name>.cdr, which our encoder wrote from tests/support/samples.cpp,
// compares values with what stands there, and writes every message again: the bytes must be the same.
const fs = require("fs");
const path = require("path");
const { MessageReader, MessageWriter } = require("@foxglove/rosmsg2-serialization");
const { definitionsOf } = require("./definitions.js");

const expected = {
  "sensor_msgs/msg/PointCloud2": { "header.stamp.sec": 1700000001, "header.stamp.nsec": 123456789,
    "header.frame_id": "lidar", height: 2, width: 3, "fields.4.name": "t", "fields.4.datatype": 6,
    is_bigendian: false, point_step: 22, row_step: 66, "data.length": 132, is_dense: true },
  "sensor_msgs/msg/LaserScan": { angle_min: -1.5, angle_max: 0, angle_increment: 0.5, time_increment: 0.25,
    scan_time: 0.125, range_min: 0.0625, range_max: 30, "ranges.3": 4, "intensities.0": 5 },
  "nav_msgs/msg/Odometry": { "header.frame_id": "lidar", child_frame_id: "base_link", "pose.pose.position.y": 1.25,
    "pose.pose.orientation.w": 0.5, "pose.covariance.35": 36, "twist.twist.linear.z": 3,
    "twist.twist.angular.x": 4, "twist.covariance.0": 51 },
  "nav_msgs/msg/OccupancyGrid": { "header.frame_id": "lidar", "info.map_load_time.nsec": 2, "info.resolution": 0.25,
    "info.width": 3, "info.height": 2, "info.origin.position.x": 7, "data.1": 100, "data.2": -1, "data.length": 6 },
  "trajectory_msgs/msg/JointTrajectory": { "header.frame_id": "lidar", "joint_names.1": "b", "points.0.positions.1": 1.5,
    "points.0.velocities.0": 2.5, "points.0.time_from_start.nsec": 250000000, "points.1.time_from_start.sec": 2 },
  "std_msgs/msg/Float64MultiArray": { "data.0": 0.25, "data.2": 7, "data.length": 3 },
  "map_msgs/msg/OccupancyGridUpdate": { x: 4, y: 5, width: 2, height: 1, "data.1": -1 },
  "nav_msgs/msg/Path": { "poses.0.header.frame_id": "lidar", "poses.1.pose.position.z": 9.5, "poses.length": 2 },
  "sensor_msgs/msg/Imu": { "orientation.x": -0.5, "orientation.w": 0.5, "orientation_covariance.8": 9,
    "angular_velocity.z": 3, "angular_velocity_covariance.0": 11, "linear_acceleration.z": 9.81,
    "linear_acceleration_covariance.8": 29 },
  "sensor_msgs/msg/JointState": { "name.1": "right", "position.0": 0.5, "velocity.0": 2.5, "effort.1": 5.5 },
  "tf2_msgs/msg/TFMessage": { "transforms.1.child_frame_id": "arm", "transforms.1.transform.translation.x": 4,
    "transforms.0.transform.rotation.z": 0.5 },
  "sensor_msgs/msg/Image": { height: 2, width: 4, encoding: "bgr8", is_bigendian: 0, step: 13, "data.1": 8 },
  "sensor_msgs/msg/CompressedImage": { format: "jpeg", "data.1": 0xd8, "data.length": 4 },
  "sensor_msgs/msg/CameraInfo": { height: 480, width: 640, distortion_model: "plumb_bob", "d.4": 0.5, "k.0": 1,
    "r.0": 11, "p.11": 32, binning_x: 2, binning_y: 3, "roi.x_offset": 4, "roi.y_offset": 5, "roi.height": 240,
    "roi.width": 320, "roi.do_rectify": false },
  "ffmpeg_image_transport_msgs/msg/FFMPEGPacket": { "header.stamp.nsec": 123456789, width: 640, height: 480,
    encoding: "libx265", pts: 1700000001123456789n, flags: 1, is_bigendian: false, "data.3": 0x26, "data.length": 5 },
  "foxglove_msgs/msg/CompressedVideo": { "timestamp.nsec": 123456789, frame_id: "lidar", format: "h264",
    "data.3": 0x65, "data.length": 5 },
  "livox_ros_driver2/msg/CustomMsg": { "header.frame_id": "lidar", timebase: 1700000001123456789n, point_num: 6,
    "points.1.offset_time": 1000001, "points.1.x": 1.5, "points.2.y": -0.25, "points.5.line": 1,
    "points.3.reflectivity": 30, "points.length": 6 },
  "std_msgs/msg/Float32": { data: 412.5 },
  "sensor_msgs/msg/BatteryState": { voltage: 24.5, temperature: 31.5, current: -3.25, charge: 7.5, capacity: 10,
    percentage: 0.75, power_supply_status: 2, present: true, location: "rear" },
  "diagnostic_msgs/msg/DiagnosticArray": { "status.0.level": 2, "status.0.name": "motor", "status.0.message": "hot",
    "status.0.hardware_id": "kurt3d/motor", "status.0.values.1.key": "limit", "status.0.values.1.value": "80" },
  "geometry_msgs/msg/Twist": { "linear.x": 0.25, "angular.z": 1.5 },
  "geometry_msgs/msg/TwistStamped": { "header.stamp.nsec": 9, "header.frame_id": "base_link", "twist.linear.y": 0.5 },
  "geometry_msgs/msg/PoseStamped": { "pose.position.z": 6.5, "pose.orientation.x": 0.5 },
  "leitstand_msgs/msg/GasConcentration": { ppm: 412.5 },
  "leitstand_msgs/msg/Victim": { number: 3, "found.sec": 1700000090, "position_in_map.x": 11.5, "heat.value": 33.5,
    tag: "R-17", "evidence.1.sequence_number": 4712n, kind: 3, merged_into: 2 },
  "leitstand_msgs/msg/Candidate": { id: 5, kind: 1, "position_in_map.x": 12.5, victim: 3, dismissed: true,
    "cues.1.text": "R-17", "cues.0.sequence_number": 4713n },
  "leitstand_msgs/msg/KeyScan": { id: 7n, name: "scan007", matched: 6n, rows: 2, sweep: 1, "points.11": 12,
    "labels.0": 1, "sensor_in_odom.position.x": 3 },
  "leitstand_msgs/msg/StopCommand": { number: 19n, stop: true, station: "station-1" },
};

const [, , catalogFile, folder] = process.argv;
const catalog = JSON.parse(fs.readFileSync(catalogFile, "utf8"));
const faults = [];
let read = 0;
for (const file of fs.readdirSync(folder)) {
  const rosName = path.basename(file, ".cdr").replace(".", "/msg/");
  const bytes = fs.readFileSync(path.join(folder, file));
  const definitions = definitionsOf(rosName, catalog[rosName]);
  const message = new MessageReader(definitions).readMessage(bytes);
  for (const [place, value] of Object.entries(expected[rosName] ?? {})) {
    const found = place.split(".").reduce((at, key) => at?.[key], message);
    if (found !== value) faults.push(`${rosName} ${place}: expected ${value}, found ${found}`);
  }
  const again = Buffer.from(new MessageWriter(definitions).writeMessage(message));
  if (!again.equals(bytes)) {
    faults.push(`${rosName}: written again it is\n${again.toString("hex")}, not\n${bytes.toString("hex")}`);
  }
  ++read;
  delete expected[rosName];
}
for (const rosName of Object.keys(expected)) faults.push(`${rosName}: there was no sample`);
console.log(`${read} samples read`);
if (faults.length > 0) {
  console.error(faults.join("\n"));
  process.exit(1);
}
