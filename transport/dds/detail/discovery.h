#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <mutex>
#include <vector>

#include "transport/dds/detail/fastdds.h"
#include "transport/dds/detail/local_endpoint.h"
#include "transport/dds/detail/mismatch.h"
#include "transport/dds/endpoint.h"

namespace leitstand::detail {

/// Keeps what discovery reports. When it is called as a listener, it only records this and calls `changed` of
/// its constructor, which must not block.
class Discovery final : public fastdds::DiscoveryListener {
public:
    Discovery(std::function<void()> changed, bool secure);

    [[nodiscard]] std::vector<RemoteParticipant> participants() const;
    [[nodiscard]] std::vector<RemoteEndpoint> endpoints() const;
    [[nodiscard]] std::vector<Mismatch> mismatches() const;
    /// Sets OfferedWriter::received to false, because only readers know which writers were heard.
    [[nodiscard]] DomainReception reception() const;

    /// Forgets all participants and endpoints, including our own endpoints. Call when the participant has
    /// left its domain.
    void clear();

    // Our own side
    void add(const Guid& local, LocalEndpoint endpoint);
    void remove(const Guid& local);
    void matched(const Guid& local, const Guid& remote, bool now);
    [[nodiscard]] std::vector<Guid> matchedWith(const Guid& local) const;
    [[nodiscard]] std::map<Guid, LocalEndpoint> local() const;  ///< our readers and writers

private:
    struct KnownParticipant {
        RemoteParticipant participant;
        std::chrono::steady_clock::time_point since;
    };
    struct Known {
        RemoteEndpoint endpoint;
        MatchTerms terms;
        std::chrono::steady_clock::time_point since;
    };

    void participantSeen(const fastdds::ParticipantData& data) override;
    void participantGone(const fastdds::rtps::GUID_t& guid) override;
    void participantJudged(const fastdds::rtps::GUID_t& guid, bool refused) override;
    void writerSeen(const fastdds::EndpointData& data) override;
    void readerSeen(const fastdds::EndpointData& data) override;
    void endpointGone(const fastdds::rtps::GUID_t& guid) override;

    void note(const fastdds::EndpointData& data, RemoteEndpoint::Kind kind, const MatchTerms& terms);
    [[nodiscard]] RemoteParticipant& known(const Guid& participant);
    [[nodiscard]] RemoteEndpoint named(RemoteEndpoint endpoint) const;

    std::function<void()> m_changed;
    bool m_secure;
    mutable std::mutex m_mutex;
    std::map<Guid, KnownParticipant> m_participants;
    std::map<Guid, Known> m_endpoints;
    std::map<Guid, LocalEndpoint> m_local;
};

}  // namespace leitstand::detail
