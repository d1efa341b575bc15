#include "core/io/robot/robot_names.h"

#include "core/event/stream_role.h"
#include "core/robot/streams/stream_table.h"

namespace leitstand::detail {
namespace {

/// Returns core's words for the values from the first to @p last.
template <class T>
Words<T> wordsUpTo(T last) {
    Words<T> words;
    for (int i = 0; i <= static_cast<int>(last); ++i)
        words.emplace_back(toString(static_cast<T>(i)), static_cast<T>(i));
    return words;
}

}  // namespace

const Words<SensorMotion>& motionWords() {
    static const Words<SensorMotion> words = {{"fixed", SensorMotion::Fixed},
                                              {"turning", SensorMotion::Turning},
                                              {"tilting", SensorMotion::Tilting}};
    return words;
}

const Words<StreamRole>& roleWords() {
    static const Words<StreamRole> words = [] {
        Words<StreamRole> all;
        for (const StreamFacts& row : streamTable()) all.emplace_back(toString(row.role), row.role);
        return all;
    }();
    return words;
}

const Words<Qos::Reliability>& reliabilityWords() {
    static const Words<Qos::Reliability> words = {{"best_effort", Qos::Reliability::BestEffort},
                                                  {"reliable", Qos::Reliability::Reliable}};
    return words;
}

const Words<Qos::Durability>& durabilityWords() {
    static const Words<Qos::Durability> words = {{"volatile", Qos::Durability::Volatile},
                                                 {"transient_local", Qos::Durability::TransientLocal}};
    return words;
}

const Words<StampSource>& stampWords() {
    static const Words<StampSource> words = wordsUpTo(StampSource::Station);
    return words;
}

const Words<DriveType>& driveWords() {
    static const Words<DriveType> words = wordsUpTo(DriveType::Omnidirectional);
    return words;
}

const Words<TfPrefix>& prefixWords() {
    static const Words<TfPrefix> words = wordsUpTo(TfPrefix::None);
    return words;
}

const Words<JointType>& jointTypeWords() {
    static const Words<JointType> words = wordsUpTo(JointType::Prismatic);
    return words;
}

const Words<JointCommandMode>& jointCommandWords() {
    static const Words<JointCommandMode> words = wordsUpTo(JointCommandMode::Velocity);
    return words;
}

const Words<LinkLossRule>& linkLossWords() {
    static const Words<LinkLossRule> words = wordsUpTo(LinkLossRule::ReturnToLink);
    return words;
}

}  // namespace leitstand::detail
