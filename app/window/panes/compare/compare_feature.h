#pragma once

#include <QObject>

#include "app/window/panes/view_context.h"
#include "core/mapping/comparison/map_comparison.h"

namespace leitstand {

class ComparePanel;
class MapFeature;
class ReviewBridge;
class ReviewComparison;

/// The mission's map beside that which other settings make of its scans ("compare"). Nothing recorded is
/// changed.
class CompareFeature final : public QObject {
    Q_OBJECT
public:
    /// @p map: whose title says which map is shown.
    CompareFeature(const ReviewContext& context, MapFeature& map);

    [[nodiscard]] QWidget& pane() const;

signals:
    void wanted();  ///< the pane is to be seen, and room for it

private:
    void begin(const RegistrationSettings& settings);
    void show();  ///< what is known of the comparison
    void choose(ComparedMap which);
    void showMap();
    [[nodiscard]] ReviewComparison& comparison() const;

    ViewContext m_context;
    ReviewBridge& m_bridge;
    MapFeature& m_map;
    ComparePanel* m_panel;
};

}  // namespace leitstand
