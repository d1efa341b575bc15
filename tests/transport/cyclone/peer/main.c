/* cyclone_peer DOMAIN SEEDS: a process on Cyclone DDS that knows all our messages from our IDL by its own
 * generator. On rt/cyclone/<type> it says samples filled from the seeds 1..SEEDS; what comes on rt/ours/<type>
 * it decodes, encodes again and says on rt/echo/<type>. Runs until it is killed. */
#include <stdio.h>
#include <stdlib.h>

#include "peer_types.h"

static void fail(const char* what, dds_return_t code) {
    printf("cyclone_peer: %s: %s\n", what, dds_strretcode(code));
    exit(1);
}

static dds_entity_t checked(const char* what, dds_entity_t entity) {
    if (entity < 0) fail(what, entity);
    return entity;
}

static dds_entity_t topic_of(dds_entity_t participant, const struct PeerType* type, const char* prefix) {
    char name[256];
    snprintf(name, sizeof name, "rt/%s/%s", prefix, type->name);
    return checked(name, dds_create_topic(participant, type->descriptor, name, NULL, NULL));
}

static void send_back(dds_entity_t reader, void* writer) {
    void* sample = NULL;
    dds_sample_info_t info;
    while (dds_take(reader, &sample, &info, 1, 1) > 0) {
        const dds_return_t written = info.valid_data ? dds_write(*(const dds_entity_t*)writer, sample) : 0;
        dds_return_loan(reader, &sample, 1);
        sample = NULL;
        if (written < 0) fail("echo", written);
    }
}

static void serve(dds_entity_t participant, const struct PeerType* type, const dds_qos_t* qos, unsigned seeds) {
    const dds_entity_t own =
        checked("writer", dds_create_writer(participant, topic_of(participant, type, "cyclone"), qos, NULL));
    for (uint64_t seed = 1; seed <= seeds; ++seed) {
        uint64_t state = seed;
        void* sample = dds_alloc(type->size);
        type->fill(&state, sample);
        const dds_return_t written = dds_write(own, sample);
        if (written < 0) fail(type->name, written);
        dds_sample_free(sample, type->descriptor, DDS_FREE_ALL);
    }
    dds_entity_t* echo = dds_alloc(sizeof *echo); /* kept for the listener until the process ends */
    *echo = checked("writer", dds_create_writer(participant, topic_of(participant, type, "echo"), qos, NULL));
    dds_listener_t* listener = dds_create_listener(echo);
    dds_lset_data_available(listener, send_back);
    checked("reader", dds_create_reader(participant, topic_of(participant, type, "ours"), qos, listener));
    dds_delete_listener(listener);
}

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    const dds_domainid_t domain = (dds_domainid_t)strtoul(argv[1], NULL, 10);
    const dds_entity_t participant = checked("participant", dds_create_participant(domain, NULL, NULL));
    dds_qos_t* qos = dds_create_qos();
    dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, DDS_SECS(10));
    dds_qset_durability(qos, DDS_DURABILITY_TRANSIENT_LOCAL);
    dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, 100);
    dds_qset_durability_service(qos, 0, DDS_HISTORY_KEEP_LAST, 100, DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED,
                                DDS_LENGTH_UNLIMITED);
    for (unsigned i = 0; i < peer_type_count; ++i) {
        serve(participant, &peer_types[i], qos, (unsigned)strtoul(argv[2], NULL, 10));
    }
    dds_delete_qos(qos);
    puts("ready");
    fflush(stdout);
    for (;;) dds_sleepfor(DDS_SECS(1));
}
