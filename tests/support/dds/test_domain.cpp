#include "tests/support/dds/test_domain.h"

#include <filesystem>
#include <stdexcept>
#include <string>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

constexpr int First = 10, Count = 90;

/// A descriptor that holds the lock of @p domain, -1 when somebody else does.
int lockOf(int domain) {
    const auto folder = std::filesystem::temp_directory_path() / "leitstand-test-domains";
    std::filesystem::create_directories(folder);
    const int file = open((folder / std::to_string(domain)).c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666);
    if (file >= 0 && flock(file, LOCK_EX | LOCK_NB) != 0) {
        close(file);
        return -1;
    }
    return file;
}

}  // namespace

TestDomain::TestDomain() {
    const int start = getpid() % Count;  // a domain just left may still have words under way
    const auto claim = [&] {
        for (int i = 0; i < Count && m_lock < 0; ++i) {
            m_number = First + (start + i) % Count;
            m_lock = lockOf(m_number);
        }
        return m_lock >= 0;
    };
    if (!waitUntil(claim, std::chrono::minutes(1)))
        throw std::runtime_error("no DDS domain is free for this test");
}

TestDomain::~TestDomain() {
    close(m_lock);
}

}  // namespace leitstand::test
