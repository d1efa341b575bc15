#pragma once

#include <cstdint>

#include <QAction>
#include <QObject>

#include "core/base/time.h"
#include "widgets/map_decisions/map_question.h"

namespace leitstand {

/// A notice over the map that a loop was closed automatically, with a button that opens the loop again. It
/// stays for 20 s.
class LoopNotice final : public QObject {
    Q_OBJECT
public:
    /// @p open: opens the newest loop. @p over: the map. @p closed: number of loops closed automatically so
    /// far; these show no notice.
    LoopNotice(QAction& open, QWidget& over, std::uint64_t closed, QObject* parent);

    /// Shows the notice when @p closed, the number of loops closed automatically so far, has changed. The
    /// newest loop moved scans by up to @p largest [m]; below 5 cm there is no notice. @p asked: the map asks
    /// a question, which dismisses the notice.
    void follow(std::uint64_t closed, double largest, SteadyTime now, bool asked);

private:
    void dismiss();

    QAction m_keep;
    MapQuestion* m_notice;  ///< child of the map
    std::uint64_t m_closed;
    SteadyTime m_until = {};
};

}  // namespace leitstand
