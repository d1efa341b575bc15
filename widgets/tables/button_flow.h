#pragma once

#include <vector>

#include <QLayout>

namespace leitstand {

/// A layout that puts widgets side by side at their size hints and wraps them into lines.
class ButtonFlow final : public QLayout {
public:
    ButtonFlow();
    ~ButtonFlow() override;

    void addItem(QLayoutItem* item) override;  ///< takes ownership of @p item
    [[nodiscard]] int count() const override { return static_cast<int>(m_items.size()); }
    [[nodiscard]] QLayoutItem* itemAt(int index) const override;
    QLayoutItem* takeAt(int index) override;
    [[nodiscard]] Qt::Orientations expandingDirections() const override { return {}; }
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;
    [[nodiscard]] QSize sizeHint() const override { return minimumSize(); }
    [[nodiscard]] QSize minimumSize() const override;  ///< fits the widest and the highest item
    void setGeometry(const QRect& area) override;

private:
    /// Returns the height that the lines need within @p area [px]. If @p place is true, also places the
    /// items.
    int lay(const QRect& area, bool place) const;

    std::vector<QLayoutItem*> m_items;
};

}  // namespace leitstand
