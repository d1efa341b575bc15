#include "core/robot/streams/thin_link.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/event/stream_role.h"
#include "core/robot/streams/stream_table.h"

namespace leitstand {
namespace {

constexpr double UsualWidth = 640.0;   ///< of cameras [px]
constexpr double UsualQuality = 80.0;  ///< of their JPEGs
/// Room for a piece of a sample in a datagram of 1400 B, and the size of its headers [B]. Those are IP, UDP,
/// RTPS, time, data, and the statistics that Fast DDS appends.
constexpr double Piece = 1240.0, Headers = 160.0;

/// From reductions that the eye hardly notices to pictures that still show a wall apart from a door.
constexpr std::array<StreamRequest, 6> Rungs = {{{true, 10.0, 60, 0},
                                                 {true, 8.0, 45, 0},
                                                 {true, 5.0, 40, 0},
                                                 {true, 5.0, 35, 320},
                                                 {true, 3.0, 25, 320},
                                                 {true, 1.0, 20, 320}}};

/// What is given up, the last first. Of pictures, the last is the camera that the driver looks through.
enum class Rank { Kept, Telemetry, Scans, Camera, Rest };

Rank rankOf(StreamRole role) {
    switch (streamFacts(role).thinRank) {
        case ThinRank::Kept:
            return Rank::Kept;
        case ThinRank::Telemetry:
            return Rank::Telemetry;
        case ThinRank::Scans:
            return Rank::Scans;
        case ThinRank::Pictures:
            return Rank::Rest;
    }
    return Rank::Kept;
}

/// One stream and its wish so far.
struct Share {
    StreamCost cost;
    Rank rank = Rank::Kept;
    bool selected = false, thin = true;
    StreamRequest request = {};
};

/// All streams, and what they cost together.
class Shares {
public:
    Shares(const std::vector<ThinRobot>& robots, const ThinSettings& settings) {
        for (const ThinRobot& robot : robots) {
            const StreamCost* const camera = robot.selected ? cameraOf(robot) : nullptr;
            for (const StreamCost& stream : robot.streams) {
                Share share{known(stream), rankOf(stream.role), robot.selected, robot.thin};
                if (&stream == camera) share.rank = Rank::Camera;
                m_all.push_back(std::move(share));
            }
        }
        m_room = settings.budget - settings.reserve;
    }
    [[nodiscard]] bool fits() const {
        double sum = 0.0;
        for (const Share& one : m_all) sum += costUnder(one.cost, one.request);
        return sum <= m_room;
    }
    /// Streams of @p rank that may be touched, those of robots that are not selected first.
    [[nodiscard]] std::vector<Share*> of(Rank rank) {
        std::vector<Share*> found;
        for (Share& one : m_all) {
            if (one.rank == rank && one.thin) found.push_back(&one);
        }
        std::stable_partition(found.begin(), found.end(), [](const Share* one) { return !one->selected; });
        return found;
    }
    [[nodiscard]] const std::vector<Share>& all() const { return m_all; }

private:
    /// The camera that the driver looks through; null: none.
    static const StreamCost* cameraOf(const ThinRobot& robot) {
        const auto& all = robot.streams;
        const auto looked = std::find_if(all.begin(), all.end(), [&](const StreamCost& one) {
            return rankOf(one.role) == Rank::Rest && one.topic == robot.camera;
        });
        if (looked != all.end()) return &*looked;
        const auto first = std::find_if(
            all.begin(), all.end(), [](const StreamCost& one) { return one.role == StreamRole::Picture; });
        return first == all.end() ? nullptr : &*first;
    }
    static StreamCost known(const StreamCost& stream) {
        const StreamCost usual = usualCost(stream.role, stream.topic);
        StreamCost cost = stream;
        if (cost.megabits < 0.0) cost.megabits = usual.megabits;
        if (cost.rate <= 0.0) cost.rate = usual.rate;
        return cost;
    }

    std::vector<Share> m_all;
    double m_room = 0.0;
};

StreamRequest glimpse(StreamRole role) {
    return role == StreamRole::Picture ? Rungs.back() : StreamRequest{.rate = 1.0};
}

/// Switches streams back on, once a second where there is room for it, the selected robot's first.
void giveBack(Shares& shares, const std::vector<Share*>& off) {
    for (auto one = off.rbegin(); one != off.rend(); ++one) {
        Share& share = **one;
        share.request = glimpse(share.cost.role);
        if (!shares.fits()) share.request = {.enabled = false};
    }
}

void thin(Shares& shares, const ThinSettings& settings) {
    const std::vector<Share*> rest = shares.of(Rank::Rest);
    for (Share* one : rest) one->request = {.enabled = false};
    for (Share* camera : shares.of(Rank::Camera)) {
        for (const StreamRequest& rung : Rungs) {
            camera->request =
                camera->cost.role == StreamRole::Picture ? rung : StreamRequest{.rate = rung.rate};
            if (shares.fits()) break;
        }
    }
    for (Share* scans : shares.of(Rank::Scans)) {
        if (!shares.fits() && !scans->selected) scans->request = {.enabled = false};
    }
    for (const double rate : {5.0, 2.0, 1.0}) {  // slices are left out: the map has fewer columns
        for (Share* scans : shares.of(Rank::Scans)) {
            if (!shares.fits() && scans->selected && scans->cost.rate > rate) scans->request = {.rate = rate};
        }
    }
    for (Share* telemetry : shares.of(Rank::Telemetry)) {
        if (!shares.fits() && telemetry->cost.rate > settings.slowTelemetry)
            telemetry->request = {.rate = settings.slowTelemetry};
    }
    giveBack(shares, rest);
}

}  // namespace

StreamCost usualCost(StreamRole role, const std::string& topic) {
    const StreamFacts& row = streamFacts(role);
    return {role, topic, row.usualRate, row.usualMegabits};
}

double onTheWire(double megabits, double rate) {
    if (megabits <= 0.0 || rate <= 0.0) return 0.0;
    const double size = megabits / 8e-6 / rate;
    return megabits + 8e-6 * rate * Headers * std::ceil(size / Piece);
}

double costUnder(const StreamCost& stream, const StreamRequest& request) {
    if (!request.enabled) return 0.0;
    double cost = std::max(stream.megabits, 0.0);
    if (request.rate > 0.0 && stream.rate > request.rate) cost *= request.rate / stream.rate;
    if (stream.role != StreamRole::Picture) return cost;
    if (request.quality > 0) cost *= std::min(1.0, request.quality / UsualQuality);
    if (request.maxWidth > 0)
        cost *= std::min(1.0, (request.maxWidth / UsualWidth) * (request.maxWidth / UsualWidth));
    return cost;
}

std::map<std::string, StreamRequest> thinRequests(const std::vector<ThinRobot>& robots,
                                                  const ThinSettings& settings) {
    Shares shares(robots, settings);
    if (!shares.fits()) thin(shares, settings);
    std::map<std::string, StreamRequest> requests;
    for (const Share& one : shares.all()) {
        if (!one.request.isPlain()) requests.emplace(one.cost.topic, one.request);
    }
    return requests;
}

}  // namespace leitstand
