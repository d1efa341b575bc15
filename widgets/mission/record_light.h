#pragma once

#include <QWidget>

#include "widgets/models/live/texts/record_text.h"

namespace leitstand {

/// Shows in the top bar whether the mission is recorded: a dot and a word. Its size is the same for every
/// state.
class RecordLight final : public QWidget {
    Q_OBJECT
public:
    explicit RecordLight(QWidget* parent = nullptr);

    void show(const RecordText& text);
    using QWidget::show;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    RecordText m_text;
};

}  // namespace leitstand
