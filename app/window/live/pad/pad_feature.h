#pragma once

#include <map>
#include <string>
#include <vector>

#include <QObject>

#include "app/services/pad/pad_memory.h"
#include "app/window/live/pad/pad_input.h"
#include "app/window/panes/view_context.h"
#include "widgets/models/pad/pad_texts.h"

class QAction;

namespace leitstand {

class DriveInput;
class PadLegend;
class PadMappingDialog;
struct LiveMoment;

/// Gamepads in the live window. They drive through DriveInput, turn cameras, trigger commands and stop
/// robots. Also has the legend of the controls, and the dialog that binds them.
class PadFeature final : public QObject {
    Q_OBJECT
public:
    PadFeature(const LiveContext& context, DriveInput& drive, PadMemory memory);
    ~PadFeature() override;

    [[nodiscard]] PadInput& input() { return m_input; }
    /// Sets the commands of the present layout, by button of the pad.
    void useLayout(const std::map<std::string, std::string>& byButton);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void addCommands();
    void connectDrive(DriveInput& drive);
    void connectTexts();
    void useRobot();
    void allow();
    void selectNext();
    void showLegend(bool on);
    void openDialog();
    void fillDialog();
    void refresh();  ///< updates legend and dialog if they are shown
    [[nodiscard]] std::vector<PadCommandFace> faces() const;

    LiveContext m_context;
    PadInput m_input;
    PadLegend* m_legend;
    PadMappingDialog* m_dialog = nullptr;  ///< null: not opened yet
    QAction* m_legendAction = nullptr;
};

}  // namespace leitstand
