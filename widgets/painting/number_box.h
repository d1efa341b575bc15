#pragma once

#include <QDoubleSpinBox>

namespace leitstand {

/// A spin box that shows negative numbers with a real minus sign and accepts both signs. Letters are still
/// shortcuts of the window while it has the focus.
class NumberBox final : public QDoubleSpinBox {
    Q_OBJECT
public:
    /// Accepts values from @p low to @p high with @p decimals digits, in steps of @p step, with @p unit as
    /// suffix.
    NumberBox(double low, double high, double step, int decimals, const QString& unit,
              QWidget* parent = nullptr);

    double valueFromText(const QString& text) const override;
    QString textFromValue(double value) const override;
    QValidator::State validate(QString& input, int& position) const override;

protected:
    bool event(QEvent* event) override;
};

}  // namespace leitstand
