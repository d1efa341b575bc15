#include <array>
#include <map>
#include <memory>
#include <optional>
#include <queue>
#include <random>

#include <gtest/gtest.h>

#include "core/event/station_samples.h"
#include "core/robot/control/grant_book.h"
#include "core/robot/control/robot_rules.h"
#include "tests/core/robot/control_scene.h"

namespace leitstand::test {
namespace {

using Action = GrantSample::Action;
constexpr int Stations = 3, Robot = Stations;  // places in the network
constexpr std::int64_t Step = 50;              // [ms]

/// Stations that ask, refuse, crash and come back over a network that keeps messages back and loses them, and
/// a robot that all of them drive whenever they believe that they may.
class Field {
public:
    explicit Field(unsigned seed) : m_random(seed), m_rules("kurt3d", {.limits = {1.0, 1.0, false}}) {
        for (int i = 0; i < Stations; ++i) start(i, {});
    }
    void runWithTrouble(std::int64_t until) {
        for (; m_now < until; m_now += Step) {
            trouble();
            step();
            if (testing::Test::HasFailure()) return;
        }
    }
    void runInPeace(std::int64_t length) {
        for (auto& [way, broken] : m_broken) broken = false;
        m_loss = 0.0;
        for (int i = 0; i < Stations; ++i) {
            if (!m_books[i]) start(i, m_memory[i]);
        }
        for (const std::int64_t end = m_now + length; m_now < end; m_now += Step) step();
    }
    /// How many stations believe that they may drive, and whether the robot obeys just that one.
    void expectAgreement() {
        int believers = 0;
        for (int i = 0; i < Stations; ++i) {
            if (!m_books[i] || !m_books[i]->mayAct(Drive, at(m_now))) continue;
            ++believers;
            EXPECT_TRUE(m_rules.grant().obeys(m_processes[i], at(m_now))) << "station " << i;
        }
        EXPECT_LE(believers, 1);
        EXPECT_TRUE(believers == 1 || m_rules.grant().holder(at(m_now)).empty());
    }
    [[nodiscard]] int handovers() const { return m_handovers; }
    [[nodiscard]] int driven() const { return m_driven; }

private:
    struct Message {
        std::int64_t arrives;
        std::optional<GrantSample> grant;  // else a drive command
        Sender from;
        DriveVelocity velocity;
    };
    using Way = std::pair<int, int>;

    bool chance(double share) { return std::uniform_real_distribution(0.0, 1.0)(m_random) < share; }
    int any(int count) { return std::uniform_int_distribution(0, count - 1)(m_random); }
    static std::string name(int station) { return std::string(1, static_cast<char>('a' + station)); }

    void start(int i, std::vector<HeldGrant> held) {
        m_processes[i] = sender(++m_lastProcess);
        m_stationOf[m_processes[i]] = name(i);
        m_books[i] = std::make_unique<GrantBook>(StationIdentity{name(i), {}, std::move(held)},
                                                 m_processes[i], at(m_now));
    }
    void trouble() {
        if (chance(0.02)) {
            const Way way{any(Stations), any(Stations + 1)};
            m_broken[way] = !m_broken[way];
        }
        m_loss = 0.05;
        const int i = any(Stations);
        if (!m_books[i]) {
            if (chance(0.05)) start(i, chance(0.8) ? m_memory[i] : std::vector<HeldGrant>{});
            return;
        }
        if (chance(0.05)) m_books[i]->requestGrant(Drive);
        if (chance(0.01)) m_books[i]->release(Drive, at(m_now));
        if (chance(0.05)) m_books[i]->answerRequest(Drive, chance(0.5), at(m_now));
        if (chance(0.005)) m_books[i].reset();
    }
    void send(int from, int to, Message message) {
        if (m_broken[{from, to}] && !message.grant) return;  // commands do not wait
        auto& queue = m_queues[{from, to}];
        message.arrives = m_now + 5 + any(60);
        if (!queue.empty()) message.arrives = std::max(message.arrives, queue.back().arrives);  // in order
        if (!chance(m_loss)) queue.push(message);
    }
    void step() {
        for (int i = 0; i < Stations; ++i) {
            if (!m_books[i]) continue;
            for (const GrantSample& reported : m_books[i]->due(at(m_now), wallAt(m_now + 700 * i))) {
                for (int to = 0; to <= Robot; ++to) send(i, to, {0, reported, m_processes[i], {}});
            }
            m_memory[i] = m_books[i]->held();
            if (m_books[i]->mayAct(Drive, at(m_now))) {
                const double speed = chance(0.3) ? 0.0 : 0.5;
                send(i, Robot, {0, std::nullopt, m_processes[i], {speed, 0.0, 0.0}});
            }
        }
        for (auto& [way, queue] : m_queues) {
            while (!m_broken[way] && !queue.empty() && queue.front().arrives <= m_now) {
                const Message message = queue.front();
                queue.pop();
                deliver(way.second, message);
            }
        }
    }
    void deliver(int to, const Message& message) {
        if (to < Stations) {
            if (m_books[to]) m_books[to]->receive(*message.grant, message.from, at(m_now));
            return;
        }
        if (message.grant) {
            m_rules.receive(*message.grant, message.from, at(m_now));
            reported(*message.grant, message.from);
            return;
        }
        if (m_rules.drive(message.velocity, message.from, at(m_now)) == DriveVerdict::Taken)
            taken(message.from);
        const bool moves = !isZero(m_rules.commanded(at(m_now)));
        m_driven += moves ? 1 : 0;
        EXPECT_TRUE(!moves || m_rules.grant().obeys(*m_driver, at(m_now)));
    }
    void reported(const GrantSample& reported, const Sender& from) {
        if (reported.action == Action::Consent || reported.action == Action::Release) m_free[from] = true;
        if (reported.action != Action::Hold) return;
        if (m_now - m_heartbeat[from] >= 3'000) m_free[from] = true;
        // Its station started anew: it is out.
        if (m_driver && *m_driver != from && m_stationOf[*m_driver] == m_stationOf[from])
            m_free[*m_driver] = true;
        m_heartbeat[from] = m_now;
    }
    /// The rule of the grants, told from what the robot received.
    void taken(const Sender& from) {
        EXPECT_LT(m_now - m_heartbeat[from], 3'000) << "a silent station is not obeyed";
        if (m_driver && *m_driver != from) {
            ++m_handovers;
            EXPECT_TRUE(m_free[*m_driver] || m_now - m_heartbeat[*m_driver] >= 3'000)
                << "at " << m_now << " ms " << m_stationOf[from] << " drives, and " << m_stationOf[*m_driver]
                << " neither consented nor was silent";
        }
        m_driver = from;
        m_free[from] = false;
    }

    std::mt19937 m_random;
    RobotRules m_rules;
    std::array<std::unique_ptr<GrantBook>, Stations> m_books;
    std::array<Sender, Stations> m_processes;
    std::array<std::vector<HeldGrant>, Stations> m_memory;
    std::map<Sender, std::string> m_stationOf;
    std::map<Way, std::queue<Message>> m_queues;
    std::map<Way, bool> m_broken;
    std::map<Sender, std::int64_t> m_heartbeat;
    std::map<Sender, bool> m_free;  ///< since it drove last it gave up, was silent or was started anew
    std::optional<Sender> m_driver;
    double m_loss = 0.0;
    std::int64_t m_now = 0;
    std::uint8_t m_lastProcess = 0;
    int m_handovers = 0, m_driven = 0;
};

TEST(GrantProperties, NeverDoTwoMoveTheRobotAndAllAgreeInTheEnd) {
    int handovers = 0, driven = 0;
    for (unsigned seed = 1; seed <= 100; ++seed) {
        Field field(seed);
        field.runWithTrouble(120'000);
        field.runInPeace(10'000);
        field.expectAgreement();
        handovers += field.handovers();
        driven += field.driven();
        ASSERT_FALSE(HasFailure()) << "seed " << seed;
    }
    EXPECT_GT(handovers, 300) << "the test means nothing when nothing happens";
    EXPECT_GT(driven, 10'000);
}

}  // namespace
}  // namespace leitstand::test
