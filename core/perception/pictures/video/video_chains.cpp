#include "core/perception/pictures/video/video_chains.h"

#include "core/event/picture_samples.h"

namespace leitstand {

void VideoChains::link(const std::string& topic, PictureSample& sample) {
    if (!sample.video) return;
    m_topics.insert(topic);
    Chain& chain = m_chains[topic];
    auto packet = std::make_shared<VideoPacket>(*sample.video);
    const std::shared_ptr<const VideoPacket> last = std::move(chain.newest);
    const bool same = last != nullptr && last->codec == packet->codec;
    if (!same) chain.numbers = {};
    const bool complete = chain.numbers.follows(packet->codec, packet->bytes.bytes);
    const std::size_t bytes = packet->bytes.bytes.size();
    packet->before = nullptr;
    packet->sinceKey = packet->waited = 0;
    if (packet->key) {
        chain.bytes = bytes;
    } else if (same && complete && last->decodable() && last->sinceKey + 1 < MostPictures &&
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
