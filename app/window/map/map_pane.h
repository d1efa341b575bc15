#pragma once

#include <QList>
#include <QWidget>

#include "widgets/models/map_text.h"

class QAction;
class QGridLayout;
class QLabel;
class QVBoxLayout;

namespace leitstand {

class MapView;
class ViewState;

/// The map with its title, the column of tools, the settings of the present look, and a help text while the
/// map is empty.
class MapPane final : public QWidget {
    Q_OBJECT
public:
    /// Shows and edits @p state, which must outlive this object.
    explicit MapPane(ViewState& state, QWidget* parent = nullptr);

    [[nodiscard]] MapView& view() const { return *m_view; }
    /// Puts @p tools into the column, from top to bottom; null is a gap.
    void setTools(const QList<QAction*>& tools);
    /// Puts @p row over the map, at its right edge.
    void setStoreys(QWidget& row);
    /// Shows @p summary of the map in the title; in a short form if the pane is narrow.
    void setSummary(const MapSummary& summary);
    /// Shows or hides the help text for an empty map.
    void setHelpVisible(bool visible);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void showTexts();
    [[nodiscard]] QWidget* header(ViewState& state);
    [[nodiscard]] QLabel* help();

    MapView* m_view;
    QLabel* m_title;
    QLabel* m_result;
    QLabel* m_help;
    QGridLayout* m_stage;
    MapSummary m_summary;
};

}  // namespace leitstand
