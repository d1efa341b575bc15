#pragma once

#include <atomic>
#include <memory>
#include <utility>

namespace leitstand {

/// A value that copies share until one of them is edited. A copy may be read, copied and destroyed in any
/// thread. Only the owner of a copy may call edit().
template <class T>
class SharedValue {
public:
    SharedValue() : m_value(std::make_shared<T>()) {}
    explicit SharedValue(T value) : m_value(std::make_shared<T>(std::move(value))) {}
    SharedValue(const SharedValue& other) : m_value(other.m_value), m_shared(true) {
        other.m_shared.store(true, std::memory_order_relaxed);
    }
    SharedValue(SharedValue&& other) noexcept
        : m_value(std::move(other.m_value)), m_shared(other.m_shared.load(std::memory_order_relaxed)) {}
    SharedValue& operator=(SharedValue other) noexcept {
        m_value = std::move(other.m_value);
        m_shared.store(other.m_shared.load(std::memory_order_relaxed), std::memory_order_relaxed);
        return *this;
    }
    ~SharedValue() = default;

    [[nodiscard]] const T& operator*() const { return *m_value; }
    [[nodiscard]] const T* operator->() const { return m_value.get(); }

    /// Returns the value for editing. If others may share it, this is a new copy.
    [[nodiscard]] T& edit() {
        // Not use_count(): when another thread released the value, its reads need not be over.
        if (m_shared.load(std::memory_order_relaxed)) {
            m_value = std::make_shared<T>(*m_value);
            m_shared.store(false, std::memory_order_relaxed);
        }
        return *m_value;
    }

private:
    std::shared_ptr<T> m_value;  // null only when moved from
    mutable std::atomic<bool> m_shared = false;
};

}  // namespace leitstand
