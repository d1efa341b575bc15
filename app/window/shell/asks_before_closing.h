#pragma once

namespace leitstand {

/// A window that asks the operator before it closes, when that matters.
class AsksBeforeClosing {
public:
    virtual ~AsksBeforeClosing() = default;
    /// Closes at once without asking: nobody is there to answer, or somebody answered already.
    virtual void closeUnasked() = 0;
};

}  // namespace leitstand
