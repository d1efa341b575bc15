/* cyclone_robot DOMAIN: a robot on Cyclone DDS with the topics, types and QoS of a stock TurtleBot 3. It
 * stands in a round room and says so until SIGINT or SIGTERM. */
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <dds/dds.h>

#include "geometry_msgs.h"
#include "nav_msgs.h"
#include "sensor_msgs.h"
#include "tf2_msgs.h"

enum { Beams = 360, PictureBytes = 3000 };

static volatile sig_atomic_t ended = 0;

static void end(int number) {
    (void)number;
    ended = 1;
}

static dds_entity_t checked(const char* what, dds_entity_t entity) {
    if (entity >= 0) return entity;
    printf("cyclone_robot: %s: %s\n", what, dds_strretcode(entity));
    exit(1);
}

static dds_entity_t topic_of(dds_entity_t participant, const char* name, const dds_topic_descriptor_t* type) {
    char dds_name[64];
    snprintf(dds_name, sizeof dds_name, "rt/%s", name);
    return checked(name, dds_create_topic(participant, type, dds_name, NULL, NULL));
}

/* As ROS 2 makes them by default. */
static dds_qos_t* usual_qos(int lasting) {
    dds_qos_t* qos = dds_create_qos();
    dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, DDS_MSECS(100));
    dds_qset_durability(qos, lasting ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
    dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, 10);
    return qos;
}

static dds_entity_t writer_of(dds_entity_t participant, const char* name,
                              const dds_topic_descriptor_t* type) {
    dds_qos_t* qos = usual_qos(strcmp(name, "tf_static") == 0);
    const dds_entity_t writer =
        checked(name, dds_create_writer(participant, topic_of(participant, name, type), qos, NULL));
    dds_delete_qos(qos);
    return writer;
}

static std_msgs_msg_dds__Header_ header_of(char* frame) {
    struct timespec now;
    clock_gettime(CLOCK_REALTIME, &now);
    std_msgs_msg_dds__Header_ header = {{(int32_t)now.tv_sec, (uint32_t)now.tv_nsec}, frame};
    return header;
}

struct Robot {
    dds_entity_t scan, odom, imu, joints, tf, tf_static, picture, camera, battery;
};

static struct Robot made_in(dds_entity_t in) {
    struct Robot robot;
    robot.scan = writer_of(in, "scan", &sensor_msgs_msg_dds__LaserScan__desc);
    robot.odom = writer_of(in, "odom", &nav_msgs_msg_dds__Odometry__desc);
    robot.imu = writer_of(in, "imu", &sensor_msgs_msg_dds__Imu__desc);
    robot.joints = writer_of(in, "joint_states", &sensor_msgs_msg_dds__JointState__desc);
    robot.tf = writer_of(in, "tf", &tf2_msgs_msg_dds__TFMessage__desc);
    robot.tf_static = writer_of(in, "tf_static", &tf2_msgs_msg_dds__TFMessage__desc);
    robot.picture = writer_of(in, "camera/image_raw/compressed", &sensor_msgs_msg_dds__CompressedImage__desc);
    robot.camera = writer_of(in, "camera/camera_info", &sensor_msgs_msg_dds__CameraInfo__desc);
    robot.battery = writer_of(in, "battery_state", &sensor_msgs_msg_dds__BatteryState__desc);
    dds_qos_t* qos = usual_qos(0);
    const dds_entity_t commands = topic_of(in, "cmd_vel", &geometry_msgs_msg_dds__Twist__desc);
    checked("cmd_vel", dds_create_reader(in, commands, qos, NULL));
    dds_delete_qos(qos);
    return robot;
}

static void say_transform(dds_entity_t writer, char* parent, char* child) {
    geometry_msgs_msg_dds__TransformStamped_ one = {.header = header_of(parent), .child_frame_id = child};
    one.transform.rotation.w = 1.0;
    tf2_msgs_msg_dds__TFMessage_ all = {{1, 1, &one, false}};
    dds_write(writer, &all);
}

static void say_scan(dds_entity_t writer) {
    static float ranges[Beams];
    for (int i = 0; i < Beams; ++i) ranges[i] = 2.0F;
    sensor_msgs_msg_dds__LaserScan_ scan = {
        .header = header_of("base_scan"), .range_min = 0.12F, .range_max = 3.5F};
    scan.angle_increment = (float)(2.0 * M_PI / Beams);
    scan.angle_max = (float)(Beams - 1) * scan.angle_increment;
    scan.ranges = (dds_sequence_float){Beams, Beams, ranges, false};
    dds_write(writer, &scan);
}

static void say_motion(const struct Robot* robot) {
    nav_msgs_msg_dds__Odometry_ odom = {.header = header_of("odom"), .child_frame_id = "base_footprint"};
    odom.pose.pose.orientation.w = 1.0;
    dds_write(robot->odom, &odom);
    sensor_msgs_msg_dds__Imu_ imu = {.header = header_of("imu_link")};
    imu.orientation.w = 1.0;
    imu.linear_acceleration.z = 9.81;
    dds_write(robot->imu, &imu);
    char* names[] = {"wheel_left_joint", "wheel_right_joint"};
    double turned[] = {0.0, 0.0};
    sensor_msgs_msg_dds__JointState_ joints = {.header = header_of("")};
    joints.name = (dds_sequence_string){2, 2, names, false};
    joints.position = (dds_sequence_double){2, 2, turned, false};
    dds_write(robot->joints, &joints);
    say_transform(robot->tf, "odom", "base_footprint");
}

static void say_picture(const struct Robot* robot) {
    static uint8_t bytes[PictureBytes]; /* as long as one; that it is none is the listener's to find */
    sensor_msgs_msg_dds__CompressedImage_ picture = {.header = header_of("camera_rgb_optical_frame"),
                                                     .format = "jpeg"};
    picture.data = (dds_sequence_uint8){PictureBytes, PictureBytes, bytes, false};
    dds_write(robot->picture, &picture);
    sensor_msgs_msg_dds__CameraInfo_ camera = {.header = header_of("camera_rgb_optical_frame")};
    camera.height = 480;
    camera.width = 640;
    camera.distortion_model = "plumb_bob";
    camera.k[0] = camera.k[4] = camera.p[0] = camera.p[5] = 500.0;
    camera.k[2] = camera.p[2] = 320.0;
    camera.k[5] = camera.p[6] = 240.0;
    camera.k[8] = camera.p[10] = camera.r[0] = camera.r[4] = camera.r[8] = 1.0;
    dds_write(robot->camera, &camera);
}

static void say_battery(dds_entity_t writer) {
    sensor_msgs_msg_dds__BatteryState_ battery = {.header = header_of(""), .present = true};
    battery.location = battery.serial_number = "";
    battery.voltage = 11.1F;
    battery.percentage = 0.8F;
    dds_write(writer, &battery);
}

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    signal(SIGINT, end);
    signal(SIGTERM, end);
    const dds_domainid_t domain = (dds_domainid_t)strtoul(argv[1], NULL, 10);
    const dds_entity_t participant = checked("participant", dds_create_participant(domain, NULL, NULL));
    const struct Robot robot = made_in(participant);
    say_transform(robot.tf_static, "base_footprint", "base_scan");
    printf("turtlebot is in domain %u\n", domain);
    fflush(stdout);
    for (unsigned tick = 0; !ended; ++tick) {
        say_motion(&robot);
        if (tick % 4 == 0) say_scan(robot.scan);
        if (tick % 2 == 0) say_picture(&robot);
        if (tick % 20 == 0) say_battery(robot.battery);
        dds_sleepfor(DDS_MSECS(50));
    }
    dds_delete(participant);
    return 0;
}
