#pragma once

#include <optional>
#include <vector>

#include <QObject>

#include "app/window/panes/view_context.h"
#include "core/mapping/storeys.h"

class QAction;

namespace leitstand {

class MapPane;
class StoreyRow;
class ViewState;

/// Shows one storey of the map: the heights of the view hide everything above and below it.
class StoreysFeature final : public QObject {
    Q_OBJECT
public:
    /// Changes @p state. All arguments must outlive this object.
    StoreysFeature(const ViewContext& context, ViewState& state, MapPane& pane, QObject* parent);

private:
    void setMap(const Map& map);
    /// Shows the storey @p number; empty: all storeys.
    void choose(std::optional<int> number);
    void step(int by);
    void follow();
    [[nodiscard]] std::optional<std::size_t> indexOf(std::optional<int> number) const;
    void showChoice();
    [[nodiscard]] static QString hint();  ///< hint for the commands

    ViewContext m_context;
    ViewState& m_state;
    StoreyRow* m_row;
    QAction *m_above = nullptr, *m_below = nullptr;
    std::vector<Storey> m_storeys;  ///< storeys of the map that is shown, in the order of the row
    std::optional<int> m_chosen;    ///< number of the storey; empty: all
    StoreyHeights m_heights;        ///< heights of the view for the selected storey
};

}  // namespace leitstand
