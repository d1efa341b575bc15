#include "transport/dds/ros_nodes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "transport/cdr/cdr_reader.h"
#include "transport/cdr/cdr_writer.h"

namespace leitstand {
namespace {

// The message, with identities of Size bytes. Their first 16 are a GUID; the rest is zero.
template <std::size_t Size>
struct Gid {
    static constexpr std::size_t LeastSize = Size;
    std::array<std::uint8_t, Size> data{};

    [[nodiscard]] Guid guid() const {
        Guid guid;
        std::copy_n(data.begin(), guid.bytes.size(), guid.bytes.begin());
        return guid;
    }
    [[nodiscard]] bool isWhole() const {
        return std::all_of(data.begin() + sizeof(Guid::bytes), data.end(),
                           [](std::uint8_t byte) { return byte == 0; });
    }
};
template <std::size_t Size>
struct NodeEntities {
    static constexpr std::size_t LeastSize = 20;  // two texts and two counts
    std::string space, name;
    std::vector<Gid<Size>> readers, writers;
};

template <std::size_t Size>
void decode(CdrReader& in, Gid<Size>& to) {
    in.read("gid", to.data);
}
template <std::size_t Size>
void decode(CdrReader& in, NodeEntities<Size>& to) {
    in.read("node_namespace", to.space);
    in.read("node_name", to.name);
    in.read("reader_gid_seq", to.readers);
    in.read("writer_gid_seq", to.writers);
}

template <std::size_t Size>
void encode(CdrWriter& out, const Gid<Size>& from) {
    out.write(from.data);
}
template <std::size_t Size>
void encode(CdrWriter& out, const NodeEntities<Size>& from) {
    out.write(from.space);
    out.write(from.name);
    out.write(from.readers);
    out.write(from.writers);
}

template <std::size_t Size>
Gid<Size> gidOf(const Guid& guid) {
    Gid<Size> gid;
    std::copy(guid.bytes.begin(), guid.bytes.end(), gid.data.begin());
    return gid;
}

template <std::size_t Size>
Payload announcement(const RosProcess& process) {
    std::vector<NodeEntities<Size>> nodes;
    for (const RosNode& node : process.nodes) {
        const auto slash = node.name.rfind('/');
        NodeEntities<Size> entities;
        entities.space = slash == 0 || slash == std::string::npos ? "/" : node.name.substr(0, slash);
        entities.name = node.name.substr(slash == std::string::npos ? 0 : slash + 1);
        for (const Guid& guid : node.readers) entities.readers.push_back(gidOf<Size>(guid));
        for (const Guid& guid : node.writers) entities.writers.push_back(gidOf<Size>(guid));
        nodes.push_back(std::move(entities));
    }
    CdrWriter out;
    out.write(gidOf<Size>(process.participant));
    out.write(nodes);
    return std::make_shared<const std::vector<std::byte>>(std::move(out).finish());
}

template <std::size_t Size>
std::vector<Guid> guidsOf(const std::vector<Gid<Size>>& gids) {
    std::vector<Guid> guids;
    guids.reserve(gids.size());
    for (const Gid<Size>& one : gids) guids.push_back(one.guid());
    return guids;
}

template <std::size_t Size>
Result<RosProcess> processIn(std::span<const std::byte> cdr) {
    CdrReader in(cdr);
    Gid<Size> participant;
    std::vector<NodeEntities<Size>> nodes;
    in.read("gid", participant);
    in.read("node_entities_info_seq", nodes);
    if (const auto end = in.finish(); !end) return end.error();
    constexpr std::size_t Empty = 4 + Size + 4, Padding = 3;  // header, identity, count of nodes
    if (nodes.empty() && cdr.size() > Empty + Padding)
        return Error{"expected nodes in what follows their count"};
    if (!participant.isWhole()) return Error{"gid: expected zeros after its 16 bytes"};
    RosProcess process{participant.guid(), Size, {}};
    for (const NodeEntities<Size>& node : nodes) {
        const bool root = node.space.empty() || node.space == "/";
        process.nodes.push_back({(root ? std::string() : node.space) + "/" + node.name, guidsOf(node.readers),
                                 guidsOf(node.writers)});
    }
    return process;
}

}  // namespace

Result<RosProcess> rosProcess(std::span<const std::byte> cdr) {
    // Read with the wrong size, the larger identity has a count at its end, or the smaller one leaves zeros.
    if (auto process = processIn<24>(cdr)) return process;
    return processIn<16>(cdr);
}

Payload rosAnnouncement(const RosProcess& process) {
    return process.gidSize == 24 ? announcement<24>(process) : announcement<16>(process);
}

void RosNodes::add(const RosProcess& process) {
    const std::lock_guard lock(m_mutex);
    if (const auto before = m_processes.find(process.participant); before != m_processes.end()) {
        for (const RosNode& node : before->second.nodes) {
            for (const Guid& one : node.readers) m_nodes.erase(one);
            for (const Guid& one : node.writers) m_nodes.erase(one);
        }
    } else if (m_processes.size() >= MostProcesses) {
        return;
    }
    m_processes.insert_or_assign(process.participant, process);
    for (const RosNode& node : process.nodes) {
        for (const std::vector<Guid>* const some : {&node.readers, &node.writers}) {
            for (const Guid& one : *some) {
                if (m_nodes.size() < MostEndpoints) m_nodes.insert_or_assign(one, node.name);
            }
        }
    }
}

std::string RosNodes::of(const Guid& endpoint) const {
    const std::lock_guard lock(m_mutex);
    const auto node = m_nodes.find(endpoint);
    return node == m_nodes.end() ? std::string() : node->second;
}

std::optional<std::size_t> RosNodes::gidSize(std::span<const Guid> participants,
                                             const std::string& unlike) const {
    const std::lock_guard lock(m_mutex);
    std::optional<std::size_t> size;
    for (const Guid& one : participants) {
        const auto process = m_processes.find(one);
        if (process == m_processes.end()) continue;
        const auto& nodes = process->second.nodes;
        const bool other =
            std::any_of(nodes.begin(), nodes.end(), [&](const RosNode& node) { return node.name != unlike; });
        if (!other) continue;
        if (size && *size != process->second.gidSize) return std::nullopt;
        size = process->second.gidSize;
    }
    return size;
}

RosNodeWatch::RosNodeWatch(Node& node) {
    ReaderSettings settings;
    settings.topic = RosDiscoveryTopic;
    settings.type = RosDiscoveryType;
    settings.qos.reliability = Qos::Reliability::Reliable;
    settings.qos.durability = Qos::Durability::TransientLocal;
    auto subscription = node.subscribe(settings, [nodes = m_nodes](const ReceivedSample& sample) {
        if (sample.event.cdr == nullptr) return;
        if (const auto process = rosProcess(*sample.event.cdr)) nodes->add(*process);
    });
    if (subscription) m_subscription = std::move(subscription).value();
}

}  // namespace leitstand
