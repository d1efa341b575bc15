#pragma once

#include <cstdint>

#include <QAction>
#include <QObject>

#include "core/base/time.h"
#include "widgets/map_decisions/map_question.h"

namespace leitstand {

/// A notice over the map that a loop was closed automatically, with a button that opens the loop again. It is
/// shown for 20 s.
class LoopNotice final : public QObject {
    Q_OBJECT
public:
    /// @p open: command that opens the newest loop. @p over: the map. @p closed: number of loops that were
    /// closed automatically so far; no notice is shown for these.
    LoopNotice(QAction& open, QWidget& over, std::uint64_t closed, QObject* parent);

    /// Shows the notice if @p closed, the number of loops closed automatically so far, has changed. The
    /// newest loop moved scans by up to @p largest [m]; below 5 cm there is no notice. @p asked: whether the
    /// map asks a question; then the notice is closed.
    void follow(std::uint64_t closed, double largest, SteadyTime now, bool asked);

private:
    void dismiss();

    QAction m_keep;
    MapQuestion* m_notice;  ///< a child of the map
    std::uint64_t m_closed;
    SteadyTime m_until = {};
};

}  // namespace leitstand
