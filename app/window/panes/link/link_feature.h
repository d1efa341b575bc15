#pragma once

#include <chrono>

#include <QObject>

#include "app/window/panes/view_context.h"

class QAction;
class QLabel;
class QWidget;

namespace leitstand {

struct LiveMoment;
class LinkPane;

/// Shows how much of the link every stream uses, with rates and qualities, and switches the thin link (T).
class LinkFeature final : public QObject {
    Q_OBJECT
public:
    explicit LinkFeature(const LiveContext& context);

    [[nodiscard]] QWidget& pane() const;
    [[nodiscard]] QLabel& badge() const { return *m_badge; }  ///< badge for the corner: the link is thin

private:
    void show(const LiveMoment& moment);
    void setThin(bool on);

    LiveContext m_context;
    QAction* m_thin;
    LinkPane* m_pane;
    QLabel* m_badge;
    std::chrono::steady_clock::time_point m_shown = {};
};

}  // namespace leitstand
