#pragma once

#include <functional>
#include <mutex>

#include "core/robot/link/screen_report.h"
#include "transport/screen/drop_book.h"
#include "transport/screen/participants.h"

namespace leitstand::screen {

/// How a node takes part in the domain, as far as the screen uses it.
struct ScreenSettings {
    /// Messages are protected as a whole; only announcements of participants and proofs of identity are not.
    bool encrypted = false;
    bool relayed = false;  ///< there is a discovery server, so participants may announce others
};

/// Is between the network and the DDS library and decides which datagrams are passed. It changes no datagram.
/// What it stores about the domain is limited (docs/wire.md). Any thread.
class Screen {
public:
    /// Calls @p dropped after something was dropped, at most once a second, on the thread that called
    /// passes(). @p dropped must not call the screen.
    explicit Screen(const ScreenSettings& settings, std::function<void()> dropped = {})
        : m_settings(settings), m_dropped(std::move(dropped)) {}

    /// Returns whether @p bytes that came from @p place may reach the library.
    [[nodiscard]] bool passes(std::span<const std::byte> bytes, const Place& place,
                              Moment now = Clock::now());

    /// Returns whether admitted participants receive discovery on @p port, and nothing else.
    [[nodiscard]] bool isDiscoveryPort(std::uint16_t port) const;

    /// Returns what was dropped so far, by reason and sender.
    [[nodiscard]] std::vector<ScreenDrop> drops() const;
    [[nodiscard]] std::uint64_t passed() const;
    /// Returns why the last datagram was dropped, in words for developers.
    [[nodiscard]] Fault lastFault() const;

private:
    struct Verdict {
        bool passes = true;
        ScreenDrop::Kind why = ScreenDrop::Kind::NoRtps;
        Fault fault = {};
    };
    [[nodiscard]] Verdict judge(const Datagram& datagram, const Place& place, Moment now);
    [[nodiscard]] Verdict judgeSpeaker(const Prefix& speaker, const Place& place, Moment now);
    [[nodiscard]] Verdict judgeOne(const Submessage& next, const Place& place, Moment now);
    [[nodiscard]] Verdict judgeAnnouncement(const Submessage& next, const Place& place, Moment now);
    [[nodiscard]] Verdict judgeKnown(const Submessage& next, Remote& remote, const Place& place, Moment now);
    [[nodiscard]] Verdict judgeEndpoint(const Submessage& next, Moment now);
    [[nodiscard]] Verdict judgeStranger(const Place& place, Moment now);

    /// Counts a verdict. Returns whether drops should be reported now.
    [[nodiscard]] bool count(const Verdict& verdict, const Place& place, Moment now);

    const ScreenSettings m_settings;
    const std::function<void()> m_dropped;
    mutable std::mutex m_mutex;  // guards all that follows
    Participants m_participants;
    std::unordered_map<Place, Budget, BytesHash> m_strangers;
    DropBook m_drops;
    std::uint64_t m_passed = 0;
    Moment m_swept{}, m_reported{};
    bool m_unreported = false;
};

}  // namespace leitstand::screen
