#pragma once

#include <vector>

#include <QLayout>

namespace leitstand {

/// A layout that puts widgets side by side in their preferred sizes, on as many lines as needed.
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
    [[nodiscard]] QSize minimumSize() const override;  ///< large enough for the widest and the highest item
    void setGeometry(const QRect& area) override;

private:
    /// Returns the height that the lines need within @p area [px]. @p place: whether to place the items as
    /// well.
    int lay(const QRect& area, bool place) const;

    std::vector<QLayoutItem*> m_items;
};

}  // namespace leitstand
