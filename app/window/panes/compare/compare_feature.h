#pragma once

#include <QObject>

#include "app/window/panes/view_context.h"
#include "core/mapping/comparison/map_comparison.h"

namespace leitstand {

class ComparePanel;
class MapFeature;
class ReviewBridge;
class ReviewComparison;

/// Registers the mission's scans again with other settings, and shows the new map, the recorded map, or both
/// ("compare"). What is recorded is not changed.
class CompareFeature final : public QObject {
    Q_OBJECT
public:
    /// @p map: its title says which map is shown.
    CompareFeature(const ReviewContext& context, MapFeature& map);

    [[nodiscard]] QWidget& pane() const;

signals:
    void wanted();  ///< the pane shall be shown, with enough space

private:
    void begin(const RegistrationSettings& settings);
    void show();  ///< shows what is known about the comparison
    void choose(ComparedMap which);
    void showMap();
    [[nodiscard]] ReviewComparison& comparison() const;

    ViewContext m_context;
    ReviewBridge& m_bridge;
    MapFeature& m_map;
    ComparePanel* m_panel;
};

}  // namespace leitstand
