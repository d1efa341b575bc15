#include "transport/dds/node.h"

#include "transport/dds/detail/participant.h"
#include "transport/dds/names.h"
#include "transport/dds/network/library_mends.h"
#include "transport/dds/network/socket_buffers.h"

namespace leitstand {
namespace {

constexpr const char* Unmended =
    "Fast DDS is not the one that this program was built for: it may fall silent, or end the program, when "
    "the "
    "last one who hears a topic goes";

}  // namespace

struct Subscription::Impl {
    std::shared_ptr<detail::Participant> participant;
    std::shared_ptr<detail::Reader> reader;
};

Subscription::Subscription(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
Subscription::~Subscription() {
    m_impl->participant->release(m_impl->reader);
}
SubscriptionCounts Subscription::counts() const {
    return m_impl->reader->counts();
}
std::vector<Guid> Subscription::writers() const {
    return m_impl->participant->discovery().matchedWith(guid());
}
Guid Subscription::guid() const {
    return m_impl->reader->guid();
}

struct Publisher::Impl {
    std::shared_ptr<detail::Participant> participant;
    std::shared_ptr<detail::Writer> writer;
};

Publisher::Publisher(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
Publisher::~Publisher() {
    m_impl->participant->release(m_impl->writer);
}
Result<void> Publisher::write(const Payload& cdr) {
    return m_impl->writer->write(cdr);
}
Result<std::uint64_t> Publisher::write(const Payload& cdr, const SampleIdentity& related) {
    return m_impl->writer->write(cdr, related);
}
int Publisher::matched() const {
    return m_impl->writer->matched();
}
std::vector<Guid> Publisher::readers() const {
    return m_impl->writer->readers();
}
bool Publisher::waitForAcknowledgments(std::chrono::milliseconds atMost) const {
    return m_impl->writer->waitForAcknowledgments(atMost);
}
Guid Publisher::guid() const {
    return m_impl->writer->guid();
}

struct Node::Impl {
    std::shared_ptr<detail::Participant> participant;
    std::vector<std::string> warnings = detail::socketBufferWarnings();
};

Node::Node(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
Node::~Node() {
    m_impl->participant->leave();
}

Result<std::unique_ptr<Node>> Node::create(const NodeSettings& settings) {
    auto participant = std::make_shared<detail::Participant>(settings);
    if (auto joined = participant->join(); !joined) return joined.error();
    auto impl = std::make_unique<Impl>();
    impl->participant = std::move(participant);
    const auto& unscreened = impl->participant->unscreened();
    impl->warnings.insert(impl->warnings.end(), unscreened.begin(), unscreened.end());
    if (!detail::mendsTheLibrary()) impl->warnings.emplace_back(Unmended);
    return std::unique_ptr<Node>(new Node(std::move(impl)));
}

Result<std::unique_ptr<Subscription>> Node::subscribe(const ReaderSettings& settings,
                                                      SampleCallback callback) {
    auto reader = m_impl->participant->subscribe(settings, std::move(callback));
    if (!reader) return reader.error();
    auto impl = std::make_unique<Subscription::Impl>();
    *impl = {m_impl->participant, *reader};
    return std::unique_ptr<Subscription>(new Subscription(std::move(impl)));
}

Result<std::unique_ptr<Publisher>> Node::publisher(const WriterSettings& settings) {
    auto writer = m_impl->participant->publish(settings);
    if (!writer) return writer.error();
    auto impl = std::make_unique<Publisher::Impl>();
    *impl = {m_impl->participant, *writer};
    return std::unique_ptr<Publisher>(new Publisher(std::move(impl)));
}

std::vector<RemoteParticipant> Node::participants() const {
    return m_impl->participant->discovery().participants();
}
std::vector<RemoteEndpoint> Node::endpoints() const {
    return m_impl->participant->discovery().endpoints();
}
Node::OwnEndpoints Node::ownEndpoints() const {
    OwnEndpoints own;
    for (const auto& [guid, endpoint] : m_impl->participant->discovery().local()) {
        if (!isRosTopic(endpoint.ddsTopic)) continue;
        (endpoint.kind == detail::LocalEndpoint::Kind::Reader ? own.readers : own.writers).push_back(guid);
    }
    return own;
}
std::vector<Mismatch> Node::mismatches() const {
    return m_impl->participant->discovery().mismatches();
}
DomainReception Node::reception() const {
    return m_impl->participant->reception();
}
Result<void> Node::rejoin(const std::function<void(const Guid&)>& entered) {
    return m_impl->participant->rejoin(entered);
}
void Node::onDiscovery(std::function<void()> changed) {
    m_impl->participant->onDiscovery(std::move(changed));
}
const std::vector<std::string>& Node::warnings() const {
    return m_impl->warnings;
}
std::vector<ScreenDrop> Node::dropped() const {
    return m_impl->participant->gate().drops();
}
Guid Node::guid() const {
    return m_impl->participant->guid();
}

}  // namespace leitstand
