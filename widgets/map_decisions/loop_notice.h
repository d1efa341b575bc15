#pragma once

#include <cstdint>

#include <QAction>
#include <QObject>

#include "core/base/time.h"
#include "widgets/map_decisions/map_question.h"

namespace leitstand {

/// Shows for a while, over the map, that a loop closed automatically, with a button that opens the loop
/// again.
class LoopNotice final : public QObject {
    Q_OBJECT
public:
    /// @p open: opens the newest loop. @p over: the map. @p closed: number of loops closed automatically
    /// before.
    LoopNotice(QAction& open, QWidget& over, std::uint64_t closed, QObject* parent);

    /// @p closed: number of loops closed automatically so far; the newest moved scans by up to @p largest
    /// [m]. @p asked: the map asks a question, which goes first.
    void follow(std::uint64_t closed, double largest, SteadyTime now, bool asked);

private:
    void dismiss();

    QAction m_keep;
    MapQuestion* m_notice;  ///< child of the map
    std::uint64_t m_closed;
    SteadyTime m_until = {};
};

}  // namespace leitstand
