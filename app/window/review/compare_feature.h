#pragma once

#include <memory>

#include <QObject>

#include "app/session/comparison/map_comparing.h"
#include "app/window/live/live_context.h"

namespace leitstand {

class ComparePanel;
class ReviewBridge;

/// The mission's map beside that which other settings make of its scans ("compare"). Nothing recorded is
/// changed.
class CompareFeature final : public QObject {
    Q_OBJECT
public:
    CompareFeature(const ViewContext& context, ReviewBridge& bridge);
    ~CompareFeature() override;

    [[nodiscard]] const MapComparisonPtr& result() const { return m_result; }  ///< null: none yet

signals:
    void told(const QString& text);
    void wanted();  ///< the pane is to be seen, and room for it

private:
    void begin(const RegistrationSettings& settings);
    void finish(const Result<MapComparisonPtr>& result);
    void showMap(ComparedMap which);
    template <class Call>
    void hop(Call call) {
        QMetaObject::invokeMethod(this, std::move(call), Qt::QueuedConnection);
    }

    ViewContext m_context;
    ReviewBridge& m_bridge;
    ComparePanel* m_panel;
    MapComparisonPtr m_result;
    std::unique_ptr<MapComparing> m_comparing;  ///< last: its thread ends first
};

}  // namespace leitstand
