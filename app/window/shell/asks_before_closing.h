#pragma once

namespace leitstand {

/// A window that asks the operator before it closes, where that matters.
class AsksBeforeClosing {
public:
    virtual ~AsksBeforeClosing() = default;
    /// Closes at once: nobody is there to be asked, or was asked already.
    virtual void closeUnasked() = 0;
};

}  // namespace leitstand
