/* All messages of the IDL as Cyclone DDS knows them; the code is made at build (generate_fill.py). */
#pragma once

#include <stddef.h>
#include <stdint.h>

#include <dds/dds.h>

struct PeerType {
    const char* name; /* "nav_msgs/Odometry" */
    const dds_topic_descriptor_t* descriptor;
    size_t size;
    void (*fill)(uint64_t* seed, void* sample);
};

extern const struct PeerType peer_types[];
extern const unsigned peer_type_count;
