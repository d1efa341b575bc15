#pragma once

#include <memory>
#include <vector>

#include <QLayout>

namespace leitstand {

/// How a part of a bar gives way when there is not enough room.
enum class GivesWay {
    Never,
    AtOnce,          ///< before others, from its preferred to its smallest size
    LittleByLittle,  ///< after those; also takes room that is left over, up to its largest size
};

/// The widths of one part [px].
struct PartWidths {
    int least = 0, liked = 0, most = 0;
    GivesWay gives = GivesWay::Never;
};

/// Returns the widths of @p parts in @p room [px], without spaces. They exceed it when even the least widths
/// do not fit.
[[nodiscard]] std::vector<int> foldedWidths(const std::vector<PartWidths>& parts, int room);

/// Lays out parts of a bar side by side, some of them at its right end. They give way in a fixed order. Room
/// that is left lies between the two groups.
class FoldingRow final : public QLayout {
    Q_OBJECT
public:
    explicit FoldingRow(QWidget* parent);
    ~FoldingRow() override;

    void add(QWidget& widget, GivesWay gives, bool atRight = false);

    void addItem(QLayoutItem* item) override;
    [[nodiscard]] int count() const override;
    [[nodiscard]] QLayoutItem* itemAt(int index) const override;
    QLayoutItem* takeAt(int index) override;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSize() const override;
    void setGeometry(const QRect& rect) override;

private:
    struct Part {
        std::unique_ptr<QLayoutItem> item;
        GivesWay gives = GivesWay::Never;
        bool atRight = false;
    };
    template <class SizeOf>
    [[nodiscard]] QSize whole(SizeOf sizeOf) const;

    std::vector<Part> m_parts;
};

}  // namespace leitstand
