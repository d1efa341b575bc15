#include <array>
#include <map>
#include <optional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/event/station_samples.h"
#include "core/robot/control/robot_rules.h"
#include "core/robot/control/stop/stop_control.h"
#include "tests/core/robot/control_scene.h"

namespace leitstand::test {
namespace {

constexpr std::size_t Stations = 3;  // the first holds the grant, unless it passes it on

/// Stations that stop and release over a network that delays, loses, doubles, overtakes and replays.
class StopField {
public:
    explicit StopField(unsigned seed) : m_random(seed) {
        for (std::size_t i = 0; i < Stations; ++i) m_controls.emplace_back(name(i));
    }
    void run(std::int64_t until, bool trouble) {
        for (; m_now < until; m_now += 20) {
            m_rules.receive(grantSaying(name(m_holder), GrantSample::Action::Hold), process(m_holder),
                            at(m_now));
            m_received = process(m_holder);
            if (trouble) operators();
            stations(trouble ? 0.3 : 0.0);
            network(trouble);
            drive();
            if (testing::Test::HasFailure()) return;
        }
    }
    void expectAllAnswered() const {
        for (const StopControl& control : m_controls) EXPECT_FALSE(control.isWaiting());
    }
    [[nodiscard]] int releases() const { return m_releases; }
    [[nodiscard]] int refused() const { return m_refused; }
    [[nodiscard]] int moved() const { return m_moved; }

private:
    struct Message {
        std::int64_t arrives;
        std::size_t station;
        Sender from;
        StopCommandSample command;
    };
    struct Answer {
        std::int64_t arrives;
        std::size_t to;
        StopStateSample state;
    };

    bool chance(double share) { return std::uniform_real_distribution(0.0, 1.0)(m_random) < share; }
    std::int64_t delay() { return std::uniform_int_distribution(0, 300)(m_random); }
    static std::string name(std::size_t i) { return std::string(1, static_cast<char>('a' + i)); }
    [[nodiscard]] Sender process(std::size_t i) const {
        return sender(static_cast<std::uint8_t>(10 * m_lives.at(i) + i));
    }
    /// Clocks of stations are seconds apart.
    [[nodiscard]] Time wall(std::size_t i) const {
        return wallAt(m_now - 5'000 * static_cast<std::int64_t>(i));
    }

    void operators() {
        for (std::size_t i = 0; i < Stations; ++i) {
            if (chance(0.01)) m_controls[i].stop(at(m_now), wall(i));
            if (chance(0.05)) static_cast<void>(m_controls[i].release(i == m_holder, at(m_now), wall(i)));
            if (chance(0.001)) {  // starts anew, and forgot its numbers
                m_controls[i] = StopControl(name(i));
                ++m_lives[i];
            }
        }
        if (chance(0.002)) {
            const std::size_t next = (m_holder + 1) % Stations;
            m_rules.receive(grantSaying(name(m_holder), GrantSample::Action::Consent, 1, name(next)),
                            process(m_holder), at(m_now));
            m_holder = next;
        }
    }
    void stations(double loss) {
        for (std::size_t i = 0; i < Stations; ++i) {
            const auto command = m_controls[i].due(at(m_now), wall(i));
            if (!command) continue;
            if (!command->stop) m_seen[{process(i), command->number}] = m_heardStops[i];
            for (int copy = 0; copy < 2; ++copy) {
                if (!chance(loss)) m_messages.push_back({m_now + delay(), i, process(i), *command});
            }
        }
    }
    void network(bool trouble) {
        if (trouble && !m_old.empty() && chance(0.02)) {
            Message replayed =
                m_old[std::uniform_int_distribution<std::size_t>(0, m_old.size() - 1)(m_random)];
            replayed.arrives = m_now;
            m_messages.push_back(replayed);
        }
        for (std::size_t i = 0; i < m_messages.size();) {
            if (m_messages[i].arrives > m_now) {
                ++i;
                continue;
            }
            const Message message = m_messages[i];
            m_messages.erase(m_messages.begin() + static_cast<std::ptrdiff_t>(i));
            m_old.push_back(message);
            arrive(message, trouble);
        }
        for (std::size_t i = 0; i < m_answers.size();) {
            if (m_answers[i].arrives > m_now) {
                ++i;
                continue;
            }
            const Answer answer = m_answers[i];
            m_answers.erase(m_answers.begin() + static_cast<std::ptrdiff_t>(i));
            m_heardStops[answer.to] = answer.state.stops;
            m_controls[answer.to].receive(answer.state);
        }
    }
    void arrive(const Message& message, bool trouble) {
        const StopStateSample before = m_rules.stopState(at(m_now));
        const auto last = m_last.find(message.from);
        const bool repeated = last != m_last.end() && last->second == message.command.number;
        const StopStateSample state = m_rules.receive(message.command, message.from, at(m_now));
        EXPECT_EQ(state.number, message.command.number) << "every command is answered";
        if (message.command.stop) {
            EXPECT_TRUE(state.stopped || repeated) << "a stop stops";
            m_last[message.from] = message.command.number;
        } else if (before.stopped && !state.stopped) {
            ++m_releases;
            EXPECT_EQ(message.from, m_received) << "not the holder";
            EXPECT_EQ((m_seen[{message.from, message.command.number}]), before.stops)
                << "whoever released had not seen the last stop";
        }
        if (!state.refused.empty()) ++m_refused;
        for (std::size_t to = 0; to < Stations; ++to) {
            // Answers are reliable and in order.
            std::int64_t arrives = m_now + (trouble ? delay() : 0);
            for (const Answer& answer : m_answers) {
                if (answer.to == to) arrives = std::max(arrives, answer.arrives);
            }
            m_answers.push_back({arrives, to, state});
        }
    }
    void drive() {
        const double speed = chance(0.5) ? 0.0 : 0.3;
        static_cast<void>(m_rules.drive({speed, 0.0, 0.0}, process(m_holder), at(m_now)));
        const bool moves = !isZero(m_rules.commanded(at(m_now)));
        EXPECT_FALSE(moves && m_rules.isStopped());
        m_moved += moves ? 1 : 0;
    }

    std::mt19937 m_random;
    RobotRules m_rules{"kurt3d", {.limits = {1.0, 1.0, false}, .firstStop = 1'000}};
    std::vector<StopControl> m_controls;
    std::array<int, Stations> m_lives{1, 1, 1};
    std::array<std::uint64_t, Stations> m_heardStops{};
    std::map<std::pair<Sender, std::uint64_t>, std::uint64_t> m_seen;  ///< release -> stops that were known
    std::map<Sender, std::uint64_t> m_last;                            ///< number of the last stop
    std::vector<Message> m_messages, m_old;
    std::vector<Answer> m_answers;
    std::size_t m_holder = 0;
    Sender m_received;  ///< whose heartbeat the robot heard last
    std::int64_t m_now = 0;
    int m_releases = 0, m_refused = 0, m_moved = 0;
};

TEST(StopProperties, StopAlwaysWinsWhateverOvertakesWhat) {
    int releases = 0, refused = 0, moved = 0;
    for (unsigned seed = 1; seed <= 60; ++seed) {
        StopField field(seed);
        field.run(60'000, true);
        field.run(65'000, false);
        field.expectAllAnswered();
        releases += field.releases();
        refused += field.refused();
        moved += field.moved();
        ASSERT_FALSE(HasFailure()) << "seed " << seed;
    }
    EXPECT_GT(releases, 100) << "the test means nothing when nothing happens";
    EXPECT_GT(refused, 100);
    EXPECT_GT(moved, 1'000);
}

}  // namespace
}  // namespace leitstand::test
