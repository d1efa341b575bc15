#pragma once

#include <memory>

#include "core/base/progress.h"
#include "core/mapping/map.h"
#include "core/mapping/registration_settings.h"

namespace leitstand {

/// Registers scans into a map one by one: label, filter, reduce, align, add (paper, section 2.1). One thread
/// at a time.
class OfflineMapper {
public:
    explicit OfflineMapper(RegistrationSettings settings);
    ~OfflineMapper();
    OfflineMapper(OfflineMapper&&) noexcept;
    OfflineMapper& operator=(OfflineMapper&&) noexcept;

    /// Adds @p scan at its registered pose. Returns false, and adds nothing, when @p progress was cancelled.
    /// A scan that cannot be aligned is added at its guess, with IcpResult::converged false.
    bool add(const ScanPtr& scan, const Progress& progress = {});

    /// Returns a snapshot of the map so far.
    [[nodiscard]] MapPtr map() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
