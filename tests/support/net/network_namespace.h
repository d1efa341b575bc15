#pragma once

#include <string>

namespace leitstand::test {

/// A network of its own: nothing of the computer's network is seen in it, and it goes with this object. Needs
/// root and /dev/net/tun.
class NetworkNamespace {
public:
    NetworkNamespace();  ///< throws where it cannot be had, with the reason
    ~NetworkNamespace();
    NetworkNamespace(const NetworkNamespace&) = delete;
    NetworkNamespace& operator=(const NetworkNamespace&) = delete;

    /// Gives it an interface "radio" of @p address in a network of 256. Returns the descriptor that whole
    /// IPv4 packets, of @p mtu bytes at most, are read from (sent by those inside) and written to; the caller
    /// closes it.
    [[nodiscard]] int addInterface(const std::string& address, int mtu = 1500);
    [[nodiscard]] int descriptor() const { return m_descriptor; }

private:
    int m_descriptor = -1;
};

/// As long as it lives, what this thread opens and the threads and processes that it starts are in @p where.
class InNamespace {
public:
    explicit InNamespace(const NetworkNamespace& where);
    ~InNamespace();
    InNamespace(const InNamespace&) = delete;
    InNamespace& operator=(const InNamespace&) = delete;

private:
    int m_before = -1;
};

/// Why namespaces cannot be had here; empty when they can.
[[nodiscard]] std::string whyNoNamespaces();
/// Why nodes of this process cannot be in several namespaces; empty when they can.
[[nodiscard]] std::string whyNoNodesInNamespaces();

}  // namespace leitstand::test
