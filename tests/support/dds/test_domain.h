#pragma once

namespace leitstand::test {

/// A DDS domain that no other test of this computer uses meanwhile, whatever process it runs in. Children may
/// use it as long as their parent keeps this.
class TestDomain {
public:
    TestDomain();  ///< throws when none gets free within a minute
    ~TestDomain();
    TestDomain(const TestDomain&) = delete;
    TestDomain& operator=(const TestDomain&) = delete;

    [[nodiscard]] int number() const { return m_number; }  ///< 10..99: below the ports that systems give away

private:
    int m_number = 0;
    int m_lock = -1;
};

}  // namespace leitstand::test
