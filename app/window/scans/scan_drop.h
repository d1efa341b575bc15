#pragma once

#include <QObject>

#include "app/window/shell/window_state.h"

namespace leitstand {

/// Lets files and folders be dropped onto a widget.
class ScanDrop final : public QObject {
    Q_OBJECT
public:
    /// Accepts drops on @p target, which becomes its parent.
    explicit ScanDrop(QWidget& target);

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    void dropped(const leitstand::Sources& sources);
};

}  // namespace leitstand
