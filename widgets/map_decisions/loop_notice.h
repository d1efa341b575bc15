#pragma once

#include <cstdint>

#include <QAction>
#include <QObject>

#include "core/base/time.h"
#include "widgets/map_decisions/map_question.h"

namespace leitstand {

/// Says over the map that it closed a loop by itself, for a while, with the button that opens the loop again.
class LoopNotice final : public QObject {
    Q_OBJECT
public:
    /// @p open: opens the newest loop. @p over: the map. @p closed: loops that closed by themselves before.
    LoopNotice(QAction& open, QWidget& over, std::uint64_t closed, QObject* parent);

    /// @p closed: how many loops closed by themselves so far; the newest moved scans by up to @p largest [m].
    /// @p asked: whether the map asks something, which goes before.
    void follow(std::uint64_t closed, double largest, SteadyTime now, bool asked);

private:
    void dismiss();

    QAction m_keep;
    MapQuestion* m_notice;  ///< of the map
    std::uint64_t m_closed;
    SteadyTime m_until = {};
};

}  // namespace leitstand
