#pragma once

#include <optional>

#include <QObject>

#include "app/services/mapping/scanner_advice.h"
#include "app/window/panes/view_context.h"

class QAction;

namespace leitstand {

class MapQuestion;
class MapView;
struct LiveMoment;

/// Asks the operator whether to correct a 3D scanner in which the map shows an error.
class ScannerFeature final : public QObject {
    Q_OBJECT
public:
    ScannerFeature(const LiveContext& context, MapView& view, QObject* parent);

private:
    void answer(bool correct);
    void follow(const LiveMoment& moment);
    [[nodiscard]] QString question() const;

    LiveContext m_context;
    QAction *m_use = nullptr, *m_leave = nullptr;
    MapQuestion* m_question = nullptr;
    std::optional<ScannerQuestion> m_asked;  ///< question that is shown
};

}  // namespace leitstand
