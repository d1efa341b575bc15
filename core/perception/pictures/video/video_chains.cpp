#include "core/perception/pictures/video/video_chains.h"

#include "core/event/picture_samples.h"

namespace leitstand {

void VideoChains::link(const std::string& topic, PictureSample& sample) {
    if (!sample.video) return;
    m_topics.insert(topic);
    Chain& chain = m_chains[topic];
    auto packet = std::make_shared<VideoPacket>(*sample.video);
    packet->before = nullptr;
    packet->sinceKey = packet->waited = 0;
    const bool same = chain.codec == packet->codec;
    if (!same) chain = {};
    chain.codec = packet->codec;
    const bool complete = chain.numbers.follows(packet->codec, packet->bytes.bytes);
    const VideoContents contents = contentsOf(packet->codec, packet->bytes.bytes);
    if (!contents.picture) {
        if (contents.parameters) chain.parameters = packet->bytes;
        packet->waited = 1;  // nothing to be seen, and no fault
        sample.video = std::move(packet);
        return;
    }
    const std::size_t bytes = packet->bytes.bytes.size();
    const auto& last = chain.newest;
    if (packet->key) {
        if (!contents.parameters) packet->parameters = chain.parameters;
        chain.bytes = bytes;
    } else if (last != nullptr && complete && last->decodable() && last->sinceKey + 1 < MostPictures &&
               chain.bytes + bytes <= MostBytes) {
        chain.bytes += bytes;
        packet->before = last;
        packet->sinceKey = last->sinceKey + 1;
    } else {
        chain.bytes = 0;
        packet->waited = (last == nullptr ? 0 : last->waited) + 1;
    }
    sample.video = packet;
    chain.newest = std::move(packet);
}

bool VideoChains::isDecodable(const std::string& topic) const {
    const auto chain = m_chains.find(topic);
    return chain != m_chains.end() && chain->second.newest && chain->second.newest->decodable();
}

}  // namespace leitstand
