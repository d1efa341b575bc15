#pragma once

#include <memory>
#include <vector>

#include <QLayout>

namespace leitstand {

/// How a part of a bar shrinks when there is not enough space.
enum class GivesWay {
    Never,
    AtOnce,          ///< first: from its preferred to its smallest width in one step
    LittleByLittle,  ///< then: as far as needed; it also grows into free space, up to its largest width
};

/// The widths of one part [px].
struct PartWidths {
    int least = 0, liked = 0, most = 0;
    GivesWay gives = GivesWay::Never;
};

/// Returns the widths of @p parts in a bar with @p room [px], which does not include spacing. Their sum
/// exceeds @p room if the parts do not fit even after all of them have shrunk.
[[nodiscard]] std::vector<int> foldedWidths(const std::vector<PartWidths>& parts, int room);

/// Lays out the parts of a bar side by side: some from the left, the others at the right end. Parts shrink in
/// the order of GivesWay. Free space is between the two groups.
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
