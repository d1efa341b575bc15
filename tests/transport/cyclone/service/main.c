/* cyclone_service DOMAIN NAME: offers the service NAME of type std_srvs/srv/SetBool as rmw_cyclonedds does,
 * until SIGINT or SIGTERM. Each answer follows one to a client that nobody is. After SIGUSR1 it collects four
 * requests each time and answers them last first. It says what it was asked. */
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#include <dds/dds.h>

#include "std_srvs.h"

enum { Held = 4 };

static volatile sig_atomic_t ended = 0;

static volatile sig_atomic_t held = 1;

static void end(int number) {
    (void)number;
    ended = 1;
}

static void hold(int number) {
    (void)number;
    held = Held;
}

static dds_entity_t checked(const char* what, dds_entity_t entity) {
    if (entity >= 0) return entity;
    printf("cyclone_service: %s: %s\n", what, dds_strretcode(entity));
    exit(1);
}

static void answer(dds_entity_t writer, const std_srvs_srv_dds__SetBool_Request_* request, bool to_it) {
    std_srvs_srv_dds__SetBool_Response_ response = {.client = request->client, .number = request->number};
    if (!to_it) response.client ^= 0x5555;
    response.success = to_it && request->data;
    response.message = to_it ? (request->data ? "on" : "off") : "for somebody else";
    dds_write(writer, &response);
}

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    signal(SIGINT, end);
    signal(SIGTERM, end);
    signal(SIGUSR1, hold);
    const dds_entity_t in = checked(
        "participant", dds_create_participant((dds_domainid_t)strtoul(argv[1], NULL, 10), NULL, NULL));
    char requests[128], answers[128];
    snprintf(requests, sizeof requests, "rq/%sRequest", argv[2]);
    snprintf(answers, sizeof answers, "rr/%sReply", argv[2]);
    dds_qos_t* qos = dds_create_qos();
    dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, DDS_SECS(1));
    dds_qset_durability(qos, DDS_DURABILITY_VOLATILE);
    dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, 10);
    const dds_entity_t writer = checked(
        answers,
        dds_create_writer(in,
                          checked(answers, dds_create_topic(in, &std_srvs_srv_dds__SetBool_Response__desc,
                                                            answers, NULL, NULL)),
                          qos, NULL));
    const dds_entity_t reader = checked(
        requests,
        dds_create_reader(in,
                          checked(requests, dds_create_topic(in, &std_srvs_srv_dds__SetBool_Request__desc,
                                                             requests, NULL, NULL)),
                          qos, NULL));
    dds_delete_qos(qos);
    puts("ready");
    fflush(stdout);
    std_srvs_srv_dds__SetBool_Request_ kept[Held];
    int count = 0;
    while (!ended) {
        void* sample = NULL;
        dds_sample_info_t info;
        while (count < held && dds_take(reader, &sample, &info, 1, 1) > 0) {
            if (info.valid_data) {
                kept[count] = *(const std_srvs_srv_dds__SetBool_Request_*)sample; /* it has no pointers */
                printf("asked %d\n", kept[count].data ? 1 : 0);
                fflush(stdout);
                ++count;
            }
            dds_return_loan(reader, &sample, 1);
            sample = NULL;
        }
        if (count >= held) {
            for (; count > 0; --count) {
                answer(writer, &kept[count - 1], false);
                answer(writer, &kept[count - 1], true);
            }
        }
        dds_sleepfor(DDS_MSECS(2));
    }
    dds_delete(in);
    return 0;
}
