#include "tests/app/attack/besieged.h"

#include "tests/transport/screen/packets.h"

namespace leitstand::test {
namespace {

/// All that is thrown at a domain, one after the other; @p many packets of mutated traffic.
class Siege : public Besieged {
protected:
    void withstand(int many) {
        Attacker one(m_domain.number());
        for (int i = 0; i < 2 * 17; ++i) one.send(Packet().submessage(0x80, 0, Bytes(60), 56).bytes());
        expectUnharmed("one packet of statistics to every port", 2 * 17);
        Mutator mutator(overheard(3'000), 5);
        storm(mutator, Mutation::Anywhere, many / 2);
        expectUnharmed("mutated packets of the domain's traffic", static_cast<std::uint64_t>(many / 2));
        storm(mutator, Mutation::InFields, many / 2);
        expectUnharmed("packets with hostile numbers, counts and lengths",
                       static_cast<std::uint64_t>(many / 2));
        storm(mutator, Mutation::InPayload, many / 10);
        expectUnharmed("well-formed packets with mutated samples", static_cast<std::uint64_t>(many / 10));
        crowd(50, 200);
        expectUnharmed("50 participants with 200 topics each", 50 * 401);
        endAndExpectWhole();
    }
};
class SiegeLong : public Siege {};

TEST_F(Siege, AnOpenDomainWithstands) {
    ASSERT_NO_FATAL_FAILURE(begin(Keys::None));
    withstand(40'000);
}
TEST_F(Siege, ADomainWithKeysWithstands) {
    ASSERT_NO_FATAL_FAILURE(begin(Keys::All));
    withstand(40'000);
}
TEST_F(SiegeLong, AnOpenDomainWithstandsAMillionPackets) {
    ASSERT_NO_FATAL_FAILURE(begin(Keys::None));
    withstand(1'000'000);
}
TEST_F(SiegeLong, ADomainWithKeysWithstandsAMillionPackets) {
    ASSERT_NO_FATAL_FAILURE(begin(Keys::All));
    withstand(1'000'000);
}

}  // namespace
}  // namespace leitstand::test
