#pragma once

namespace leitstand::test {

/// Environment of Cyclone DDS that speaks over the loopback interface only, without multicast.
inline constexpr const char* LoopbackOnly =
    "CYCLONEDDS_URI=<CycloneDDS><Domain><General><Interfaces><NetworkInterface name=\"lo\" "
    "multicast=\"false\"/>"
    "</Interfaces><AllowMulticast>false</AllowMulticast></General><Discovery><ParticipantIndex>auto"
    "</ParticipantIndex><Peers><Peer address=\"127.0.0.1\"/></Peers></Discovery></Domain></CycloneDDS>";

}  // namespace leitstand::test
