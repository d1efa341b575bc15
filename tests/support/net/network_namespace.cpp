#include "tests/support/net/network_namespace.h"

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <thread>

#include <arpa/inet.h>
#include <fcntl.h>
#include <linux/if_tun.h>
#include <net/if.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

namespace leitstand::test {
namespace {

[[noreturn]] void fail(const std::string& what) {
    throw std::runtime_error(what + ": " + std::strerror(errno));
}

int ownNamespace() {
    return open("/proc/thread-self/ns/net", O_RDONLY | O_CLOEXEC);
}

void name(ifreq& request, const char* interface) {
    std::strncpy(request.ifr_name, interface, IFNAMSIZ - 1);
}

void raise(int socket, const char* interface) {
    ifreq request{};
    name(request, interface);
    if (ioctl(socket, SIOCGIFFLAGS, &request) != 0) fail("SIOCGIFFLAGS");
    request.ifr_flags = static_cast<short>(request.ifr_flags | IFF_UP | IFF_RUNNING | IFF_MULTICAST);
    if (ioctl(socket, SIOCSIFFLAGS, &request) != 0) fail("SIOCSIFFLAGS");
}

void setAddress(int socket, const char* interface, const std::string& address, unsigned long what) {
    ifreq request{};
    name(request, interface);
    auto* ipv4 = reinterpret_cast<sockaddr_in*>(&request.ifr_addr);
    ipv4->sin_family = AF_INET;
    inet_pton(AF_INET, address.c_str(), &ipv4->sin_addr);
    if (ioctl(socket, what, &request) != 0) fail("address " + address);
}

void setMtu(int socket, const char* interface, int mtu) {
    ifreq request{};
    name(request, interface);
    request.ifr_mtu = mtu;
    if (ioctl(socket, SIOCSIFMTU, &request) != 0) fail("SIOCSIFMTU");
}

}  // namespace

NetworkNamespace::NetworkNamespace() {
    // A thread moves out and leaves; the descriptor keeps where it went.
    int error = 0;
    std::thread([&] {
        if (unshare(CLONE_NEWNET) == 0) m_descriptor = ownNamespace();
        error = errno;
    }).join();
    errno = error;
    if (m_descriptor < 0) fail("a network namespace cannot be made");
}

NetworkNamespace::~NetworkNamespace() {
    close(m_descriptor);
}

int NetworkNamespace::addInterface(const std::string& address, int mtu) {
    const InNamespace inside(*this);
    const int tun = open("/dev/net/tun", O_RDWR | O_CLOEXEC | O_NONBLOCK);
    if (tun < 0) fail("/dev/net/tun");
    ifreq request{};
    name(request, "radio");
    request.ifr_flags = IFF_TUN | IFF_NO_PI;
    if (ioctl(tun, TUNSETIFF, &request) != 0) fail("TUNSETIFF");
    const int control = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    setAddress(control, "radio", address, SIOCSIFADDR);
    setAddress(control, "radio", "255.255.255.0", SIOCSIFNETMASK);
    setMtu(control, "radio", mtu);
    raise(control, "radio");
    raise(control, "lo");
    close(control);
    return tun;
}

InNamespace::InNamespace(const NetworkNamespace& where) : m_before(ownNamespace()) {
    if (setns(where.descriptor(), CLONE_NEWNET) != 0) fail("setns");
}

InNamespace::~InNamespace() {
    setns(m_before, CLONE_NEWNET);
    close(m_before);
}

std::string whyNoNamespaces() {
    if (geteuid() != 0) return "network namespaces need root";
    try {
        NetworkNamespace probe;
        close(probe.addInterface("10.99.0.1"));
        return {};
    } catch (const std::exception& error) {
        return error.what();
    }
}

std::string whyNoNodesInNamespaces() {
#if __has_include(<fastdds/LibrarySettings.hpp>)
    return "Fast DDS 3 looks at the interfaces of a process once";
#else
    return whyNoNamespaces();
#endif
}

}  // namespace leitstand::test
