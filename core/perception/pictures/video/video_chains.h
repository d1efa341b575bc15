#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "core/perception/pictures/video/video_bitstream.h"

namespace leitstand {

struct PictureSample;

/// Links each picture of a video with those before it, back to the last key picture, so that it can be
/// decoded by itself. Parameters that are sent without a picture go with the next key picture. Where a
/// picture is missing, those after it are linked with nothing until the next key picture: what would be
/// decoded of them is wrong.
class VideoChains {
public:
    /// Limits of what hangs together: twenty seconds of 30 Hz with the longest intervals between key pictures
    /// that encoders usually have, and what fits into memory.
    static constexpr int MostPictures = 600;
    static constexpr std::size_t MostBytes = 64 << 20;  ///< [B]

    /// Links @p sample, the next picture on @p topic. Does nothing to pictures that are of no video.
    void link(const std::string& topic, PictureSample& sample);
    /// Call where reading goes on elsewhere: what comes next on @p topic does not follow.
    void forget(const std::string& topic) { m_chains.erase(topic); }
    void forgetAll() { m_chains.clear(); }
    /// Whether a video ever came on @p topic.
    [[nodiscard]] bool isVideo(const std::string& topic) const { return m_topics.contains(topic); }
    /// Whether the newest picture on @p topic can be decoded.
    [[nodiscard]] bool isDecodable(const std::string& topic) const;

private:
    struct Chain {
        std::optional<VideoCodec> codec;
        std::shared_ptr<const VideoPacket> newest;
        std::size_t bytes = 0;  ///< of all packets since the key picture
        PictureNumbers numbers;
        SharedBytes parameters;  ///< newest that came without a picture
    };
    std::map<std::string, Chain> m_chains;  ///< by topic
    std::set<std::string> m_topics;         ///< of all videos so far
};

}  // namespace leitstand
