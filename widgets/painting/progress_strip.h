#pragma once

#include <QWidget>

class QAction;
class QLabel;
class QProgressBar;

namespace leitstand {

/// Shows the current work, its progress, and a button that cancels it. Hidden while there is no work.
class ProgressStrip final : public QWidget {
    Q_OBJECT
public:
    /// @p cancel: triggered by the button.
    explicit ProgressStrip(QAction& cancel, QWidget* parent = nullptr);

    /// Shows the strip. @p text: the current work. @p fraction: the part of it that is done, 0 to 1.
    void show(const QString& text, double fraction);
    using QWidget::show;

private:
    QLabel* m_text;
    QProgressBar* m_bar;
};

}  // namespace leitstand
