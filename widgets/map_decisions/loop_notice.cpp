#include "widgets/map_decisions/loop_notice.h"

#include <chrono>

#include "widgets/models/numbers.h"

namespace leitstand {
namespace {

constexpr std::chrono::seconds Shown(20);
constexpr double Noticed = 0.05;  ///< smaller moves of the map show no notice [m]

}  // namespace

LoopNotice::LoopNotice(QAction& open, QWidget& over, std::uint64_t closed, QObject* parent)
    : QObject(parent), m_keep(tr("Keep")), m_closed(closed) {
    m_keep.setObjectName(QStringLiteral("loop.keep"));
    m_keep.setToolTip(tr("The loop stays closed; the menu Map opens it later, too"));
    m_notice = new MapQuestion(QStringLiteral("loopNotice"), {&open, &m_keep}, over);
    connect(&m_keep, &QAction::triggered, this, &LoopNotice::dismiss);
    connect(&open, &QAction::triggered, this, &LoopNotice::dismiss);
}

void LoopNotice::dismiss() {
    m_until = {};
    m_notice->ask({});
}

void LoopNotice::follow(std::uint64_t closed, double largest, SteadyTime now, bool asked) {
    if (closed != m_closed) {
        m_closed = closed;
        if (largest < Noticed) return dismiss();  // the button would open this loop
        m_until = now + Shown;
        m_notice->ask(tr("The map met itself and closed the loop: scans moved by up to %1 m.")
                          .arg(numberText(largest, 2)));
    }
    if (asked || now >= m_until) dismiss();
}

}  // namespace leitstand
