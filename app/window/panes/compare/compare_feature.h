#pragma once

#include <QObject>

#include "app/window/panes/view_context.h"
#include "core/mapping/comparison/map_comparison.h"

namespace leitstand {

class ComparePanel;
class MapFeature;
class ReviewBridge;
class ReviewComparison;

/// Registers the mission's scans again with other settings, and shows that map, the recorded one or both
/// ("compare"). Changes nothing that is recorded.
class CompareFeature final : public QObject {
    Q_OBJECT
public:
    /// @p map: its title names the map that is shown.
    CompareFeature(const ReviewContext& context, MapFeature& map);

    [[nodiscard]] QWidget& pane() const;

signals:
    void wanted();  ///< the pane is to be shown, with room for it

private:
    void begin(const RegistrationSettings& settings);
    void show();  ///< shows what is known of the comparison
    void choose(ComparedMap which);
    void showMap();
    [[nodiscard]] ReviewComparison& comparison() const;

    ViewContext m_context;
    ReviewBridge& m_bridge;
    MapFeature& m_map;
    ComparePanel* m_panel;
};

}  // namespace leitstand
