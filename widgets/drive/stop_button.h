#pragma once

#include <functional>
#include <vector>

#include <QWidget>

#include "widgets/models/live/stop_line.h"

class QGridLayout;

namespace leitstand {

class ReleaseHandle;

/// The stop of all robots: one large red button, and for each robot that a stop holds how far it came and a
/// handle that lets it go when it is held for one second. Esc is the window's: it is only written here.
class StopButton final : public QWidget {
    Q_OBJECT
public:
    explicit StopButton(QWidget* parent = nullptr);

    /// One line per robot, always in the same order.
    void show(const std::vector<StopLine>& lines);
    using QWidget::show;

signals:
    void stopRequested();                         ///< of all robots, on press: not only when let go
    void releaseRequested(const QString& robot);  ///< its name; was held for a second

private:
    QGridLayout* m_handles;
    std::vector<ReleaseHandle*> m_lines;
};

}  // namespace leitstand
