#pragma once

namespace leitstand {

/// A window that may ask the operator before it closes.
class AsksBeforeClosing {
public:
    virtual ~AsksBeforeClosing() = default;
    /// Closes at once without asking, because nobody can answer, or somebody has answered already.
    virtual void closeUnasked() = 0;
};

}  // namespace leitstand
